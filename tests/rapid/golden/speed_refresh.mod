MODULE speed_refresh
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        VelSet 80,300;
        SpeedRefresh 50;
        MoveL p0,v200,fine,tool0;
        MoveL p0,v500,fine,tool0;
        SpeedRefresh 100;
        VelSet C_MOTSET.vel.oride/2,C_MOTSET.vel.max;
        MoveL p0,v200,fine,tool0;
        SpeedRefresh 120;
    ERROR (ERR_SPEED_REFRESH_LIM)
        WaitTime 1;
        TRYNEXT;
    ENDPROC
ENDMODULE
