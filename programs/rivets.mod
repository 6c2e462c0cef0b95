MODULE Rivets
    ! An IRB 140 on a rail sets nine rivets of a frame in two rows, in the order of the drawing's numbers.
    ! No rivet has to wait for another one: the cell file says so (order), and trajopt order finds a faster one.

    CONST jointtarget j_home:=[[0,0,0,0,30,0],[900,9E9,9E9,9E9,9E9,9E9]];

    CONST robtarget p_r1_in:=[[520,250,460],[0,0,1,0],[0,0,0,0],[250,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r1:=[[520,250,380],[0,0,1,0],[0,0,0,0],[250,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r1_out:=[[520,250,460],[0,0,1,0],[0,0,0,0],[250,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r2_in:=[[600,1750,410],[0,0,1,0],[0,0,0,0],[1750,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r2:=[[600,1750,330],[0,0,1,0],[0,0,0,0],[1750,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r2_out:=[[600,1750,410],[0,0,1,0],[0,0,0,0],[1750,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r3_in:=[[520,1000,460],[0,0,1,0],[0,0,0,0],[1000,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r3:=[[520,1000,380],[0,0,1,0],[0,0,0,0],[1000,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r3_out:=[[520,1000,460],[0,0,1,0],[0,0,0,0],[1000,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r4_in:=[[600,550,410],[0,0,1,0],[0,0,0,0],[550,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r4:=[[600,550,330],[0,0,1,0],[0,0,0,0],[550,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r4_out:=[[600,550,410],[0,0,1,0],[0,0,0,0],[550,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r5_in:=[[520,1900,460],[0,0,1,0],[0,0,0,0],[1900,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r5:=[[520,1900,380],[0,0,1,0],[0,0,0,0],[1900,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r5_out:=[[520,1900,460],[0,0,1,0],[0,0,0,0],[1900,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r6_in:=[[600,1300,410],[0,0,1,0],[0,0,0,0],[1300,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r6:=[[600,1300,330],[0,0,1,0],[0,0,0,0],[1300,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r6_out:=[[600,1300,410],[0,0,1,0],[0,0,0,0],[1300,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r7_in:=[[520,760,460],[0,0,1,0],[0,0,0,0],[760,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r7:=[[520,760,380],[0,0,1,0],[0,0,0,0],[760,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r7_out:=[[520,760,460],[0,0,1,0],[0,0,0,0],[760,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r8_in:=[[600,1450,410],[0,0,1,0],[0,0,0,0],[1450,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r8:=[[600,1450,330],[0,0,1,0],[0,0,0,0],[1450,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r8_out:=[[600,1450,410],[0,0,1,0],[0,0,0,0],[1450,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r9_in:=[[520,400,460],[0,0,1,0],[0,0,0,0],[400,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r9:=[[520,400,380],[0,0,1,0],[0,0,0,0],[400,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_r9_out:=[[520,400,460],[0,0,1,0],[0,0,0,0],[400,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        Rivet1;
        Rivet2;
        Rivet3;
        Rivet4;
        Rivet5;
        Rivet6;
        Rivet7;
        Rivet8;
        Rivet9;
        MoveAbsJ j_home, v2500, fine, tool0;
    ENDPROC

    PROC Rivet1()
        MoveJ p_r1_in, v2500, fine, tool0;
        MoveL p_r1, v500, fine, tool0;
        SetDO do_rivet, 1;
        WaitTime 0.3;
        SetDO do_rivet, 0;
        MoveL p_r1_out, v500, fine, tool0;
    ENDPROC

    PROC Rivet2()
        MoveJ p_r2_in, v2500, fine, tool0;
        MoveL p_r2, v500, fine, tool0;
        SetDO do_rivet, 1;
        WaitTime 0.3;
        SetDO do_rivet, 0;
        MoveL p_r2_out, v500, fine, tool0;
    ENDPROC

    PROC Rivet3()
        MoveJ p_r3_in, v2500, fine, tool0;
        MoveL p_r3, v500, fine, tool0;
        SetDO do_rivet, 1;
        WaitTime 0.3;
        SetDO do_rivet, 0;
        MoveL p_r3_out, v500, fine, tool0;
    ENDPROC

    PROC Rivet4()
        MoveJ p_r4_in, v2500, fine, tool0;
        MoveL p_r4, v500, fine, tool0;
        SetDO do_rivet, 1;
        WaitTime 0.3;
        SetDO do_rivet, 0;
        MoveL p_r4_out, v500, fine, tool0;
    ENDPROC

    PROC Rivet5()
        MoveJ p_r5_in, v2500, fine, tool0;
        MoveL p_r5, v500, fine, tool0;
        SetDO do_rivet, 1;
        WaitTime 0.3;
        SetDO do_rivet, 0;
        MoveL p_r5_out, v500, fine, tool0;
    ENDPROC

    PROC Rivet6()
        MoveJ p_r6_in, v2500, fine, tool0;
        MoveL p_r6, v500, fine, tool0;
        SetDO do_rivet, 1;
        WaitTime 0.3;
        SetDO do_rivet, 0;
        MoveL p_r6_out, v500, fine, tool0;
    ENDPROC

    PROC Rivet7()
        MoveJ p_r7_in, v2500, fine, tool0;
        MoveL p_r7, v500, fine, tool0;
        SetDO do_rivet, 1;
        WaitTime 0.3;
        SetDO do_rivet, 0;
        MoveL p_r7_out, v500, fine, tool0;
    ENDPROC

    PROC Rivet8()
        MoveJ p_r8_in, v2500, fine, tool0;
        MoveL p_r8, v500, fine, tool0;
        SetDO do_rivet, 1;
        WaitTime 0.3;
        SetDO do_rivet, 0;
        MoveL p_r8_out, v500, fine, tool0;
    ENDPROC

    PROC Rivet9()
        MoveJ p_r9_in, v2500, fine, tool0;
        MoveL p_r9, v500, fine, tool0;
        SetDO do_rivet, 1;
        WaitTime 0.3;
        SetDO do_rivet, 0;
        MoveL p_r9_out, v500, fine, tool0;
    ENDPROC
ENDMODULE
