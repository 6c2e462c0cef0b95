MODULE arrays_of_three_dimensions
    CONST num count:=2;
    VAR num cube{count,count,2*count};
    VAR num sum;
    PROC main()
        FOR i FROM 1 TO 2 DO
            FOR j FROM 1 TO 2 DO
                FOR k FROM 1 TO Dim(cube,3) DO
                    cube{i,j,k}:=100*i+10*j+k;
                ENDFOR
            ENDFOR
        ENDFOR
        WaitTime cube{2,1,4};
        WaitTime cube{3,1,1};
    ENDPROC
ENDMODULE
