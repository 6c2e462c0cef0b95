; sha256 ffad9f84378da2984171c5984bef4997a2e7ce623f7706686aaedc5b44096c28 of tool_loops.py and of this
; made by numba 0.68.1, llvmlite 0.50.0, Python 3.11.7
; loops.fill_rows: array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 1d, A); array(float64, 1d, A); array(float64, 1d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, C); array(float64, 2d, C); array(float64, 2d, C); array(float64, 2d, A)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.fill_rows(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.v.0, ptr readnone captures(none) %arg.v.1, i64 %arg.v.2, i64 %arg.v.3, ptr readonly captures(none) %arg.v.4, i64 %arg.v.5.0, i64 %arg.v.5.1, i64 %arg.v.6.0, i64 %arg.v.6.1, ptr readnone captures(none) %arg.w.0, ptr readnone captures(none) %arg.w.1, i64 %arg.w.2, i64 %arg.w.3, ptr readonly captures(none) %arg.w.4, i64 %arg.w.5.0, i64 %arg.w.5.1, i64 %arg.w.6.0, i64 %arg.w.6.1, ptr readnone captures(none) %arg.bend.0, ptr readnone captures(none) %arg.bend.1, i64 %arg.bend.2, i64 %arg.bend.3, ptr readonly captures(none) %arg.bend.4, i64 %arg.bend.5.0, i64 %arg.bend.5.1, i64 %arg.bend.6.0, i64 %arg.bend.6.1, ptr readnone captures(none) %arg.v_tcp.0, ptr readnone captures(none) %arg.v_tcp.1, i64 %arg.v_tcp.2, i64 %arg.v_tcp.3, ptr readonly captures(none) %arg.v_tcp.4, i64 %arg.v_tcp.5.0, i64 %arg.v_tcp.6.0, ptr readnone captures(none) %arg.a_tcp.0, ptr readnone captures(none) %arg.a_tcp.1, i64 %arg.a_tcp.2, i64 %arg.a_tcp.3, ptr readonly captures(none) %arg.a_tcp.4, i64 %arg.a_tcp.5.0, i64 %arg.a_tcp.6.0, ptr readnone captures(none) %arg.v_ori.0, ptr readnone captures(none) %arg.v_ori.1, i64 %arg.v_ori.2, i64 %arg.v_ori.3, ptr readonly captures(none) %arg.v_ori.4, i64 %arg.v_ori.5.0, i64 %arg.v_ori.6.0, ptr readnone captures(none) %arg.ramps.0, ptr readnone captures(none) %arg.ramps.1, i64 %arg.ramps.2, i64 %arg.ramps.3, ptr readonly captures(none) %arg.ramps.4, i64 %arg.ramps.5.0, i64 %arg.ramps.5.1, i64 %arg.ramps.6.0, i64 %arg.ramps.6.1, ptr readnone captures(none) %arg.sides.0, ptr readnone captures(none) %arg.sides.1, i64 %arg.sides.2, i64 %arg.sides.3, ptr readonly captures(none) %arg.sides.4, i64 %arg.sides.5.0, i64 %arg.sides.5.1, i64 %arg.sides.6.0, i64 %arg.sides.6.1, ptr readnone captures(none) %arg.top.0, ptr readnone captures(none) %arg.top.1, i64 %arg.top.2, i64 %arg.top.3, ptr writeonly captures(none) %arg.top.4, i64 %arg.top.5.0, i64 %arg.top.5.1, i64 %arg.top.6.0, i64 %arg.top.6.1, ptr readnone captures(none) %arg.slopes.0, ptr readnone captures(none) %arg.slopes.1, i64 %arg.slopes.2, i64 %arg.slopes.3, ptr writeonly captures(none) %arg.slopes.4, i64 %arg.slopes.5.0, i64 %arg.slopes.5.1, i64 %arg.slopes.6.0, i64 %arg.slopes.6.1, ptr readnone captures(none) %arg.bends.0, ptr readnone captures(none) %arg.bends.1, i64 %arg.bends.2, i64 %arg.bends.3, ptr writeonly captures(none) %arg.bends.4, i64 %arg.bends.5.0, i64 %arg.bends.5.1, i64 %arg.bends.6.0, i64 %arg.bends.6.1, ptr readnone captures(none) %arg.rests.0, ptr readnone captures(none) %arg.rests.1, i64 %arg.rests.2, i64 %arg.rests.3, ptr writeonly captures(none) %arg.rests.4, i64 %arg.rests.5.0, i64 %arg.rests.5.1, i64 %arg.rests.6.0, i64 %arg.rests.6.1) local_unnamed_addr #0 {
B0.endif:
  %invariant.gep957 = getelementptr i8, ptr %arg.v.4, i64 %arg.v.6.1
  %invariant.gep959 = getelementptr i8, ptr %arg.w.4, i64 %arg.w.6.1
  %invariant.gep961 = getelementptr i8, ptr %arg.bend.4, i64 %arg.bend.6.1
  %invariant.gep963 = getelementptr i8, ptr %arg.ramps.4, i64 %arg.ramps.6.1
  %.337989.not = icmp slt i64 %arg.v.5.0, 1
  br i1 %.337989.not, label %common.ret, label %B94.lr.ph

