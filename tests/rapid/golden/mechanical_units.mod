MODULE mechanical_units
    CONST robtarget p:=[[450,0,400],[0,0,1,0],[0,0,0,0],[9E9,30,9E9,9E9,9E9,9E9]];
    PERS loaddata l:=[40,[0,0,50],[1,0,0,0],0,0,0];
    PROC main()
        ConfJ \Off;
        ActUnit STN1;
        MechUnitLoad STN1, 1, l;
        MoveJ p, v1000, z50, tool0;
        DeactUnit STN1;
        IndReset EXTR, 1 \RefNum:=0 \Short;
        IndCMove EXTR, 1, 90;
        WaitUntil IndSpeed(EXTR, 1 \InSpeed);
        MoveJ Offs(p,0,50,0), v1000, fine, tool0;
        IF IsMechUnitActive(STN1) WaitTime 9;
    ENDPROC
ENDMODULE
