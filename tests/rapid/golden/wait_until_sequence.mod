MODULE wait_until_sequence
    PROC main()
        WaitUntil gi1>2 OR di1=1;
        WaitTime gi1;
        WaitTime gi1;
        WaitTime di1;
    ENDPROC
ENDMODULE