B94.lr.ph:                                        ; preds = %B0.endif
  %invariant.gep967 = getelementptr double, ptr %arg.bends.4, i64 %arg.sides.5.0
  %invariant.gep965 = getelementptr double, ptr %arg.slopes.4, i64 %arg.sides.5.0
  %.650 = shl i64 %arg.v.6.1, 1
  %invariant.gep998 = getelementptr i8, ptr %arg.v.4, i64 %.650
  %.994 = shl i64 %arg.w.6.1, 1
  %invariant.gep1000 = getelementptr i8, ptr %arg.w.4, i64 %.994
  %.1508 = shl i64 %arg.bend.6.1, 1
  %invariant.gep1002 = getelementptr i8, ptr %arg.bend.4, i64 %.1508
  %invariant.gep = getelementptr i8, ptr %arg.sides.4, i64 %arg.sides.6.1
  %.2523 = icmp slt i64 %arg.sides.5.0, 0
  %.2524 = select i1 %.2523, i64 %arg.slopes.5.1, i64 0
  %invariant.gep1004 = getelementptr double, ptr %invariant.gep965, i64 %.2524
  %.2580 = select i1 %.2523, i64 %arg.bends.5.1, i64 0
  %invariant.gep1006 = getelementptr double, ptr %invariant.gep967, i64 %.2580
  %.2638 = select i1 %.2523, i64 %arg.rests.5.1, i64 0
  %.2639 = add i64 %.2638, %arg.sides.5.0
  %.2656 = mul i64 %arg.rests.6.1, %.2639
  %invariant.gep1008 = getelementptr i8, ptr %arg.rests.4, i64 %.2656
  %0 = add i64 %arg.sides.5.0, -1
  %1 = add nsw i64 %arg.v.5.0, -1
  %2 = mul i64 %arg.slopes.5.1, %1
  %3 = add i64 %2, %arg.sides.5.0
  %4 = shl i64 %3, 3
  %scevgep = getelementptr i8, ptr %arg.slopes.4, i64 %4
  %5 = shl i64 %arg.slopes.5.1, 3
  %6 = mul i64 %arg.bends.5.1, %1
  %7 = add i64 %6, %arg.sides.5.0
  %8 = shl i64 %7, 3
  %scevgep38 = getelementptr i8, ptr %arg.bends.4, i64 %8
  %9 = shl i64 %arg.bends.5.1, 3
  %10 = getelementptr i8, ptr %invariant.gep, i64 %arg.sides.5.0
  %scevgep39 = getelementptr i8, ptr %10, i64 7
  %11 = getelementptr i8, ptr %arg.sides.4, i64 %arg.sides.5.0
  %scevgep40 = getelementptr i8, ptr %11, i64 7
  %ident.check = icmp ne i64 %arg.sides.6.0, 1
  %12 = getelementptr i8, ptr %arg.sides.4, i64 %0
  %13 = icmp ult ptr %12, %arg.sides.4
  %14 = getelementptr i8, ptr %invariant.gep, i64 %0
  %15 = icmp ult ptr %14, %invariant.gep
  %16 = or i1 %ident.check, %13
  %17 = or i1 %16, %15
  %bound0 = icmp ult ptr %arg.slopes.4, %scevgep38
  %bound1 = icmp ult ptr %arg.bends.4, %scevgep
  %found.conflict = and i1 %bound1, %bound0
  %18 = or i64 %9, %5
  %19 = icmp slt i64 %18, 0
  %20 = or i1 %19, %found.conflict
  %bound042 = icmp ult ptr %arg.slopes.4, %scevgep39
  %bound143 = icmp ult ptr %invariant.gep, %scevgep
  %found.conflict44 = and i1 %bound042, %bound143
  %stride.check45 = icmp slt i64 %5, 0
  %21 = or i1 %stride.check45, %found.conflict44
  %conflict.rdx = or i1 %21, %20
  %bound046 = icmp ult ptr %arg.slopes.4, %scevgep40
  %bound147 = icmp ult ptr %arg.sides.4, %scevgep
  %found.conflict48 = and i1 %bound046, %bound147
  %conflict.rdx50 = or i1 %found.conflict48, %conflict.rdx
  %bound051 = icmp ult ptr %arg.bends.4, %scevgep39
  %bound152 = icmp ult ptr %invariant.gep, %scevgep38
  %found.conflict53 = and i1 %bound051, %bound152
  %stride.check54 = icmp slt i64 %9, 0
  %22 = or i1 %stride.check54, %found.conflict53
  %conflict.rdx55 = or i1 %22, %conflict.rdx50
  %bound056 = icmp ult ptr %arg.bends.4, %scevgep40
  %bound157 = icmp ult ptr %arg.sides.4, %scevgep38
  %found.conflict58 = and i1 %bound056, %bound157
  %conflict.rdx60 = or i1 %found.conflict58, %conflict.rdx55
  %n.vec = and i64 %arg.sides.5.0, 9223372036854775806
  %scevgep67 = getelementptr i8, ptr %arg.sides.4, i64 1
  %scevgep71 = getelementptr i8, ptr %scevgep67, i64 %arg.sides.6.1
  %23 = shl i64 %arg.sides.6.0, 1
  %24 = icmp slt i64 %arg.sides.5.0, 1
  %25 = icmp sgt i64 %arg.slopes.5.1, %arg.sides.5.0
  %26 = icmp samesign ult i64 %arg.sides.5.0, 16
  %brmerge = select i1 %26, i1 true, i1 %17
  %brmerge65 = select i1 %brmerge, i1 true, i1 %conflict.rdx60
  %27 = icmp eq i64 %arg.sides.5.0, %n.vec
  %28 = and i64 %arg.sides.5.0, 1
  %29 = icmp eq i64 %28, 0
  br label %B94

