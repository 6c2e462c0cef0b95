MODULE where_the_robot_starts
    VAR robtarget r;
    CONST jointtarget j:=[[0,0,0,0,0,0],[250,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        r:=CRobT(\Tool:=tool0);
        MoveL r,v500,fine,tool0;
        MoveAbsJ j,v500,fine,tool0;
        MoveExtJ [[0,0,0,0,0,0],[300,9E9,9E9,9E9,9E9,9E9]],vlin100,fine;
        r:=CRobT();
        MoveL r,v500,fine,tool0;
        r.extax.eax_a:=500;
        MoveL r,v500,fine,tool0;
    ENDPROC
ENDMODULE
