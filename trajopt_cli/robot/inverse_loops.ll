; sha256 16520c92ff944e052f5c33038b31eab269a08e297b1cb3ac66a342f267f1cf84 of inverse_loops.py and of this
; made by numba 0.68.1, llvmlite 0.50.0, Python 3.11.7
; loops.fill_joints: array(float64, 1d, C); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 3d, A); array(int64, 1d, A); array(float64, 2d, C); array(float64, 3d, C)
; loops.fill_bent: array(float64, 1d, C); array(float64, 3d, C); array(float64, 2d, A); array(float64, 1d, A); array(float64, 2d, C)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.fill_joints(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.arm.0, ptr readnone captures(none) %arg.arm.1, i64 %arg.arm.2, i64 %arg.arm.3, ptr readonly captures(none) %arg.arm.4, i64 %arg.arm.5.0, i64 %arg.arm.6.0, ptr readnone captures(none) %arg.X_WC.0, ptr readnone captures(none) %arg.X_WC.1, i64 %arg.X_WC.2, i64 %arg.X_WC.3, ptr readonly captures(none) %arg.X_WC.4, i64 %arg.X_WC.5.0, i64 %arg.X_WC.5.1, i64 %arg.X_WC.6.0, i64 %arg.X_WC.6.1, ptr readnone captures(none) %arg.way.0, ptr readnone captures(none) %arg.way.1, i64 %arg.way.2, i64 %arg.way.3, ptr readonly captures(none) %arg.way.4, i64 %arg.way.5.0, i64 %arg.way.5.1, i64 %arg.way.6.0, i64 %arg.way.6.1, ptr readnone captures(none) %arg.X_FK.0, ptr readnone captures(none) %arg.X_FK.1, i64 %arg.X_FK.2, i64 %arg.X_FK.3, ptr readonly captures(none) %arg.X_FK.4, i64 %arg.X_FK.5.0, i64 %arg.X_FK.5.1, i64 %arg.X_FK.6.0, i64 %arg.X_FK.6.1, ptr readnone captures(none) %arg.X_WF.0, ptr readnone captures(none) %arg.X_WF.1, i64 %arg.X_WF.2, i64 %arg.X_WF.3, ptr readonly captures(none) %arg.X_WF.4, i64 %arg.X_WF.5.0, i64 %arg.X_WF.5.1, i64 %arg.X_WF.5.2, i64 %arg.X_WF.6.0, i64 %arg.X_WF.6.1, i64 %arg.X_WF.6.2, ptr readnone captures(none) %arg.cfx.0, ptr readnone captures(none) %arg.cfx.1, i64 %arg.cfx.2, i64 %arg.cfx.3, ptr readonly captures(none) %arg.cfx.4, i64 %arg.cfx.5.0, i64 %arg.cfx.6.0, ptr readnone captures(none) %arg.room.0, ptr readnone captures(none) %arg.room.1, i64 %arg.room.2, i64 %arg.room.3, ptr captures(none) %arg.room.4, i64 %arg.room.5.0, i64 %arg.room.5.1, i64 %arg.room.6.0, i64 %arg.room.6.1, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr writeonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.5.1, i64 %arg.q.5.2, i64 %arg.q.6.0, i64 %arg.q.6.1, i64 %arg.q.6.2) local_unnamed_addr #0 {
B0.else.endif:
  %.1468.i = alloca ptr, align 8
  %.2177.i = alloca ptr, align 8
  %.231 = icmp slt i64 %arg.room.5.0, 1
  %.211.sroa.0.3669 = select i1 %.231, i64 %arg.room.5.0, i64 0, !prof !0
  %.332 = icmp slt i64 %arg.room.5.1, 1
  br i1 %.332, label %B0.endif.endif.else.endif.endif.endif.thread, label %B0.endif.else.endif.endif.endif, !prof !0

B188:                                             ; preds = %B188.lr.ph, %B417
  %lsr.iv29 = phi i64 [ %arg.X_WF.5.0, %B188.lr.ph ], [ %lsr.iv.next, %B417 ]
  %lsr.iv27 = phi ptr [ %arg.way.4, %B188.lr.ph ], [ %scevgep28, %B417 ]
  %lsr.iv25 = phi ptr [ %arg.X_WF.4, %B188.lr.ph ], [ %scevgep26, %B417 ]
  %lsr.iv23 = phi ptr [ %arg.cfx.4, %B188.lr.ph ], [ %scevgep24, %B417 ]
  %lsr.iv = phi ptr [ %arg.q.4, %B188.lr.ph ], [ %scevgep, %B417 ]
  %invariant.gep.i = getelementptr i8, ptr %lsr.iv25, i64 %arg.X_WF.6.2
  %invariant.gep449.i = getelementptr i8, ptr %lsr.iv25, i64 %.763.i
  %invariant.gep451.i = getelementptr i8, ptr %lsr.iv25, i64 %.885.i
  %sunkaddr2.i = getelementptr i8, ptr %lsr.iv25, i64 %arg.X_WF.6.1
  %sunkaddr3.i = getelementptr i8, ptr %invariant.gep.i, i64 %arg.X_WF.6.1
  %sunkaddr4.i = getelementptr i8, ptr %invariant.gep449.i, i64 %arg.X_WF.6.1
  %sunkaddr6.i = getelementptr i8, ptr %lsr.iv25, i64 %sunkaddr5.i
  %sunkaddr12.i = getelementptr i8, ptr %invariant.gep.i, i64 %sunkaddr5.i
  %sunkaddr23.i = getelementptr i8, ptr %invariant.gep449.i, i64 %sunkaddr5.i
  %sunkaddr.i = getelementptr i8, ptr %invariant.gep451.i, i64 %arg.X_WF.6.1
  %sunkaddr56.i = getelementptr i8, ptr %lsr.iv27, i64 %arg.way.6.1
  %sunkaddr58.i = getelementptr i8, ptr %invariant.gep451.i, i64 %sunkaddr5.i
  %sunkaddr62.i = getelementptr i8, ptr %lsr.iv27, i64 %sunkaddr61.i
  br label %B435.us.us.3.i

B435.us.us.3.i:                                   ; preds = %B435.us.us.3.i, %B188
  %lsr.iv3.i = phi ptr [ %scevgep4.i, %B435.us.us.3.i ], [ %arg.X_WC.4, %B188 ]
  %lsr.iv.i = phi ptr [ %scevgep.i, %B435.us.us.3.i ], [ %.433132136, %B188 ]
  %.213511521.us.i = phi i64 [ %.220.us.i, %B435.us.us.3.i ], [ 0, %B188 ]
  %0 = shl nuw nsw i64 %.213511521.us.i, 3
  %scevgep1.i = getelementptr i8, ptr %.635, i64 %0
  %.823.us.us.i = load double, ptr %23, align 8, !noalias !1
  %.711.us.us.i = load double, ptr %22, align 8, !noalias !1
  %.600.us.us.i = load double, ptr %arg.X_FK.4, align 8, !noalias !1
  %.545.us483.us.i = load double, ptr %lsr.iv25, align 8, !noalias !1
  %.601.us484.us.i = fmul double %.600.us.us.i, %.545.us483.us.i
  %.656.us486.us.i = load double, ptr %invariant.gep.i, align 8, !noalias !1
  %.712.us487.us.i = fmul double %.711.us.us.i, %.656.us486.us.i
  %.713.us488.us.i = fadd double %.601.us484.us.i, %.712.us487.us.i
  %.768.us490.us.i = load double, ptr %invariant.gep449.i, align 8, !noalias !1
  %.824.us491.us.i = fmul double %.823.us.us.i, %.768.us490.us.i
  %.825.us492.us.i = fadd double %.713.us488.us.i, %.824.us491.us.i
  %.1044.us497.us.i = load double, ptr %lsr.iv3.i, align 8, !noalias !1
  %.1048.us498.us.i = fmul double %.1044.us497.us.i, %.825.us492.us.i
  %.1052.us499.us.i = fadd double %.1048.us498.us.i, 0.000000e+00
  %.545.us483.us.1.i = load double, ptr %sunkaddr2.i, align 8, !noalias !1
  %.601.us484.us.1.i = fmul double %.600.us.us.i, %.545.us483.us.1.i
  %.656.us486.us.1.i = load double, ptr %sunkaddr3.i, align 8, !noalias !1
  %.712.us487.us.1.i = fmul double %.711.us.us.i, %.656.us486.us.1.i
  %.713.us488.us.1.i = fadd double %.601.us484.us.1.i, %.712.us487.us.1.i
  %.768.us490.us.1.i = load double, ptr %sunkaddr4.i, align 8, !noalias !1
  %.824.us491.us.1.i = fmul double %.823.us.us.i, %.768.us490.us.1.i
  %.825.us492.us.1.i = fadd double %.713.us488.us.1.i, %.824.us491.us.1.i
  %scevgep6.i = getelementptr i8, ptr %lsr.iv3.i, i64 %arg.X_WC.6.0
  %.1044.us497.us.1.i = load double, ptr %scevgep6.i, align 8, !noalias !1
  %.1048.us498.us.1.i = fmul double %.1044.us497.us.1.i, %.825.us492.us.1.i
  %.1052.us499.us.1.i = fadd double %.1052.us499.us.i, %.1048.us498.us.1.i
  %.545.us483.us.2.i = load double, ptr %sunkaddr6.i, align 8, !noalias !1
  %.601.us484.us.2.i = fmul double %.600.us.us.i, %.545.us483.us.2.i
  %.656.us486.us.2.i = load double, ptr %sunkaddr12.i, align 8, !noalias !1
  %.712.us487.us.2.i = fmul double %.711.us.us.i, %.656.us486.us.2.i
  %.713.us488.us.2.i = fadd double %.601.us484.us.2.i, %.712.us487.us.2.i
  %.768.us490.us.2.i = load double, ptr %sunkaddr23.i, align 8, !noalias !1
  %.824.us491.us.2.i = fmul double %.823.us.us.i, %.768.us490.us.2.i
  %.825.us492.us.2.i = fadd double %.713.us488.us.2.i, %.824.us491.us.2.i
  %sunkaddr35.i = getelementptr i8, ptr %lsr.iv3.i, i64 %sunkaddr25.i
  %.1044.us497.us.2.i = load double, ptr %sunkaddr35.i, align 8, !noalias !1
  %.1048.us498.us.2.i = fmul double %.1044.us497.us.2.i, %.825.us492.us.2.i
  %.1052.us499.us.2.i = fadd double %.1052.us499.us.1.i, %.1048.us498.us.2.i
  store double %.1052.us499.us.2.i, ptr %lsr.iv.i, align 8, !noalias !1
  %.600.us.us.1.pre.i = load double, ptr %sunkaddr37.i, align 8, !noalias !1
  %.711.us.us.1.pre.i = load double, ptr %sunkaddr42.i, align 8, !noalias !1
  %.823.us.us.1.pre.i = load double, ptr %sunkaddr43.i, align 8, !noalias !1
  %.545.us483.us.1536.i = load double, ptr %lsr.iv25, align 8, !noalias !1
  %.601.us484.us.1537.i = fmul double %.600.us.us.1.pre.i, %.545.us483.us.1536.i
  %.656.us486.us.1538.i = load double, ptr %invariant.gep.i, align 8, !noalias !1
  %.712.us487.us.1539.i = fmul double %.711.us.us.1.pre.i, %.656.us486.us.1538.i
  %.713.us488.us.1540.i = fadd double %.601.us484.us.1537.i, %.712.us487.us.1539.i
  %.768.us490.us.1541.i = load double, ptr %invariant.gep449.i, align 8, !noalias !1
  %.824.us491.us.1542.i = fmul double %.823.us.us.1.pre.i, %.768.us490.us.1541.i
  %.825.us492.us.1543.i = fadd double %.713.us488.us.1540.i, %.824.us491.us.1542.i
  %.1044.us497.us.1544.i = load double, ptr %lsr.iv3.i, align 8, !noalias !1
  %.1048.us498.us.1545.i = fmul double %.1044.us497.us.1544.i, %.825.us492.us.1543.i
  %.1052.us499.us.1546.i = fadd double %.1048.us498.us.1545.i, 0.000000e+00
  %.545.us483.us.1.1.i = load double, ptr %sunkaddr2.i, align 8, !noalias !1
  %.601.us484.us.1.1.i = fmul double %.600.us.us.1.pre.i, %.545.us483.us.1.1.i
  %.656.us486.us.1.1.i = load double, ptr %sunkaddr3.i, align 8, !noalias !1
  %.712.us487.us.1.1.i = fmul double %.711.us.us.1.pre.i, %.656.us486.us.1.1.i
  %.713.us488.us.1.1.i = fadd double %.601.us484.us.1.1.i, %.712.us487.us.1.1.i
  %.768.us490.us.1.1.i = load double, ptr %sunkaddr4.i, align 8, !noalias !1
  %.824.us491.us.1.1.i = fmul double %.823.us.us.1.pre.i, %.768.us490.us.1.1.i
  %.825.us492.us.1.1.i = fadd double %.713.us488.us.1.1.i, %.824.us491.us.1.1.i
  %.1044.us497.us.1.1.i = load double, ptr %scevgep6.i, align 8, !noalias !1
  %.1048.us498.us.1.1.i = fmul double %.1044.us497.us.1.1.i, %.825.us492.us.1.1.i
  %.1052.us499.us.1.1.i = fadd double %.1052.us499.us.1546.i, %.1048.us498.us.1.1.i
  %.545.us483.us.2.1.i = load double, ptr %sunkaddr6.i, align 8, !noalias !1
  %.601.us484.us.2.1.i = fmul double %.600.us.us.1.pre.i, %.545.us483.us.2.1.i
  %.656.us486.us.2.1.i = load double, ptr %sunkaddr12.i, align 8, !noalias !1
  %.712.us487.us.2.1.i = fmul double %.711.us.us.1.pre.i, %.656.us486.us.2.1.i
  %.713.us488.us.2.1.i = fadd double %.601.us484.us.2.1.i, %.712.us487.us.2.1.i
  %.768.us490.us.2.1.i = load double, ptr %sunkaddr23.i, align 8, !noalias !1
  %.824.us491.us.2.1.i = fmul double %.823.us.us.1.pre.i, %.768.us490.us.2.1.i
  %.825.us492.us.2.1.i = fadd double %.713.us488.us.2.1.i, %.824.us491.us.2.1.i
  %.1044.us497.us.2.1.i = load double, ptr %sunkaddr35.i, align 8, !noalias !1
  %.1048.us498.us.2.1.i = fmul double %.1044.us497.us.2.1.i, %.825.us492.us.2.1.i
  %.1052.us499.us.2.1.i = fadd double %.1052.us499.us.1.1.i, %.1048.us498.us.2.1.i
  %scevgep2.i = getelementptr i8, ptr %lsr.iv.i, i64 %arg.room.6.1
  store double %.1052.us499.us.2.1.i, ptr %scevgep2.i, align 8, !noalias !1
  %.823.us.us.2.i = load double, ptr %sunkaddr45.i, align 8, !noalias !1
  %.711.us.us.2.i = load double, ptr %sunkaddr47.i, align 8, !noalias !1
  %.600.us.us.2.i = load double, ptr %sunkaddr49.i, align 8, !noalias !1
  %.545.us483.us.2564.i = load double, ptr %lsr.iv25, align 8, !noalias !1
  %.601.us484.us.2565.i = fmul double %.600.us.us.2.i, %.545.us483.us.2564.i
  %.656.us486.us.2566.i = load double, ptr %invariant.gep.i, align 8, !noalias !1
  %.712.us487.us.2567.i = fmul double %.711.us.us.2.i, %.656.us486.us.2566.i
  %.713.us488.us.2568.i = fadd double %.601.us484.us.2565.i, %.712.us487.us.2567.i
  %.768.us490.us.2569.i = load double, ptr %invariant.gep449.i, align 8, !noalias !1
  %.824.us491.us.2570.i = fmul double %.823.us.us.2.i, %.768.us490.us.2569.i
  %.825.us492.us.2571.i = fadd double %.713.us488.us.2568.i, %.824.us491.us.2570.i
  %.1044.us497.us.2572.i = load double, ptr %lsr.iv3.i, align 8, !noalias !1
  %.1048.us498.us.2573.i = fmul double %.1044.us497.us.2572.i, %.825.us492.us.2571.i
  %.1052.us499.us.2574.i = fadd double %.1048.us498.us.2573.i, 0.000000e+00
  %.545.us483.us.1.2.i = load double, ptr %sunkaddr2.i, align 8, !noalias !1
  %.601.us484.us.1.2.i = fmul double %.600.us.us.2.i, %.545.us483.us.1.2.i
  %.656.us486.us.1.2.i = load double, ptr %sunkaddr3.i, align 8, !noalias !1
  %.712.us487.us.1.2.i = fmul double %.711.us.us.2.i, %.656.us486.us.1.2.i
  %.713.us488.us.1.2.i = fadd double %.601.us484.us.1.2.i, %.712.us487.us.1.2.i
  %.768.us490.us.1.2.i = load double, ptr %sunkaddr4.i, align 8, !noalias !1
  %.824.us491.us.1.2.i = fmul double %.823.us.us.2.i, %.768.us490.us.1.2.i
  %.825.us492.us.1.2.i = fadd double %.713.us488.us.1.2.i, %.824.us491.us.1.2.i
  %.1044.us497.us.1.2.i = load double, ptr %scevgep6.i, align 8, !noalias !1
  %.1048.us498.us.1.2.i = fmul double %.1044.us497.us.1.2.i, %.825.us492.us.1.2.i
  %.1052.us499.us.1.2.i = fadd double %.1052.us499.us.2574.i, %.1048.us498.us.1.2.i
  %.545.us483.us.2.2.i = load double, ptr %sunkaddr6.i, align 8, !noalias !1
  %.601.us484.us.2.2.i = fmul double %.600.us.us.2.i, %.545.us483.us.2.2.i
  %.656.us486.us.2.2.i = load double, ptr %sunkaddr12.i, align 8, !noalias !1
  %.712.us487.us.2.2.i = fmul double %.711.us.us.2.i, %.656.us486.us.2.2.i
  %.713.us488.us.2.2.i = fadd double %.601.us484.us.2.2.i, %.712.us487.us.2.2.i
  %.768.us490.us.2.2.i = load double, ptr %sunkaddr23.i, align 8, !noalias !1
  %.824.us491.us.2.2.i = fmul double %.823.us.us.2.i, %.768.us490.us.2.2.i
  %.825.us492.us.2.2.i = fadd double %.713.us488.us.2.2.i, %.824.us491.us.2.2.i
  %.1044.us497.us.2.2.i = load double, ptr %sunkaddr35.i, align 8, !noalias !1
  %.1048.us498.us.2.2.i = fmul double %.1044.us497.us.2.2.i, %.825.us492.us.2.2.i
  %.1052.us499.us.2.2.i = fadd double %.1052.us499.us.1.2.i, %.1048.us498.us.2.2.i
  %sunkaddr51.i = getelementptr i8, ptr %lsr.iv.i, i64 %sunkaddr50.i
  store double %.1052.us499.us.2.2.i, ptr %sunkaddr51.i, align 8, !noalias !1
  %.823.us.us.3.i = load double, ptr %sunkaddr52.i, align 8, !noalias !1
  %.711.us.us.3.i = load double, ptr %sunkaddr53.i, align 8, !noalias !1
  %.600.us.us.3.i = load double, ptr %sunkaddr54.i, align 8, !noalias !1
  %.545.us.us.us.3.i = load double, ptr %lsr.iv25, align 8, !noalias !1
  %.601.us.us.us.3.i = fmul double %.600.us.us.3.i, %.545.us.us.us.3.i
  %.656.us.us.us.3.i = load double, ptr %invariant.gep.i, align 8, !noalias !1
  %.712.us.us.us.3.i = fmul double %.711.us.us.3.i, %.656.us.us.us.3.i
  %.713.us.us.us.3.i = fadd double %.601.us.us.us.3.i, %.712.us.us.us.3.i
  %.768.us.us.us.3.i = load double, ptr %invariant.gep449.i, align 8, !noalias !1
  %.824.us.us.us.3.i = fmul double %.823.us.us.3.i, %.768.us.us.us.3.i
  %.825.us.us.us.3.i = fadd double %.713.us.us.us.3.i, %.824.us.us.us.3.i
  %.890.us.us.us.3.i = load double, ptr %invariant.gep451.i, align 8, !noalias !1
  %.945.us.us.us.3.i = load double, ptr %invariant.gep453.i, align 8, !noalias !1
  %.946.us.us.us.3.i = fsub double %.890.us.us.us.3.i, %.945.us.us.us.3.i
  %.978.us.us.us.3.i = load double, ptr %lsr.iv27, align 8, !noalias !1
  %.979.us.us.us.3.i = fsub double %.946.us.us.us.3.i, %.978.us.us.us.3.i
  %.981.us.us.us.3.i = fadd double %.825.us.us.us.3.i, %.979.us.us.us.3.i
  %.1044.us.us.us.3.i = load double, ptr %lsr.iv3.i, align 8, !noalias !1
  %.1048.us.us.us.3.i = fmul double %.1044.us.us.us.3.i, %.981.us.us.us.3.i
  %.1052.us.us.us.3.i = fadd double %.1048.us.us.us.3.i, 0.000000e+00
  %.545.us.us.us.1.3.i = load double, ptr %sunkaddr2.i, align 8, !noalias !1
  %.601.us.us.us.1.3.i = fmul double %.600.us.us.3.i, %.545.us.us.us.1.3.i
  %.656.us.us.us.1.3.i = load double, ptr %sunkaddr3.i, align 8, !noalias !1
  %.712.us.us.us.1.3.i = fmul double %.711.us.us.3.i, %.656.us.us.us.1.3.i
  %.713.us.us.us.1.3.i = fadd double %.601.us.us.us.1.3.i, %.712.us.us.us.1.3.i
  %.768.us.us.us.1.3.i = load double, ptr %sunkaddr4.i, align 8, !noalias !1
  %.824.us.us.us.1.3.i = fmul double %.823.us.us.3.i, %.768.us.us.us.1.3.i
  %.825.us.us.us.1.3.i = fadd double %.713.us.us.us.1.3.i, %.824.us.us.us.1.3.i
  %.890.us.us.us.1.3.i = load double, ptr %sunkaddr.i, align 8, !noalias !1
  %.945.us.us.us.1.3.i = load double, ptr %sunkaddr55.i, align 8, !noalias !1
  %.946.us.us.us.1.3.i = fsub double %.890.us.us.us.1.3.i, %.945.us.us.us.1.3.i
  %.978.us.us.us.1.3.i = load double, ptr %sunkaddr56.i, align 8, !noalias !1
  %.979.us.us.us.1.3.i = fsub double %.946.us.us.us.1.3.i, %.978.us.us.us.1.3.i
  %.981.us.us.us.1.3.i = fadd double %.825.us.us.us.1.3.i, %.979.us.us.us.1.3.i
  %.1044.us.us.us.1.3.i = load double, ptr %scevgep6.i, align 8, !noalias !1
  %.1048.us.us.us.1.3.i = fmul double %.1044.us.us.us.1.3.i, %.981.us.us.us.1.3.i
  %.1052.us.us.us.1.3.i = fadd double %.1052.us.us.us.3.i, %.1048.us.us.us.1.3.i
  %.545.us.us.us.2.3.i = load double, ptr %sunkaddr6.i, align 8, !noalias !1
  %.601.us.us.us.2.3.i = fmul double %.600.us.us.3.i, %.545.us.us.us.2.3.i
  %.656.us.us.us.2.3.i = load double, ptr %sunkaddr12.i, align 8, !noalias !1
  %.712.us.us.us.2.3.i = fmul double %.711.us.us.3.i, %.656.us.us.us.2.3.i
  %.713.us.us.us.2.3.i = fadd double %.601.us.us.us.2.3.i, %.712.us.us.us.2.3.i
  %.768.us.us.us.2.3.i = load double, ptr %sunkaddr23.i, align 8, !noalias !1
  %.824.us.us.us.2.3.i = fmul double %.823.us.us.3.i, %.768.us.us.us.2.3.i
  %.825.us.us.us.2.3.i = fadd double %.713.us.us.us.2.3.i, %.824.us.us.us.2.3.i
  %.890.us.us.us.2.3.i = load double, ptr %sunkaddr58.i, align 8, !noalias !1
  %.945.us.us.us.2.3.i = load double, ptr %sunkaddr60.i, align 8, !noalias !1
  %.946.us.us.us.2.3.i = fsub double %.890.us.us.us.2.3.i, %.945.us.us.us.2.3.i
  %.978.us.us.us.2.3.i = load double, ptr %sunkaddr62.i, align 8, !noalias !1
  %.979.us.us.us.2.3.i = fsub double %.946.us.us.us.2.3.i, %.978.us.us.us.2.3.i
  %.981.us.us.us.2.3.i = fadd double %.825.us.us.us.2.3.i, %.979.us.us.us.2.3.i
  %.1044.us.us.us.2.3.i = load double, ptr %sunkaddr35.i, align 8, !noalias !1
  %.1048.us.us.us.2.3.i = fmul double %.1044.us.us.us.2.3.i, %.981.us.us.us.2.3.i
  %.1052.us.us.us.2.3.i = fadd double %.1052.us.us.us.1.3.i, %.1048.us.us.us.2.3.i
  %.1156.us.us.3.i = load double, ptr %sunkaddr63.i, align 8, !noalias !1
  %.1212.us.us.3.i = fmul double %.1052.us499.us.2.2.i, %.1156.us.us.3.i
  %.1214.us.us.3.i = fsub double %.1052.us.us.us.2.3.i, %.1212.us.us.3.i
  store double %.1214.us.us.3.i, ptr %scevgep1.i, align 8, !noalias !1
  %.220.us.i = add nuw nsw i64 %.213511521.us.i, 1
  %scevgep.i = getelementptr i8, ptr %lsr.iv.i, i64 %arg.room.6.0
  %scevgep4.i = getelementptr i8, ptr %lsr.iv3.i, i64 %arg.X_WC.6.1
  %exitcond.not.i = icmp eq i64 %.220.us.i, 3
  br i1 %exitcond.not.i, label %part.0, label %B435.us.us.3.i

