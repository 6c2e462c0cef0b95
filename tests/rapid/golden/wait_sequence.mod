MODULE wait_sequence
    PROC main()
        WaitDI di1,1;
        WaitTime 10+di1;
        WaitTime 20+di1;
        WaitDI di1,1;
        WaitDI di1,0;
        WaitTime 30+di1;
        WaitTime 40+di1;
    ENDPROC
ENDMODULE
