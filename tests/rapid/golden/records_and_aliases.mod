MODULE records_and_aliases
    RECORD box
        metre height;
        pos at;
    ENDRECORD
    RECORD shelf
        box upper;
        bool full;
    ENDRECORD
    ALIAS num metre;
    VAR shelf shelves{2}:=[[[2,[1,2,3]],TRUE],[[4,[5,6,7]],FALSE]];
    VAR shelf one;
    VAR num m{2,2};
    PROC main()
        one:=shelves{2};
        one.upper.at.z:=9;
        WaitTime one.upper.height;
        WaitTime one.upper.at.z+shelves{2}.upper.at.z;
        m:=[[1,2],[3,4]];
        IF m=[[1,2],[3,4]] AND one<>shelves{2} AND shelves{1}.upper=[2,[1,2,3]] WaitTime m{2,1};
    ENDPROC
ENDMODULE
