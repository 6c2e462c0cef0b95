MODULE Cell
    PERS num height;
    LOCAL VAR num step:=1;
    PROC main()
        WaitTime height+step;
        height:=20;
        show;
    ENDPROC
ENDMODULE
