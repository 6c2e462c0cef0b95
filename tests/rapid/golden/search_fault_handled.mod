MODULE search_fault_handled
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget pB:=[[500,0,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    VAR robtarget pFound;
    PROC main()
        MoveL p0,v500,fine,tool0;
        SearchL\Stop,diTouch,pFound,pB,v50,tool0;
        MoveL Offs(pB,0,0,50),v500,fine,tool0;
        ERROR
            IF ERRNO=ERR_WHLSEARCH THEN
                SetDO doMissed,1;
                TRYNEXT;
            ENDIF
    ENDPROC
ENDMODULE
