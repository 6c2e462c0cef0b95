MODULE PlannedOtherwise
    CONST robtarget p:=[[450,0,647],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_v:=[[450,50,647],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_e:=[[400,100,647],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveJ p, v500, fine, tool0;
        MoveC p_v, p_e, v100, fine, tool0;
        AccSet 50, 100;
        MoveLDO p, v100, z10, tool0, doGlue, 1;
        MoveL p, v100, fine, tool0;
    ENDPROC
ENDMODULE
