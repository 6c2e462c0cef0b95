MODULE recursion_without_end
    PROC main()
        main;
    ENDPROC
ENDMODULE
