MODULE answer_of_another_type
    VAR num count;
    PROC main()
        TPReadNum count,"How many?";
    ENDPROC
ENDMODULE
