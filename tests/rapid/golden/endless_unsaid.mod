MODULE endless_unsaid
    PROC main()
        WHILE 1=1 DO
            WaitTime 1;
        ENDWHILE
    ENDPROC
ENDMODULE