B94:                                              ; preds = %B1168, %B94.lr.ph
  %lsr.iv77 = phi ptr [ %arg.bends.4, %B94.lr.ph ], [ %scevgep78, %B1168 ]
  %lsr.iv = phi ptr [ %arg.slopes.4, %B94.lr.ph ], [ %scevgep75, %B1168 ]
  %.343973992 = phi i64 [ 0, %B94.lr.ph ], [ %.350, %B1168 ]
  %.426 = mul i64 %.343973992, %arg.v.6.0
  %.430 = getelementptr i8, ptr %arg.v.4, i64 %.426
  %.432 = load double, ptr %.430, align 8
  %gep958 = getelementptr i8, ptr %invariant.gep957, i64 %.426
  %.543 = load double, ptr %gep958, align 8
  %gep999 = getelementptr i8, ptr %invariant.gep998, i64 %.426
  %.655 = load double, ptr %gep999, align 8
  %.744 = mul i64 %.343973992, %arg.v_tcp.6.0
  %.746 = getelementptr i8, ptr %arg.v_tcp.4, i64 %.744
  %.748 = load double, ptr %.746, align 8
  %.781 = mul i64 %.343973992, %arg.v_ori.6.0
  %.783 = getelementptr i8, ptr %arg.v_ori.4, i64 %.781
  %.785 = load double, ptr %.783, align 8
  %.834 = mul i64 %.343973992, %arg.w.6.0
  %.838 = getelementptr i8, ptr %arg.w.4, i64 %.834
  %.840 = load double, ptr %.838, align 8
  %gep960 = getelementptr i8, ptr %invariant.gep959, i64 %.834
  %.919 = load double, ptr %gep960, align 8
  %gep1001 = getelementptr i8, ptr %invariant.gep1000, i64 %.834
  %.999 = load double, ptr %gep1001, align 8
  %.147.i34 = fmul double %.999, %.999
  %.147.i22 = fmul double %.919, %.919
  %.147.i = fmul double %.840, %.840
  %.350 = add nuw nsw i64 %.343973992, 1
  %.488 = fmul double %.432, %.432
  %.599 = fmul double %.543, %.543
  %.600 = fadd double %.488, %.599
  %.711 = fmul double %.655, %.655
  %.712 = fadd double %.600, %.711
  %sqrt = tail call double @llvm.sqrt.f64(double %.712)
  %.753 = fdiv double %.748, %sqrt
  %.944 = fadd double %.147.i, %.147.i22
  %.1024 = fadd double %.944, %.147.i34
  %sqrt1 = tail call double @llvm.sqrt.f64(double %.1024)
  %.1029 = fdiv double %.785, %sqrt1
  %.1079 = mul i64 %.343973992, %arg.top.5.1
  %.1083 = getelementptr double, ptr %arg.top.4, i64 %.1079
  store double %.753, ptr %.1083, align 8
  %.1138 = getelementptr i8, ptr %.1083, i64 8
  store double %.1029, ptr %.1138, align 8
  %.12.i = fcmp olt double %sqrt, 0x3D719799812DEA11
  %.13.i = select i1 %.12.i, double 0x3D719799812DEA11, double %sqrt
  %.1223 = load double, ptr %.430, align 8
  %.1227 = fdiv double %.1223, %.13.i
  %.1282 = load double, ptr %gep958, align 8
  %.1286 = fdiv double %.1282, %.13.i
  %.1341 = load double, ptr %gep999, align 8
  %.1345 = fdiv double %.1341, %.13.i
  %.1394 = mul i64 %.343973992, %arg.bend.6.0
  %.1398 = getelementptr i8, ptr %arg.bend.4, i64 %.1394
  %.1400 = load double, ptr %.1398, align 8
  %.1401 = fmul double %.1227, %.1400
  %gep962 = getelementptr i8, ptr %invariant.gep961, i64 %.1394
  %.1456 = load double, ptr %gep962, align 8
  %.1457 = fmul double %.1286, %.1456
  %.1458 = fadd double %.1401, %.1457
  %gep1003 = getelementptr i8, ptr %invariant.gep1002, i64 %.1394
  %.1513 = load double, ptr %gep1003, align 8
  %.1514 = fmul double %.1345, %.1513
  %.1515 = fadd double %.1458, %.1514
  %.1575 = fmul double %.1227, %.1515
  %.1576 = fsub double %.1400, %.1575
  %.1633 = fmul double %.1286, %.1515
  %.1634 = fsub double %.1456, %.1633
  %.1691 = fmul double %.1345, %.1515
  %.1692 = fsub double %.1513, %.1691
  %.1720 = mul i64 %.343973992, %arg.a_tcp.6.0
  %.1722 = getelementptr i8, ptr %arg.a_tcp.4, i64 %.1720
  %.1724 = load double, ptr %.1722, align 8
  %.1729 = fdiv double %sqrt, %.1724
  %.1766 = fdiv double %.1515, %.1724
  %.1767 = fmul double %.1576, %.1576
  %.1768 = fmul double %.1634, %.1634
  %.1769 = fadd double %.1767, %.1768
  %.1770 = fmul double %.1692, %.1692
  %.1771 = fadd double %.1770, %.1769
  %sqrt944 = tail call double @llvm.sqrt.f64(double %.1771)
  %.1808 = fdiv double %sqrt944, %.1724
  br i1 %24, label %B980, label %B874.lr.ph

