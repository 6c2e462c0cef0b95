MODULE WorkObjectOfJoints
    PERS wobjdata w1:=[FALSE,TRUE,"",[[100,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
    CONST jointtarget j1:=[[0,10,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p1:=[[500,0,500],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveAbsJ j1, v100, z10, tool0 \WObj:=w1;
        MoveAbsJ j1, v100, fine, tool0;
        MoveL p1, v100, fine, tool0 \WObj:=w1;
        MoveL p1, v100, fine, tool0;
    ENDPROC
ENDMODULE
