MODULE zones
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST zonedata zOwn:=[FALSE,7,9,11,1,12,2];
    CONST zonedata zStop:=[TRUE,7,9,11,1,12,2];
    VAR stoppointdata sOwn:=[1,TRUE,[100,100,0,2],0,0,"",0,0];
    PROC main()
        MoveJ p0,v500,z0,tool0;
        MoveJ p0,v500,zOwn,tool0;
        MoveJ p0,v500,z50\Z:=20,tool0;
        MoveJ p0,v500,zStop,tool0;
        MoveJ p0,v500,z50\Inpos:=inpos20,tool0;
        MoveJ p0,v500,z50\Inpos:=sOwn,tool0;
    ENDPROC
ENDMODULE