part.0: ; preds = %B435.us.us.3.i
  %.1830 = load double, ptr %sunkaddr, align 8
  %.1832 = fcmp une double %.1830, 0.000000e+00
  %.1866 = load i64, ptr %lsr.iv23, align 8
  %.268973980.i = lshr i64 %.1866, 2
  br i1 %.1832, label %B280, label %B350

B280:                                             ; preds = %part.0
  call void @llvm.lifetime.start.p0(ptr nonnull %.2177.i)
  %.1125976.i = and i64 %.1866, 1
  %1 = and i64 %.1866, -9223372036854775806
  %2 = icmp slt i64 %.1866, 0
  %3 = icmp eq i64 %1, 2
  %4 = icmp eq i64 %1, 0
  br label %B38.i

B38.i:                                            ; preds = %B1005.i, %B280
  %exitcond1137.not.i = phi i1 [ false, %B280 ], [ true, %B1005.i ]
  %.347.not.i.i = phi i1 [ true, %B280 ], [ false, %B1005.i ]
  %.21110321075.i = phi i64 [ 0, %B280 ], [ 1, %B1005.i ]
  %.291.not.i = icmp eq i64 %.268973980.i, %.21110321075.i
  %or.cond.i = or i1 %2, %.291.not.i
  br i1 %or.cond.i, label %B72.i, label %B1005.i

B72.i:                                            ; preds = %B38.i
  %.326.i = load double, ptr %.635, align 8, !noalias !4
  %.356.i = load double, ptr %sunkaddr1.i, align 8, !noalias !4
  %.53.i.i = load double, ptr %sunkaddr.i10, align 8, !noalias !7
  %.59.i.i = fmul double %.326.i, %.326.i
  %.62.i.i = fmul double %.356.i, %.356.i
  %.63.i.i = fadd double %.59.i.i, %.62.i.i
  %sqrt.i.i = tail call double @llvm.sqrt.f64(double %.63.i.i)
  %.73.i.i = fcmp une double %.53.i.i, 0.000000e+00
  br i1 %.73.i.i, label %B80.i.i, label %B426.endif.i.i

B80.i.i:                                          ; preds = %B72.i
  %.76.i.i = tail call double @llvm.fabs.f64(double %.53.i.i)
  %.78.i.i = fsub double %sqrt.i.i, %.76.i.i
  %.84.i.i = fcmp ult double %.78.i.i, 0xBD719799812DEA11
  br i1 %.84.i.i, label %B272.endif.endif.endif.i.i, label %B140.endif.i.i

B140.endif.i.i:                                   ; preds = %B80.i.i
  %.12.i.i.i = fcmp olt double %.78.i.i, 0.000000e+00
  %.13.i.i.i = select i1 %.12.i.i.i, double 0.000000e+00, double %.78.i.i
  %.122.i.i = fadd double %.76.i.i, %sqrt.i.i
  %.123.i.i = fmul double %.122.i.i, %.13.i.i.i
  %sqrt5.i.i = tail call double @llvm.sqrt.f64(double %.123.i.i)
  %5 = fneg double %sqrt5.i.i
  %.143.i.i = select i1 %.347.not.i.i, double %sqrt5.i.i, double %5
  br label %B272.endif.endif.endif.i.i

B272.endif.endif.endif.i.i:                       ; preds = %B140.endif.i.i, %B80.i.i
  %"$phi272.0.2.0.i.i" = phi double [ %.143.i.i, %B140.endif.i.i ], [ 0x7FF8000000000000, %B80.i.i ]
  %.163.i.i = fmul double %.326.i, %"$phi272.0.2.0.i.i"
  %.166.i.i = fmul double %.356.i, %.53.i.i
  %.167.i.i = fadd double %.166.i.i, %.163.i.i
  %.170.i.i = fmul double %sqrt.i.i, %sqrt.i.i
  %.174.i.i = fdiv double %.167.i.i, %.170.i.i
  %.176.i.i = fmul double %.356.i, %"$phi272.0.2.0.i.i"
  %.181.i.i = fmul double %.326.i, %.53.i.i
  %.186.i.i = fsub double %.176.i.i, %.181.i.i
  %.195.i.i = fdiv double %.186.i.i, %.170.i.i
  %.6.i.i.i = tail call double @atan2(double %.195.i.i, double %.174.i.i)
  %.12.i1.i.i = fcmp ole double %.6.i.i.i, 0xC00921FB54442D18
  %"$phi76.0.2.0.i.i.i" = select i1 %.12.i1.i.i, double 0x400921FB54442D18, double %.6.i.i.i
  br label %B372.lr.ph.i

B426.endif.i.i:                                   ; preds = %B72.i
  %.242.i.i = fcmp ult double %sqrt.i.i, 0x3D719799812DEA11
  %.249.i.i = fdiv double %.326.i, %sqrt.i.i
  %.257.i.i = fdiv double %.356.i, %sqrt.i.i
  %"$phi426.0.2.sroa.8.0.i.i" = select i1 %.242.i.i, double 0.000000e+00, double %.257.i.i
  %"$phi426.0.2.sroa.0.0.i.i" = select i1 %.242.i.i, double 1.000000e+00, double %.249.i.i
  %.6.i2.i.i = tail call double @atan2(double %"$phi426.0.2.sroa.8.0.i.i", double %"$phi426.0.2.sroa.0.0.i.i")
  %.12.i3.i.i = fcmp ole double %.6.i2.i.i, 0xC00921FB54442D18
  %"$phi76.0.2.0.i4.i.i" = select i1 %.12.i3.i.i, double 0x400921FB54442D18, double %.6.i2.i.i
  br i1 %.347.not.i.i, label %B372.lr.ph.i, label %B470.endif.i.i

B470.endif.i.i:                                   ; preds = %B426.endif.i.i
  %.9.i.i.i = fcmp ogt double %"$phi76.0.2.0.i4.i.i", 0.000000e+00
  %"$phi54.0.2.0.v.i.i.i" = select i1 %.9.i.i.i, double 0xC00921FB54442D18, double 0x400921FB54442D18
  %"$phi54.0.2.0.i.i.i" = fadd double %"$phi76.0.2.0.i4.i.i", %"$phi54.0.2.0.v.i.i.i"
  %.34.i.i.i = fcmp ole double %"$phi54.0.2.0.i.i.i", 0xC00921FB54442D18
  %"$phi96.0.2.0.i.i.i" = select i1 %.34.i.i.i, double 0x400921FB54442D18, double %"$phi54.0.2.0.i.i.i"
  %.380.i.i = fneg double %"$phi426.0.2.sroa.0.0.i.i"
  %.384.i.i = fneg double %"$phi426.0.2.sroa.8.0.i.i"
  %.388.i.i = fneg double %sqrt.i.i
  br label %B372.lr.ph.i

B372.i:                                           ; preds = %B372.lr.ph.i, %B1003.i
  %.1247.not.i = phi i64 [ 1, %B372.lr.ph.i ], [ -1, %B1003.i ]
  %exitcond.not.i9 = phi i1 [ false, %B372.lr.ph.i ], [ true, %B1003.i ]
  %.106710081022.i = phi i64 [ 0, %B372.lr.ph.i ], [ 1, %B1003.i ]
  %.1147.not.i = icmp eq i64 %.1125976.i, %.106710081022.i
  %or.cond983.i = or i1 %2, %.1147.not.i
  br i1 %or.cond983.i, label %B406.i, label %B1003.i

B406.i:                                           ; preds = %B372.i
  %.1182.i = load double, ptr %arg.arm.4, align 8, !noalias !4
  %.1184.i = fsub double %"$phi272.0.2.0.sink.i.i", %.1182.i
  %.1214.i = load double, ptr %sunkaddr2.i11, align 8, !noalias !4
  %.1244.i = load double, ptr %sunkaddr3.i12, align 8, !noalias !4
  %.1245.i = fsub double %.1214.i, %.1244.i
  %.90.i.i = load double, ptr %.89.i.i, align 8, !noalias !10
  %.120.i.i = load double, ptr %.119.i.i, align 8, !noalias !10
  %.180.i.i = load double, ptr %sunkaddr44.i7, align 8, !noalias !10
  %.235.i.i = fmul double %.180.i.i, %.180.i.i
  %.291.i.i = load double, ptr %sunkaddr48.i, align 8, !noalias !10
  %.352.i.i = fmul double %.291.i.i, %.291.i.i
  %.353.i.i = fadd double %.235.i.i, %.352.i.i
  %sqrt.i3.i = tail call double @llvm.sqrt.f64(double %.353.i.i)
  %.408.i.i = load double, ptr %sunkaddr46.i, align 8, !noalias !10
  %.409.i.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.408.i.i)
  %.417.i.i = fcmp olt double %sqrt.i3.i, 0x3D719799812DEA11
  br i1 %.417.i.i, label %B200.endif.endif.endif.endif.endif.i.i, label %B932.i.i

