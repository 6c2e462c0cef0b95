MODULE goto_out_of_loops
    VAR num count;
    PROC main()
        FOR i FROM 1 TO 9 DO
            IF i=3 GOTO found;
            WaitTime i;
        ENDFOR
        found:
        again:
        Incr count;
        WaitTime 10*count;
        IF count<2 GOTO again;
    ENDPROC
ENDMODULE
