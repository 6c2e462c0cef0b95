MODULE signal_sequence
    PROC main()
        FOR i FROM 1 TO 5 DO
            WaitTime 10*i+di1;
        ENDFOR
    ENDPROC
ENDMODULE