B742.i.i:                                         ; preds = %B200.endif.endif.endif.endif.endif.i.i
  %.790.i.i = fmul double %sqrt455.i.i, %sqrt455.i.i
  %.793.i.i = fmul double %sqrt454.i.i, %sqrt454.i.i
  %.794.i.i = fadd double %.790.i.i, %.793.i.i
  %.795.i.i = fmul double %.13.i3.i.i, %.13.i3.i.i
  %.796.i.i = fsub double %.794.i.i, %.795.i.i
  %.799.i.i = fmul double %sqrt455.i.i, 2.000000e+00
  %.801.i.i = fmul double %.799.i.i, %sqrt454.i.i
  %.805.i.i = fdiv double %.796.i.i, %.801.i.i
  %.12.i4.i.i = fcmp olt double %.805.i.i, -1.000000e+00
  %.13.i5.i.i = select i1 %.12.i4.i.i, double -1.000000e+00, double %.805.i.i
  %.12.i6.i.i = fcmp ogt double %.13.i5.i.i, 1.000000e+00
  %.13.i7.i.i = select i1 %.12.i6.i.i, double 1.000000e+00, double %.13.i5.i.i
  %.889.i.i = tail call double @atan2(double %.120.i.i, double %.90.i.i)
  %.892.i.i = tail call double @atan2(double %.1245.i, double %.1184.i)
  %.894.i.i = tail call double @acos(double %.13.i7.i.i)
  %.897.i.i = fsub double %.892.i.i, %.894.i.i
  %.898.i.i = fsub double %.889.i.i, %.897.i.i
  %.899.i.i = tail call double @llvm.cos.f64(double %.898.i.i)
  %.900.i.i = tail call double @llvm.sin.f64(double %.898.i.i)
  br label %B900.i.i

B900.i.i:                                         ; preds = %B200.endif.endif.endif.endif.endif.i.i, %B742.i.i
  %s.4.0.i.i = phi double [ %.900.i.i, %B742.i.i ], [ %.543.i.i, %B200.endif.endif.endif.endif.endif.i.i ]
  %c.4.0.i.i = phi double [ %.899.i.i, %B742.i.i ], [ %.483.i.i, %B200.endif.endif.endif.endif.endif.i.i ]
  %.918.i.i = fcmp ogt double %.409.i.i, 0.000000e+00
  br i1 %.918.i.i, label %part.1, label %B916.i.i

B916.i.i:                                         ; preds = %B900.i.i
  br label %part.1

B932.i.i:                                         ; preds = %B406.i
  %.956.i.i = sub nsw i64 0, %.1247.not.i
  %.1011.i.i = sitofp i64 %.956.i.i to double
  %.1012.i.i = fmul double %.180.i.i, %.1011.i.i
  %.1017.i.i = fdiv double %.1012.i.i, %sqrt.i3.i
  %.1077.i.i = sitofp i64 %.1247.not.i to double
  %.1078.i.i = fmul double %.291.i.i, %.1077.i.i
  %.1083.i.i = fdiv double %.1078.i.i, %sqrt.i3.i
  %.1139.i.i = tail call double @atan2(double %sqrt.i3.i, double %.408.i.i)
  %.1205.pre.i.i = load double, ptr %.1008, align 8, !noalias !10
  %.1263.pre.i.i = load double, ptr %26, align 8, !noalias !10
  br label %part.1

B200.endif.endif.endif.endif.endif.i.i:           ; preds = %B406.i
  %.423.i.i = sitofp i64 %.1247.not.i to double
  %.424.i.i = fmul double %.409.i.i, %.423.i.i
  %.480.i.i = load double, ptr %.1008, align 8, !noalias !10
  %.483.i.i = fmul double %.424.i.i, %.480.i.i
  %.485.i.i = sub nsw i64 0, %.1247.not.i
  %.487.i.i = sitofp i64 %.485.i.i to double
  %.488.i.i = fmul double %.409.i.i, %.487.i.i
  %.542.i.i = load double, ptr %26, align 8, !noalias !10
  %.543.i.i = fmul double %.488.i.i, %.542.i.i
  %.560.i.i = fmul double %.90.i.i, %.483.i.i
  %.563.i.i = fmul double %.120.i.i, %.543.i.i
  %.564.i.i = fadd double %.560.i.i, %.563.i.i
  %.566.i.i = fsub double %.1184.i, %.564.i.i
  %.569.i.i = fmul double %.120.i.i, %.483.i.i
  %.572.i.i = fmul double %.90.i.i, %.543.i.i
  %.573.i.i = fsub double %.569.i.i, %.572.i.i
  %.575.i.i = fsub double %.1245.i, %.573.i.i
  %.576.i.i = fmul double %.566.i.i, %.566.i.i
  %.577.i.i = fmul double %.575.i.i, %.575.i.i
  %.578.i.i = fadd double %.576.i.i, %.577.i.i
  %sqrt453.i.i = tail call double @llvm.sqrt.f64(double %.578.i.i)
  %.609.i.i = load double, ptr %sunkaddr4.i13, align 8, !noalias !10
  %.639.i.i = load double, ptr %.638.i.i, align 8, !noalias !10
  %.640.i.i = fsub double %.609.i.i, %.639.i.i
  %.641.i.i = tail call double @llvm.fabs.f64(double %.640.i.i)
  %.12.i.i7.i = fcmp ogt double %.641.i.i, %sqrt453.i.i
  %.13.i.i8.i = select i1 %.12.i.i7.i, double %.641.i.i, double %sqrt453.i.i
  %.737.i.i = fadd double %.609.i.i, %.639.i.i
  %.12.i2.i.i = fcmp olt double %.737.i.i, %.13.i.i8.i
  %.13.i3.i.i = select i1 %.12.i2.i.i, double %.737.i.i, double %.13.i.i8.i
  %.768.i.i = fmul double %.1184.i, %.1184.i
  %.771.i.i = fmul double %.1245.i, %.1245.i
  %.772.i.i = fadd double %.768.i.i, %.771.i.i
  %sqrt455.i.i = tail call double @llvm.sqrt.f64(double %.772.i.i)
  %.776.i.i = fmul double %.90.i.i, %.90.i.i
  %.779.i.i = fmul double %.120.i.i, %.120.i.i
  %.780.i.i = fadd double %.776.i.i, %.779.i.i
  %sqrt454.i.i = tail call double @llvm.sqrt.f64(double %.780.i.i)
  %.865.i.i = fcmp une double %sqrt453.i.i, %.13.i3.i.i
  %.879.i.i = fmul double %sqrt455.i.i, %sqrt454.i.i
  %.885.i.i = fcmp ogt double %.879.i.i, 0.000000e+00
  %or.cond.i.i = select i1 %.865.i.i, i1 %.885.i.i, i1 false
  br i1 %or.cond.i.i, label %B742.i.i, label %B900.i.i

part.1: ; preds = %B932.i.i, %B916.i.i, %B900.i.i
  %.1263.i.i = phi double [ %.542.i.i, %B916.i.i ], [ %.542.i.i, %B900.i.i ], [ %.1263.pre.i.i, %B932.i.i ]
  %.1205.i.i = phi double [ %.480.i.i, %B916.i.i ], [ %.480.i.i, %B900.i.i ], [ %.1205.pre.i.i, %B932.i.i ]
  %.1508.pre-phi.i.i = phi double [ %.423.i.i, %B916.i.i ], [ %.423.i.i, %B900.i.i ], [ %.1077.i.i, %B932.i.i ]
  %s.3.0.i.i = phi double [ %s.4.0.i.i, %B916.i.i ], [ %s.4.0.i.i, %B900.i.i ], [ %.1083.i.i, %B932.i.i ]
  %c.3.0.i.i = phi double [ %c.4.0.i.i, %B916.i.i ], [ %c.4.0.i.i, %B900.i.i ], [ %.1017.i.i, %B932.i.i ]
  %t5.2.0.i.i = phi double [ 0x400921FB54442D18, %B916.i.i ], [ 0.000000e+00, %B900.i.i ], [ %.1139.i.i, %B932.i.i ]
  %.1209.i.i = fmul double %.1205.i.i, %s.3.0.i.i
  %.1265.i.i = fmul double %.1263.i.i, %c.3.0.i.i
  %.1266.i.i = fadd double %.1209.i.i, %.1265.i.i
  %.1267.i.i = fneg double %.1266.i.i
  %.1321.i.i = load double, ptr %sunkaddr34.i, align 8, !noalias !10
  %.1323.i.i = fmul double %s.3.0.i.i, %.1321.i.i
  %.1377.i.i = load double, ptr %sunkaddr36.i, align 8, !noalias !10
  %.1386.i.i = fmul double %c.3.0.i.i, %.1377.i.i
  %.1387.i.i = fadd double %.1323.i.i, %.1386.i.i
  %.1388.i.i = fneg double %.1387.i.i
  %.6.i.i4.i = tail call double @atan2(double %.1267.i.i, double %.1388.i.i)
  %.12.i1.i5.i = fcmp ole double %.6.i.i4.i, 0xC00921FB54442D18
  %"$phi76.0.2.0.i.i6.i" = select i1 %.12.i1.i5.i, double 0x400921FB54442D18, double %.6.i.i4.i
  %.1415.i.i = fmul double %.90.i.i, %c.3.0.i.i
  %.1418.i.i = fmul double %.120.i.i, %s.3.0.i.i
  %.1419.i.i = fadd double %.1418.i.i, %.1415.i.i
  %.1421.i.i = fsub double %.1184.i, %.1419.i.i
  %.1426.i.i = fmul double %.120.i.i, %c.3.0.i.i
  %.1431.i.i = fmul double %.90.i.i, %s.3.0.i.i
  %.1434.i.i = fsub double %.1426.i.i, %.1431.i.i
  %.1436.i.i = fsub double %.1245.i, %.1434.i.i
  store double %.1421.i.i, ptr %.1210, align 8, !noalias !10
  store double %.1436.i.i, ptr %.1497.i.i, align 8, !noalias !10
  %.1501.i.i = tail call double @atan2(double %s.3.0.i.i, double %c.3.0.i.i)
  %.1509.i.i = fmul double %.1508.pre-phi.i.i, %t5.2.0.i.i
  store double %.1501.i.i, ptr %.1542.i.i, align 8, !noalias !10
  store double %.1509.i.i, ptr %.1572.i.i, align 8, !noalias !10
  store double %"$phi76.0.2.0.i.i6.i", ptr %.1602.i.i, align 8, !noalias !10
  %.2088.i = or disjoint i64 %.106710081022.i, %.2083.i
  br i1 %3, label %B574.1.i, label %B574.i

B574.i:                                           ; preds = %part.1
  %.53.i9.i = load double, ptr %sunkaddr4.i13, align 8, !noalias !13
  %.82.i.i = load double, ptr %sunkaddr5.i14, align 8, !noalias !13
  %.126.i.i = fmul double %.1421.i.i, %.1421.i.i
  %.129.i.i = fmul double %.1436.i.i, %.1436.i.i
  %.130.i.i = fadd double %.126.i.i, %.129.i.i
  %.136.i.i = fmul double %.53.i9.i, %.53.i9.i
  %.139.i.i = fmul double %.82.i.i, %.82.i.i
  %.140.i.i = fadd double %.136.i.i, %.139.i.i
  %.142.i10.i = fsub double %.140.i.i, %.130.i.i
  %.145.i.i = fmul double %.53.i9.i, 2.000000e+00
  %.147.i.i = fmul double %.145.i.i, %.82.i.i
  %.151.i.i = fdiv double %.142.i10.i, %.147.i.i
  %.156.i.i = tail call double @llvm.fabs.f64(double %.151.i.i)
  %.159.i.i = fcmp ugt double %.156.i.i, 0x3FF0000000001198
  br i1 %.159.i.i, label %B574.endif.i, label %B266.endif.endif.i.i

B266.endif.endif.i.i:                             ; preds = %B574.i
  %.111.i.i = load double, ptr %sunkaddr6.i15, align 8, !noalias !13
  %.12.i.i11.i = fcmp ogt double %.151.i.i, 1.000000e+00
  %.13.i.i12.i = select i1 %.12.i.i11.i, double 1.000000e+00, double %.151.i.i
  %.12.i1.i13.i = fcmp olt double %.13.i.i12.i, -1.000000e+00
  %.13.i2.i.i = select i1 %.12.i1.i13.i, double -1.000000e+00, double %.13.i.i12.i
  %.261.i.i = fsub double 1.000000e+00, %.13.i2.i.i
  %.264.i.i = fadd double %.13.i2.i.i, 1.000000e+00
  %.265.i.i = fmul double %.261.i.i, %.264.i.i
  %.266.i.i = tail call double @sqrt(double %.265.i.i)
  %.276.i.i = tail call double @atan2(double %.13.i2.i.i, double %.266.i.i)
  %.334.i.i = fmul double %.82.i.i, %.13.i2.i.i
  %.336.i.i = fsub double %.53.i9.i, %.334.i.i
  %.341.i.i = fmul double %.82.i.i, %.266.i.i
  %.345.i.i = fmul double %.1421.i.i, %.336.i.i
  %.347.i.i = fmul double %.1436.i.i, %.341.i.i
  %.348.i.i = fsub double %.345.i.i, %.347.i.i
  %.350.i.i = fmul double %.1436.i.i, %.336.i.i
  %.354.i.i = fmul double %.1421.i.i, %.341.i.i
  %.357.i.i = fadd double %.350.i.i, %.354.i.i
  %.358.i.i = tail call double @atan2(double %.348.i.i, double %.357.i.i)
  %.413.i.i = fsub double %.276.i.i, %.111.i.i
  br label %B574.endif.i

B694.i:                                           ; preds = %B574.endif.i, %B694.i
  %t4.3.6.i = phi double [ %.1713.i, %B694.i ], [ %.1701.i, %B574.endif.i ]
  %.1713.i = fadd double %t4.3.6.i, 0xC01921FB54442D18
  %.1718.i = fcmp ogt double %.1713.i, 0x400921FB54442D18
  br i1 %.1718.i, label %B694.i, label %B742.i

B742.i:                                           ; preds = %B694.i, %B574.endif.i
  %t4.4.7.i = phi double [ %.1701.i, %B574.endif.i ], [ %.1713.i, %B694.i ]
  %.1732.i = fcmp ugt double %t4.4.7.i, 0xC00921FB54442D18
  br i1 %.1732.i, label %B816.i, label %B766.i

B766.i:                                           ; preds = %B742.i, %B766.i
  %t4.5.6.i = phi double [ %.1739.i, %B766.i ], [ %t4.4.7.i, %B742.i ]
  %.1739.i = fadd double %t4.5.6.i, 0x401921FB54442D18
  %.1745.i = fcmp ugt double %.1739.i, 0xC00921FB54442D18
  br i1 %.1745.i, label %B816.i, label %B766.i

B816.i:                                           ; preds = %B766.i, %B742.i
  %t4.6.7.i = phi double [ %t4.4.7.i, %B742.i ], [ %.1739.i, %B766.i ]
  store double %"$phi76.0.2.0.i.sink.i.i", ptr %.705, align 8, !noalias !4
  store double %.358.sink.i.i, ptr %sunkaddr9.i, align 8, !noalias !4
  store double %.413.sink.i.i, ptr %sunkaddr10.i17, align 8, !noalias !4
  store double %t4.6.7.i, ptr %sunkaddr11.i18, align 8, !noalias !4
  store double %.1509.i.i, ptr %sunkaddr12.i19, align 8, !noalias !4
  store double %"$phi76.0.2.0.i.i6.i", ptr %sunkaddr13.i, align 8, !noalias !4
  %6 = mul i64 %.2088.i, %arg.q.5.2
  %spec.select.i = select i1 %2, i64 %6, i64 0
  %.2134.i = getelementptr double, ptr %lsr.iv, i64 %spec.select.i
  call fastcc void @part.2(ptr nonnull %.2177.i, ptr nonnull readonly %arg.arm.4, ptr nonnull %.705, ptr %.2134.i, i64 %arg.q.5.2)
  br i1 %4, label %B1003.i, label %B816.B574.1_crit_edge.i

B816.B574.1_crit_edge.i:                          ; preds = %B816.i
  %.1587.1.pre.i = load double, ptr %.1210, align 8, !noalias !4
  %.1617.1.pre.i = load double, ptr %.1497.i.i, align 8, !noalias !4
  br label %B574.1.i

B1003.i:                                          ; preds = %B816.1.i, %B816.i, %B372.i
  br i1 %exitcond.not.i9, label %B1005.i, label %B372.i

B574.1.i:                                         ; preds = %B816.B574.1_crit_edge.i, %part.1
  %.1617.1.i = phi double [ %.1617.1.pre.i, %B816.B574.1_crit_edge.i ], [ %.1436.i.i, %part.1 ]
  %.1587.1.i = phi double [ %.1587.1.pre.i, %B816.B574.1_crit_edge.i ], [ %.1421.i.i, %part.1 ]
  %.53.i15.i = load double, ptr %sunkaddr4.i13, align 8, !noalias !16
  %.82.i17.i = load double, ptr %sunkaddr5.i14, align 8, !noalias !16
  %.126.i20.i = fmul double %.1587.1.i, %.1587.1.i
  %.129.i21.i = fmul double %.1617.1.i, %.1617.1.i
  %.130.i22.i = fadd double %.129.i21.i, %.126.i20.i
  %.136.i23.i = fmul double %.53.i15.i, %.53.i15.i
  %.139.i24.i = fmul double %.82.i17.i, %.82.i17.i
  %.140.i25.i = fadd double %.136.i23.i, %.139.i24.i
  %.142.i26.i = fsub double %.140.i25.i, %.130.i22.i
  %.145.i27.i = fmul double %.53.i15.i, 2.000000e+00
  %.147.i28.i = fmul double %.145.i27.i, %.82.i17.i
  %.151.i29.i = fdiv double %.142.i26.i, %.147.i28.i
  %.156.i30.i = tail call double @llvm.fabs.f64(double %.151.i29.i)
  %.159.i31.i = fcmp ugt double %.156.i30.i, 0x3FF0000000001198
  br i1 %.159.i31.i, label %B574.endif.1.i, label %B266.endif.endif.i32.i

