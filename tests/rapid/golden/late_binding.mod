MODULE late_binding
    VAR string name:="pick";
    PROC main()
        %name%  3;
        %"p"+"ick"% 4;
        CallByVar "place",2;
        %"nowhere"%;
    ERROR (ERR_REFUNKPRC)
        WaitTime 9;
        TRYNEXT;
    ENDPROC
    PROC pick(num seconds)
        WaitTime seconds;
    ENDPROC
    PROC place2()
        WaitTime 20;
    ENDPROC
ENDMODULE
