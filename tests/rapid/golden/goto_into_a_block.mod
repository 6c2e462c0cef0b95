MODULE goto_into_a_block
    PROC main()
        GOTO inside;
        FOR i FROM 1 TO 9 DO
            inside:
        ENDFOR
    ENDPROC
ENDMODULE