B266.endif.endif.i32.i:                           ; preds = %B574.1.i
  %.111.i19.i = load double, ptr %sunkaddr6.i15, align 8, !noalias !16
  %.12.i.i33.i = fcmp ogt double %.151.i29.i, 1.000000e+00
  %.13.i.i34.i = select i1 %.12.i.i33.i, double 1.000000e+00, double %.151.i29.i
  %.12.i1.i35.i = fcmp olt double %.13.i.i34.i, -1.000000e+00
  %.13.i2.i36.i = select i1 %.12.i1.i35.i, double -1.000000e+00, double %.13.i.i34.i
  %.261.i37.i = fsub double 1.000000e+00, %.13.i2.i36.i
  %.264.i38.i = fadd double %.13.i2.i36.i, 1.000000e+00
  %.265.i39.i = fmul double %.261.i37.i, %.264.i38.i
  %.266.i40.i = tail call double @sqrt(double %.265.i39.i)
  %.276.i41.i = tail call double @atan2(double %.13.i2.i36.i, double %.266.i40.i)
  %.290.i.i = fneg double %.266.i40.i
  %.295.i.i = fsub double 0xC00921FB54442D18, %.276.i41.i
  %.307.i.i = fcmp ugt double %.295.i.i, 0xC012D97C7F3321D2
  %e.3.0.i.i = select i1 %.307.i.i, double %.295.i.i, double 0x3FF921FB54442D18
  %.334.i42.i = fmul double %.82.i17.i, %.13.i2.i36.i
  %.336.i43.i = fsub double %.53.i15.i, %.334.i42.i
  %.341.i44.i = fmul double %.82.i17.i, %.290.i.i
  %.345.i45.i = fmul double %.1587.1.i, %.336.i43.i
  %.347.i46.i = fmul double %.1617.1.i, %.341.i44.i
  %.348.i47.i = fsub double %.345.i45.i, %.347.i46.i
  %.350.i48.i = fmul double %.1617.1.i, %.336.i43.i
  %.354.i49.i = fmul double %.1587.1.i, %.341.i44.i
  %.357.i50.i = fadd double %.350.i48.i, %.354.i49.i
  %.358.i51.i = tail call double @atan2(double %.348.i47.i, double %.357.i50.i)
  %.413.i58.i = fsub double %e.3.0.i.i, %.111.i19.i
  br label %B574.endif.1.i

B574.endif.1.i:                                   ; preds = %B266.endif.endif.i32.i, %B574.1.i
  %.358.sink.i65.i = phi double [ %.358.i51.i, %B266.endif.endif.i32.i ], [ 0x7FF8000000000000, %B574.1.i ]
  %.413.sink.i66.i = phi double [ %.413.i58.i, %B266.endif.endif.i32.i ], [ 0x7FF8000000000000, %B574.1.i ]
  %.1697.1.i = load double, ptr %.1542.i.i, align 8, !noalias !4
  %.1699.1.i = fsub double %.1697.1.i, %.358.sink.i65.i
  %.1701.1.i = fsub double %.1699.1.i, %.413.sink.i66.i
  %.1708.1.i = fcmp ogt double %.1701.1.i, 0x400921FB54442D18
  br i1 %.1708.1.i, label %B694.1.i, label %B742.1.i

B694.1.i:                                         ; preds = %B574.endif.1.i, %B694.1.i
  %t4.3.6.1.i = phi double [ %.1713.1.i, %B694.1.i ], [ %.1701.1.i, %B574.endif.1.i ]
  %.1713.1.i = fadd double %t4.3.6.1.i, 0xC01921FB54442D18
  %.1718.1.i = fcmp ogt double %.1713.1.i, 0x400921FB54442D18
  br i1 %.1718.1.i, label %B694.1.i, label %B742.1.i

B742.1.i:                                         ; preds = %B694.1.i, %B574.endif.1.i
  %t4.4.7.1.i = phi double [ %.1701.1.i, %B574.endif.1.i ], [ %.1713.1.i, %B694.1.i ]
  %.1732.1.i = fcmp ugt double %t4.4.7.1.i, 0xC00921FB54442D18
  br i1 %.1732.1.i, label %B816.1.i, label %B766.1.i

B766.1.i:                                         ; preds = %B742.1.i, %B766.1.i
  %t4.5.6.1.i = phi double [ %.1739.1.i, %B766.1.i ], [ %t4.4.7.1.i, %B742.1.i ]
  %.1739.1.i = fadd double %t4.5.6.1.i, 0x401921FB54442D18
  %.1745.1.i = fcmp ugt double %.1739.1.i, 0xC00921FB54442D18
  br i1 %.1745.1.i, label %B816.1.i, label %B766.1.i

B816.1.i:                                         ; preds = %B766.1.i, %B742.1.i
  %t4.6.7.1.i = phi double [ %t4.4.7.1.i, %B742.1.i ], [ %.1739.1.i, %B766.1.i ]
  %.1778.1.i = load double, ptr %.1572.i.i, align 8, !noalias !4
  %.1808.1.i = load double, ptr %.1602.i.i, align 8, !noalias !4
  store double %"$phi76.0.2.0.i.sink.i.i", ptr %.705, align 8, !noalias !4
  store double %.358.sink.i65.i, ptr %sunkaddr9.i, align 8, !noalias !4
  store double %.413.sink.i66.i, ptr %sunkaddr10.i17, align 8, !noalias !4
  store double %t4.6.7.1.i, ptr %sunkaddr11.i18, align 8, !noalias !4
  store double %.1778.1.i, ptr %sunkaddr12.i19, align 8, !noalias !4
  store double %.1808.1.i, ptr %sunkaddr13.i, align 8, !noalias !4
  %.2090.1.i = or disjoint i64 %.2088.i, 2
  %7 = mul i64 %.2090.1.i, %arg.q.5.2
  %.2132.1.i = select i1 %2, i64 %7, i64 0
  %.2134.1.i = getelementptr double, ptr %lsr.iv, i64 %.2132.1.i
  call fastcc void @part.2(ptr nonnull %.2177.i, ptr nonnull readonly %arg.arm.4, ptr nonnull %.705, ptr %.2134.1.i, i64 %arg.q.5.2)
  br label %B1003.i

B1005.i:                                          ; preds = %B1003.i, %B38.i
  br i1 %exitcond1137.not.i, label %part.3, label %B38.i

B372.lr.ph.i:                                     ; preds = %B470.endif.i.i, %B426.endif.i.i, %B272.endif.endif.endif.i.i
  %"$phi76.0.2.0.i.sink.i.i" = phi double [ %"$phi76.0.2.0.i.i.i", %B272.endif.endif.endif.i.i ], [ %"$phi96.0.2.0.i.i.i", %B470.endif.i.i ], [ %"$phi76.0.2.0.i4.i.i", %B426.endif.i.i ]
  %.174.sink.i.i = phi double [ %.174.i.i, %B272.endif.endif.endif.i.i ], [ %.380.i.i, %B470.endif.i.i ], [ %"$phi426.0.2.sroa.0.0.i.i", %B426.endif.i.i ]
  %.195.sink.i.i = phi double [ %.195.i.i, %B272.endif.endif.endif.i.i ], [ %.384.i.i, %B470.endif.i.i ], [ %"$phi426.0.2.sroa.8.0.i.i", %B426.endif.i.i ]
  %"$phi272.0.2.0.sink.i.i" = phi double [ %"$phi272.0.2.0.i.i", %B272.endif.endif.endif.i.i ], [ %.388.i.i, %B470.endif.i.i ], [ %sqrt.i.i, %B426.endif.i.i ]
  %.583.i = load double, ptr %.433132136, align 8, !noalias !4
  %.585.i = fmul double %.174.sink.i.i, %.583.i
  %.639.i = load double, ptr %.147.i1.i, align 8, !noalias !4
  %.641.i = fmul double %.195.sink.i.i, %.639.i
  %.642.i = fadd double %.585.i, %.641.i
  %.698.i = fmul double %.174.sink.i.i, %.639.i
  %.754.i = fmul double %.195.sink.i.i, %.583.i
  %.755.i = fsub double %.698.i, %.754.i
  %.809.i = load double, ptr %24, align 8, !noalias !4
  store double %.642.i, ptr %.1008, align 8, !noalias !4
  store double %.755.i, ptr %25, align 8, !noalias !4
  store double %.809.i, ptr %26, align 8, !noalias !4
  %.583.1.i = load double, ptr %.204.i.i, align 8, !noalias !4
  %.585.1.i = fmul double %.174.sink.i.i, %.583.1.i
  %.639.1.i = load double, ptr %.262.i.i, align 8, !noalias !4
  %.641.1.i = fmul double %.195.sink.i.i, %.639.1.i
  %.642.1.i = fadd double %.585.1.i, %.641.1.i
  %.698.1.i = fmul double %.174.sink.i.i, %.639.1.i
  %.754.1.i = fmul double %.195.sink.i.i, %.583.1.i
  %.755.1.i = fsub double %.698.1.i, %.754.1.i
  %.809.1.i = load double, ptr %.737.i.i16, align 8, !noalias !4
  store double %.642.1.i, ptr %sunkaddr34.i, align 8, !noalias !4
  store double %.755.1.i, ptr %sunkaddr35.i3, align 8, !noalias !4
  store double %.809.1.i, ptr %sunkaddr36.i, align 8, !noalias !4
  %.583.2.i = load double, ptr %.321.i.i, align 8, !noalias !4
  %.585.2.i = fmul double %.174.sink.i.i, %.583.2.i
  %.639.2.i = load double, ptr %.377.i.i, align 8, !noalias !4
  %.641.2.i = fmul double %.195.sink.i.i, %.639.2.i
  %.642.2.i = fadd double %.585.2.i, %.641.2.i
  %.698.2.i = fmul double %.174.sink.i.i, %.639.2.i
  %.754.2.i = fmul double %.195.sink.i.i, %.583.2.i
  %.755.2.i = fsub double %.698.2.i, %.754.2.i
  %.809.2.i = load double, ptr %.557.i.i, align 8, !noalias !4
  store double %.642.2.i, ptr %sunkaddr44.i7, align 8, !noalias !4
  store double %.755.2.i, ptr %sunkaddr46.i, align 8, !noalias !4
  store double %.809.2.i, ptr %sunkaddr48.i, align 8, !noalias !4
  %.2083.i = shl nuw nsw i64 %.21110321075.i, 2
  br label %B372.i

B574.endif.i:                                     ; preds = %B266.endif.endif.i.i, %B574.i
  %.358.sink.i.i = phi double [ %.358.i.i, %B266.endif.endif.i.i ], [ 0x7FF8000000000000, %B574.i ]
  %.413.sink.i.i = phi double [ %.413.i.i, %B266.endif.endif.i.i ], [ 0x7FF8000000000000, %B574.i ]
  %.1699.i = fsub double %.1501.i.i, %.358.sink.i.i
  %.1701.i = fsub double %.1699.i, %.413.sink.i.i
  %.1708.i = fcmp ogt double %.1701.i, 0x400921FB54442D18
  br i1 %.1708.i, label %B694.i, label %B742.i

part.3: ; preds = %B1005.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.2177.i)
  br label %B417

B350:                                             ; preds = %part.0
  call void @llvm.lifetime.start.p0(ptr nonnull %.1468.i)
  %.521600605.i = lshr i64 %.1866, 1
  %.562.i = and i64 %.521600605.i, 1
  %8 = and i64 %.1866, -9223372036854775807
  %9 = icmp slt i64 %.1866, 0
  %10 = icmp eq i64 %8, 1
  %11 = icmp eq i64 %8, 0
  br label %B38.us.i

B38.us.i:                                         ; preds = %B673.us.i, %B350
  %exitcond878.not.i = phi i1 [ true, %B673.us.i ], [ false, %B350 ]
  %.347.not.i.i20 = phi i1 [ false, %B673.us.i ], [ true, %B350 ]
  %.177666701.us.i = phi i64 [ 1, %B673.us.i ], [ 0, %B350 ]
  %.257.not.us.i = icmp eq i64 %.268973980.i, %.177666701.us.i
  %or.cond.us.i = or i1 %9, %.257.not.us.i
  br i1 %or.cond.us.i, label %B72.us.i, label %B673.us.i

B72.us.i:                                         ; preds = %B38.us.i
  %.292.us.i = load double, ptr %.635, align 8, !noalias !19
  %.322.us.i = load double, ptr %sunkaddr1.i, align 8, !noalias !19
  %.53.i.i21 = load double, ptr %sunkaddr.i10, align 8, !noalias !22
  %.59.i.i22 = fmul double %.292.us.i, %.292.us.i
  %.62.i.i23 = fmul double %.322.us.i, %.322.us.i
  %.63.i.i24 = fadd double %.59.i.i22, %.62.i.i23
  %sqrt.i.i25 = tail call double @llvm.sqrt.f64(double %.63.i.i24)
  %.73.i.i26 = fcmp une double %.53.i.i21, 0.000000e+00
  br i1 %.73.i.i26, label %B80.i.i99, label %B426.endif.i.i27

B80.i.i99:                                        ; preds = %B72.us.i
  %.76.i.i100 = tail call double @llvm.fabs.f64(double %.53.i.i21)
  %.78.i.i101 = fsub double %sqrt.i.i25, %.76.i.i100
  %.84.i.i102 = fcmp ult double %.78.i.i101, 0xBD719799812DEA11
  br i1 %.84.i.i102, label %B272.endif.endif.endif.i.i110, label %B140.endif.i.i103

B140.endif.i.i103:                                ; preds = %B80.i.i99
  %.12.i.i.i104 = fcmp olt double %.78.i.i101, 0.000000e+00
  %.13.i.i.i105 = select i1 %.12.i.i.i104, double 0.000000e+00, double %.78.i.i101
  %.122.i.i106 = fadd double %.76.i.i100, %sqrt.i.i25
  %.123.i.i107 = fmul double %.122.i.i106, %.13.i.i.i105
  %sqrt5.i.i108 = tail call double @llvm.sqrt.f64(double %.123.i.i107)
  %12 = fneg double %sqrt5.i.i108
  %.143.i.i109 = select i1 %.347.not.i.i20, double %sqrt5.i.i108, double %12
  br label %B272.endif.endif.endif.i.i110

B272.endif.endif.endif.i.i110:                    ; preds = %B140.endif.i.i103, %B80.i.i99
  %"$phi272.0.2.0.i.i111" = phi double [ %.143.i.i109, %B140.endif.i.i103 ], [ 0x7FF8000000000000, %B80.i.i99 ]
  %.163.i.i112 = fmul double %.292.us.i, %"$phi272.0.2.0.i.i111"
  %.166.i.i113 = fmul double %.322.us.i, %.53.i.i21
  %.167.i.i114 = fadd double %.166.i.i113, %.163.i.i112
  %.170.i.i115 = fmul double %sqrt.i.i25, %sqrt.i.i25
  %.174.i.i116 = fdiv double %.167.i.i114, %.170.i.i115
  %.176.i.i117 = fmul double %.322.us.i, %"$phi272.0.2.0.i.i111"
  %.181.i.i118 = fmul double %.292.us.i, %.53.i.i21
  %.186.i.i119 = fsub double %.176.i.i117, %.181.i.i118
  %.195.i.i120 = fdiv double %.186.i.i119, %.170.i.i115
  %.6.i.i.i121 = tail call double @atan2(double %.195.i.i120, double %.174.i.i116)
  %.12.i1.i.i122 = fcmp ole double %.6.i.i.i121, 0xC00921FB54442D18
  %"$phi76.0.2.0.i.i.i123" = select i1 %.12.i1.i.i122, double 0x400921FB54442D18, double %.6.i.i.i121
  br label %B72.endif.endif.endif.us.i

B426.endif.i.i27:                                 ; preds = %B72.us.i
  %.242.i.i28 = fcmp ult double %sqrt.i.i25, 0x3D719799812DEA11
  %.249.i.i29 = fdiv double %.292.us.i, %sqrt.i.i25
  %.257.i.i30 = fdiv double %.322.us.i, %sqrt.i.i25
  %"$phi426.0.2.sroa.8.0.i.i31" = select i1 %.242.i.i28, double 0.000000e+00, double %.257.i.i30
  %"$phi426.0.2.sroa.0.0.i.i32" = select i1 %.242.i.i28, double 1.000000e+00, double %.249.i.i29
  %.6.i2.i.i33 = tail call double @atan2(double %"$phi426.0.2.sroa.8.0.i.i31", double %"$phi426.0.2.sroa.0.0.i.i32")
  %.12.i3.i.i34 = fcmp ole double %.6.i2.i.i33, 0xC00921FB54442D18
  %"$phi76.0.2.0.i4.i.i35" = select i1 %.12.i3.i.i34, double 0x400921FB54442D18, double %.6.i2.i.i33
  br i1 %.347.not.i.i20, label %B72.endif.endif.endif.us.i, label %B470.endif.i.i36

B470.endif.i.i36:                                 ; preds = %B426.endif.i.i27
  %.9.i.i.i37 = fcmp ogt double %"$phi76.0.2.0.i4.i.i35", 0.000000e+00
  %"$phi54.0.2.0.v.i.i.i38" = select i1 %.9.i.i.i37, double 0xC00921FB54442D18, double 0x400921FB54442D18
  %"$phi54.0.2.0.i.i.i39" = fadd double %"$phi76.0.2.0.i4.i.i35", %"$phi54.0.2.0.v.i.i.i38"
  %.34.i.i.i40 = fcmp ole double %"$phi54.0.2.0.i.i.i39", 0xC00921FB54442D18
  %"$phi96.0.2.0.i.i.i41" = select i1 %.34.i.i.i40, double 0x400921FB54442D18, double %"$phi54.0.2.0.i.i.i39"
  %.380.i.i42 = fneg double %"$phi426.0.2.sroa.0.0.i.i32"
  %.384.i.i43 = fneg double %"$phi426.0.2.sroa.8.0.i.i31"
  %.388.i.i44 = fneg double %sqrt.i.i25
  br label %B72.endif.endif.endif.us.i

