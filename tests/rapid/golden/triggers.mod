MODULE triggers
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p1:=[[500,300,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    VAR triggdata tOn;
    VAR triggdata tOff;
    VAR triggdata tInt;
    VAR triggdata tTime;
    VAR intnum iNo;
    PROC main()
        TriggIO tOn,20\DOp:=doGlue,1;
        TriggEquip tOff,15\Start,0.05\DOp:=doGlue,0;
        TriggInt tInt,40,iNo;
        TriggIO tTime,0.2\Time\GOp:=goNo,7;
        MoveJ p0,v500,fine,tool0;
        TriggL p1,v200,tOn\T2:=tOff\T3:=tInt,z10,tool0;
        TriggJ p0,v200,tTime,fine,tool0;
    ENDPROC
ENDMODULE
