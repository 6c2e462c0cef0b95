MODULE star_target
    PROC main()
        MoveL *,v500,fine,tool0;
    ENDPROC
ENDMODULE
