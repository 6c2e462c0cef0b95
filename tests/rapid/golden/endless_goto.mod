MODULE endless_goto
    VAR num pass;
    PROC main()
        start:
        Incr pass;
        WaitTime pass;
        GOTO start;
    ENDPROC
ENDMODULE
