MODULE zones_shrink
    CONST robtarget p1:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p2:=[[530,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p3:=[[530,80,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p4:=[[530,80,700],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveL p1,v100,z50,tool0;
        MoveL p2,v100,z50,tool0;
        MoveL p3,v100,z30,tool0;
        SetDO doX,1;
        MoveL p4,v100,z100,tool0;
        WaitTime 0.5;
        MoveL p3,v100,z5,tool0;
        MoveL p1,v100,z5,tool0;
    ENDPROC
ENDMODULE