B72.endif.endif.endif.us.i:                       ; preds = %B470.endif.i.i36, %B426.endif.i.i27, %B272.endif.endif.endif.i.i110
  %"$phi76.0.2.0.i.sink.i.i45" = phi double [ %"$phi76.0.2.0.i.i.i123", %B272.endif.endif.endif.i.i110 ], [ %"$phi96.0.2.0.i.i.i41", %B470.endif.i.i36 ], [ %"$phi76.0.2.0.i4.i.i35", %B426.endif.i.i27 ]
  %.174.sink.i.i46 = phi double [ %.174.i.i116, %B272.endif.endif.endif.i.i110 ], [ %.380.i.i42, %B470.endif.i.i36 ], [ %"$phi426.0.2.sroa.0.0.i.i32", %B426.endif.i.i27 ]
  %.195.sink.i.i47 = phi double [ %.195.i.i120, %B272.endif.endif.endif.i.i110 ], [ %.384.i.i43, %B470.endif.i.i36 ], [ %"$phi426.0.2.sroa.8.0.i.i31", %B426.endif.i.i27 ]
  %"$phi272.0.2.0.sink.i.i48" = phi double [ %"$phi272.0.2.0.i.i111", %B272.endif.endif.endif.i.i110 ], [ %.388.i.i44, %B470.endif.i.i36 ], [ %sqrt.i.i25, %B426.endif.i.i27 ]
  %.1374.us.i = shl nuw nsw i64 %.177666701.us.i, 2
  br label %B174.us.i

B673.us.i:                                        ; preds = %B672.us.i, %B38.us.i
  br i1 %exitcond878.not.i, label %part.4, label %B38.us.i

B174.us.i:                                        ; preds = %B672.us.i, %B72.endif.endif.endif.us.i
  %exitcond.not.i49 = phi i1 [ false, %B72.endif.endif.endif.us.i ], [ true, %B672.us.i ]
  %.285.not.i.i = phi i1 [ true, %B72.endif.endif.endif.us.i ], [ false, %B672.us.i ]
  %.464636654.us.i = phi i64 [ 0, %B72.endif.endif.endif.us.i ], [ 1, %B672.us.i ]
  %.584.not.us.i = icmp eq i64 %.562.i, %.464636654.us.i
  %or.cond.i50 = or i1 %9, %.584.not.us.i
  br i1 %or.cond.i50, label %B214.us.i, label %B672.us.i

B214.us.i:                                        ; preds = %B174.us.i
  %.619.us.i = load double, ptr %arg.arm.4, align 8, !noalias !19
  %.621.us.i = fsub double %"$phi272.0.2.0.sink.i.i48", %.619.us.i
  %.651.us.i = load double, ptr %sunkaddr2.i11, align 8, !noalias !19
  %.681.us.i = load double, ptr %sunkaddr3.i12, align 8, !noalias !19
  %.682.us.i = fsub double %.651.us.i, %.681.us.i
  %.53.i15.i51 = load double, ptr %sunkaddr4.i13, align 8, !noalias !25
  %.82.i.i52 = load double, ptr %sunkaddr5.i14, align 8, !noalias !25
  %.111.i.i53 = load double, ptr %sunkaddr6.i15, align 8, !noalias !25
  %.126.i.i54 = fmul double %.621.us.i, %.621.us.i
  %.129.i.i55 = fmul double %.682.us.i, %.682.us.i
  %.130.i.i56 = fadd double %.126.i.i54, %.129.i.i55
  %.136.i.i57 = fmul double %.53.i15.i51, %.53.i15.i51
  %.139.i.i58 = fmul double %.82.i.i52, %.82.i.i52
  %.140.i.i59 = fadd double %.136.i.i57, %.139.i.i58
  %.142.i16.i = fsub double %.140.i.i59, %.130.i.i56
  %.145.i.i60 = fmul double %.53.i15.i51, 2.000000e+00
  %.147.i.i61 = fmul double %.145.i.i60, %.82.i.i52
  %.151.i.i62 = fdiv double %.142.i16.i, %.147.i.i61
  %.156.i.i63 = tail call double @llvm.fabs.f64(double %.151.i.i62)
  %.159.i.i64 = fcmp ugt double %.156.i.i63, 0x3FF0000000001198
  br i1 %.159.i.i64, label %B214.endif.us.i, label %B266.endif.endif.i.i65

B410.i.i:                                         ; preds = %B266.endif.endif.i.i65
  %.290.i.i72 = fneg double %.266.i.i70
  %.295.i.i73 = fsub double 0xC00921FB54442D18, %.276.i.i71
  %.307.i.i74 = fcmp ugt double %.295.i.i73, 0xC012D97C7F3321D2
  br i1 %.307.i.i74, label %B486.i.i, label %B466.i.i

B466.i.i:                                         ; preds = %B410.i.i
  br label %B486.i.i

B486.i.i:                                         ; preds = %B266.endif.endif.i.i65, %B466.i.i, %B410.i.i
  %c3.3.0.i.i = phi double [ %.290.i.i72, %B466.i.i ], [ %.290.i.i72, %B410.i.i ], [ %.266.i.i70, %B266.endif.endif.i.i65 ]
  %e.3.0.i.i75 = phi double [ 0x3FF921FB54442D18, %B466.i.i ], [ %.295.i.i73, %B410.i.i ], [ %.276.i.i71, %B266.endif.endif.i.i65 ]
  %.334.i.i76 = fmul double %.82.i.i52, %.13.i2.i.i66
  %.336.i.i77 = fsub double %.53.i15.i51, %.334.i.i76
  %.341.i.i78 = fmul double %.82.i.i52, %c3.3.0.i.i
  %.345.i.i79 = fmul double %.621.us.i, %.336.i.i77
  %.347.i.i80 = fmul double %.682.us.i, %.341.i.i78
  %.348.i.i81 = fsub double %.345.i.i79, %.347.i.i80
  %.350.i.i82 = fmul double %.682.us.i, %.336.i.i77
  %.354.i.i83 = fmul double %.621.us.i, %.341.i.i78
  %.357.i.i84 = fadd double %.350.i.i82, %.354.i.i83
  %.358.i.i85 = tail call double @atan2(double %.348.i.i81, double %.357.i.i84)
  %.366.i.i = fdiv double %.348.i.i81, %.130.i.i56
  %.371.i.i = fdiv double %.357.i.i84, %.130.i.i56
  %.382.i.i = fcmp une double %.111.i.i53, 0.000000e+00
  br i1 %.382.i.i, label %B620.i.i, label %B724.i.i

B620.i.i:                                         ; preds = %B486.i.i
  %.385.i.i = tail call double @llvm.cos.f64(double %.111.i.i53)
  %.387.i.i = tail call double @llvm.sin.f64(double %.111.i.i53)
  %.389.i.i = fmul double %.385.i.i, %c3.3.0.i.i
  %.391.i.i = fmul double %.387.i.i, %.13.i2.i.i66
  %.392.i.i = fadd double %.391.i.i, %.389.i.i
  %.394.i.i = fmul double %.385.i.i, %.13.i2.i.i66
  %.398.i.i = fmul double %.387.i.i, %c3.3.0.i.i
  %.401.i.i = fsub double %.394.i.i, %.398.i.i
  br label %B724.i.i

B724.i.i:                                         ; preds = %B620.i.i, %B486.i.i
  %s3.3.0.i.i = phi double [ %.401.i.i, %B620.i.i ], [ %.13.i2.i.i66, %B486.i.i ]
  %c3.4.0.i.i = phi double [ %.392.i.i, %B620.i.i ], [ %c3.3.0.i.i, %B486.i.i ]
  %.413.i.i86 = fsub double %e.3.0.i.i75, %.111.i.i53
  %.420.i.i = fmul double %.371.i.i, %c3.4.0.i.i
  %.423.i.i87 = fmul double %.366.i.i, %s3.3.0.i.i
  %.424.i.i88 = fsub double %.420.i.i, %.423.i.i87
  %.427.i.i = fmul double %.366.i.i, %c3.4.0.i.i
  %.434.i.i = fmul double %.371.i.i, %s3.3.0.i.i
  %.439.i.i = fadd double %.434.i.i, %.427.i.i
  br label %B214.endif.us.i

B266.endif.endif.i.i65:                           ; preds = %B214.us.i
  %.12.i.i17.i = fcmp ogt double %.151.i.i62, 1.000000e+00
  %.13.i.i18.i = select i1 %.12.i.i17.i, double 1.000000e+00, double %.151.i.i62
  %.12.i1.i19.i = fcmp olt double %.13.i.i18.i, -1.000000e+00
  %.13.i2.i.i66 = select i1 %.12.i1.i19.i, double -1.000000e+00, double %.13.i.i18.i
  %.261.i.i67 = fsub double 1.000000e+00, %.13.i2.i.i66
  %.264.i.i68 = fadd double %.13.i2.i.i66, 1.000000e+00
  %.265.i.i69 = fmul double %.261.i.i67, %.264.i.i68
  %.266.i.i70 = tail call double @sqrt(double %.265.i.i69)
  %.276.i.i71 = tail call double @atan2(double %.13.i2.i.i66, double %.266.i.i70)
  br i1 %.285.not.i.i, label %B486.i.i, label %B410.i.i

B214.endif.us.i:                                  ; preds = %B724.i.i, %B214.us.i
  %.358.sink.i.i89 = phi double [ %.358.i.i85, %B724.i.i ], [ 0x7FF8000000000000, %B214.us.i ]
  %.413.sink.i.i90 = phi double [ %.413.i.i86, %B724.i.i ], [ 0x7FF8000000000000, %B214.us.i ]
  %.424.sink.i.i = phi double [ %.424.i.i88, %B724.i.i ], [ 0x7FF8000000000000, %B214.us.i ]
  %.439.sink.i.i = phi double [ %.439.i.i, %B724.i.i ], [ 0x7FF8000000000000, %B214.us.i ]
  %.91.i.i = load double, ptr %.433132136, align 8, !noalias !28
  %.95.i.i = fmul double %.174.sink.i.i46, %.91.i.i
  %.149.i.i = load double, ptr %.147.i1.i, align 8, !noalias !28
  %.151.i2.i = fmul double %.195.sink.i.i47, %.149.i.i
  %.152.i.i = fadd double %.95.i.i, %.151.i2.i
  %.206.i.i = load double, ptr %.204.i.i, align 8, !noalias !28
  %.208.i.i = fmul double %.174.sink.i.i46, %.206.i.i
  %.264.i3.i = load double, ptr %.262.i.i, align 8, !noalias !28
  %.268.i.i = fmul double %.195.sink.i.i47, %.264.i3.i
  %.269.i.i = fadd double %.208.i.i, %.268.i.i
  %.323.i.i = load double, ptr %.321.i.i, align 8, !noalias !28
  %.325.i.i = fmul double %.174.sink.i.i46, %.323.i.i
  %.379.i.i = load double, ptr %.377.i.i, align 8, !noalias !28
  %.381.i.i = fmul double %.195.sink.i.i47, %.379.i.i
  %.382.i4.i = fadd double %.325.i.i, %.381.i.i
  %.444.i.i = fmul double %.174.sink.i.i46, %.379.i.i
  %.500.i.i = fmul double %.195.sink.i.i47, %.323.i.i
  %.501.i.i = fsub double %.444.i.i, %.500.i.i
  %.503.i.i = fmul double %.439.sink.i.i, %.382.i4.i
  %.559.i.i = load double, ptr %.557.i.i, align 8, !noalias !28
  %.563.i.i91 = fmul double %.424.sink.i.i, %.559.i.i
  %.564.i.i92 = fadd double %.563.i.i91, %.503.i.i
  %.565.i.i = fmul double %.564.i.i92, %.564.i.i92
  %.566.i.i93 = fmul double %.501.i.i, %.501.i.i
  %.567.i.i = fadd double %.566.i.i93, %.565.i.i
  %sqrt.i5.i = tail call double @llvm.sqrt.f64(double %.567.i.i)
  %.573.i.i94 = fneg double %.564.i.i92
  %.6.i.i6.i = tail call double @atan2(double %.501.i.i, double %.573.i.i94)
  %.12.i.i7.i95 = fcmp ole double %.6.i.i6.i, 0xC00921FB54442D18
  %"$phi76.0.2.0.i.i8.i" = select i1 %.12.i.i7.i95, double 0x400921FB54442D18, double %.6.i.i6.i
  %.601.i.i = fmul double %.424.sink.i.i, %.382.i4.i
  %.661.i.i = fmul double %.439.sink.i.i, %.559.i.i
  %.662.i.i = fsub double %.601.i.i, %.661.i.i
  %.664.i.i = tail call double @atan2(double %sqrt.i5.i, double %.662.i.i)
  %.672.i.i = fcmp olt double %sqrt.i5.i, 1.000000e-03
  br i1 %.672.i.i, label %B486.i9.i, label %B388.endif.i.i

B486.i9.i:                                        ; preds = %B214.endif.us.i
  %.871.i.i = fcmp olt double %sqrt.i5.i, 0x3D719799812DEA11
  br i1 %.871.i.i, label %B508.i.i, label %B542.endif.i.i

B508.i.i:                                         ; preds = %B486.i9.i
  %.881.i.i = fcmp olt double %.664.i.i, 1.000000e+00
  br i1 %.881.i.i, label %B542.endif.i.i, label %B526.i.i

B526.i.i:                                         ; preds = %B508.i.i
  br label %B542.endif.i.i

B388.endif.i.i:                                   ; preds = %B214.endif.us.i
  %.683.i.i = fmul double %.424.sink.i.i, %.269.i.i
  %.739.i.i = load double, ptr %.737.i.i16, align 8, !noalias !28
  %.741.i.i = fmul double %.439.sink.i.i, %.739.i.i
  %.742.i.i = fsub double %.683.i.i, %.741.i.i
  %.796.i.i96 = load double, ptr %24, align 8, !noalias !28
  %.805.i.i97 = fmul double %.439.sink.i.i, %.796.i.i96
  %.810.i.i = fmul double %.424.sink.i.i, %.152.i.i
  %.815.i.i = fsub double %.805.i.i97, %.810.i.i
  %.6.i1.i.i = tail call double @atan2(double %.742.i.i, double %.815.i.i)
  br label %part.5

B542.endif.i.i:                                   ; preds = %B526.i.i, %B508.i.i, %B486.i9.i
  %t5.2.0.i.i98 = phi double [ %.664.i.i, %B486.i9.i ], [ 0x400921FB54442D18, %B526.i.i ], [ 0.000000e+00, %B508.i.i ]
  %t4.2.0.i.i = phi double [ %"$phi76.0.2.0.i.i8.i", %B486.i9.i ], [ 0.000000e+00, %B526.i.i ], [ 0.000000e+00, %B508.i.i ]
  %.909.i.i = tail call double @llvm.cos.f64(double %t4.2.0.i.i)
  %.911.i.i = tail call double @llvm.sin.f64(double %t4.2.0.i.i)
  %.967.i.i = fmul double %.174.sink.i.i46, %.149.i.i
  %.1027.i.i = fmul double %.195.sink.i.i47, %.91.i.i
  %.1028.i.i = fsub double %.967.i.i, %.1027.i.i
  %.1029.i.i = fmul double %.1028.i.i, %.909.i.i
  %.1032.i.i = fmul double %.439.sink.i.i, %.152.i.i
  %.1088.i.i = load double, ptr %24, align 8, !noalias !28
  %.1090.i.i = fmul double %.424.sink.i.i, %.1088.i.i
  %.1091.i.i = fadd double %.1032.i.i, %.1090.i.i
  %.1092.i.i = fmul double %.911.i.i, %.1091.i.i
  %.1093.i.i = fadd double %.1029.i.i, %.1092.i.i
  %.1153.i.i = fmul double %.174.sink.i.i46, %.264.i3.i
  %.1211.i.i = fmul double %.195.sink.i.i47, %.206.i.i
  %.1214.i.i = fsub double %.1153.i.i, %.1211.i.i
  %.1215.i.i = fmul double %.1214.i.i, %.909.i.i
  %.1218.i.i = fmul double %.439.sink.i.i, %.269.i.i
  %.1276.i.i = load double, ptr %.737.i.i16, align 8, !noalias !28
  %.1285.i.i = fmul double %.424.sink.i.i, %.1276.i.i
  %.1288.i.i = fadd double %.1218.i.i, %.1285.i.i
  %.1289.i.i = fmul double %.911.i.i, %.1288.i.i
  %.1290.i.i = fadd double %.1215.i.i, %.1289.i.i
  %.6.i4.i.i = tail call double @atan2(double %.1093.i.i, double %.1290.i.i)
  br label %part.5

part.5: ; preds = %B542.endif.i.i, %B388.endif.i.i
  %.6.i4.sink7.i.i = phi double [ %.6.i4.i.i, %B542.endif.i.i ], [ %.6.i1.i.i, %B388.endif.i.i ]
  %t4.2.0.sink.i.i = phi double [ %t4.2.0.i.i, %B542.endif.i.i ], [ %"$phi76.0.2.0.i.i8.i", %B388.endif.i.i ]
  %t5.2.0.sink.i.i = phi double [ %t5.2.0.i.i98, %B542.endif.i.i ], [ %.664.i.i, %B388.endif.i.i ]
  %.12.i5.i.i = fcmp ole double %.6.i4.sink7.i.i, 0xC00921FB54442D18
  %"$phi76.0.2.0.i6.i.i" = select i1 %.12.i5.i.i, double 0x400921FB54442D18, double %.6.i4.sink7.i.i
  %.1208.us.i = fneg double %t5.2.0.sink.i.i
  %.1376.us.i = shl nuw nsw i64 %.464636654.us.i, 1
  %.1377.us.i = or disjoint i64 %.1376.us.i, %.1374.us.i
  %.1379.fr.us.i = freeze i64 %.1377.us.i
  br i1 %10, label %B576.us.1.i, label %B576.us.i

B672.us.i:                                        ; preds = %B636.thread.us.1.i, %B636.thread.us.i, %B174.us.i
  br i1 %exitcond.not.i49, label %B673.us.i, label %B174.us.i

B576.us.i:                                        ; preds = %part.5
  store double %"$phi76.0.2.0.i.sink.i.i45", ptr %.705, align 8, !noalias !19
  store double %.358.sink.i.i89, ptr %sunkaddr9.i, align 8, !noalias !19
  store double %.413.sink.i.i90, ptr %sunkaddr10.i17, align 8, !noalias !19
  store double %t4.2.0.sink.i.i, ptr %sunkaddr11.i18, align 8, !noalias !19
  store double %t5.2.0.sink.i.i, ptr %sunkaddr12.i19, align 8, !noalias !19
  store double %"$phi76.0.2.0.i6.i.i", ptr %sunkaddr13.i, align 8, !noalias !19
  br i1 %9, label %B636.us.i, label %B636.thread.us.i