B874:                                             ; preds = %B874.preheader66, %B874
  %lsr.iv80 = phi ptr [ %arg.sides.4, %B874.preheader66 ], [ %scevgep81, %B874 ]
  %.1904952954 = phi i64 [ %.1904952954.unr, %B874.preheader66 ], [ %.1911.1, %B874 ]
  %scevgep83 = getelementptr i8, ptr %lsr.iv80, i64 %51
  %.1989 = load double, ptr %scevgep83, align 8
  %.1991 = fmul double %.1729, %.1989
  %.2047 = fmul double %.1766, %.1989
  %30 = getelementptr i8, ptr %lsr.iv80, i64 %arg.sides.6.1
  %scevgep82 = getelementptr i8, ptr %30, i64 %51
  %.2101 = load double, ptr %scevgep82, align 8
  %.2103 = fmul double %.1808, %.2101
  %.2104 = fadd double %.2047, %.2103
  %31 = shl i64 %.1904952954, 3
  %scevgep91 = getelementptr i8, ptr %lsr.iv, i64 %31
  store double %.1991, ptr %scevgep91, align 8
  %scevgep88 = getelementptr i8, ptr %lsr.iv77, i64 %31
  store double %.2104, ptr %scevgep88, align 8
  %.1911.1 = add nuw nsw i64 %.1904952954, 2
  %scevgep84 = getelementptr i8, ptr %lsr.iv80, i64 %53
  %.1989.1 = load double, ptr %scevgep84, align 8
  %.1991.1 = fmul double %.1729, %.1989.1
  %.2047.1 = fmul double %.1766, %.1989.1
  %scevgep85 = getelementptr i8, ptr %30, i64 %53
  %.2101.1 = load double, ptr %scevgep85, align 8
  %.2103.1 = fmul double %.1808, %.2101.1
  %.2104.1 = fadd double %.2047.1, %.2103.1
  %scevgep90 = getelementptr i8, ptr %scevgep91, i64 8
  store double %.1991.1, ptr %scevgep90, align 8
  %scevgep87 = getelementptr i8, ptr %scevgep88, i64 8
  store double %.2104.1, ptr %scevgep87, align 8
  %scevgep81 = getelementptr i8, ptr %lsr.iv80, i64 %23
  %exitcond.not.1 = icmp eq i64 %arg.sides.5.0, %.1911.1
  br i1 %exitcond.not.1, label %B980, label %B874, !llvm.loop !0

