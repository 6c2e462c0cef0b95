MODULE optional_parameters
    PROC main()
        outer;
        outer \seconds:=2;
        outer \seconds:=3 \double;
        outer \minutes:=0.5;
    ENDPROC
    PROC outer(\num seconds | num minutes \switch double)
        inner \seconds?seconds \minutes?minutes \double?double;
    ENDPROC
    PROC inner(\num seconds | num minutes \switch double)
        VAR num factor:=1;
        IF Present(double) factor:=2;
        IF Present(seconds) THEN
            WaitTime factor*seconds;
        ELSEIF Present(minutes) THEN
            WaitTime factor*60*minutes;
        ELSE
            WaitTime 1;
        ENDIF
    ENDPROC
ENDMODULE
