MODULE frames_at_run_time
    TASK PERS wobjdata w:=[FALSE,TRUE,"",[[1000,0,0],[0.70710678,0,0,0.70710678]],[[0,0,50],[1,0,0,0]]];
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveL p0,v500,fine,tool0\WObj:=w;
        w.oframe.trans:=[0,0,150];
        MoveL p0,v500,fine,tool0\WObj:=w;
        FOR i FROM 1 TO 2 DO
            w.uframe.trans.x:=w.uframe.trans.x+10;
            MoveL p0,v500,fine,tool0\WObj:=w;
        ENDFOR
    ENDPROC
ENDMODULE
