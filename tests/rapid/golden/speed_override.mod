MODULE speed_override
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        VelSet 50,800;
        MoveL p0,v1000,fine,tool0;
        MoveL p0,v2000,fine,tool0;
        MoveL p0,v100\V:=300,fine,tool0;
        MoveL p0,v100\T:=2,fine,tool0;
        VelSet 100,5000;
        MoveL p0,[1200,90,60,45],fine,tool0;
    ENDPROC
ENDMODULE