B636.us.i:                                        ; preds = %B576.us.i
  %.1404.us.i = icmp slt i64 %.1379.fr.us.i, 0
  %.1405.us.i = select i1 %.1404.us.i, i64 %arg.q.5.1, i64 0
  %spec.select.us.i = add i64 %.1405.us.i, %.1379.fr.us.i
  %13 = mul i64 %spec.select.us.i, %arg.q.5.2
  br label %B636.thread.us.i

B636.thread.us.i:                                 ; preds = %B636.us.i, %B576.us.i
  %.1423.us.i = phi i64 [ 0, %B576.us.i ], [ %13, %B636.us.i ]
  %.1425.us.i = getelementptr double, ptr %lsr.iv, i64 %.1423.us.i
  call fastcc void @part.2(ptr nonnull %.1468.i, ptr nonnull readonly %arg.arm.4, ptr nonnull %.705, ptr %.1425.us.i, i64 %arg.q.5.2)
  br i1 %11, label %B672.us.i, label %B576.us.1.i

B576.us.1.i:                                      ; preds = %B636.thread.us.i, %part.5
  store double %"$phi76.0.2.0.i.sink.i.i45", ptr %.705, align 8, !noalias !19
  store double %.358.sink.i.i89, ptr %sunkaddr9.i, align 8, !noalias !19
  store double %.413.sink.i.i90, ptr %sunkaddr10.i17, align 8, !noalias !19
  %.9.i.i = fcmp ogt double %t4.2.0.sink.i.i, 0.000000e+00
  %"$phi54.0.2.0.v.i.i" = select i1 %.9.i.i, double 0xC00921FB54442D18, double 0x400921FB54442D18
  %"$phi54.0.2.0.i.i" = fadd double %t4.2.0.sink.i.i, %"$phi54.0.2.0.v.i.i"
  %.34.i.i = fcmp ole double %"$phi54.0.2.0.i.i", 0xC00921FB54442D18
  %"$phi96.0.2.0.i.i" = select i1 %.34.i.i, double 0x400921FB54442D18, double %"$phi54.0.2.0.i.i"
  %.9.i20.i = fcmp ogt double %"$phi76.0.2.0.i6.i.i", 0.000000e+00
  %"$phi54.0.2.0.v.i21.i" = select i1 %.9.i20.i, double 0xC00921FB54442D18, double 0x400921FB54442D18
  %"$phi54.0.2.0.i22.i" = fadd double %"$phi76.0.2.0.i6.i.i", %"$phi54.0.2.0.v.i21.i"
  %.34.i23.i = fcmp ole double %"$phi54.0.2.0.i22.i", 0xC00921FB54442D18
  %"$phi96.0.2.0.i24.i" = select i1 %.34.i23.i, double 0x400921FB54442D18, double %"$phi54.0.2.0.i22.i"
  store double %"$phi96.0.2.0.i.i", ptr %sunkaddr11.i18, align 8, !noalias !19
  store double %.1208.us.i, ptr %sunkaddr12.i19, align 8, !noalias !19
  store double %"$phi96.0.2.0.i24.i", ptr %sunkaddr13.i, align 8, !noalias !19
  br i1 %9, label %B636.us.1.i, label %B636.thread.us.1.i

B636.us.1.i:                                      ; preds = %B576.us.1.i
  %.1379.us.1.i = add i64 %.1379.fr.us.i, 1
  %.1404.us.1.i = icmp slt i64 %.1379.us.1.i, 0
  %.1405.us.1.i = select i1 %.1404.us.1.i, i64 %arg.q.5.1, i64 0
  %spec.select.us.1.i = add i64 %.1405.us.1.i, %.1379.us.1.i
  %14 = mul i64 %spec.select.us.1.i, %arg.q.5.2
  br label %B636.thread.us.1.i

B636.thread.us.1.i:                               ; preds = %B636.us.1.i, %B576.us.1.i
  %.1423.us.1.i = phi i64 [ 0, %B576.us.1.i ], [ %14, %B636.us.1.i ]
  %.1425.us.1.i = getelementptr double, ptr %lsr.iv, i64 %.1423.us.1.i
  call fastcc void @part.2(ptr nonnull %.1468.i, ptr nonnull readonly %arg.arm.4, ptr nonnull %.705, ptr %.1425.us.1.i, i64 %arg.q.5.2)
  br label %B672.us.i

part.4: ; preds = %B673.us.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.1468.i)
  br label %B417

B416:                                             ; preds = %B417, %B0.endif.endif.endif.endif.endif.else.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B417:                                             ; preds = %part.4, %part.3
  %scevgep = getelementptr i8, ptr %lsr.iv, i64 %21
  %scevgep24 = getelementptr i8, ptr %lsr.iv23, i64 %arg.cfx.6.0
  %scevgep26 = getelementptr i8, ptr %lsr.iv25, i64 %arg.X_WF.6.0
  %scevgep28 = getelementptr i8, ptr %lsr.iv27, i64 %arg.way.6.0
  %lsr.iv.next = add nsw i64 %lsr.iv29, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond.not, label %B416, label %B188

B0.endif.else.endif.endif.endif:                  ; preds = %B0.else.endif
  %.349 = icmp samesign ult i64 %arg.room.5.1, 4
  %.429129144 = mul i64 %.211.sroa.0.3669, %arg.room.5.1
  %15 = getelementptr double, ptr %arg.room.4, i64 %.429129144
  br label %B0.endif.endif.endif.else.endif

B0.endif.endif.else.endif.endif.endif.thread:     ; preds = %B0.else.endif
  %.429 = mul i64 %.211.sroa.0.3669, %arg.room.5.1
  %16 = getelementptr double, ptr %arg.room.4, i64 %.429
  %.433 = getelementptr double, ptr %16, i64 %arg.room.5.1
  br label %B0.endif.endif.endif.else.endif

B0.endif.endif.endif.else.endif:                  ; preds = %B0.endif.else.endif.endif.endif, %B0.endif.endif.else.endif.endif.endif.thread
  %.514.sroa.0.3140 = phi i64 [ 0, %B0.endif.else.endif.endif.endif ], [ %arg.room.5.1, %B0.endif.endif.else.endif.endif.endif.thread ]
  %.349677131138 = phi i1 [ %.349, %B0.endif.else.endif.endif.endif ], [ true, %B0.endif.endif.else.endif.endif.endif.thread ]
  %.433132136 = phi ptr [ %15, %B0.endif.else.endif.endif.endif ], [ %.433, %B0.endif.endif.else.endif.endif.endif.thread ]
  %.idx = mul i64 %arg.room.5.1, 24
  %17 = getelementptr i8, ptr %arg.room.4, i64 %.idx
  %.635 = getelementptr double, ptr %17, i64 %.514.sroa.0.3140
  %.705.idx = shl i64 %arg.room.5.1, 5
  %.705 = getelementptr i8, ptr %arg.room.4, i64 %.705.idx
  br i1 %.231, label %B0.endif.endif.endif.else.endif.if, label %B0.endif.endif.endif.else.endif.endif.endif, !prof !0

B0.endif.endif.endif.else.endif.if:               ; preds = %B0.endif.endif.endif.else.endif
  %18 = mul i64 %arg.room.5.1, %arg.room.5.0
  br label %B0.endif.endif.endif.else.endif.endif.endif

B0.endif.endif.endif.else.endif.endif.endif:      ; preds = %B0.endif.endif.endif.else.endif.if, %B0.endif.endif.endif.else.endif
  %.786.sroa.0.3 = phi i64 [ %18, %B0.endif.endif.endif.else.endif.if ], [ 0, %B0.endif.endif.endif.else.endif ]
  br i1 %.349677131138, label %B0.endif.endif.endif.endif.else.endif.if, label %B0.endif.endif.endif.endif.endif.else.endif, !prof !0

B0.endif.endif.endif.endif.else.endif.if:         ; preds = %B0.endif.endif.endif.else.endif.endif.endif
  br label %B0.endif.endif.endif.endif.endif.else.endif

B0.endif.endif.endif.endif.endif.else.endif:      ; preds = %B0.endif.endif.endif.endif.else.endif.if, %B0.endif.endif.endif.else.endif.endif.endif
  %.887.sroa.0.3 = phi i64 [ %arg.room.5.1, %B0.endif.endif.endif.endif.else.endif.if ], [ 3, %B0.endif.endif.endif.else.endif.endif.endif ]
  %19 = getelementptr double, ptr %arg.room.4, i64 %.786.sroa.0.3
  %.1008 = getelementptr double, ptr %19, i64 %.887.sroa.0.3
  %.1089.sroa.0.3681 = select i1 %.332, i64 %arg.room.5.1, i64 0, !prof !0
  %.idx651 = mul i64 %arg.room.5.1, 40
  %20 = getelementptr i8, ptr %arg.room.4, i64 %.idx651
  %.1210 = getelementptr double, ptr %20, i64 %.1089.sroa.0.3681
  %.1540660.not = icmp slt i64 %arg.X_WF.5.0, 1
  br i1 %.1540660.not, label %B416, label %B188.lr.ph

