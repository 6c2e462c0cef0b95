MODULE robot_needed
    VAR robtarget r;
    CONST jointtarget j:=[[0,0,0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveAbsJ j,v500,fine,tool0;
        r:=CRobT();
    ENDPROC
ENDMODULE
