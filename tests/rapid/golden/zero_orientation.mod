MODULE zero_orientation
    VAR robtarget p;
    PROC main()
        MoveL p,v500,fine,tool0;
    ENDPROC
ENDMODULE
