MODULE wait_groups
    PROC main()
        WaitGI gi1,5;
        WaitTime gi1;
        WaitGI gi2\NOTEQ,3;
        WaitTime gi2;
        WaitAI ai1\GT,1.5;
        WaitTime ai1;
        WaitAI ai2\LT,0.5;
        WaitTime ai2;
    ENDPROC
ENDMODULE
