MODULE error_retry_in_vain
    PROC main()
        WaitTime 1/0;
    ERROR
        RETRY;
    ENDPROC
ENDMODULE