B980:                                             ; preds = %B874, %B874.prol.loopexit, %middle.block, %B94
  br i1 %25, label %B1014.endif, label %B1168

B1168:                                            ; preds = %B1014.endif, %B980
  %scevgep75 = getelementptr i8, ptr %lsr.iv, i64 %5
  %scevgep78 = getelementptr i8, ptr %lsr.iv77, i64 %9
  %exitcond1028.not = icmp eq i64 %.350, %arg.v.5.0
  br i1 %exitcond1028.not, label %common.ret, label %B94

common.ret:                                       ; preds = %B1168, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B874.lr.ph:                                       ; preds = %B94
  %.2152 = mul i64 %.343973992, %arg.slopes.5.1
  %32 = getelementptr double, ptr %arg.slopes.4, i64 %.2152
  %.2207 = mul i64 %.343973992, %arg.bends.5.1
  %33 = getelementptr double, ptr %arg.bends.4, i64 %.2207
  br i1 %brmerge65, label %B874.preheader, label %vector.ph

vector.ph:                                        ; preds = %B874.lr.ph
  %broadcast.splatinsert = insertelement <2 x double> poison, double %.1729, i64 0
  %broadcast.splat = shufflevector <2 x double> %broadcast.splatinsert, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert61 = insertelement <2 x double> poison, double %.1766, i64 0
  %broadcast.splat62 = shufflevector <2 x double> %broadcast.splatinsert61, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert63 = insertelement <2 x double> poison, double %.1808, i64 0
  %broadcast.splat64 = shufflevector <2 x double> %broadcast.splatinsert63, <2 x double> poison, <2 x i32> zeroinitializer
  br label %vector.body

vector.body:                                      ; preds = %vector.body, %vector.ph
  %index = phi i64 [ 0, %vector.ph ], [ %index.next, %vector.body ]
  %scevgep69 = getelementptr i8, ptr %scevgep67, i64 %index
  %scevgep70 = getelementptr i8, ptr %scevgep69, i64 -1
  %34 = load double, ptr %scevgep70, align 8, !alias.scope !2
  %35 = load double, ptr %scevgep69, align 8, !alias.scope !2
  %36 = insertelement <2 x double> poison, double %34, i64 0
  %37 = insertelement <2 x double> %36, double %35, i64 1
  %38 = fmul <2 x double> %broadcast.splat, %37
  %39 = fmul <2 x double> %broadcast.splat62, %37
  %scevgep73 = getelementptr i8, ptr %scevgep71, i64 %index
  %scevgep74 = getelementptr i8, ptr %scevgep73, i64 -1
  %40 = load double, ptr %scevgep74, align 8, !alias.scope !5
  %41 = load double, ptr %scevgep73, align 8, !alias.scope !5
  %42 = insertelement <2 x double> poison, double %40, i64 0
  %43 = insertelement <2 x double> %42, double %41, i64 1
  %44 = fmul <2 x double> %broadcast.splat64, %43
  %45 = fadd <2 x double> %39, %44
  %46 = shl i64 %index, 3
  %scevgep76 = getelementptr i8, ptr %lsr.iv, i64 %46
  store <2 x double> %38, ptr %scevgep76, align 8, !alias.scope !7, !noalias !9
  %scevgep79 = getelementptr i8, ptr %lsr.iv77, i64 %46
  store <2 x double> %45, ptr %scevgep79, align 8, !alias.scope !11, !noalias !12
  %index.next = add nuw nsw i64 %index, 2
  %47 = icmp eq i64 %n.vec, %index.next
  br i1 %47, label %middle.block, label %vector.body, !llvm.loop !13

