MODULE Alpha
    ! Its own p_rest hides the one of Calib; the tool and p_high are Calib's.
    LOCAL CONST robtarget p_rest:=[[450,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveJ p_rest, v500, fine, tShared;
        MoveJ p_high, v500, fine, tShared;
        Rest;
    ENDPROC
ENDMODULE
