MODULE Cell
    PERS num height;
    LOCAL VAR num extra:=1;
    PROC main()
        WaitTime height+extra;
        height:=20;
        show;
    ENDPROC
ENDMODULE