middle.block:                                     ; preds = %vector.body
  br i1 %27, label %B980, label %B874.preheader

B874.preheader:                                   ; preds = %middle.block, %B874.lr.ph
  %.1904952954.ph = phi i64 [ 0, %B874.lr.ph ], [ %n.vec, %middle.block ]
  %.neg = or disjoint i64 %.1904952954.ph, 1
  br i1 %29, label %B874.prol.loopexit, label %B874.prol

B874.prol:                                        ; preds = %B874.preheader
  %.1983.prol = mul i64 %.1904952954.ph, %arg.sides.6.0
  %.1987.prol = getelementptr i8, ptr %arg.sides.4, i64 %.1983.prol
  %.1989.prol = load double, ptr %.1987.prol, align 8
  %.1991.prol = fmul double %.1729, %.1989.prol
  %.2047.prol = fmul double %.1766, %.1989.prol
  %gep.prol = getelementptr i8, ptr %invariant.gep, i64 %.1983.prol
  %.2101.prol = load double, ptr %gep.prol, align 8
  %.2103.prol = fmul double %.1808, %.2101.prol
  %.2104.prol = fadd double %.2047.prol, %.2103.prol
  %48 = getelementptr double, ptr %32, i64 %.1904952954.ph
  store double %.1991.prol, ptr %48, align 8
  %49 = getelementptr double, ptr %33, i64 %.1904952954.ph
  store double %.2104.prol, ptr %49, align 8
  br label %B874.prol.loopexit

B874.prol.loopexit:                               ; preds = %B874.prol, %B874.preheader
  %.1904952954.unr = phi i64 [ %.1904952954.ph, %B874.preheader ], [ %.neg, %B874.prol ]
  %50 = icmp eq i64 %arg.sides.5.0, %.neg
  br i1 %50, label %B980, label %B874.preheader66

B874.preheader66:                                 ; preds = %B874.prol.loopexit
  %51 = mul i64 %.1904952954.unr, %arg.sides.6.0
  %52 = add nuw i64 %.1904952954.unr, 1
  %53 = mul i64 %52, %arg.sides.6.0
  br label %B874

B1014.endif:                                      ; preds = %B980
  %.2292 = mul i64 %.343973992, %arg.ramps.6.0
  %.2296 = getelementptr i8, ptr %arg.ramps.4, i64 %.2292
  %.2298 = load double, ptr %.2296, align 8
  %gep964 = getelementptr i8, ptr %invariant.gep963, i64 %.2292
  %.2353 = load double, ptr %gep964, align 8
  %.2354 = fadd double %.2298, %.2353
  %.2359 = fmul double %.2354, 5.000000e-01
  %.2364 = fdiv double %sqrt, %.2359
  %.2371 = fdiv double %.1515, %.2359
  %.2484 = fsub double %.2353, %.2298
  %.2489 = fmul double %.2484, 5.000000e-01
  %.2493 = fdiv double %.2489, %.2359
  %.2542 = mul i64 %.343973992, %arg.slopes.5.1
  %gep1005 = getelementptr double, ptr %invariant.gep1004, i64 %.2542
  store double %.2364, ptr %gep1005, align 8
  %.2598 = mul i64 %.343973992, %arg.bends.5.1
  %gep1007 = getelementptr double, ptr %invariant.gep1006, i64 %.2598
  store double %.2371, ptr %gep1007, align 8
  %.2655 = mul i64 %.343973992, %arg.rests.6.0
  %gep1009 = getelementptr i8, ptr %invariant.gep1008, i64 %.2655
  store double %.2493, ptr %gep1009, align 8
  br label %B1168
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sqrt.f64(double) #1

attributes #0 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #1 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }

!0 = distinct !{!0, !1}
!1 = !{!"llvm.loop.isvectorized", i32 1}
!2 = !{!3}
!3 = distinct !{!3, !4}
!4 = distinct !{!4, !"LVerDomain"}
!5 = !{!6}
!6 = distinct !{!6, !4}
!7 = !{!8}
!8 = distinct !{!8, !4}
!9 = !{!10, !6, !3}
!10 = distinct !{!10, !4}
!11 = !{!10}
!12 = !{!6, !3}
!13 = distinct !{!13, !1, !14}
!14 = !{!"llvm.loop.unroll.runtime.disable"}
