MODULE ArcLengths
    ! Around [500,0,600] with radius 100 in the horizontal plane: half a circle, then a quarter on.
    CONST robtarget p_r:=[[600,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_b:=[[500,100,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_l:=[[400,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_s:=[[429.2893219,-70.7106781,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_f:=[[500,-100,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveL p_r, v500, fine, tool0;
        MoveC p_b, p_l, v100, fine, tool0;
        MoveC p_s, p_f, v100, fine, tool0;
        MoveL Offs(p_f,0,-100,0), v100, fine, tool0;
    ENDPROC
ENDMODULE
