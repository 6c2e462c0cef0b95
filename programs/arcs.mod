MODULE Arcs
    ! An IRB 140 on a rail draws beads of glue on three parts: round a slot, round a bow, and a ring round a hole.
    ! The rail (external axis a, mm) drives along the world's y and carries the base, so a robtarget keeps its place in
    ! the world whatever its eax_a says.

    CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];

    ! The rail may begin to follow the next move 120 mm before the point, the tool turns off 20 mm before it.
    CONST zonedata z_rail:=[FALSE,20,30,120,3,120,12];

    PERS tooldata tNozzle:=[TRUE,[[0,0,100],[1,0,0,0]],[0.6,[0,0,50],[1,0,0,0],0,0,0]];

    ! The slot: 120 mm by 80 mm with round ends, its middle at x 500, y 300.
    CONST robtarget p_slot_in:=[[460,240,280],[0,0,1,0],[0,0,0,0],[150,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_slot_1:=[[460,240,200],[0,0,1,0],[0,0,0,0],[150,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_slot_2:=[[460,360,200],[0,0,1,0],[0,0,0,0],[190,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_slot_top:=[[500,400,200],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_slot_3:=[[540,360,200],[0,0,1,0],[0,0,0,0],[190,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_slot_4:=[[540,240,200],[0,0,1,0],[0,0,0,0],[150,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_slot_foot:=[[500,200,200],[0,0,1,0],[0,0,0,0],[140,9E9,9E9,9E9,9E9,9E9]];

    ! The bow: along one side, round an arc that meets both sides at an angle, and back.
    CONST robtarget p_bow_in:=[[440,900,280],[0,0,1,0],[0,0,0,0],[800,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_bow_1:=[[440,900,200],[0,0,1,0],[0,0,0,0],[800,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_bow_2:=[[440,1050,200],[0,0,1,0],[0,0,0,0],[900,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_bow_top:=[[500,1080,200],[0,0,1,0],[0,0,0,0],[900,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_bow_3:=[[560,1050,200],[0,0,1,0],[0,0,0,0],[900,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_bow_4:=[[560,900,200],[0,0,1,0],[0,0,0,0],[800,9E9,9E9,9E9,9E9,9E9]];

    ! The hole: a circle of 25 mm in two arcs.
    CONST robtarget p_ring_in:=[[475,1500,260],[0,0,1,0],[0,0,0,0],[1400,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_ring:=[[475,1500,200],[0,0,1,0],[0,0,0,0],[1400,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        ! The cycle begins and ends at home, at rest.
        GlueSlot;
        GlueBow;
        GlueRing;
        MoveAbsJ j_home, v2500, fine, tNozzle;
    ENDPROC

    PROC GlueSlot()
        MoveJ p_slot_in, v2500, z20, tNozzle;
        MoveL p_slot_1, v500, fine, tNozzle;
        Set do_glue;
        MoveL p_slot_2, v200, z5, tNozzle;
        MoveC p_slot_top, p_slot_3, v200, z5, tNozzle;
        MoveL p_slot_4, v200, z5, tNozzle;
        MoveC p_slot_foot, p_slot_1, v200, fine, tNozzle;
        Reset do_glue;
        MoveL p_slot_in, v500, z30, tNozzle;
    ENDPROC

    PROC GlueBow()
        MoveJ p_bow_in, v2500, z20, tNozzle;
        MoveL p_bow_1, v500, fine, tNozzle;
        Set do_glue;
        MoveL p_bow_2, v200, z_rail, tNozzle;
        MoveC p_bow_top, p_bow_3, v200, z_rail, tNozzle;
        MoveL p_bow_4, v200, fine, tNozzle;
        Reset do_glue;
        MoveL Offs(p_bow_4,0,0,80), v500, z30, tNozzle;
    ENDPROC

    PROC GlueRing()
        MoveJ p_ring_in, v2500, z20, tNozzle;
        MoveL p_ring, v500, fine, tNozzle;
        Set do_glue;
        MoveC Offs(p_ring,25,25,0), Offs(p_ring,50,0,0), v100, z10, tNozzle;
        MoveC Offs(p_ring,25,-25,0), p_ring, v100, fine, tNozzle;
        Reset do_glue;
        MoveL p_ring_in, v500, z20, tNozzle;
    ENDPROC
ENDMODULE
