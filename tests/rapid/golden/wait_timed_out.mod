MODULE wait_timed_out
    PROC main()
        WaitDI di1,1\MaxTime:=2.5;
    ENDPROC
ENDMODULE
