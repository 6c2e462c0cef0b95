MODULE LineAfterJoints
    ! At joints [0,0,0,0,90,0] the flange is at [450,0,647] and looks down, so the tool's tip is at [450,0,547].
    PERS tooldata tLong:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
    CONST jointtarget j_down:=[[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p:=[[450,0,497],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveAbsJ j_down, v500, fine, tLong;
        MoveL p, v100, fine, tLong;
        MoveL p, v100, fine, tool0; ! another tool at the same point: the flange comes down by its length
    ENDPROC
ENDMODULE
