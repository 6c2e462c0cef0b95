MODULE signal_poll
    PROC main()
        WHILE diReady=0 DO
            WaitTime 0.1;
        ENDWHILE
        WaitTime 7;
    ENDPROC
ENDMODULE