B188.lr.ph:                                       ; preds = %B0.endif.endif.endif.endif.endif.else.endif
  %.2096 = shl i64 %arg.q.5.1, 3
  %21 = mul i64 %.2096, %arg.q.5.2
  %22 = getelementptr i8, ptr %arg.X_FK.4, i64 %arg.X_FK.6.0
  %.763.i = shl i64 %arg.X_WF.6.2, 1
  %.817.i = shl i64 %arg.X_FK.6.0, 1
  %23 = getelementptr i8, ptr %arg.X_FK.4, i64 %.817.i
  %.885.i = mul i64 %arg.X_WF.6.2, 3
  %.940.i = mul i64 %arg.X_WC.6.1, 3
  %invariant.gep453.i = getelementptr i8, ptr %arg.X_WC.4, i64 %.940.i
  %.595.us.us.3.i = mul i64 %arg.X_FK.6.1, 3
  %sunkaddr5.i = shl i64 %arg.X_WF.6.1, 1
  %sunkaddr25.i = shl i64 %arg.X_WC.6.0, 1
  %sunkaddr37.i = getelementptr i8, ptr %arg.X_FK.4, i64 %arg.X_FK.6.1
  %sunkaddr42.i = getelementptr i8, ptr %22, i64 %arg.X_FK.6.1
  %sunkaddr43.i = getelementptr i8, ptr %23, i64 %arg.X_FK.6.1
  %sunkaddr44.i = shl i64 %arg.X_FK.6.1, 1
  %sunkaddr45.i = getelementptr i8, ptr %23, i64 %sunkaddr44.i
  %sunkaddr47.i = getelementptr i8, ptr %22, i64 %sunkaddr44.i
  %sunkaddr49.i = getelementptr i8, ptr %arg.X_FK.4, i64 %sunkaddr44.i
  %sunkaddr50.i = shl i64 %arg.room.6.1, 1
  %sunkaddr52.i = getelementptr i8, ptr %23, i64 %.595.us.us.3.i
  %sunkaddr53.i = getelementptr i8, ptr %22, i64 %.595.us.us.3.i
  %sunkaddr54.i = getelementptr i8, ptr %arg.X_FK.4, i64 %.595.us.us.3.i
  %sunkaddr55.i = getelementptr i8, ptr %invariant.gep453.i, i64 %arg.X_WC.6.0
  %sunkaddr60.i = getelementptr i8, ptr %invariant.gep453.i, i64 %sunkaddr25.i
  %sunkaddr61.i = shl i64 %arg.way.6.1, 1
  %sunkaddr63.i = getelementptr i8, ptr %arg.arm.4, i64 56
  %sunkaddr = getelementptr i8, ptr %arg.arm.4, i64 80
  %sunkaddr1.i = getelementptr i8, ptr %.635, i64 8
  %sunkaddr.i10 = getelementptr i8, ptr %arg.arm.4, i64 8
  %sunkaddr2.i11 = getelementptr i8, ptr %.635, i64 16
  %sunkaddr3.i12 = getelementptr i8, ptr %arg.arm.4, i64 16
  %sunkaddr4.i13 = getelementptr i8, ptr %arg.arm.4, i64 24
  %sunkaddr5.i14 = getelementptr i8, ptr %arg.arm.4, i64 40
  %sunkaddr6.i15 = getelementptr i8, ptr %arg.arm.4, i64 48
  %.147.i1.i = getelementptr i8, ptr %.433132136, i64 %arg.room.6.0
  %.204.i.i = getelementptr i8, ptr %.433132136, i64 %arg.room.6.1
  %.262.i.i = getelementptr i8, ptr %.147.i1.i, i64 %arg.room.6.1
  %.321.i.i = getelementptr i8, ptr %.433132136, i64 %sunkaddr50.i
  %.377.i.i = getelementptr i8, ptr %.147.i1.i, i64 %sunkaddr50.i
  %.553.i.i = shl i64 %arg.room.6.0, 1
  %24 = getelementptr i8, ptr %.433132136, i64 %.553.i.i
  %.557.i.i = getelementptr i8, ptr %24, i64 %sunkaddr50.i
  %.737.i.i16 = getelementptr i8, ptr %24, i64 %arg.room.6.1
  %sunkaddr9.i = getelementptr i8, ptr %.705, i64 8
  %sunkaddr10.i17 = getelementptr i8, ptr %.705, i64 16
  %sunkaddr11.i18 = getelementptr i8, ptr %.705, i64 24
  %sunkaddr12.i19 = getelementptr i8, ptr %.705, i64 32
  %sunkaddr13.i = getelementptr i8, ptr %.705, i64 40
  %25 = getelementptr i8, ptr %.1008, i64 %arg.room.6.0
  %26 = getelementptr i8, ptr %.1008, i64 %.553.i.i
  %sunkaddr34.i = getelementptr i8, ptr %.1008, i64 %arg.room.6.1
  %sunkaddr35.i3 = getelementptr i8, ptr %25, i64 %arg.room.6.1
  %sunkaddr36.i = getelementptr i8, ptr %26, i64 %arg.room.6.1
  %sunkaddr44.i7 = getelementptr i8, ptr %.1008, i64 %sunkaddr50.i
  %sunkaddr46.i = getelementptr i8, ptr %25, i64 %sunkaddr50.i
  %sunkaddr48.i = getelementptr i8, ptr %26, i64 %sunkaddr50.i
  %.89.i.i = getelementptr i8, ptr %arg.arm.4, i64 64
  %.119.i.i = getelementptr i8, ptr %arg.arm.4, i64 72
  %.638.i.i = getelementptr i8, ptr %arg.arm.4, i64 32
  %.1497.i.i = getelementptr i8, ptr %.1210, i64 8
  %.1542.i.i = getelementptr i8, ptr %.1210, i64 16
  %.1572.i.i = getelementptr i8, ptr %.1210, i64 24
  %.1602.i.i = getelementptr i8, ptr %.1210, i64 32
  br label %B188
}

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.start.p0(ptr captures(none)) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sqrt.f64(double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #2

; Function Attrs: mustprogress nofree nosync nounwind willreturn memory(none)
declare double @atan2(double, double) local_unnamed_addr #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.copysign.f64(double, double) #2

; Function Attrs: mustprogress nofree nosync nounwind willreturn memory(none)
declare double @acos(double) local_unnamed_addr #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.cos.f64(double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sin.f64(double) #2

; Function Attrs: mustprogress nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #3

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @part.2(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.arm.4, ptr captures(none) %arg.t.4, ptr writeonly captures(none) %arg.q.4, i64 %arg.q.5.0) unnamed_addr #0 {
B0.endif.endif:
  %.194 = load double, ptr %arg.t.4, align 8
  %0 = tail call double @llvm.fabs.f64(double %.194)
  %1 = fcmp ueq double %0, 0x7FF0000000000000
  br i1 %1, label %B108.else.endif, label %B34

B34:                                              ; preds = %B0.endif.endif
  %2 = getelementptr i8, ptr %arg.t.4, i64 8
  %.194.1 = load double, ptr %2, align 8
  %3 = tail call double @llvm.fabs.f64(double %.194.1)
  %4 = fcmp ueq double %3, 0x7FF0000000000000
  br i1 %4, label %B108.else.endif, label %B34.1

B34.1:                                            ; preds = %B34
  %5 = getelementptr i8, ptr %arg.t.4, i64 16
  %.194.2 = load double, ptr %5, align 8
  %6 = tail call double @llvm.fabs.f64(double %.194.2)
  %7 = fcmp ueq double %6, 0x7FF0000000000000
  br i1 %7, label %B108.else.endif, label %B34.2

B34.2:                                            ; preds = %B34.1
  %8 = getelementptr i8, ptr %arg.t.4, i64 24
  %.194.3 = load double, ptr %8, align 8
  %9 = tail call double @llvm.fabs.f64(double %.194.3)
  %10 = fcmp ueq double %9, 0x7FF0000000000000
  br i1 %10, label %B108.else.endif, label %B34.3

B34.3:                                            ; preds = %B34.2
  %11 = getelementptr i8, ptr %arg.t.4, i64 32
  %.194.4 = load double, ptr %11, align 8
  %12 = tail call double @llvm.fabs.f64(double %.194.4)
  %13 = fcmp ueq double %12, 0x7FF0000000000000
  br i1 %13, label %B108.else.endif, label %B34.4

B34.4:                                            ; preds = %B34.3
  %14 = getelementptr i8, ptr %arg.t.4, i64 40
  %.194.5 = load double, ptr %14, align 8
  %15 = tail call double @llvm.fabs.f64(double %.194.5)
  %16 = fcmp ueq double %15, 0x7FF0000000000000
  br i1 %16, label %B108.else.endif, label %B34.5

B34.5:                                            ; preds = %B34.4
  %.580 = getelementptr i8, ptr %arg.arm.4, i64 88
  %.581 = load double, ptr %.580, align 8
  %.640 = getelementptr i8, ptr %arg.arm.4, i64 136
  %.641 = load double, ptr %.640, align 8
  %.642 = fsub double %.194.1, %.641
  %.643 = fmul double %.581, %.642
  %.644 = fadd double %.194.2, %.643
  store double %.644, ptr %5, align 8
  store double %.194, ptr %arg.q.4, align 8
  %17 = getelementptr i8, ptr %arg.arm.4, i64 112
  %.955 = load double, ptr %17, align 8
  %18 = getelementptr i8, ptr %arg.arm.4, i64 120
  %.988 = load double, ptr %18, align 8
  %.1023 = fcmp une double %.988, 0.000000e+00
  br i1 %.1023, label %B416, label %B706

B416:                                             ; preds = %B34.5
  %19 = getelementptr i8, ptr %arg.arm.4, i64 104
  %.922 = load double, ptr %19, align 8
  %20 = getelementptr i8, ptr %arg.arm.4, i64 96
  %.889 = load double, ptr %20, align 8
  %.1055 = load double, ptr %arg.t.4, align 8
  %.1057 = fsub double %.1055, %.922
  %.1061 = fmul double %.889, %.1057
  store double %.1061, ptr %arg.q.4, align 8
  %.1127 = fadd double %.955, 0x400921FB54442D18
  %.1128 = fcmp ogt double %.1061, %.1127
  br i1 %.1128, label %B490, label %B578

B490:                                             ; preds = %B416, %B490
  %.1160503 = phi double [ %.1163, %B490 ], [ %.1061, %B416 ]
  %.1163 = fadd double %.1160503, 0xC01921FB54442D18
  %.1228 = fcmp ogt double %.1163, %.1127
  br i1 %.1228, label %B490, label %B578.loopexit

B578.loopexit:                                    ; preds = %B490
  store double %.1163, ptr %arg.q.4, align 8
  br label %B578

B578:                                             ; preds = %B578.loopexit, %B416
  %.855.promoted504 = phi double [ %.1163, %B578.loopexit ], [ %.1061, %B416 ]
  %.1262 = fadd double %.955, 0xC00921FB54442D18
  %.1263 = fcmp ugt double %.855.promoted504, %.1262
  br i1 %.1263, label %B706, label %B618

B618:                                             ; preds = %B578, %B618
  %.1295505 = phi double [ %.1298, %B618 ], [ %.855.promoted504, %B578 ]
  %.1298 = fadd double %.1295505, 0x401921FB54442D18
  %.1363 = fcmp ugt double %.1298, %.1262
  br i1 %.1363, label %B706.loopexit, label %B618

B706.loopexit:                                    ; preds = %B618
  store double %.1298, ptr %arg.q.4, align 8
  br label %B706

B706:                                             ; preds = %B706.loopexit, %B578, %B34.5
  %.825.1 = load double, ptr %2, align 8
  %21 = getelementptr i8, ptr %arg.q.4, i64 8
  store double %.825.1, ptr %21, align 8
  %22 = getelementptr i8, ptr %arg.arm.4, i64 144
  %.955.1 = load double, ptr %22, align 8
  %23 = getelementptr i8, ptr %arg.arm.4, i64 152
  %.988.1 = load double, ptr %23, align 8
  %.1023.1 = fcmp une double %.988.1, 0.000000e+00
  br i1 %.1023.1, label %B416.1, label %B706.1

B416.1:                                           ; preds = %B706
  %.922.1 = load double, ptr %.640, align 8
  %24 = getelementptr i8, ptr %arg.arm.4, i64 128
  %.889.1 = load double, ptr %24, align 8
  %.1057.1 = fsub double %.825.1, %.922.1
  %.1061.1 = fmul double %.889.1, %.1057.1
  store double %.1061.1, ptr %21, align 8
  %.1127.1 = fadd double %.955.1, 0x400921FB54442D18
  %.1128.1 = fcmp ogt double %.1061.1, %.1127.1
  br i1 %.1128.1, label %B490.1, label %B578.1

B490.1:                                           ; preds = %B416.1, %B490.1
  %.1160503.1 = phi double [ %.1163.1, %B490.1 ], [ %.1061.1, %B416.1 ]
  %.1163.1 = fadd double %.1160503.1, 0xC01921FB54442D18
  %.1228.1 = fcmp ogt double %.1163.1, %.1127.1
  br i1 %.1228.1, label %B490.1, label %B578.loopexit.1

B578.loopexit.1:                                  ; preds = %B490.1
  store double %.1163.1, ptr %21, align 8
  br label %B578.1

B578.1:                                           ; preds = %B578.loopexit.1, %B416.1
  %.855.promoted504.1 = phi double [ %.1163.1, %B578.loopexit.1 ], [ %.1061.1, %B416.1 ]
  %.1262.1 = fadd double %.955.1, 0xC00921FB54442D18
  %.1263.1 = fcmp ugt double %.855.promoted504.1, %.1262.1
  br i1 %.1263.1, label %B706.1, label %B618.1

B618.1:                                           ; preds = %B578.1, %B618.1
  %.1295505.1 = phi double [ %.1298.1, %B618.1 ], [ %.855.promoted504.1, %B578.1 ]
  %.1298.1 = fadd double %.1295505.1, 0x401921FB54442D18
  %.1363.1 = fcmp ugt double %.1298.1, %.1262.1
  br i1 %.1363.1, label %B706.loopexit.1, label %B618.1

B706.loopexit.1:                                  ; preds = %B618.1
  store double %.1298.1, ptr %21, align 8
  br label %B706.1

B706.1:                                           ; preds = %B706.loopexit.1, %B578.1, %B706
  %.825.2 = load double, ptr %5, align 8
  %25 = getelementptr i8, ptr %arg.q.4, i64 16
  store double %.825.2, ptr %25, align 8
  %26 = getelementptr i8, ptr %arg.arm.4, i64 176
  %.955.2 = load double, ptr %26, align 8
  %27 = getelementptr i8, ptr %arg.arm.4, i64 184
  %.988.2 = load double, ptr %27, align 8
  %.1023.2 = fcmp une double %.988.2, 0.000000e+00
  br i1 %.1023.2, label %B416.2, label %B706.2

B416.2:                                           ; preds = %B706.1
  %28 = getelementptr i8, ptr %arg.arm.4, i64 168
  %.922.2 = load double, ptr %28, align 8
  %29 = getelementptr i8, ptr %arg.arm.4, i64 160
  %.889.2 = load double, ptr %29, align 8
  %.1057.2 = fsub double %.825.2, %.922.2
  %.1061.2 = fmul double %.889.2, %.1057.2
  store double %.1061.2, ptr %25, align 8
  %.1127.2 = fadd double %.955.2, 0x400921FB54442D18
  %.1128.2 = fcmp ogt double %.1061.2, %.1127.2
  br i1 %.1128.2, label %B490.2, label %B578.2

B490.2:                                           ; preds = %B416.2, %B490.2
  %.1160503.2 = phi double [ %.1163.2, %B490.2 ], [ %.1061.2, %B416.2 ]
  %.1163.2 = fadd double %.1160503.2, 0xC01921FB54442D18
  %.1228.2 = fcmp ogt double %.1163.2, %.1127.2
  br i1 %.1228.2, label %B490.2, label %B578.loopexit.2

B578.loopexit.2:                                  ; preds = %B490.2
  store double %.1163.2, ptr %25, align 8
  br label %B578.2

B578.2:                                           ; preds = %B578.loopexit.2, %B416.2
  %.855.promoted504.2 = phi double [ %.1163.2, %B578.loopexit.2 ], [ %.1061.2, %B416.2 ]
  %.1262.2 = fadd double %.955.2, 0xC00921FB54442D18
  %.1263.2 = fcmp ugt double %.855.promoted504.2, %.1262.2
  br i1 %.1263.2, label %B706.2, label %B618.2

B618.2:                                           ; preds = %B578.2, %B618.2
  %.1295505.2 = phi double [ %.1298.2, %B618.2 ], [ %.855.promoted504.2, %B578.2 ]
  %.1298.2 = fadd double %.1295505.2, 0x401921FB54442D18
  %.1363.2 = fcmp ugt double %.1298.2, %.1262.2
  br i1 %.1363.2, label %B706.loopexit.2, label %B618.2

B706.loopexit.2:                                  ; preds = %B618.2
  store double %.1298.2, ptr %25, align 8
  br label %B706.2

B706.2:                                           ; preds = %B706.loopexit.2, %B578.2, %B706.1
  %.825.3 = load double, ptr %8, align 8
  %30 = getelementptr i8, ptr %arg.q.4, i64 24
  store double %.825.3, ptr %30, align 8
  %31 = getelementptr i8, ptr %arg.arm.4, i64 208
  %.955.3 = load double, ptr %31, align 8
  %32 = getelementptr i8, ptr %arg.arm.4, i64 216
  %.988.3 = load double, ptr %32, align 8
  %.1023.3 = fcmp une double %.988.3, 0.000000e+00
  br i1 %.1023.3, label %B416.3, label %B706.3

B416.3:                                           ; preds = %B706.2
  %33 = getelementptr i8, ptr %arg.arm.4, i64 200
  %.922.3 = load double, ptr %33, align 8
  %34 = getelementptr i8, ptr %arg.arm.4, i64 192
  %.889.3 = load double, ptr %34, align 8
  %.1057.3 = fsub double %.825.3, %.922.3
  %.1061.3 = fmul double %.889.3, %.1057.3
  store double %.1061.3, ptr %30, align 8
  %.1127.3 = fadd double %.955.3, 0x400921FB54442D18
  %.1128.3 = fcmp ogt double %.1061.3, %.1127.3
  br i1 %.1128.3, label %B490.3, label %B578.3

B490.3:                                           ; preds = %B416.3, %B490.3
  %.1160503.3 = phi double [ %.1163.3, %B490.3 ], [ %.1061.3, %B416.3 ]
  %.1163.3 = fadd double %.1160503.3, 0xC01921FB54442D18
  %.1228.3 = fcmp ogt double %.1163.3, %.1127.3
  br i1 %.1228.3, label %B490.3, label %B578.loopexit.3

B578.loopexit.3:                                  ; preds = %B490.3
  store double %.1163.3, ptr %30, align 8
  br label %B578.3

B578.3:                                           ; preds = %B578.loopexit.3, %B416.3
  %.855.promoted504.3 = phi double [ %.1163.3, %B578.loopexit.3 ], [ %.1061.3, %B416.3 ]
  %.1262.3 = fadd double %.955.3, 0xC00921FB54442D18
  %.1263.3 = fcmp ugt double %.855.promoted504.3, %.1262.3
  br i1 %.1263.3, label %B706.3, label %B618.3

B618.3:                                           ; preds = %B578.3, %B618.3
  %.1295505.3 = phi double [ %.1298.3, %B618.3 ], [ %.855.promoted504.3, %B578.3 ]
  %.1298.3 = fadd double %.1295505.3, 0x401921FB54442D18
  %.1363.3 = fcmp ugt double %.1298.3, %.1262.3
  br i1 %.1363.3, label %B706.loopexit.3, label %B618.3

B706.loopexit.3:                                  ; preds = %B618.3
  store double %.1298.3, ptr %30, align 8
  br label %B706.3

B706.3:                                           ; preds = %B706.loopexit.3, %B578.3, %B706.2
  %.825.4 = load double, ptr %11, align 8
  %35 = getelementptr i8, ptr %arg.q.4, i64 32
  store double %.825.4, ptr %35, align 8
  %36 = getelementptr i8, ptr %arg.arm.4, i64 240
  %.955.4 = load double, ptr %36, align 8
  %37 = getelementptr i8, ptr %arg.arm.4, i64 248
  %.988.4 = load double, ptr %37, align 8
  %.1023.4 = fcmp une double %.988.4, 0.000000e+00
  br i1 %.1023.4, label %B416.4, label %B706.4

B416.4:                                           ; preds = %B706.3
  %38 = getelementptr i8, ptr %arg.arm.4, i64 232
  %.922.4 = load double, ptr %38, align 8
  %39 = getelementptr i8, ptr %arg.arm.4, i64 224
  %.889.4 = load double, ptr %39, align 8
  %.1057.4 = fsub double %.825.4, %.922.4
  %.1061.4 = fmul double %.889.4, %.1057.4
  store double %.1061.4, ptr %35, align 8
  %.1127.4 = fadd double %.955.4, 0x400921FB54442D18
  %.1128.4 = fcmp ogt double %.1061.4, %.1127.4
  br i1 %.1128.4, label %B490.4, label %B578.4

B490.4:                                           ; preds = %B416.4, %B490.4
  %.1160503.4 = phi double [ %.1163.4, %B490.4 ], [ %.1061.4, %B416.4 ]
  %.1163.4 = fadd double %.1160503.4, 0xC01921FB54442D18
  %.1228.4 = fcmp ogt double %.1163.4, %.1127.4
  br i1 %.1228.4, label %B490.4, label %B578.loopexit.4

B578.loopexit.4:                                  ; preds = %B490.4
  store double %.1163.4, ptr %35, align 8
  br label %B578.4

B578.4:                                           ; preds = %B578.loopexit.4, %B416.4
  %.855.promoted504.4 = phi double [ %.1163.4, %B578.loopexit.4 ], [ %.1061.4, %B416.4 ]
  %.1262.4 = fadd double %.955.4, 0xC00921FB54442D18
  %.1263.4 = fcmp ugt double %.855.promoted504.4, %.1262.4
  br i1 %.1263.4, label %B706.4, label %B618.4

B618.4:                                           ; preds = %B578.4, %B618.4
  %.1295505.4 = phi double [ %.1298.4, %B618.4 ], [ %.855.promoted504.4, %B578.4 ]
  %.1298.4 = fadd double %.1295505.4, 0x401921FB54442D18
  %.1363.4 = fcmp ugt double %.1298.4, %.1262.4
  br i1 %.1363.4, label %B706.loopexit.4, label %B618.4

B706.loopexit.4:                                  ; preds = %B618.4
  store double %.1298.4, ptr %35, align 8
  br label %B706.4

B706.4:                                           ; preds = %B706.loopexit.4, %B578.4, %B706.3
  %.825.5 = load double, ptr %14, align 8
  %40 = getelementptr i8, ptr %arg.q.4, i64 40
  store double %.825.5, ptr %40, align 8
  %41 = getelementptr i8, ptr %arg.arm.4, i64 272
  %.955.5 = load double, ptr %41, align 8
  %42 = getelementptr i8, ptr %arg.arm.4, i64 280
  %.988.5 = load double, ptr %42, align 8
  %.1023.5 = fcmp une double %.988.5, 0.000000e+00
  br i1 %.1023.5, label %B416.5, label %common.ret

B416.5:                                           ; preds = %B706.4
  %43 = getelementptr i8, ptr %arg.arm.4, i64 264
  %.922.5 = load double, ptr %43, align 8
  %44 = getelementptr i8, ptr %arg.arm.4, i64 256
  %.889.5 = load double, ptr %44, align 8
  %.1057.5 = fsub double %.825.5, %.922.5
  %.1061.5 = fmul double %.889.5, %.1057.5
  store double %.1061.5, ptr %40, align 8
  %.1127.5 = fadd double %.955.5, 0x400921FB54442D18
  %.1128.5 = fcmp ogt double %.1061.5, %.1127.5
  br i1 %.1128.5, label %B490.5, label %B578.5

B490.5:                                           ; preds = %B416.5, %B490.5
  %.1160503.5 = phi double [ %.1163.5, %B490.5 ], [ %.1061.5, %B416.5 ]
  %.1163.5 = fadd double %.1160503.5, 0xC01921FB54442D18
  %.1228.5 = fcmp ogt double %.1163.5, %.1127.5
  br i1 %.1228.5, label %B490.5, label %B578.loopexit.5

B578.loopexit.5:                                  ; preds = %B490.5
  store double %.1163.5, ptr %40, align 8
  br label %B578.5

B578.5:                                           ; preds = %B578.loopexit.5, %B416.5
  %.855.promoted504.5 = phi double [ %.1163.5, %B578.loopexit.5 ], [ %.1061.5, %B416.5 ]
  %.1262.5 = fadd double %.955.5, 0xC00921FB54442D18
  %.1263.5 = fcmp ugt double %.855.promoted504.5, %.1262.5
  br i1 %.1263.5, label %common.ret, label %B618.5

B618.5:                                           ; preds = %B578.5, %B618.5
  %.1295505.5 = phi double [ %.1298.5, %B618.5 ], [ %.855.promoted504.5, %B578.5 ]
  %.1298.5 = fadd double %.1295505.5, 0x401921FB54442D18
  %.1363.5 = fcmp ugt double %.1298.5, %.1262.5
  br i1 %.1363.5, label %B706.loopexit.5, label %B618.5

B706.loopexit.5:                                  ; preds = %B618.5
  store double %.1298.5, ptr %40, align 8
  br label %common.ret

common.ret:                                       ; preds = %.463.endif, %B706.4, %B578.5, %B706.loopexit.5, %middle.block, %B108.else.endif
  store ptr null, ptr %retptr, align 8
  ret void

B108.else.endif:                                  ; preds = %B34.4, %B34.3, %B34.2, %B34.1, %B34, %B0.endif.endif
  %.397 = icmp slt i64 %arg.q.5.0, 1
  br i1 %.397, label %common.ret, label %.463.endif.preheader, !prof !0

.463.endif.preheader:                             ; preds = %B108.else.endif
  %min.iters.check = icmp samesign ult i64 %arg.q.5.0, 4
  br i1 %min.iters.check, label %.463.endif.preheader1, label %vector.ph, !prof !31

vector.ph:                                        ; preds = %.463.endif.preheader
  %n.vec = and i64 %arg.q.5.0, 9223372036854775804
  br label %vector.body

vector.body:                                      ; preds = %vector.body, %vector.ph
  %index = phi i64 [ 0, %vector.ph ], [ %index.next, %vector.body ]
  %sunkaddr29 = shl i64 %index, 3
  %sunkaddr31 = getelementptr i8, ptr %arg.q.4, i64 %sunkaddr29
  store <2 x double> splat (double 0x7FF8000000000000), ptr %sunkaddr31, align 8
  %sunkaddr34 = getelementptr i8, ptr %sunkaddr31, i64 16
  store <2 x double> splat (double 0x7FF8000000000000), ptr %sunkaddr34, align 8
  %index.next = add nuw nsw i64 %index, 4
  %45 = icmp eq i64 %n.vec, %index.next
  br i1 %45, label %middle.block, label %vector.body, !prof !32, !llvm.loop !33

middle.block:                                     ; preds = %vector.body
  %cmp.n = icmp eq i64 %arg.q.5.0, %n.vec
  br i1 %cmp.n, label %common.ret, label %.463.endif.preheader1, !prof !37

.463.endif.preheader1:                            ; preds = %middle.block, %.463.endif.preheader
  %.459.0511.ph = phi i64 [ %n.vec, %middle.block ], [ 0, %.463.endif.preheader ]
  br label %.463.endif

.463.endif:                                       ; preds = %.463.endif.preheader1, %.463.endif
  %.459.0511 = phi i64 [ %.504, %.463.endif ], [ %.459.0511.ph, %.463.endif.preheader1 ]
  %46 = shl i64 %.459.0511, 3
  %scevgep = getelementptr i8, ptr %arg.q.4, i64 %46
  store double 0x7FF8000000000000, ptr %scevgep, align 8
  %.504 = add nuw nsw i64 %.459.0511, 1
  %exitcond.not = icmp eq i64 %arg.q.5.0, %.504
  br i1 %exitcond.not, label %common.ret, label %.463.endif, !prof !38, !llvm.loop !39
}

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.end.p0(ptr captures(none)) #1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.fill_bent(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.arm.0, ptr readnone captures(none) %arg.arm.1, i64 %arg.arm.2, i64 %arg.arm.3, ptr readonly captures(none) %arg.arm.4, i64 %arg.arm.5.0, i64 %arg.arm.6.0, ptr readnone captures(none) %arg.R.0, ptr readnone captures(none) %arg.R.1, i64 %arg.R.2, i64 %arg.R.3, ptr readonly captures(none) %arg.R.4, i64 %arg.R.5.0, i64 %arg.R.5.1, i64 %arg.R.5.2, i64 %arg.R.6.0, i64 %arg.R.6.1, i64 %arg.R.6.2, ptr readnone captures(none) %arg.centre.0, ptr readnone captures(none) %arg.centre.1, i64 %arg.centre.2, i64 %arg.centre.3, ptr readonly captures(none) %arg.centre.4, i64 %arg.centre.5.0, i64 %arg.centre.5.1, i64 %arg.centre.6.0, i64 %arg.centre.6.1, ptr readnone captures(none) %arg.side.0, ptr readnone captures(none) %arg.side.1, i64 %arg.side.2, i64 %arg.side.3, ptr readonly captures(none) %arg.side.4, i64 %arg.side.5.0, i64 %arg.side.6.0, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr writeonly captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.5.1, i64 %arg.out.6.0, i64 %arg.out.6.1) local_unnamed_addr #0 {
B0.endif:
  %.195218.not = icmp slt i64 %arg.R.5.0, 1
  br i1 %.195218.not, label %B174, label %B62.lr.ph

