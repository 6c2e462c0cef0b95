MODULE HingeLine
    ! A reconstruction of a hinge riveting line (T. Krotky, Plzen 2014; the real program is confidential). An IRB 140 on
    ! a rail takes a hinge out of station N1, carries it to N2 and, still in the gripper, on to N3. As on the real line
    ! the arm folds to its home pose before every transfer, the rail moves alone, and the arm unfolds again.
    ! N1 is one functional area (rail at 0), N2 and N3 are the other (rail at 1500 mm). The rail (external axis a, mm)
    ! drives along the world's y.
    ! The figures it meets: 5.557 s of arm motion and 9.557 s with the rail, as `trajopt analyse` adds them up; a third
    ! of the arm's time goes into the detours (of 10.7 s on the real line, 19.5 - 15.79 s); the waits are what is left
    ! of the 19.5 s cycle beside 14.7 s of motion. Poses and speeds are otherwise invented. Folding and unfolding is
    ! slow for want of space; moves that may carry the rail along run at v2500, for the tool then travels with it.

    CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_home_n2:=[[0,0,0,0,30,0],[1500,9E9,9E9,9E9,9E9,9E9]];

    ! Station N1, tool straight down.
    CONST robtarget p_n1_in:=[[460,-180,440],[0,0,1,0],[-1,0,-1,0],[0,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n1_above:=[[540,-240,400],[0,0,1,0],[-1,0,-1,0],[0,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n1:=[[540,-240,340],[0,0,1,0],[-1,0,-1,0],[0,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n1_lift:=[[540,-240,400],[0,0,1,0],[-1,0,-1,0],[0,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n1_out:=[[460,-180,440],[0,0,1,0],[-1,0,-1,0],[0,9E9,9E9,9E9,9E9,9E9]];

    ! Station N2, turned by 30 degrees about the vertical.
    CONST robtarget p_n2_clear:=[[460,1380,480],[0,-0.2588190,0.9659258,0],[-1,0,-1,0],[1500,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n2_in:=[[460,1360,440],[0,-0.2588190,0.9659258,0],[-1,0,-1,0],[1500,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n2_above:=[[540,1300,400],[0,-0.2588190,0.9659258,0],[-1,0,-1,0],[1500,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n2:=[[540,1300,340],[0,-0.2588190,0.9659258,0],[-1,0,-1,0],[1500,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n2_lift:=[[540,1300,400],[0,-0.2588190,0.9659258,0],[-1,0,-1,0],[1500,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n2_out:=[[460,1360,440],[0,-0.2588190,0.9659258,0],[-1,0,-1,0],[1500,9E9,9E9,9E9,9E9,9E9]];

    ! Station N3, 70 mm higher and turned by 45 degrees the other way.
    CONST robtarget p_n3_in:=[[460,1760,520],[0,0.3826834,0.9238795,0],[0,0,0,0],[1500,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n3_above:=[[540,1820,470],[0,0.3826834,0.9238795,0],[0,0,0,0],[1500,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n3:=[[540,1820,410],[0,0.3826834,0.9238795,0],[0,0,0,0],[1500,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n3_lift:=[[540,1820,470],[0,0.3826834,0.9238795,0],[0,0,0,0],[1500,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n3_out:=[[460,1760,520],[0,0.3826834,0.9238795,0],[0,0,0,0],[1500,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        ! The cycle begins and ends at home, at rest.
        ServeN1;
        RideToN2;
        ServeN2;
        ServeN3;
        RideHome;
    ENDPROC

    PROC ServeN1()
        MoveJ p_n1_in, v600, fine, tool0 \WObj:=wobj0;
        MoveL p_n1_above, v500, fine, tool0 \WObj:=wobj0;
        MoveL p_n1, v200, fine, tool0 \WObj:=wobj0;
        WaitTime 0.8; ! the gripper closes, the station lets go
        MoveL p_n1_lift, v200, fine, tool0 \WObj:=wobj0;
        MoveL p_n1_out, v500, fine, tool0 \WObj:=wobj0;
    ENDPROC

    PROC RideToN2()
        MoveAbsJ j_home, v600, fine, tool0; ! trajopt: optional
        MoveAbsJ j_home_n2, v2500, fine, tool0; ! trajopt: optional
        MoveJ p_n2_clear, v600, fine, tool0 \WObj:=wobj0; ! trajopt: optional
    ENDPROC

    PROC ServeN2()
        MoveJ p_n2_in, v2500, fine, tool0 \WObj:=wobj0;
        MoveL p_n2_above, v500, fine, tool0 \WObj:=wobj0;
        MoveL p_n2, v200, fine, tool0 \WObj:=wobj0;
        WaitTime 2.0; ! riveting; the part stays in the gripper
        MoveL p_n2_lift, v200, fine, tool0 \WObj:=wobj0;
        MoveL p_n2_out, v500, fine, tool0 \WObj:=wobj0;
    ENDPROC

    PROC ServeN3()
        MoveJ p_n3_in, v800, fine, tool0 \WObj:=wobj0;
        MoveL p_n3_above, v500, fine, tool0 \WObj:=wobj0;
        MoveL p_n3, v200, fine, tool0 \WObj:=wobj0;
        WaitTime 2.0; ! riveting, then the station takes the part
        MoveL p_n3_lift, v200, fine, tool0 \WObj:=wobj0;
        MoveL p_n3_out, v500, fine, tool0 \WObj:=wobj0;
    ENDPROC

    PROC RideHome()
        MoveAbsJ j_home_n2, v600, fine, tool0; ! trajopt: optional
        MoveAbsJ j_home, v2500, fine, tool0;
    ENDPROC
ENDMODULE
