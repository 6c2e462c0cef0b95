MODULE endless_main
    VAR num pass;
    PROC main()
        WHILE TRUE DO
            Incr pass;
            WaitTime pass;
        ENDWHILE
        WaitTime 99;
    ENDPROC
ENDMODULE
