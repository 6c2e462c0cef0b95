MODULE alternatives_together
    PROC main()
        outer \seconds:=2 \minutes:=1;
    ENDPROC
    PROC outer(\num seconds | num minutes)
    ENDPROC
ENDMODULE