B62.lr.ph:                                        ; preds = %B0.endif
  %0 = shl i64 %arg.out.5.1, 3
  %.281 = shl i64 %arg.R.5.1, 3
  %1 = mul i64 %.281, %arg.R.5.2
  %.89.i = getelementptr i8, ptr %arg.arm.4, i64 64
  %.119.i = getelementptr i8, ptr %arg.arm.4, i64 72
  %.idx.i = shl i64 %arg.R.5.2, 4
  %.606.i = getelementptr i8, ptr %arg.arm.4, i64 24
  %.636.i = getelementptr i8, ptr %arg.arm.4, i64 32
  br label %B62

B62:                                              ; preds = %part.6, %B62.lr.ph
  %lsr.iv15 = phi i64 [ %arg.R.5.0, %B62.lr.ph ], [ %lsr.iv.next, %part.6 ]
  %lsr.iv13 = phi ptr [ %arg.R.4, %B62.lr.ph ], [ %scevgep14, %part.6 ]
  %lsr.iv10 = phi ptr [ %arg.centre.4, %B62.lr.ph ], [ %scevgep11, %part.6 ]
  %lsr.iv8 = phi ptr [ %arg.side.4, %B62.lr.ph ], [ %scevgep9, %part.6 ]
  %lsr.iv = phi ptr [ %arg.out.4, %B62.lr.ph ], [ %scevgep, %part.6 ]
  %.376 = load double, ptr %lsr.iv10, align 8
  %scevgep12 = getelementptr i8, ptr %lsr.iv10, i64 %arg.centre.6.1
  %.430 = load double, ptr %scevgep12, align 8
  %.461 = load double, ptr %lsr.iv8, align 8
  %.90.i = load double, ptr %.89.i, align 8, !noalias !41
  %.120.i = load double, ptr %.119.i, align 8, !noalias !41
  %.179.i = getelementptr i8, ptr %lsr.iv13, i64 16
  %.180.i = load double, ptr %.179.i, align 8, !noalias !41
  %.235.i = fmul double %.180.i, %.180.i
  %2 = getelementptr i8, ptr %lsr.iv13, i64 %.idx.i
  %.290.i = getelementptr i8, ptr %2, i64 16
  %.291.i = load double, ptr %.290.i, align 8, !noalias !41
  %.352.i = fmul double %.291.i, %.291.i
  %.353.i = fadd double %.235.i, %.352.i
  %sqrt.i = tail call double @llvm.sqrt.f64(double %.353.i)
  %3 = getelementptr double, ptr %lsr.iv13, i64 %arg.R.5.2
  %.407.i = getelementptr i8, ptr %3, i64 16
  %.408.i = load double, ptr %.407.i, align 8, !noalias !41
  %.409.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.408.i)
  %.417.i = fcmp olt double %sqrt.i, 0x3D719799812DEA11
  br i1 %.417.i, label %B200.endif.endif.endif.endif.endif.i, label %B932.i

B742.i:                                           ; preds = %B200.endif.endif.endif.endif.endif.i
  %.788.i = fmul double %sqrt450.i, %sqrt450.i
  %.791.i = fmul double %sqrt449.i, %sqrt449.i
  %.792.i = fadd double %.788.i, %.791.i
  %.793.i = fmul double %.13.i3.i, %.13.i3.i
  %.794.i = fsub double %.792.i, %.793.i
  %.797.i = fmul double %sqrt450.i, 2.000000e+00
  %.799.i = fmul double %.797.i, %sqrt449.i
  %.803.i = fdiv double %.794.i, %.799.i
  %.12.i4.i = fcmp olt double %.803.i, -1.000000e+00
  %.13.i5.i = select i1 %.12.i4.i, double -1.000000e+00, double %.803.i
  %.12.i6.i = fcmp ogt double %.13.i5.i, 1.000000e+00
  %.13.i7.i = select i1 %.12.i6.i, double 1.000000e+00, double %.13.i5.i
  %.887.i = tail call double @atan2(double %.120.i, double %.90.i)
  %.890.i = tail call double @atan2(double %.430, double %.376)
  %.892.i = tail call double @acos(double %.13.i7.i)
  %.895.i = fsub double %.890.i, %.892.i
  %.896.i = fsub double %.887.i, %.895.i
  %.897.i = tail call double @llvm.cos.f64(double %.896.i)
  %.898.i = tail call double @llvm.sin.f64(double %.896.i)
  br label %B900.i

B900.i:                                           ; preds = %B200.endif.endif.endif.endif.endif.i, %B742.i
  %s.4.0.i = phi double [ %.898.i, %B742.i ], [ %.541.i, %B200.endif.endif.endif.endif.endif.i ]
  %c.4.0.i = phi double [ %.897.i, %B742.i ], [ %.482.i, %B200.endif.endif.endif.endif.endif.i ]
  %.916.i = fcmp ogt double %.409.i, 0.000000e+00
  br i1 %.916.i, label %part.6, label %B916.i

B916.i:                                           ; preds = %B900.i
  br label %part.6

B932.i:                                           ; preds = %B62
  %.954.i = fneg double %.461
  %.1009.i = fmul double %.180.i, %.954.i
  %.1014.i = fdiv double %.1009.i, %sqrt.i
  %.1074.i = fmul double %.461, %.291.i
  %.1079.i = fdiv double %.1074.i, %sqrt.i
  %.1135.i = tail call double @atan2(double %sqrt.i, double %.408.i)
  %.1201.pre.i = load double, ptr %lsr.iv13, align 8, !noalias !41
  %.1259.pre.i = load double, ptr %2, align 8, !noalias !41
  br label %part.6

B200.endif.endif.endif.endif.endif.i:             ; preds = %B62
  %.423.i = fmul double %.461, %.409.i
  %.479.i = load double, ptr %lsr.iv13, align 8, !noalias !41
  %.482.i = fmul double %.423.i, %.479.i
  %.484.i = fneg double %.461
  %.486.i = fmul double %.409.i, %.484.i
  %.540.i = load double, ptr %2, align 8, !noalias !41
  %.541.i = fmul double %.486.i, %.540.i
  %.558.i = fmul double %.90.i, %.482.i
  %.561.i = fmul double %.120.i, %.541.i
  %.562.i = fadd double %.558.i, %.561.i
  %.564.i = fsub double %.376, %.562.i
  %.567.i = fmul double %.120.i, %.482.i
  %.570.i = fmul double %.90.i, %.541.i
  %.571.i = fsub double %.567.i, %.570.i
  %.573.i = fsub double %.430, %.571.i
  %.574.i = fmul double %.564.i, %.564.i
  %.575.i = fmul double %.573.i, %.573.i
  %.576.i = fadd double %.574.i, %.575.i
  %sqrt448.i = tail call double @llvm.sqrt.f64(double %.576.i)
  %.607.i = load double, ptr %.606.i, align 8, !noalias !41
  %.637.i = load double, ptr %.636.i, align 8, !noalias !41
  %.638.i = fsub double %.607.i, %.637.i
  %.639.i = tail call double @llvm.fabs.f64(double %.638.i)
  %.12.i.i = fcmp ogt double %.639.i, %sqrt448.i
  %.13.i.i = select i1 %.12.i.i, double %.639.i, double %sqrt448.i
  %.735.i = fadd double %.607.i, %.637.i
  %.12.i2.i = fcmp olt double %.735.i, %.13.i.i
  %.13.i3.i = select i1 %.12.i2.i, double %.735.i, double %.13.i.i
  %.766.i = fmul double %.376, %.376
  %.769.i = fmul double %.430, %.430
  %.770.i = fadd double %.766.i, %.769.i
  %sqrt450.i = tail call double @llvm.sqrt.f64(double %.770.i)
  %.774.i = fmul double %.90.i, %.90.i
  %.777.i = fmul double %.120.i, %.120.i
  %.778.i = fadd double %.774.i, %.777.i
  %sqrt449.i = tail call double @llvm.sqrt.f64(double %.778.i)
  %.863.i = fcmp une double %sqrt448.i, %.13.i3.i
  %.877.i = fmul double %sqrt450.i, %sqrt449.i
  %.883.i = fcmp ogt double %.877.i, 0.000000e+00
  %or.cond.i = select i1 %.863.i, i1 %.883.i, i1 false
  br i1 %or.cond.i, label %B742.i, label %B900.i

part.6: ; preds = %B900.i, %B916.i, %B932.i
  %.1259.i = phi double [ %.1259.pre.i, %B932.i ], [ %.540.i, %B900.i ], [ %.540.i, %B916.i ]
  %.1201.i = phi double [ %.1201.pre.i, %B932.i ], [ %.479.i, %B900.i ], [ %.479.i, %B916.i ]
  %s.3.0.i = phi double [ %.1079.i, %B932.i ], [ %s.4.0.i, %B900.i ], [ %s.4.0.i, %B916.i ]
  %c.3.0.i = phi double [ %.1014.i, %B932.i ], [ %c.4.0.i, %B900.i ], [ %c.4.0.i, %B916.i ]
  %t5.2.0.i = phi double [ %.1135.i, %B932.i ], [ 0.000000e+00, %B900.i ], [ 0x400921FB54442D18, %B916.i ]
  %.1205.i = fmul double %.1201.i, %s.3.0.i
  %.1261.i = fmul double %.1259.i, %c.3.0.i
  %.1262.i = fadd double %.1205.i, %.1261.i
  %.1263.i = fneg double %.1262.i
  %.1316.i = getelementptr i8, ptr %lsr.iv13, i64 8
  %.1317.i = load double, ptr %.1316.i, align 8, !noalias !41
  %.1319.i = fmul double %s.3.0.i, %.1317.i
  %sunkaddr4.i = getelementptr i8, ptr %2, i64 8
  %.1373.i = load double, ptr %sunkaddr4.i, align 8, !noalias !41
  %.1382.i = fmul double %c.3.0.i, %.1373.i
  %.1383.i = fadd double %.1319.i, %.1382.i
  %.1384.i = fneg double %.1383.i
  %.6.i.i = tail call double @atan2(double %.1263.i, double %.1384.i)
  %.12.i1.i = fcmp ole double %.6.i.i, 0xC00921FB54442D18
  %"$phi76.0.2.0.i.i" = select i1 %.12.i1.i, double 0x400921FB54442D18, double %.6.i.i
  %.1411.i = fmul double %.90.i, %c.3.0.i
  %.1414.i = fmul double %.120.i, %s.3.0.i
  %.1415.i = fadd double %.1414.i, %.1411.i
  %.1417.i = fsub double %.376, %.1415.i
  %.1422.i = fmul double %.120.i, %c.3.0.i
  %.1427.i = fmul double %.90.i, %s.3.0.i
  %.1430.i = fsub double %.1422.i, %.1427.i
  %.1432.i = fsub double %.430, %.1430.i
  store double %.1417.i, ptr %lsr.iv, align 8, !noalias !41
  %.1493.i = getelementptr i8, ptr %lsr.iv, i64 8
  store double %.1432.i, ptr %.1493.i, align 8, !noalias !41
  %.1497.i = tail call double @atan2(double %s.3.0.i, double %c.3.0.i)
  %.1504.i = fmul double %.461, %t5.2.0.i
  %.1537.i = getelementptr i8, ptr %lsr.iv, i64 16
  store double %.1497.i, ptr %.1537.i, align 8, !noalias !41
  %.1567.i = getelementptr i8, ptr %lsr.iv, i64 24
  store double %.1504.i, ptr %.1567.i, align 8, !noalias !41
  %.1597.i = getelementptr i8, ptr %lsr.iv, i64 32
  store double %"$phi76.0.2.0.i.i", ptr %.1597.i, align 8, !noalias !41
  %scevgep = getelementptr i8, ptr %lsr.iv, i64 %0
  %scevgep9 = getelementptr i8, ptr %lsr.iv8, i64 %arg.side.6.0
  %scevgep11 = getelementptr i8, ptr %lsr.iv10, i64 %arg.centre.6.0
  %scevgep14 = getelementptr i8, ptr %lsr.iv13, i64 %1
  %lsr.iv.next = add nsw i64 %lsr.iv15, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond.not, label %B174, label %B62

B174:                                             ; preds = %part.6, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

attributes #0 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #1 = { nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #3 = { mustprogress nofree nosync nounwind willreturn memory(none) }

!0 = !{!"branch_weights", i32 1, i32 99}
!1 = !{!2}
!2 = distinct !{!2, !3, !"part.7: %retptr"}
!3 = distinct !{!3, !"part.7"}
!4 = !{!5}
!5 = distinct !{!5, !6, !"part.8: %retptr"}
!6 = distinct !{!6, !"part.8"}
!7 = !{!8, !5}
!8 = distinct !{!8, !9, !"part.9: %retptr"}
!9 = distinct !{!9, !"part.9"}
!10 = !{!11, !5}
!11 = distinct !{!11, !12, !"part.10: %retptr"}
!12 = distinct !{!12, !"part.10"}
!13 = !{!14, !5}
!14 = distinct !{!14, !15, !"part.11: %retptr"}
!15 = distinct !{!15, !"part.11"}
!16 = !{!17, !5}
!17 = distinct !{!17, !18, !"part.11: %retptr"}
!18 = distinct !{!18, !"part.11"}
!19 = !{!20}
!20 = distinct !{!20, !21, !"part.12: %retptr"}
!21 = distinct !{!21, !"part.12"}
!22 = !{!23, !20}
!23 = distinct !{!23, !24, !"part.9: %retptr"}
!24 = distinct !{!24, !"part.9"}
!25 = !{!26, !20}
!26 = distinct !{!26, !27, !"part.11: %retptr"}
!27 = distinct !{!27, !"part.11"}
!28 = !{!29, !20}
!29 = distinct !{!29, !30, !"part.13: %retptr"}
!30 = distinct !{!30, !"part.13"}
!31 = !{!"branch_weights", i32 1, i32 127}
!32 = !{!"branch_weights", i32 127, i32 3048}
!33 = distinct !{!33, !34, !35, !36}
!34 = !{!"llvm.loop.isvectorized", i32 1}
!35 = !{!"llvm.loop.unroll.runtime.disable"}
!36 = !{!"llvm.loop.estimated_trip_count", i32 25}
!37 = !{!"branch_weights", i32 1, i32 3}
!38 = !{!"branch_weights", i32 1, i32 0}
!39 = distinct !{!39, !35, !34, !40}
!40 = !{!"llvm.loop.estimated_trip_count", i32 0}
!41 = !{!42}
!42 = distinct !{!42, !43, !"part.14: %retptr"}
!43 = distinct !{!43, !"part.14"}
