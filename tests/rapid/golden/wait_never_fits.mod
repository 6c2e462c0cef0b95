MODULE wait_never_fits
    PROC main()
        WaitTime 1;
        WaitDI di1,1;
    ENDPROC
ENDMODULE
