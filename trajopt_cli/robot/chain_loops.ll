; sha256 79db7b2cab242af524b6d6960ac05a288e5b34e1da064a01cda28f9b4b1a4ffc of chain_loops.py and of this
; made by numba 0.68.1, llvmlite 0.50.0, Python 3.11.7
; loops.poses: array(float64, 2d, C); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 3d, C); array(float64, 2d, A); array(float64, 3d, C)
; loops.points: array(float64, 2d, C); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 3d, C); array(float64, 2d, A); array(float64, 3d, C)
; loops.jacobians: array(float64, 2d, C); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 3d, C); array(float64, 2d, A); array(float64, 3d, C)
; loops.motions: array(float64, 2d, C); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 3d, C); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 3d, C)
; loops.follow: array(float64, 2d, C); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 3d, C); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, C); array(float64, 2d, C)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.poses(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.chain.0, ptr readnone captures(none) %arg.chain.1, i64 %arg.chain.2, i64 %arg.chain.3, ptr readonly captures(none) %arg.chain.4, i64 %arg.chain.5.0, i64 %arg.chain.5.1, i64 %arg.chain.6.0, i64 %arg.chain.6.1, ptr readnone captures(none) %arg.X_WC.0, ptr readnone captures(none) %arg.X_WC.1, i64 %arg.X_WC.2, i64 %arg.X_WC.3, ptr readonly captures(none) %arg.X_WC.4, i64 %arg.X_WC.5.0, i64 %arg.X_WC.5.1, i64 %arg.X_WC.6.0, i64 %arg.X_WC.6.1, ptr readnone captures(none) %arg.ride.0, ptr readnone captures(none) %arg.ride.1, i64 %arg.ride.2, i64 %arg.ride.3, ptr readonly captures(none) %arg.ride.4, i64 %arg.ride.5.0, i64 %arg.ride.5.1, i64 %arg.ride.6.0, i64 %arg.ride.6.1, ptr readnone captures(none) %arg.X_6T.0, ptr readnone captures(none) %arg.X_6T.1, i64 %arg.X_6T.2, i64 %arg.X_6T.3, ptr readonly captures(none) %arg.X_6T.4, i64 %arg.X_6T.5.0, i64 %arg.X_6T.5.1, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr readnone captures(none) %arg.room.0, ptr readnone captures(none) %arg.room.1, i64 %arg.room.2, i64 %arg.room.3, ptr %arg.room.4, i64 %arg.room.5.0, i64 %arg.room.5.1, i64 %arg.room.5.2, i64 %arg.room.6.0, i64 %arg.room.6.1, i64 %arg.room.6.2, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.5.1, i64 %arg.q.6.0, i64 %arg.q.6.1, ptr readnone captures(none) %arg.X.0, ptr readnone captures(none) %arg.X.1, i64 %arg.X.2, i64 %arg.X.3, ptr writeonly captures(none) %arg.X.4, i64 %arg.X.5.0, i64 %arg.X.5.1, i64 %arg.X.5.2, i64 %arg.X.6.0, i64 %arg.X.6.1, i64 %arg.X.6.2) local_unnamed_addr #0 {
B0.endif:
  %.250589.not = icmp slt i64 %arg.q.5.0, 1
  br i1 %.250589.not, label %B416, label %B62.lr.ph

B62.lr.ph:                                        ; preds = %B0.endif
  %factor.op.mul = shl i64 %arg.room.5.1, 4
  %.467.reass = mul i64 %factor.op.mul, %arg.room.5.2
  %0 = getelementptr i8, ptr %arg.room.4, i64 %.467.reass
  %.idx558 = mul i64 %arg.room.5.2, 48
  %.idx559 = mul i64 %arg.X.5.2, 24
  %1 = getelementptr i8, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0
  %.idx560 = shl i64 %arg.room.5.2, 4
  %.1077 = shl i64 %arg.X_6T.6.0, 1
  %2 = getelementptr i8, ptr %arg.X_6T.4, i64 %.1077
  %.idx = shl i64 %arg.X.5.2, 4
  %scevgep = getelementptr i8, ptr %arg.X.4, i64 24
  %3 = shl i64 %arg.X.5.1, 3
  %4 = mul i64 %3, %arg.X.5.2
  %.idx.i = mul i64 %arg.room.5.2, 40
  %.168.i = mul i64 %arg.room.5.2, %arg.room.5.1
  %.348.idx.i = shl i64 %.168.i, 4
  %.348.i = getelementptr i8, ptr %arg.room.4, i64 %.348.idx.i
  %5 = getelementptr i8, ptr %.348.i, i64 %.idx.i
  %.3175.i = mul i64 %arg.X_6T.6.1, 3
  %.3178.i = getelementptr i8, ptr %arg.X_6T.4, i64 %.3175.i
  %.3288.i = getelementptr i8, ptr %1, i64 %.3175.i
  %.3398.i = getelementptr i8, ptr %2, i64 %.3175.i
  %6 = getelementptr i8, ptr %.348.i, i64 %.idx558
  %.447.i = add nsw i64 %arg.q.5.1, -6
  %.622.i = mul i64 %arg.X_WC.6.1, 3
  %invariant.gep1184.i = getelementptr i8, ptr %arg.X_WC.4, i64 %.622.i
  %.721.i = icmp slt i64 %arg.q.5.1, 7
  %..447.i = select i1 %.721.i, i64 0, i64 %.447.i
  %.7631173.i = icmp sgt i64 %..447.i, 0
  %invariant.gep1178.2.i = getelementptr i8, ptr %arg.room.4, i64 16
  %gep1179.1.2.i = getelementptr double, ptr %invariant.gep1178.2.i, i64 %arg.room.5.2
  %7 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  %8 = getelementptr i8, ptr %arg.room.4, i64 %.idx560
  %.2054.1.i = getelementptr i8, ptr %arg.room.4, i64 8
  %.2165.1.i = getelementptr i8, ptr %7, i64 8
  %.2276.1.i = getelementptr i8, ptr %8, i64 8
  %.2165.2.i = getelementptr i8, ptr %7, i64 16
  %.2276.2.i = getelementptr i8, ptr %8, i64 16
  %.1431.peel.i = getelementptr i8, ptr %arg.chain.4, i64 8
  %.1449.peel.i = icmp slt i64 %arg.q.5.1, 6
  %.1450.peel.i = select i1 %.1449.peel.i, i64 %arg.q.5.1, i64 0
  %.1451.peel.i = add i64 %.1450.peel.i, %.447.i
  %.1462.peel.i = mul i64 %.1451.peel.i, %arg.q.6.1
  %.1521.peel.i = getelementptr i8, ptr %arg.chain.4, i64 16
  %.1577.peel.i = getelementptr i8, ptr %arg.chain.4, i64 48
  %.2109.peel.i = getelementptr i8, ptr %arg.chain.4, i64 24
  %.2220.peel.i = getelementptr i8, ptr %arg.chain.4, i64 32
  %.2331.peel.i = getelementptr i8, ptr %arg.chain.4, i64 40
  %sunkaddr101.i = shl i64 %.168.i, 3
  %sunkaddr102.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr101.i
  %sunkaddr130.i = getelementptr i8, ptr %.348.i, i64 8
  %sunkaddr107.i = getelementptr i8, ptr %sunkaddr102.i, i64 8
  %sunkaddr132.i = getelementptr i8, ptr %.348.i, i64 16
  %sunkaddr112.i = getelementptr i8, ptr %sunkaddr102.i, i64 16
  %9 = add i64 %.348.idx.i, 16
  %10 = shl i64 %arg.room.5.2, 3
  %11 = or disjoint i64 %factor.op.mul, 8
  %12 = mul i64 %11, %arg.room.5.2
  %13 = add i64 %12, 16
  %14 = shl i64 %arg.room.5.1, 3
  %15 = add i64 %14, 8
  %16 = mul i64 %15, %arg.room.5.2
  %17 = add i64 %16, 16
  %18 = shl i64 %arg.chain.5.1, 3
  %19 = getelementptr i8, ptr %arg.chain.4, i64 %18
  %scevgep49.i = getelementptr i8, ptr %19, i64 48
  %20 = add i64 %arg.q.5.1, -5
  %sunkaddr134.i = getelementptr i8, ptr %arg.room.4, i64 %10
  %sunkaddr139.i = getelementptr i8, ptr %sunkaddr134.i, i64 8
  %sunkaddr145.i = getelementptr i8, ptr %sunkaddr134.i, i64 16
  %.3071.1.i = getelementptr i8, ptr %5, i64 8
  %.3455.1.i = getelementptr i8, ptr %6, i64 8
  %.3071.2.i = getelementptr i8, ptr %5, i64 16
  %.3455.2.i = getelementptr i8, ptr %6, i64 16
  %sunkaddr35 = getelementptr i8, ptr %arg.X_6T.4, i64 %arg.X_6T.6.1
  %sunkaddr36 = getelementptr i8, ptr %1, i64 %arg.X_6T.6.1
  %sunkaddr37 = getelementptr i8, ptr %2, i64 %arg.X_6T.6.1
  %sunkaddr38 = shl i64 %arg.X_6T.6.1, 1
  %sunkaddr39 = getelementptr i8, ptr %arg.X_6T.4, i64 %sunkaddr38
  %sunkaddr41 = getelementptr i8, ptr %1, i64 %sunkaddr38
  %sunkaddr43 = getelementptr i8, ptr %2, i64 %sunkaddr38
  %sunkaddr44 = getelementptr i8, ptr %0, i64 %.idx558
  %sunkaddr51 = shl i64 %arg.X.5.2, 3
  %sunkaddr61 = getelementptr i8, ptr %sunkaddr44, i64 8
  %sunkaddr71 = getelementptr i8, ptr %sunkaddr44, i64 16
  %.1168.1.i = getelementptr i8, ptr %arg.X_WC.4, i64 %arg.X_WC.6.1
  %.1165.2.i = shl i64 %arg.X_WC.6.1, 1
  %.1168.2.i = getelementptr i8, ptr %arg.X_WC.4, i64 %.1165.2.i
  %.1220.2.i = shl i64 %arg.room.5.2, 1
  %gep1179.2.i = getelementptr double, ptr %arg.room.4, i64 %.1220.2.i
  %gep1185.1.i = getelementptr i8, ptr %invariant.gep1184.i, i64 %arg.X_WC.6.0
  %21 = getelementptr i8, ptr %arg.X_WC.4, i64 %arg.X_WC.6.0
  %.1168.1.1.i = getelementptr i8, ptr %21, i64 %arg.X_WC.6.1
  %gep1179.1.1.i = getelementptr double, ptr %.2054.1.i, i64 %arg.room.5.2
  %.1168.2.1.i = getelementptr i8, ptr %21, i64 %.1165.2.i
  %gep1179.2.1.i = getelementptr double, ptr %.2054.1.i, i64 %.1220.2.i
  %.621.2.i = shl i64 %arg.X_WC.6.0, 1
  %gep1185.2.i = getelementptr i8, ptr %invariant.gep1184.i, i64 %.621.2.i
  %22 = icmp eq i64 %..447.i, 1
  %unroll_iter.i = and i64 %..447.i, 9223372036854775806
  %23 = shl i64 %arg.ride.6.0, 1
  %24 = shl i64 %arg.q.6.1, 1
  %25 = add nsw i64 %..447.i, -2
  %26 = lshr i64 %25, 1
  %27 = icmp eq i64 %26, 0
  %28 = add nuw nsw i64 %26, 1
  %unroll_iter12.i = and i64 %28, 9223372036854775806
  %29 = and i64 %25, 2
  %lcmp.mod.not55.not.i = icmp eq i64 %29, 0
  %30 = and i64 %..447.i, 1
  %lcmp.mod.not.i = icmp eq i64 %30, 0
  %invariant.gep.us.1.i = getelementptr i8, ptr %arg.ride.4, i64 %arg.ride.6.1
  %.903.us.2.i = shl i64 %arg.ride.6.1, 1
  %invariant.gep.us.2.i = getelementptr i8, ptr %arg.ride.4, i64 %.903.us.2.i
  %.902.us.epil.i = mul i64 %unroll_iter.i, %arg.ride.6.0
  %gep.us.epil.i = getelementptr i8, ptr %arg.ride.4, i64 %.902.us.epil.i
  %.937.us.epil.i = mul i64 %unroll_iter.i, %arg.q.6.1
  %.902.us.1.epil.i = mul i64 %unroll_iter.i, %arg.ride.6.0
  %gep.us.1.epil.i = getelementptr i8, ptr %invariant.gep.us.1.i, i64 %.902.us.1.epil.i
  %.937.us.1.epil.i = mul i64 %unroll_iter.i, %arg.q.6.1
  %.902.us.2.epil.i = mul i64 %unroll_iter.i, %arg.ride.6.0
  %gep.us.2.epil.i = getelementptr i8, ptr %invariant.gep.us.2.i, i64 %.902.us.2.epil.i
  %.937.us.2.epil.i = mul i64 %unroll_iter.i, %arg.q.6.1
  %31 = getelementptr i8, ptr %arg.X_WC.4, i64 %.621.2.i
  %.1168.1.2.i = getelementptr i8, ptr %31, i64 %arg.X_WC.6.1
  %.1168.2.2.i = getelementptr i8, ptr %31, i64 %.1165.2.i
  %gep1179.2.2.i = getelementptr double, ptr %invariant.gep1178.2.i, i64 %.1220.2.i
  br label %B62

B62:                                              ; preds = %part.0, %B62.lr.ph
  %lsr.iv32 = phi i64 [ %arg.q.5.0, %B62.lr.ph ], [ %lsr.iv.next, %part.0 ]
  %lsr.iv30 = phi ptr [ %arg.q.4, %B62.lr.ph ], [ %scevgep31, %part.0 ]
  %lsr.iv = phi ptr [ %scevgep, %B62.lr.ph ], [ %scevgep8, %part.0 ]
  %.627.us.i = load double, ptr %invariant.gep1184.i, align 8, !noalias !0
  store double %.627.us.i, ptr %.348.i, align 8, !noalias !0
  br i1 %.7631173.i, label %B184.us.preheader.i, label %B120.endif.preheader.i

B184.us.preheader.i:                              ; preds = %B62
  br i1 %22, label %B184.us.epil.preheader.i, label %B184.us.preheader.new.i

B184.us.preheader.new.i:                          ; preds = %B184.us.preheader.i
  br i1 %27, label %B184.us.epil.preheader3.i, label %B184.us.i

B120.endif.preheader.i:                           ; preds = %B62
  %.1170.i = load double, ptr %arg.X_WC.4, align 8, !noalias !0
  store double %.1170.i, ptr %arg.room.4, align 8, !noalias !0
  %.1170.1.i = load double, ptr %.1168.1.i, align 8, !noalias !0
  store double %.1170.1.i, ptr %7, align 8, !noalias !0
  %.1170.2.i = load double, ptr %.1168.2.i, align 8, !noalias !0
  store double %.1170.2.i, ptr %gep1179.2.i, align 8, !noalias !0
  %.627.1.i = load double, ptr %gep1185.1.i, align 8, !noalias !0
  store double %.627.1.i, ptr %sunkaddr130.i, align 8, !noalias !0
  %.1170.11251.i = load double, ptr %21, align 8, !noalias !0
  store double %.1170.11251.i, ptr %.2054.1.i, align 8, !noalias !0
  %.1170.1.1.i = load double, ptr %.1168.1.1.i, align 8, !noalias !0
  store double %.1170.1.1.i, ptr %gep1179.1.1.i, align 8, !noalias !0
  %.1170.2.1.i = load double, ptr %.1168.2.1.i, align 8, !noalias !0
  store double %.1170.2.1.i, ptr %gep1179.2.1.i, align 8, !noalias !0
  %.627.2.i = load double, ptr %gep1185.2.i, align 8, !noalias !0
  br label %B652.endif.2.peel.next.i.sink.split

B184.us.1.i:                                      ; preds = %B182.B258.endif.endif_crit_edge.us.new.i, %B184.us.1.i
  %lsr.iv81.i = phi i64 [ %lsr.iv.next82.i, %B184.us.1.i ], [ %unroll_iter12.i, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %lsr.iv71.i = phi ptr [ %scevgep88.i, %B184.us.1.i ], [ %lsr.iv30, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %lsr.iv68.i = phi ptr [ %scevgep85.i, %B184.us.1.i ], [ %invariant.gep.us.1.i, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %.9431177.us.1.i = phi double [ %.943.us.1.1.1.i, %B184.us.1.i ], [ %.627.us.1.i, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %.908.us.1.i = load double, ptr %lsr.iv68.i, align 8, !noalias !0
  %.941.us.1.i = load double, ptr %lsr.iv71.i, align 8, !noalias !0
  %.942.us.1.i = fmul double %.908.us.1.i, %.941.us.1.i
  %.943.us.1.i = fadd double %.9431177.us.1.i, %.942.us.1.i
  store double %.943.us.1.i, ptr %sunkaddr130.i, align 8, !noalias !0
  %scevgep70.i = getelementptr i8, ptr %lsr.iv68.i, i64 %arg.ride.6.0
  %.908.us.1.1.i = load double, ptr %scevgep70.i, align 8, !noalias !0
  %scevgep73.i = getelementptr i8, ptr %lsr.iv71.i, i64 %arg.q.6.1
  %.941.us.1.1.i = load double, ptr %scevgep73.i, align 8, !noalias !0
  %.942.us.1.1.i = fmul double %.908.us.1.1.i, %.941.us.1.1.i
  %.943.us.1.1.i = fadd double %.943.us.1.i, %.942.us.1.1.i
  store double %.943.us.1.1.i, ptr %sunkaddr130.i, align 8, !noalias !0
  %scevgep83.i = getelementptr i8, ptr %scevgep70.i, i64 %arg.ride.6.0
  %.908.us.1.134.i = load double, ptr %scevgep83.i, align 8, !noalias !0
  %scevgep86.i = getelementptr i8, ptr %scevgep73.i, i64 %arg.q.6.1
  %.941.us.1.135.i = load double, ptr %scevgep86.i, align 8, !noalias !0
  %.942.us.1.136.i = fmul double %.908.us.1.134.i, %.941.us.1.135.i
  %.943.us.1.137.i = fadd double %.943.us.1.1.i, %.942.us.1.136.i
  store double %.943.us.1.137.i, ptr %sunkaddr130.i, align 8, !noalias !0
  %scevgep84.i = getelementptr i8, ptr %scevgep83.i, i64 %arg.ride.6.0
  %.908.us.1.1.1.i = load double, ptr %scevgep84.i, align 8, !noalias !0
  %scevgep87.i = getelementptr i8, ptr %scevgep86.i, i64 %arg.q.6.1
  %.941.us.1.1.1.i = load double, ptr %scevgep87.i, align 8, !noalias !0
  %.942.us.1.1.1.i = fmul double %.908.us.1.1.1.i, %.941.us.1.1.1.i
  %.943.us.1.1.1.i = fadd double %.943.us.1.137.i, %.942.us.1.1.1.i
  store double %.943.us.1.1.1.i, ptr %sunkaddr130.i, align 8, !noalias !0
  %lsr.iv.next82.i = add i64 %lsr.iv81.i, -2
  %niter33.ncmp.1.i = icmp eq i64 %lsr.iv.next82.i, 0
  %scevgep85.i = getelementptr i8, ptr %scevgep84.i, i64 %arg.ride.6.0
  %scevgep88.i = getelementptr i8, ptr %scevgep87.i, i64 %arg.q.6.1
  br i1 %niter33.ncmp.1.i, label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i, label %B184.us.1.i

B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i: ; preds = %B184.us.1.i
  %scevgep72.i = getelementptr i8, ptr %lsr.iv71.i, i64 %24
  %scevgep72.1.i = getelementptr i8, ptr %scevgep72.i, i64 %24
  %scevgep69.i = getelementptr i8, ptr %lsr.iv68.i, i64 %23
  %scevgep69.1.i = getelementptr i8, ptr %scevgep69.i, i64 %23
  br i1 %lcmp.mod.not55.not.i, label %B184.us.1.epil.preheader21.i, label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i

B184.us.1.epil.preheader21.i:                     ; preds = %B182.B258.endif.endif_crit_edge.us.new.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i
  %lsr.iv71.epil.init.i = phi ptr [ %lsr.iv30, %B182.B258.endif.endif_crit_edge.us.new.i ], [ %scevgep72.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ]
  %lsr.iv68.epil.init.i = phi ptr [ %invariant.gep.us.1.i, %B182.B258.endif.endif_crit_edge.us.new.i ], [ %scevgep69.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ]
  %.9431177.us.1.epil.init27.i = phi double [ %.627.us.1.i, %B182.B258.endif.endif_crit_edge.us.new.i ], [ %.943.us.1.1.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ]
  %.908.us.1.epil23.i = load double, ptr %lsr.iv68.epil.init.i, align 8, !noalias !0
  %.941.us.1.epil24.i = load double, ptr %lsr.iv71.epil.init.i, align 8, !noalias !0
  %.942.us.1.epil25.i = fmul double %.908.us.1.epil23.i, %.941.us.1.epil24.i
  %.943.us.1.epil26.i = fadd double %.9431177.us.1.epil.init27.i, %.942.us.1.epil25.i
  store double %.943.us.1.epil26.i, ptr %sunkaddr130.i, align 8, !noalias !0
  %scevgep70.epil.i = getelementptr i8, ptr %lsr.iv68.epil.init.i, i64 %arg.ride.6.0
  %.908.us.1.1.epil.i = load double, ptr %scevgep70.epil.i, align 8, !noalias !0
  %scevgep73.epil.i = getelementptr i8, ptr %lsr.iv71.epil.init.i, i64 %arg.q.6.1
  %.941.us.1.1.epil.i = load double, ptr %scevgep73.epil.i, align 8, !noalias !0
  %.942.us.1.1.epil.i = fmul double %.908.us.1.1.epil.i, %.941.us.1.1.epil.i
  %.943.us.1.1.epil.i = fadd double %.943.us.1.epil26.i, %.942.us.1.1.epil.i
  store double %.943.us.1.1.epil.i, ptr %sunkaddr130.i, align 8, !noalias !0
  br label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i

B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i: ; preds = %B184.us.1.epil.preheader21.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i
  %.943.us.1.1.lcssa.i = phi double [ %.943.us.1.1.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ], [ %.943.us.1.1.epil.i, %B184.us.1.epil.preheader21.i ]
  br i1 %lcmp.mod.not.i, label %B182.B258.endif.endif_crit_edge.us.1.i, label %B184.us.1.epil.preheader.i

B184.us.1.epil.preheader.i:                       ; preds = %B182.B258.endif.endif_crit_edge.us.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i
  %.9431177.us.1.epil.init.i = phi double [ %.627.us.1.i, %B182.B258.endif.endif_crit_edge.us.i ], [ %.943.us.1.1.lcssa.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i ]
  %.908.us.1.epil.i = load double, ptr %gep.us.1.epil.i, align 8, !noalias !0
  %.939.us.1.epil.i = getelementptr i8, ptr %lsr.iv30, i64 %.937.us.1.epil.i
  %.941.us.1.epil.i = load double, ptr %.939.us.1.epil.i, align 8, !noalias !0
  %.942.us.1.epil.i = fmul double %.908.us.1.epil.i, %.941.us.1.epil.i
  %.943.us.1.epil.i = fadd double %.9431177.us.1.epil.init.i, %.942.us.1.epil.i
  store double %.943.us.1.epil.i, ptr %sunkaddr130.i, align 8, !noalias !0
  br label %B182.B258.endif.endif_crit_edge.us.1.i

B182.B258.endif.endif_crit_edge.us.1.i:           ; preds = %B184.us.1.epil.preheader.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i
  %.1170.us.11255.i = load double, ptr %21, align 8, !noalias !0
  store double %.1170.us.11255.i, ptr %.2054.1.i, align 8, !noalias !0
  %.1170.us.1.1.i = load double, ptr %.1168.1.1.i, align 8, !noalias !0
  store double %.1170.us.1.1.i, ptr %gep1179.1.1.i, align 8, !noalias !0
  %.1170.us.2.1.i = load double, ptr %.1168.2.1.i, align 8, !noalias !0
  store double %.1170.us.2.1.i, ptr %gep1179.2.1.i, align 8, !noalias !0
  %.627.us.2.i = load double, ptr %gep1185.2.i, align 8, !noalias !0
  store double %.627.us.2.i, ptr %sunkaddr132.i, align 8, !noalias !0
  br i1 %22, label %B184.us.2.epil.preheader.i, label %B182.B258.endif.endif_crit_edge.us.1.new.i

B182.B258.endif.endif_crit_edge.us.1.new.i:       ; preds = %B182.B258.endif.endif_crit_edge.us.1.i
  br i1 %27, label %B184.us.2.epil.preheader38.i, label %B184.us.2.i

B184.us.2.i:                                      ; preds = %B182.B258.endif.endif_crit_edge.us.1.new.i, %B184.us.2.i
  %lsr.iv63.i = phi i64 [ %lsr.iv.next64.i, %B184.us.2.i ], [ %unroll_iter12.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %lsr.iv65.i = phi ptr [ %scevgep80.i, %B184.us.2.i ], [ %lsr.iv30, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %lsr.iv62.i = phi ptr [ %scevgep71.i, %B184.us.2.i ], [ %invariant.gep.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %.9431177.us.2.i = phi double [ %.943.us.2.1.1.i, %B184.us.2.i ], [ %.627.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %.908.us.2.i = load double, ptr %lsr.iv62.i, align 8, !noalias !0
  %.941.us.2.i = load double, ptr %lsr.iv65.i, align 8, !noalias !0
  %.942.us.2.i = fmul double %.908.us.2.i, %.941.us.2.i
  %.943.us.2.i = fadd double %.9431177.us.2.i, %.942.us.2.i
  store double %.943.us.2.i, ptr %sunkaddr132.i, align 8, !noalias !0
  %scevgep64.i = getelementptr i8, ptr %lsr.iv62.i, i64 %arg.ride.6.0
  %.908.us.2.1.i = load double, ptr %scevgep64.i, align 8, !noalias !0
  %scevgep67.i = getelementptr i8, ptr %lsr.iv65.i, i64 %arg.q.6.1
  %.941.us.2.1.i = load double, ptr %scevgep67.i, align 8, !noalias !0
  %.942.us.2.1.i = fmul double %.908.us.2.1.i, %.941.us.2.1.i
  %.943.us.2.1.i = fadd double %.943.us.2.i, %.942.us.2.1.i
  store double %.943.us.2.1.i, ptr %sunkaddr132.i, align 8, !noalias !0
  %scevgep65.i = getelementptr i8, ptr %scevgep64.i, i64 %arg.ride.6.0
  %.908.us.2.151.i = load double, ptr %scevgep65.i, align 8, !noalias !0
  %scevgep74.i = getelementptr i8, ptr %scevgep67.i, i64 %arg.q.6.1
  %.941.us.2.152.i = load double, ptr %scevgep74.i, align 8, !noalias !0
  %.942.us.2.153.i = fmul double %.908.us.2.151.i, %.941.us.2.152.i
  %.943.us.2.154.i = fadd double %.943.us.2.1.i, %.942.us.2.153.i
  store double %.943.us.2.154.i, ptr %sunkaddr132.i, align 8, !noalias !0
  %scevgep68.i = getelementptr i8, ptr %scevgep65.i, i64 %arg.ride.6.0
  %.908.us.2.1.1.i = load double, ptr %scevgep68.i, align 8, !noalias !0
  %scevgep77.i = getelementptr i8, ptr %scevgep74.i, i64 %arg.q.6.1
  %.941.us.2.1.1.i = load double, ptr %scevgep77.i, align 8, !noalias !0
  %.942.us.2.1.1.i = fmul double %.908.us.2.1.1.i, %.941.us.2.1.1.i
  %.943.us.2.1.1.i = fadd double %.943.us.2.154.i, %.942.us.2.1.1.i
  store double %.943.us.2.1.1.i, ptr %sunkaddr132.i, align 8, !noalias !0
  %lsr.iv.next64.i = add i64 %lsr.iv63.i, -2
  %niter50.ncmp.1.i = icmp eq i64 %lsr.iv.next64.i, 0
  %scevgep71.i = getelementptr i8, ptr %scevgep68.i, i64 %arg.ride.6.0
  %scevgep80.i = getelementptr i8, ptr %scevgep77.i, i64 %arg.q.6.1
  br i1 %niter50.ncmp.1.i, label %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i, label %B184.us.2.i

B184.us.i:                                        ; preds = %B184.us.preheader.new.i, %B184.us.i
  %lsr.iv89.i = phi i64 [ %lsr.iv.next90.i, %B184.us.i ], [ %unroll_iter12.i, %B184.us.preheader.new.i ]
  %lsr.iv77.i = phi ptr [ %scevgep96.i, %B184.us.i ], [ %lsr.iv30, %B184.us.preheader.new.i ]
  %lsr.iv74.i = phi ptr [ %scevgep93.i, %B184.us.i ], [ %arg.ride.4, %B184.us.preheader.new.i ]
  %.9431177.us.i = phi double [ %.943.us.119.1.i, %B184.us.i ], [ %.627.us.i, %B184.us.preheader.new.i ]
  %.908.us.i = load double, ptr %lsr.iv74.i, align 8, !noalias !0
  %.941.us.i = load double, ptr %lsr.iv77.i, align 8, !noalias !0
  %.942.us.i = fmul double %.908.us.i, %.941.us.i
  %.943.us.i = fadd double %.9431177.us.i, %.942.us.i
  store double %.943.us.i, ptr %.348.i, align 8, !noalias !0
  %scevgep76.i = getelementptr i8, ptr %lsr.iv74.i, i64 %arg.ride.6.0
  %.908.us.114.i = load double, ptr %scevgep76.i, align 8, !noalias !0
  %scevgep79.i = getelementptr i8, ptr %lsr.iv77.i, i64 %arg.q.6.1
  %.941.us.117.i = load double, ptr %scevgep79.i, align 8, !noalias !0
  %.942.us.118.i = fmul double %.908.us.114.i, %.941.us.117.i
  %.943.us.119.i = fadd double %.943.us.i, %.942.us.118.i
  store double %.943.us.119.i, ptr %.348.i, align 8, !noalias !0
  %scevgep91.i = getelementptr i8, ptr %scevgep76.i, i64 %arg.ride.6.0
  %.908.us.115.i = load double, ptr %scevgep91.i, align 8, !noalias !0
  %scevgep94.i = getelementptr i8, ptr %scevgep79.i, i64 %arg.q.6.1
  %.941.us.116.i = load double, ptr %scevgep94.i, align 8, !noalias !0
  %.942.us.117.i = fmul double %.908.us.115.i, %.941.us.116.i
  %.943.us.118.i = fadd double %.943.us.119.i, %.942.us.117.i
  store double %.943.us.118.i, ptr %.348.i, align 8, !noalias !0
  %scevgep92.i = getelementptr i8, ptr %scevgep91.i, i64 %arg.ride.6.0
  %.908.us.114.1.i = load double, ptr %scevgep92.i, align 8, !noalias !0
  %scevgep95.i = getelementptr i8, ptr %scevgep94.i, i64 %arg.q.6.1
  %.941.us.117.1.i = load double, ptr %scevgep95.i, align 8, !noalias !0
  %.942.us.118.1.i = fmul double %.908.us.114.1.i, %.941.us.117.1.i
  %.943.us.119.1.i = fadd double %.943.us.118.i, %.942.us.118.1.i
  store double %.943.us.119.1.i, ptr %.348.i, align 8, !noalias !0
  %lsr.iv.next90.i = add i64 %lsr.iv89.i, -2
  %niter.ncmp.119.i = icmp eq i64 %lsr.iv.next90.i, 0
  %scevgep93.i = getelementptr i8, ptr %scevgep92.i, i64 %arg.ride.6.0
  %scevgep96.i = getelementptr i8, ptr %scevgep95.i, i64 %arg.q.6.1
  br i1 %niter.ncmp.119.i, label %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i, label %B184.us.i

B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i: ; preds = %B184.us.i
  %scevgep78.i = getelementptr i8, ptr %lsr.iv77.i, i64 %24
  %scevgep78.1.i = getelementptr i8, ptr %scevgep78.i, i64 %24
  %scevgep75.i = getelementptr i8, ptr %lsr.iv74.i, i64 %23
  %scevgep75.1.i = getelementptr i8, ptr %scevgep75.i, i64 %23
  br i1 %lcmp.mod.not55.not.i, label %B184.us.epil.preheader3.i, label %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i

B184.us.epil.preheader3.i:                        ; preds = %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i, %B184.us.preheader.new.i
  %lsr.iv77.epil.init.i = phi ptr [ %lsr.iv30, %B184.us.preheader.new.i ], [ %scevgep78.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ]
  %lsr.iv74.epil.init.i = phi ptr [ %arg.ride.4, %B184.us.preheader.new.i ], [ %scevgep75.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ]
  %.9431177.us.epil.init8.i = phi double [ %.627.us.i, %B184.us.preheader.new.i ], [ %.943.us.119.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ]
  %.908.us.epil4.i = load double, ptr %lsr.iv74.epil.init.i, align 8, !noalias !0
  %.941.us.epil5.i = load double, ptr %lsr.iv77.epil.init.i, align 8, !noalias !0
  %.942.us.epil6.i = fmul double %.908.us.epil4.i, %.941.us.epil5.i
  %.943.us.epil7.i = fadd double %.9431177.us.epil.init8.i, %.942.us.epil6.i
  store double %.943.us.epil7.i, ptr %.348.i, align 8, !noalias !0
  %scevgep76.epil.i = getelementptr i8, ptr %lsr.iv74.epil.init.i, i64 %arg.ride.6.0
  %.908.us.114.epil.i = load double, ptr %scevgep76.epil.i, align 8, !noalias !0
  %scevgep79.epil.i = getelementptr i8, ptr %lsr.iv77.epil.init.i, i64 %arg.q.6.1
  %.941.us.117.epil.i = load double, ptr %scevgep79.epil.i, align 8, !noalias !0
  %.942.us.118.epil.i = fmul double %.908.us.114.epil.i, %.941.us.117.epil.i
  %.943.us.119.epil.i = fadd double %.943.us.epil7.i, %.942.us.118.epil.i
  store double %.943.us.119.epil.i, ptr %.348.i, align 8, !noalias !0
  br label %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i

B182.B258.endif.endif_crit_edge.us.unr-lcssa.i:   ; preds = %B184.us.epil.preheader3.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i
  %.943.us.119.lcssa.i = phi double [ %.943.us.119.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ], [ %.943.us.119.epil.i, %B184.us.epil.preheader3.i ]
  br i1 %lcmp.mod.not.i, label %B182.B258.endif.endif_crit_edge.us.i, label %B184.us.epil.preheader.i

B184.us.epil.preheader.i:                         ; preds = %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i, %B184.us.preheader.i
  %.9431177.us.epil.init.i = phi double [ %.627.us.i, %B184.us.preheader.i ], [ %.943.us.119.lcssa.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i ]
  %.908.us.epil.i = load double, ptr %gep.us.epil.i, align 8, !noalias !0
  %.939.us.epil.i = getelementptr i8, ptr %lsr.iv30, i64 %.937.us.epil.i
  %.941.us.epil.i = load double, ptr %.939.us.epil.i, align 8, !noalias !0
  %.942.us.epil.i = fmul double %.908.us.epil.i, %.941.us.epil.i
  %.943.us.epil.i = fadd double %.9431177.us.epil.init.i, %.942.us.epil.i
  store double %.943.us.epil.i, ptr %.348.i, align 8, !noalias !0
  br label %B182.B258.endif.endif_crit_edge.us.i

B182.B258.endif.endif_crit_edge.us.i:             ; preds = %B184.us.epil.preheader.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i
  %.1170.us.i = load double, ptr %arg.X_WC.4, align 8, !noalias !0
  store double %.1170.us.i, ptr %arg.room.4, align 8, !noalias !0
  %.1170.us.1.i = load double, ptr %.1168.1.i, align 8, !noalias !0
  store double %.1170.us.1.i, ptr %7, align 8, !noalias !0
  %.1170.us.2.i = load double, ptr %.1168.2.i, align 8, !noalias !0
  store double %.1170.us.2.i, ptr %gep1179.2.i, align 8, !noalias !0
  %.627.us.1.i = load double, ptr %gep1185.1.i, align 8, !noalias !0
  store double %.627.us.1.i, ptr %sunkaddr130.i, align 8, !noalias !0
  br i1 %22, label %B184.us.1.epil.preheader.i, label %B182.B258.endif.endif_crit_edge.us.new.i

B182.B258.endif.endif_crit_edge.us.new.i:         ; preds = %B182.B258.endif.endif_crit_edge.us.i
  br i1 %27, label %B184.us.1.epil.preheader21.i, label %B184.us.1.i

B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i: ; preds = %B184.us.2.i
  %scevgep66.i = getelementptr i8, ptr %lsr.iv65.i, i64 %24
  %scevgep66.1.i = getelementptr i8, ptr %scevgep66.i, i64 %24
  %scevgep63.i = getelementptr i8, ptr %lsr.iv62.i, i64 %23
  %scevgep63.1.i = getelementptr i8, ptr %scevgep63.i, i64 %23
  br i1 %lcmp.mod.not55.not.i, label %B184.us.2.epil.preheader38.i, label %B652.endif.2.peel.next.loopexit.unr-lcssa.i

B184.us.2.epil.preheader38.i:                     ; preds = %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i, %B182.B258.endif.endif_crit_edge.us.1.new.i
  %lsr.iv65.epil.init.i = phi ptr [ %lsr.iv30, %B182.B258.endif.endif_crit_edge.us.1.new.i ], [ %scevgep66.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ]
  %lsr.iv62.epil.init.i = phi ptr [ %invariant.gep.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ], [ %scevgep63.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ]
  %.9431177.us.2.epil.init44.i = phi double [ %.627.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ], [ %.943.us.2.1.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ]
  %.908.us.2.epil40.i = load double, ptr %lsr.iv62.epil.init.i, align 8, !noalias !0
  %.941.us.2.epil41.i = load double, ptr %lsr.iv65.epil.init.i, align 8, !noalias !0
  %.942.us.2.epil42.i = fmul double %.908.us.2.epil40.i, %.941.us.2.epil41.i
  %.943.us.2.epil43.i = fadd double %.9431177.us.2.epil.init44.i, %.942.us.2.epil42.i
  store double %.943.us.2.epil43.i, ptr %sunkaddr132.i, align 8, !noalias !0
  %scevgep64.epil.i = getelementptr i8, ptr %lsr.iv62.epil.init.i, i64 %arg.ride.6.0
  %.908.us.2.1.epil.i = load double, ptr %scevgep64.epil.i, align 8, !noalias !0
  %scevgep67.epil.i = getelementptr i8, ptr %lsr.iv65.epil.init.i, i64 %arg.q.6.1
  %.941.us.2.1.epil.i = load double, ptr %scevgep67.epil.i, align 8, !noalias !0
  %.942.us.2.1.epil.i = fmul double %.908.us.2.1.epil.i, %.941.us.2.1.epil.i
  %.943.us.2.1.epil.i = fadd double %.943.us.2.epil43.i, %.942.us.2.1.epil.i
  store double %.943.us.2.1.epil.i, ptr %sunkaddr132.i, align 8, !noalias !0
  br label %B652.endif.2.peel.next.loopexit.unr-lcssa.i

B652.endif.2.peel.next.loopexit.unr-lcssa.i:      ; preds = %B184.us.2.epil.preheader38.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i
  %.943.us.2.1.lcssa.i = phi double [ %.943.us.2.1.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ], [ %.943.us.2.1.epil.i, %B184.us.2.epil.preheader38.i ]
  br i1 %lcmp.mod.not.i, label %B652.endif.2.peel.next.i, label %B184.us.2.epil.preheader.i

B184.us.2.epil.preheader.i:                       ; preds = %B652.endif.2.peel.next.loopexit.unr-lcssa.i, %B182.B258.endif.endif_crit_edge.us.1.i
  %.9431177.us.2.epil.init.i = phi double [ %.627.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.i ], [ %.943.us.2.1.lcssa.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.i ]
  %.908.us.2.epil.i = load double, ptr %gep.us.2.epil.i, align 8, !noalias !0
  %.939.us.2.epil.i = getelementptr i8, ptr %lsr.iv30, i64 %.937.us.2.epil.i
  %.941.us.2.epil.i = load double, ptr %.939.us.2.epil.i, align 8, !noalias !0
  %.942.us.2.epil.i = fmul double %.908.us.2.epil.i, %.941.us.2.epil.i
  %.943.us.2.epil.i = fadd double %.9431177.us.2.epil.init.i, %.942.us.2.epil.i
  br label %B652.endif.2.peel.next.i.sink.split

B652.endif.2.peel.next.i.sink.split:              ; preds = %B120.endif.preheader.i, %B184.us.2.epil.preheader.i
  %.943.us.2.epil.i.sink = phi double [ %.943.us.2.epil.i, %B184.us.2.epil.preheader.i ], [ %.627.2.i, %B120.endif.preheader.i ]
  store double %.943.us.2.epil.i.sink, ptr %sunkaddr132.i, align 8, !noalias !0
  br label %B652.endif.2.peel.next.i

B652.endif.2.peel.next.i:                         ; preds = %B652.endif.2.peel.next.i.sink.split, %B652.endif.2.peel.next.loopexit.unr-lcssa.i
  %.1170.21252.i = load double, ptr %31, align 8, !noalias !0
  store double %.1170.21252.i, ptr %invariant.gep1178.2.i, align 8, !noalias !0
  %.1170.1.2.i = load double, ptr %.1168.1.2.i, align 8, !noalias !0
  store double %.1170.1.2.i, ptr %gep1179.1.2.i, align 8, !noalias !0
  %.1170.2.2.i = load double, ptr %.1168.2.2.i, align 8, !noalias !0
  store double %.1170.2.2.i, ptr %gep1179.2.2.i, align 8, !noalias !0
  %.1432.peel.i = load double, ptr %.1431.peel.i, align 8, !noalias !0
  %.1464.peel.i = getelementptr i8, ptr %lsr.iv30, i64 %.1462.peel.i
  %.1466.peel.i = load double, ptr %.1464.peel.i, align 8, !noalias !0
  %.1467.peel.i = fmul double %.1432.peel.i, %.1466.peel.i
  %.1522.peel.i = load double, ptr %.1521.peel.i, align 8, !noalias !0
  %.1523.peel.i = fadd double %.1467.peel.i, %.1522.peel.i
  %.1578.peel.i = load double, ptr %.1577.peel.i, align 8, !noalias !0
  %.1580.peel.i = fmul double %.1578.peel.i, 0.000000e+00
  %.1583.peel.i = fsub double %.1523.peel.i, %.1580.peel.i
  %.1621.peel.i = tail call double @llvm.cos.f64(double %.1583.peel.i)
  %.1622.peel.i = tail call double @llvm.sin.f64(double %.1583.peel.i)
  %.1683.peel.i = load double, ptr %arg.chain.4, align 8, !noalias !0
  %.5.i.peel.i = fptosi double %.1683.peel.i to i64
  %.1712.peel.i = add nsw i64 %.5.i.peel.i, 1
  %.1732.peel.i = srem i64 %.1712.peel.i, 3
  %.1734.peel.i = icmp slt i64 %.1732.peel.i, 0
  %.1743.peel.i = add nsw i64 %.1732.peel.i, 3
  %.1723.1.peel.i = select i1 %.1734.peel.i, i64 %.1743.peel.i, i64 %.1732.peel.i
  %.1754.peel.i = add nsw i64 %.5.i.peel.i, 2
  %.1774.peel.i = srem i64 %.1754.peel.i, 3
  %.1776.peel.i = icmp slt i64 %.1774.peel.i, 0
  %.1785.peel.i = add nsw i64 %.1774.peel.i, 3
  %.1765.1.peel.i = select i1 %.1776.peel.i, i64 %.1785.peel.i, i64 %.1774.peel.i
  %.2415.peel.i = icmp slt i64 %.5.i.peel.i, 0
  %.2416.peel.i = select i1 %.2415.peel.i, i64 %arg.room.5.1, i64 0
  %.2417.peel.i = add i64 %.2416.peel.i, %.5.i.peel.i
  %.2437.peel.i = mul i64 %.2417.peel.i, %arg.room.5.2
  %32 = getelementptr double, ptr %arg.room.4, i64 %.2437.peel.i
  %.1999.peel.i = load double, ptr %.348.i, align 8, !noalias !0
  %.2055.peel.i = load double, ptr %arg.room.4, align 8, !noalias !0
  %.2110.peel.i = load double, ptr %.2109.peel.i, align 8, !noalias !0
  %.2111.peel.i = fmul double %.2055.peel.i, %.2110.peel.i
  %.2112.peel.i = fadd double %.1999.peel.i, %.2111.peel.i
  %.2166.peel.i = load double, ptr %7, align 8, !noalias !0
  %.2221.peel.i = load double, ptr %.2220.peel.i, align 8, !noalias !0
  %.2222.peel.i = fmul double %.2166.peel.i, %.2221.peel.i
  %.2223.peel.i = fadd double %.2112.peel.i, %.2222.peel.i
  %.2277.peel.i = load double, ptr %8, align 8, !noalias !0
  %.2332.peel.i = load double, ptr %.2331.peel.i, align 8, !noalias !0
  %.2333.peel.i = fmul double %.2277.peel.i, %.2332.peel.i
  %.2334.peel.i = fadd double %.2223.peel.i, %.2333.peel.i
  store double %.2334.peel.i, ptr %.348.i, align 8, !noalias !0
  %.2442.peel.i = load double, ptr %32, align 8, !noalias !0
  store double %.2442.peel.i, ptr %sunkaddr102.i, align 8, !noalias !0
  %.1999.1.peel.i = load double, ptr %sunkaddr130.i, align 8, !noalias !0
  %.2055.1.peel.i = load double, ptr %.2054.1.i, align 8, !noalias !0
  %.2110.1.peel.i = load double, ptr %.2109.peel.i, align 8, !noalias !0
  %.2111.1.peel.i = fmul double %.2055.1.peel.i, %.2110.1.peel.i
  %.2112.1.peel.i = fadd double %.1999.1.peel.i, %.2111.1.peel.i
  %.2166.1.peel.i = load double, ptr %.2165.1.i, align 8, !noalias !0
  %.2221.1.peel.i = load double, ptr %.2220.peel.i, align 8, !noalias !0
  %.2222.1.peel.i = fmul double %.2166.1.peel.i, %.2221.1.peel.i
  %.2223.1.peel.i = fadd double %.2112.1.peel.i, %.2222.1.peel.i
  %.2277.1.peel.i = load double, ptr %.2276.1.i, align 8, !noalias !0
  %.2332.1.peel.i = load double, ptr %.2331.peel.i, align 8, !noalias !0
  %.2333.1.peel.i = fmul double %.2277.1.peel.i, %.2332.1.peel.i
  %.2334.1.peel.i = fadd double %.2223.1.peel.i, %.2333.1.peel.i
  store double %.2334.1.peel.i, ptr %sunkaddr130.i, align 8, !noalias !0
  %.2441.1.peel.i = getelementptr i8, ptr %32, i64 8
  %.2442.1.peel.i = load double, ptr %.2441.1.peel.i, align 8, !noalias !0
  store double %.2442.1.peel.i, ptr %sunkaddr107.i, align 8, !noalias !0
  %.1999.2.peel.i = load double, ptr %sunkaddr132.i, align 8, !noalias !0
  %.2055.2.peel.i = load double, ptr %invariant.gep1178.2.i, align 8, !noalias !0
  %.2110.2.peel.i = load double, ptr %.2109.peel.i, align 8, !noalias !0
  %.2111.2.peel.i = fmul double %.2055.2.peel.i, %.2110.2.peel.i
  %.2112.2.peel.i = fadd double %.1999.2.peel.i, %.2111.2.peel.i
  %.2166.2.peel.i = load double, ptr %.2165.2.i, align 8, !noalias !0
  %.2221.2.peel.i = load double, ptr %.2220.peel.i, align 8, !noalias !0
  %.2222.2.peel.i = fmul double %.2166.2.peel.i, %.2221.2.peel.i
  %.2223.2.peel.i = fadd double %.2112.2.peel.i, %.2222.2.peel.i
  %.2277.2.peel.i = load double, ptr %.2276.2.i, align 8, !noalias !0
  %.2332.2.peel.i = load double, ptr %.2331.peel.i, align 8, !noalias !0
  %.2333.2.peel.i = fmul double %.2277.2.peel.i, %.2332.2.peel.i
  %.2334.2.peel.i = fadd double %.2223.2.peel.i, %.2333.2.peel.i
  store double %.2334.2.peel.i, ptr %sunkaddr132.i, align 8, !noalias !0
  %.2441.2.peel.i = getelementptr i8, ptr %32, i64 16
  %.2442.2.peel.i = load double, ptr %.2441.2.peel.i, align 8, !noalias !0
  store double %.2442.2.peel.i, ptr %sunkaddr112.i, align 8, !noalias !0
  %.2651.peel.i = icmp slt i64 %.1723.1.peel.i, 0
  %.2652.peel.i = select i1 %.2651.peel.i, i64 %arg.room.5.1, i64 0
  %.2653.peel.i = add i64 %.2652.peel.i, %.1723.1.peel.i
  %.2673.peel.i = mul i64 %.2653.peel.i, %arg.room.5.2
  %33 = getelementptr double, ptr %arg.room.4, i64 %.2673.peel.i
  %.2706.peel.i = icmp slt i64 %.1765.1.peel.i, 0
  %.2707.peel.i = select i1 %.2706.peel.i, i64 %arg.room.5.1, i64 0
  %.2708.peel.i = add i64 %.2707.peel.i, %.1765.1.peel.i
  %.2728.peel.i = mul i64 %.2708.peel.i, %arg.room.5.2
  %34 = getelementptr double, ptr %arg.room.4, i64 %.2728.peel.i
  %.2678.peel.i = load double, ptr %33, align 8, !noalias !0
  %.2733.peel.i = load double, ptr %34, align 8, !noalias !0
  %.2737.peel.i = fmul double %.1621.peel.i, %.2678.peel.i
  %.2739.peel.i = fmul double %.1622.peel.i, %.2733.peel.i
  %.2740.peel.i = fadd double %.2737.peel.i, %.2739.peel.i
  %.2742.peel.i = fmul double %.1621.peel.i, %.2733.peel.i
  %.2744.peel.i = fmul double %.1622.peel.i, %.2678.peel.i
  %.2745.peel.i = fsub double %.2742.peel.i, %.2744.peel.i
  store double %.2740.peel.i, ptr %33, align 8, !noalias !0
  store double %.2745.peel.i, ptr %34, align 8, !noalias !0
  %.2677.1.peel.i = getelementptr i8, ptr %33, i64 8
  %.2678.1.peel.i = load double, ptr %.2677.1.peel.i, align 8, !noalias !0
  %.2732.1.peel.i = getelementptr i8, ptr %34, i64 8
  %.2733.1.peel.i = load double, ptr %.2732.1.peel.i, align 8, !noalias !0
  %.2737.1.peel.i = fmul double %.1621.peel.i, %.2678.1.peel.i
  %.2739.1.peel.i = fmul double %.1622.peel.i, %.2733.1.peel.i
  %.2740.1.peel.i = fadd double %.2737.1.peel.i, %.2739.1.peel.i
  %.2742.1.peel.i = fmul double %.1621.peel.i, %.2733.1.peel.i
  %.2744.1.peel.i = fmul double %.1622.peel.i, %.2678.1.peel.i
  %.2745.1.peel.i = fsub double %.2742.1.peel.i, %.2744.1.peel.i
  store double %.2740.1.peel.i, ptr %.2677.1.peel.i, align 8, !noalias !0
  store double %.2745.1.peel.i, ptr %.2732.1.peel.i, align 8, !noalias !0
  %.2677.2.peel.i = getelementptr i8, ptr %33, i64 16
  %.2678.2.peel.i = load double, ptr %.2677.2.peel.i, align 8, !noalias !0
  %.2732.2.peel.i = getelementptr i8, ptr %34, i64 16
  %.2733.2.peel.i = load double, ptr %.2732.2.peel.i, align 8, !noalias !0
  %.2737.2.peel.i = fmul double %.1621.peel.i, %.2678.2.peel.i
  %.2739.2.peel.i = fmul double %.1622.peel.i, %.2733.2.peel.i
  %.2740.2.peel.i = fadd double %.2737.2.peel.i, %.2739.2.peel.i
  %.2742.2.peel.i = fmul double %.1621.peel.i, %.2733.2.peel.i
  %.2744.2.peel.i = fmul double %.1622.peel.i, %.2678.2.peel.i
  %.2745.2.peel.i = fsub double %.2742.2.peel.i, %.2744.2.peel.i
  store double %.2740.2.peel.i, ptr %.2677.2.peel.i, align 8, !noalias !0
  store double %.2745.2.peel.i, ptr %.2732.2.peel.i, align 8, !noalias !0
  br label %B652.endif.2.i

B652.endif.2.i:                                   ; preds = %B652.endif.2.i, %B652.endif.2.peel.next.i
  %lsr.iv60.i = phi i64 [ 5, %B652.endif.2.peel.next.i ], [ %lsr.iv.next61.i, %B652.endif.2.i ]
  %lsr.iv58.i = phi i64 [ %20, %B652.endif.2.peel.next.i ], [ %lsr.iv.next59.i, %B652.endif.2.i ]
  %lsr.iv50.i = phi ptr [ %scevgep49.i, %B652.endif.2.peel.next.i ], [ %scevgep51.i, %B652.endif.2.i ]
  %lsr.iv42.i = phi i64 [ %17, %B652.endif.2.peel.next.i ], [ %lsr.iv.next43.i, %B652.endif.2.i ]
  %lsr.iv35.i = phi i64 [ %13, %B652.endif.2.peel.next.i ], [ %lsr.iv.next36.i, %B652.endif.2.i ]
  %lsr.iv.i = phi i64 [ %9, %B652.endif.2.peel.next.i ], [ %lsr.iv.next.i, %B652.endif.2.i ]
  %before.2.01232.i = phi double [ %.1466.peel.i, %B652.endif.2.peel.next.i ], [ %.1466.i, %B652.endif.2.i ]
  %scevgep55.i = getelementptr i8, ptr %lsr.iv50.i, i64 -48
  %scevgep57.i = getelementptr i8, ptr %lsr.iv50.i, i64 -40
  %.1432.i = load double, ptr %scevgep57.i, align 8, !noalias !0
  %.1449.i = icmp slt i64 %lsr.iv58.i, 0
  %.1450.i = select i1 %.1449.i, i64 %arg.q.5.1, i64 0
  %35 = add i64 %.1450.i, %lsr.iv58.i
  %.1462.i = mul i64 %35, %arg.q.6.1
  %.1464.i = getelementptr i8, ptr %lsr.iv30, i64 %.1462.i
  %.1466.i = load double, ptr %.1464.i, align 8, !noalias !0
  %.1467.i = fmul double %.1432.i, %.1466.i
  %scevgep56.i = getelementptr i8, ptr %lsr.iv50.i, i64 -32
  %.1522.i = load double, ptr %scevgep56.i, align 8, !noalias !0
  %.1523.i = fadd double %.1467.i, %.1522.i
  %.1578.i = load double, ptr %lsr.iv50.i, align 8, !noalias !0
  %.1580.i = fmul double %before.2.01232.i, %.1578.i
  %.1583.i = fsub double %.1523.i, %.1580.i
  %.1621.i = tail call double @llvm.cos.f64(double %.1583.i)
  %.1622.i = tail call double @llvm.sin.f64(double %.1583.i)
  %.1683.i = load double, ptr %scevgep55.i, align 8, !noalias !0
  %.5.i.i = fptosi double %.1683.i to i64
  %.1712.i = add nsw i64 %.5.i.i, 1
  %.1732.i = srem i64 %.1712.i, 3
  %.1734.i = icmp slt i64 %.1732.i, 0
  %.1743.i = add nsw i64 %.1732.i, 3
  %.1723.1.i = select i1 %.1734.i, i64 %.1743.i, i64 %.1732.i
  %.1754.i = add nsw i64 %.5.i.i, 2
  %.1774.i = srem i64 %.1754.i, 3
  %.1776.i = icmp slt i64 %.1774.i, 0
  %.1785.i = add nsw i64 %.1774.i, 3
  %.1765.1.i = select i1 %.1776.i, i64 %.1785.i, i64 %.1774.i
  %scevgep54.i = getelementptr i8, ptr %lsr.iv50.i, i64 -24
  %scevgep53.i = getelementptr i8, ptr %lsr.iv50.i, i64 -16
  %scevgep52.i = getelementptr i8, ptr %lsr.iv50.i, i64 -8
  %.2415.i = icmp slt i64 %.5.i.i, 0
  %.2416.i = select i1 %.2415.i, i64 %arg.room.5.1, i64 0
  %.2417.i = add i64 %.2416.i, %.5.i.i
  %.2437.i = mul i64 %.2417.i, %arg.room.5.2
  %36 = getelementptr double, ptr %arg.room.4, i64 %.2437.i
  %scevgep33.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv.i
  %scevgep34.i = getelementptr i8, ptr %scevgep33.i, i64 -16
  %.1999.i = load double, ptr %scevgep34.i, align 8, !noalias !0
  %.2055.i = load double, ptr %arg.room.4, align 8, !noalias !0
  %.2110.i = load double, ptr %scevgep54.i, align 8, !noalias !0
  %.2111.i = fmul double %.2055.i, %.2110.i
  %.2112.i = fadd double %.1999.i, %.2111.i
  %.2166.i = load double, ptr %sunkaddr134.i, align 8, !noalias !0
  %.2221.i = load double, ptr %scevgep53.i, align 8, !noalias !0
  %.2222.i = fmul double %.2166.i, %.2221.i
  %.2223.i = fadd double %.2112.i, %.2222.i
  %.2277.i = load double, ptr %8, align 8, !noalias !0
  %.2332.i = load double, ptr %scevgep52.i, align 8, !noalias !0
  %.2333.i = fmul double %.2277.i, %.2332.i
  %.2334.i = fadd double %.2223.i, %.2333.i
  %scevgep37.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv35.i
  %scevgep38.i = getelementptr i8, ptr %scevgep37.i, i64 -16
  store double %.2334.i, ptr %scevgep38.i, align 8, !noalias !0
  %.2442.i = load double, ptr %36, align 8, !noalias !0
  %scevgep44.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv42.i
  %scevgep45.i = getelementptr i8, ptr %scevgep44.i, i64 -16
  store double %.2442.i, ptr %scevgep45.i, align 8, !noalias !0
  %scevgep62.i = getelementptr i8, ptr %scevgep33.i, i64 -8
  %.1999.1.i = load double, ptr %scevgep62.i, align 8, !noalias !0
  %.2055.1.i = load double, ptr %.2054.1.i, align 8, !noalias !0
  %.2110.1.i = load double, ptr %scevgep54.i, align 8, !noalias !0
  %.2111.1.i = fmul double %.2055.1.i, %.2110.1.i
  %.2112.1.i = fadd double %.1999.1.i, %.2111.1.i
  %.2166.1.i = load double, ptr %sunkaddr139.i, align 8, !noalias !0
  %.2221.1.i = load double, ptr %scevgep53.i, align 8, !noalias !0
  %.2222.1.i = fmul double %.2166.1.i, %.2221.1.i
  %.2223.1.i = fadd double %.2112.1.i, %.2222.1.i
  %.2277.1.i = load double, ptr %.2276.1.i, align 8, !noalias !0
  %.2332.1.i = load double, ptr %scevgep52.i, align 8, !noalias !0
  %.2333.1.i = fmul double %.2277.1.i, %.2332.1.i
  %.2334.1.i = fadd double %.2223.1.i, %.2333.1.i
  %scevgep60.i = getelementptr i8, ptr %scevgep37.i, i64 -8
  store double %.2334.1.i, ptr %scevgep60.i, align 8, !noalias !0
  %.2441.1.i = getelementptr i8, ptr %36, i64 8
  %.2442.1.i = load double, ptr %.2441.1.i, align 8, !noalias !0
  %scevgep58.i = getelementptr i8, ptr %scevgep44.i, i64 -8
  store double %.2442.1.i, ptr %scevgep58.i, align 8, !noalias !0
  %.1999.2.i = load double, ptr %scevgep33.i, align 8, !noalias !0
  %.2055.2.i = load double, ptr %invariant.gep1178.2.i, align 8, !noalias !0
  %.2110.2.i = load double, ptr %scevgep54.i, align 8, !noalias !0
  %.2111.2.i = fmul double %.2055.2.i, %.2110.2.i
  %.2112.2.i = fadd double %.1999.2.i, %.2111.2.i
  %.2166.2.i = load double, ptr %sunkaddr145.i, align 8, !noalias !0
  %.2221.2.i = load double, ptr %scevgep53.i, align 8, !noalias !0
  %.2222.2.i = fmul double %.2166.2.i, %.2221.2.i
  %.2223.2.i = fadd double %.2112.2.i, %.2222.2.i
  %.2277.2.i = load double, ptr %.2276.2.i, align 8, !noalias !0
  %.2332.2.i = load double, ptr %scevgep52.i, align 8, !noalias !0
  %.2333.2.i = fmul double %.2277.2.i, %.2332.2.i
  %.2334.2.i = fadd double %.2223.2.i, %.2333.2.i
  store double %.2334.2.i, ptr %scevgep37.i, align 8, !noalias !0
  %.2441.2.i = getelementptr i8, ptr %36, i64 16
  %.2442.2.i = load double, ptr %.2441.2.i, align 8, !noalias !0
  store double %.2442.2.i, ptr %scevgep44.i, align 8, !noalias !0
  %.2651.i = icmp slt i64 %.1723.1.i, 0
  %.2652.i = select i1 %.2651.i, i64 %arg.room.5.1, i64 0
  %.2653.i = add i64 %.2652.i, %.1723.1.i
  %.2673.i = mul i64 %.2653.i, %arg.room.5.2
  %37 = getelementptr double, ptr %arg.room.4, i64 %.2673.i
  %.2706.i = icmp slt i64 %.1765.1.i, 0
  %.2707.i = select i1 %.2706.i, i64 %arg.room.5.1, i64 0
  %.2708.i = add i64 %.2707.i, %.1765.1.i
  %.2728.i = mul i64 %.2708.i, %arg.room.5.2
  %38 = getelementptr double, ptr %arg.room.4, i64 %.2728.i
  %.2678.i = load double, ptr %37, align 8, !noalias !0
  %.2733.i = load double, ptr %38, align 8, !noalias !0
  %.2737.i = fmul double %.1621.i, %.2678.i
  %.2739.i = fmul double %.1622.i, %.2733.i
  %.2740.i = fadd double %.2737.i, %.2739.i
  %.2742.i = fmul double %.1621.i, %.2733.i
  %.2744.i = fmul double %.1622.i, %.2678.i
  %.2745.i = fsub double %.2742.i, %.2744.i
  store double %.2740.i, ptr %37, align 8, !noalias !0
  store double %.2745.i, ptr %38, align 8, !noalias !0
  %.2677.1.i = getelementptr i8, ptr %37, i64 8
  %.2678.1.i = load double, ptr %.2677.1.i, align 8, !noalias !0
  %.2732.1.i = getelementptr i8, ptr %38, i64 8
  %.2733.1.i = load double, ptr %.2732.1.i, align 8, !noalias !0
  %.2737.1.i = fmul double %.1621.i, %.2678.1.i
  %.2739.1.i = fmul double %.1622.i, %.2733.1.i
  %.2740.1.i = fadd double %.2737.1.i, %.2739.1.i
  %.2742.1.i = fmul double %.1621.i, %.2733.1.i
  %.2744.1.i = fmul double %.1622.i, %.2678.1.i
  %.2745.1.i = fsub double %.2742.1.i, %.2744.1.i
  store double %.2740.1.i, ptr %.2677.1.i, align 8, !noalias !0
  store double %.2745.1.i, ptr %.2732.1.i, align 8, !noalias !0
  %.2677.2.i = getelementptr i8, ptr %37, i64 16
  %.2678.2.i = load double, ptr %.2677.2.i, align 8, !noalias !0
  %.2732.2.i = getelementptr i8, ptr %38, i64 16
  %.2733.2.i = load double, ptr %.2732.2.i, align 8, !noalias !0
  %.2737.2.i = fmul double %.1621.i, %.2678.2.i
  %.2739.2.i = fmul double %.1622.i, %.2733.2.i
  %.2740.2.i = fadd double %.2737.2.i, %.2739.2.i
  %.2742.2.i = fmul double %.1621.i, %.2733.2.i
  %.2744.2.i = fmul double %.1622.i, %.2678.2.i
  %.2745.2.i = fsub double %.2742.2.i, %.2744.2.i
  store double %.2740.2.i, ptr %.2677.2.i, align 8, !noalias !0
  store double %.2745.2.i, ptr %.2732.2.i, align 8, !noalias !0
  %lsr.iv.next.i = add i64 %lsr.iv.i, %10
  %lsr.iv.next36.i = add i64 %lsr.iv35.i, %10
  %lsr.iv.next43.i = add i64 %lsr.iv42.i, %10
  %scevgep51.i = getelementptr i8, ptr %lsr.iv50.i, i64 %18
  %lsr.iv.next59.i = add i64 %lsr.iv58.i, 1
  %lsr.iv.next61.i = add nsw i64 %lsr.iv60.i, -1
  %exitcond1259.not.i = icmp eq i64 %lsr.iv.next61.i, 0
  br i1 %exitcond1259.not.i, label %part.0, label %B652.endif.2.i, !llvm.loop !3

part.0: ; preds = %B652.endif.2.i
  %.3072.i = load double, ptr %5, align 8, !noalias !0
  %.3126.i = load double, ptr %arg.room.4, align 8, !noalias !0
  %.3180.i = load double, ptr %.3178.i, align 8, !noalias !0
  %.3181.i = fmul double %.3126.i, %.3180.i
  %.3182.i = fadd double %.3072.i, %.3181.i
  %.3236.i = load double, ptr %sunkaddr134.i, align 8, !noalias !0
  %.3290.i = load double, ptr %.3288.i, align 8, !noalias !0
  %.3291.i = fmul double %.3236.i, %.3290.i
  %.3292.i = fadd double %.3182.i, %.3291.i
  %.3346.i = load double, ptr %8, align 8, !noalias !0
  %.3400.i = load double, ptr %.3398.i, align 8, !noalias !0
  %.3401.i = fmul double %.3346.i, %.3400.i
  %.3402.i = fadd double %.3292.i, %.3401.i
  store double %.3402.i, ptr %6, align 8, !noalias !0
  %.3072.1.i = load double, ptr %.3071.1.i, align 8, !noalias !0
  %.3126.1.i = load double, ptr %.2054.1.i, align 8, !noalias !0
  %.3180.1.i = load double, ptr %.3178.i, align 8, !noalias !0
  %.3181.1.i = fmul double %.3126.1.i, %.3180.1.i
  %.3182.1.i = fadd double %.3072.1.i, %.3181.1.i
  %.3236.1.i = load double, ptr %sunkaddr139.i, align 8, !noalias !0
  %.3290.1.i = load double, ptr %.3288.i, align 8, !noalias !0
  %.3291.1.i = fmul double %.3236.1.i, %.3290.1.i
  %.3292.1.i = fadd double %.3182.1.i, %.3291.1.i
  %.3346.1.i = load double, ptr %.2276.1.i, align 8, !noalias !0
  %.3400.1.i = load double, ptr %.3398.i, align 8, !noalias !0
  %.3401.1.i = fmul double %.3346.1.i, %.3400.1.i
  %.3402.1.i = fadd double %.3292.1.i, %.3401.1.i
  store double %.3402.1.i, ptr %.3455.1.i, align 8, !noalias !0
  %.3072.2.i = load double, ptr %.3071.2.i, align 8, !noalias !0
  %.3126.2.i = load double, ptr %invariant.gep1178.2.i, align 8, !noalias !0
  %.3180.2.i = load double, ptr %.3178.i, align 8, !noalias !0
  %.3181.2.i = fmul double %.3126.2.i, %.3180.2.i
  %.3182.2.i = fadd double %.3072.2.i, %.3181.2.i
  %.3236.2.i = load double, ptr %sunkaddr145.i, align 8, !noalias !0
  %.3290.2.i = load double, ptr %.3288.i, align 8, !noalias !0
  %.3291.2.i = fmul double %.3236.2.i, %.3290.2.i
  %.3292.2.i = fadd double %.3182.2.i, %.3291.2.i
  %.3346.2.i = load double, ptr %.2276.2.i, align 8, !noalias !0
  %.3400.2.i = load double, ptr %.3398.i, align 8, !noalias !0
  %.3401.2.i = fmul double %.3346.2.i, %.3400.2.i
  %.3402.2.i = fadd double %.3292.2.i, %.3401.2.i
  store double %.3402.2.i, ptr %.3455.2.i, align 8, !noalias !0
  %scevgep23 = getelementptr i8, ptr %lsr.iv, i64 -24
  %scevgep13 = getelementptr i8, ptr %lsr.iv, i64 %.idx559
  %scevgep14 = getelementptr i8, ptr %scevgep13, i64 -24
  %.808.us = load double, ptr %arg.room.4, align 8
  %.862.us = load double, ptr %arg.X_6T.4, align 8
  %.863.us = fmul double %.808.us, %.862.us
  %.918.us = load double, ptr %sunkaddr134.i, align 8
  %.972.us = load double, ptr %1, align 8
  %.973.us = fmul double %.918.us, %.972.us
  %.974.us = fadd double %.863.us, %.973.us
  %.1029.us = load double, ptr %8, align 8
  %.1083.us = load double, ptr %2, align 8
  %.1084.us = fmul double %.1029.us, %.1083.us
  %.1085.us = fadd double %.974.us, %.1084.us
  store double %.1085.us, ptr %scevgep23, align 8
  %.808.us.1 = load double, ptr %arg.room.4, align 8
  %.862.us.1 = load double, ptr %sunkaddr35, align 8
  %.863.us.1 = fmul double %.808.us.1, %.862.us.1
  %.918.us.1 = load double, ptr %sunkaddr134.i, align 8
  %.972.us.1 = load double, ptr %sunkaddr36, align 8
  %.973.us.1 = fmul double %.918.us.1, %.972.us.1
  %.974.us.1 = fadd double %.863.us.1, %.973.us.1
  %.1029.us.1 = load double, ptr %8, align 8
  %.1083.us.1 = load double, ptr %sunkaddr37, align 8
  %.1084.us.1 = fmul double %.1029.us.1, %.1083.us.1
  %.1085.us.1 = fadd double %.974.us.1, %.1084.us.1
  %scevgep22 = getelementptr i8, ptr %lsr.iv, i64 -16
  store double %.1085.us.1, ptr %scevgep22, align 8
  %.808.us.2 = load double, ptr %arg.room.4, align 8
  %.862.us.2 = load double, ptr %sunkaddr39, align 8
  %.863.us.2 = fmul double %.808.us.2, %.862.us.2
  %.918.us.2 = load double, ptr %sunkaddr134.i, align 8
  %.972.us.2 = load double, ptr %sunkaddr41, align 8
  %.973.us.2 = fmul double %.918.us.2, %.972.us.2
  %.974.us.2 = fadd double %.863.us.2, %.973.us.2
  %.1029.us.2 = load double, ptr %8, align 8
  %.1083.us.2 = load double, ptr %sunkaddr43, align 8
  %.1084.us.2 = fmul double %.1029.us.2, %.1083.us.2
  %.1085.us.2 = fadd double %.974.us.2, %.1084.us.2
  %scevgep21 = getelementptr i8, ptr %lsr.iv, i64 -8
  store double %.1085.us.2, ptr %scevgep21, align 8
  %.1243.us = load double, ptr %sunkaddr44, align 8
  store double %.1243.us, ptr %lsr.iv, align 8
  store double 0.000000e+00, ptr %scevgep14, align 8
  %.808.us.1608 = load double, ptr %.2054.1.i, align 8
  %.862.us.1609 = load double, ptr %arg.X_6T.4, align 8
  %.863.us.1610 = fmul double %.808.us.1608, %.862.us.1609
  %.918.us.1611 = load double, ptr %sunkaddr139.i, align 8
  %.972.us.1612 = load double, ptr %1, align 8
  %.973.us.1613 = fmul double %.918.us.1611, %.972.us.1612
  %.974.us.1614 = fadd double %.863.us.1610, %.973.us.1613
  %.1029.us.1615 = load double, ptr %.2276.1.i, align 8
  %.1083.us.1616 = load double, ptr %2, align 8
  %.1084.us.1617 = fmul double %.1029.us.1615, %.1083.us.1616
  %.1085.us.1618 = fadd double %.974.us.1614, %.1084.us.1617
  %sunkaddr52 = getelementptr i8, ptr %lsr.iv, i64 %sunkaddr51
  %sunkaddr53 = getelementptr i8, ptr %sunkaddr52, i64 -24
  store double %.1085.us.1618, ptr %sunkaddr53, align 8
  %.808.us.1.1 = load double, ptr %.2054.1.i, align 8
  %.862.us.1.1 = load double, ptr %sunkaddr35, align 8
  %.863.us.1.1 = fmul double %.808.us.1.1, %.862.us.1.1
  %.918.us.1.1 = load double, ptr %sunkaddr139.i, align 8
  %.972.us.1.1 = load double, ptr %sunkaddr36, align 8
  %.973.us.1.1 = fmul double %.918.us.1.1, %.972.us.1.1
  %.974.us.1.1 = fadd double %.863.us.1.1, %.973.us.1.1
  %.1029.us.1.1 = load double, ptr %.2276.1.i, align 8
  %.1083.us.1.1 = load double, ptr %sunkaddr37, align 8
  %.1084.us.1.1 = fmul double %.1029.us.1.1, %.1083.us.1.1
  %.1085.us.1.1 = fadd double %.974.us.1.1, %.1084.us.1.1
  %sunkaddr56 = getelementptr i8, ptr %sunkaddr52, i64 -16
  store double %.1085.us.1.1, ptr %sunkaddr56, align 8
  %.808.us.2.1 = load double, ptr %.2054.1.i, align 8
  %.862.us.2.1 = load double, ptr %sunkaddr39, align 8
  %.863.us.2.1 = fmul double %.808.us.2.1, %.862.us.2.1
  %.918.us.2.1 = load double, ptr %sunkaddr139.i, align 8
  %.972.us.2.1 = load double, ptr %sunkaddr41, align 8
  %.973.us.2.1 = fmul double %.918.us.2.1, %.972.us.2.1
  %.974.us.2.1 = fadd double %.863.us.2.1, %.973.us.2.1
  %.1029.us.2.1 = load double, ptr %.2276.1.i, align 8
  %.1083.us.2.1 = load double, ptr %sunkaddr43, align 8
  %.1084.us.2.1 = fmul double %.1029.us.2.1, %.1083.us.2.1
  %.1085.us.2.1 = fadd double %.974.us.2.1, %.1084.us.2.1
  %sunkaddr59 = getelementptr i8, ptr %sunkaddr52, i64 -8
  store double %.1085.us.2.1, ptr %sunkaddr59, align 8
  %.1243.us.1 = load double, ptr %sunkaddr61, align 8
  store double %.1243.us.1, ptr %sunkaddr52, align 8
  %scevgep12 = getelementptr i8, ptr %scevgep13, i64 -16
  store double 0.000000e+00, ptr %scevgep12, align 8
  %scevgep19 = getelementptr i8, ptr %lsr.iv, i64 %.idx
  %scevgep20 = getelementptr i8, ptr %scevgep19, i64 -24
  %.808.us.2619 = load double, ptr %invariant.gep1178.2.i, align 8
  %.862.us.2620 = load double, ptr %arg.X_6T.4, align 8
  %.863.us.2621 = fmul double %.808.us.2619, %.862.us.2620
  %.918.us.2622 = load double, ptr %sunkaddr145.i, align 8
  %.972.us.2623 = load double, ptr %1, align 8
  %.973.us.2624 = fmul double %.918.us.2622, %.972.us.2623
  %.974.us.2625 = fadd double %.863.us.2621, %.973.us.2624
  %.1029.us.2626 = load double, ptr %.2276.2.i, align 8
  %.1083.us.2627 = load double, ptr %2, align 8
  %.1084.us.2628 = fmul double %.1029.us.2626, %.1083.us.2627
  %.1085.us.2629 = fadd double %.974.us.2625, %.1084.us.2628
  store double %.1085.us.2629, ptr %scevgep20, align 8
  %.808.us.1.2 = load double, ptr %invariant.gep1178.2.i, align 8
  %.862.us.1.2 = load double, ptr %sunkaddr35, align 8
  %.863.us.1.2 = fmul double %.808.us.1.2, %.862.us.1.2
  %.918.us.1.2 = load double, ptr %sunkaddr145.i, align 8
  %.972.us.1.2 = load double, ptr %sunkaddr36, align 8
  %.973.us.1.2 = fmul double %.918.us.1.2, %.972.us.1.2
  %.974.us.1.2 = fadd double %.863.us.1.2, %.973.us.1.2
  %.1029.us.1.2 = load double, ptr %.2276.2.i, align 8
  %.1083.us.1.2 = load double, ptr %sunkaddr37, align 8
  %.1084.us.1.2 = fmul double %.1029.us.1.2, %.1083.us.1.2
  %.1085.us.1.2 = fadd double %.974.us.1.2, %.1084.us.1.2
  %scevgep18 = getelementptr i8, ptr %scevgep19, i64 -16
  store double %.1085.us.1.2, ptr %scevgep18, align 8
  %.808.us.2.2 = load double, ptr %invariant.gep1178.2.i, align 8
  %.862.us.2.2 = load double, ptr %sunkaddr39, align 8
  %.863.us.2.2 = fmul double %.808.us.2.2, %.862.us.2.2
  %.918.us.2.2 = load double, ptr %sunkaddr145.i, align 8
  %.972.us.2.2 = load double, ptr %sunkaddr41, align 8
  %.973.us.2.2 = fmul double %.918.us.2.2, %.972.us.2.2
  %.974.us.2.2 = fadd double %.863.us.2.2, %.973.us.2.2
  %.1029.us.2.2 = load double, ptr %.2276.2.i, align 8
  %.1083.us.2.2 = load double, ptr %sunkaddr43, align 8
  %.1084.us.2.2 = fmul double %.1029.us.2.2, %.1083.us.2.2
  %.1085.us.2.2 = fadd double %.974.us.2.2, %.1084.us.2.2
  %scevgep16 = getelementptr i8, ptr %scevgep19, i64 -8
  store double %.1085.us.2.2, ptr %scevgep16, align 8
  %.1243.us.2 = load double, ptr %sunkaddr71, align 8
  store double %.1243.us.2, ptr %scevgep19, align 8
  %scevgep10 = getelementptr i8, ptr %scevgep13, i64 -8
  store double 0.000000e+00, ptr %scevgep10, align 8
  store double 1.000000e+00, ptr %scevgep13, align 8
  %scevgep8 = getelementptr i8, ptr %lsr.iv, i64 %4
  %scevgep31 = getelementptr i8, ptr %lsr.iv30, i64 %arg.q.6.0
  %lsr.iv.next = add nsw i64 %lsr.iv32, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond.not, label %B416, label %B62

B416:                                             ; preds = %part.0, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.cos.f64(double) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sin.f64(double) #1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.points(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.chain.0, ptr readnone captures(none) %arg.chain.1, i64 %arg.chain.2, i64 %arg.chain.3, ptr readonly captures(none) %arg.chain.4, i64 %arg.chain.5.0, i64 %arg.chain.5.1, i64 %arg.chain.6.0, i64 %arg.chain.6.1, ptr readnone captures(none) %arg.X_WC.0, ptr readnone captures(none) %arg.X_WC.1, i64 %arg.X_WC.2, i64 %arg.X_WC.3, ptr readonly captures(none) %arg.X_WC.4, i64 %arg.X_WC.5.0, i64 %arg.X_WC.5.1, i64 %arg.X_WC.6.0, i64 %arg.X_WC.6.1, ptr readnone captures(none) %arg.ride.0, ptr readnone captures(none) %arg.ride.1, i64 %arg.ride.2, i64 %arg.ride.3, ptr readonly captures(none) %arg.ride.4, i64 %arg.ride.5.0, i64 %arg.ride.5.1, i64 %arg.ride.6.0, i64 %arg.ride.6.1, ptr readnone captures(none) %arg.X_6T.0, ptr readnone captures(none) %arg.X_6T.1, i64 %arg.X_6T.2, i64 %arg.X_6T.3, ptr readonly captures(none) %arg.X_6T.4, i64 %arg.X_6T.5.0, i64 %arg.X_6T.5.1, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr readnone captures(none) %arg.room.0, ptr readnone captures(none) %arg.room.1, i64 %arg.room.2, i64 %arg.room.3, ptr %arg.room.4, i64 %arg.room.5.0, i64 %arg.room.5.1, i64 %arg.room.5.2, i64 %arg.room.6.0, i64 %arg.room.6.1, i64 %arg.room.6.2, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.5.1, i64 %arg.q.6.0, i64 %arg.q.6.1, ptr readnone captures(none) %arg.o.0, ptr readnone captures(none) %arg.o.1, i64 %arg.o.2, i64 %arg.o.3, ptr writeonly captures(none) %arg.o.4, i64 %arg.o.5.0, i64 %arg.o.5.1, i64 %arg.o.5.2, i64 %arg.o.6.0, i64 %arg.o.6.1, i64 %arg.o.6.2) local_unnamed_addr #0 {
B0.endif:
  %.369 = alloca ptr, align 8
  %.250340.not = icmp slt i64 %arg.q.5.0, 1
  br i1 %.250340.not, label %B224, label %B62.lr.ph

B62.lr.ph:                                        ; preds = %B0.endif
  %factor.op.mul328 = shl i64 %arg.room.5.1, 4
  %factor.op.mul.reass = mul i64 %factor.op.mul328, %arg.room.5.2
  %0 = getelementptr i8, ptr %arg.room.4, i64 %factor.op.mul.reass
  call fastcc void @part.1(ptr nonnull %.369, ptr %arg.chain.4, i64 %arg.chain.5.1, ptr %arg.X_WC.4, i64 %arg.X_WC.6.0, i64 %arg.X_WC.6.1, ptr %arg.ride.4, i64 %arg.ride.6.0, i64 %arg.ride.6.1, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr %arg.room.4, i64 %arg.room.5.1, i64 %arg.room.5.2, ptr %arg.q.4, i64 %arg.q.5.1, i64 %arg.q.6.1)
  %.732.us.peel = load double, ptr %0, align 8
  store double %.732.us.peel, ptr %arg.o.4, align 8
  %1 = getelementptr i8, ptr %0, i64 8
  %.732.us.1.peel = load double, ptr %1, align 8
  %2 = getelementptr i8, ptr %arg.o.4, i64 8
  store double %.732.us.1.peel, ptr %2, align 8
  %3 = getelementptr i8, ptr %0, i64 16
  %.732.us.2.peel = load double, ptr %3, align 8
  %4 = getelementptr i8, ptr %arg.o.4, i64 16
  store double %.732.us.2.peel, ptr %4, align 8
  %5 = getelementptr double, ptr %0, i64 %arg.room.5.2
  %6 = getelementptr double, ptr %arg.o.4, i64 %arg.o.5.2
  %.732.us.1357.peel = load double, ptr %5, align 8
  store double %.732.us.1357.peel, ptr %6, align 8
  %7 = getelementptr i8, ptr %5, i64 8
  %.732.us.1.1.peel = load double, ptr %7, align 8
  %8 = getelementptr i8, ptr %6, i64 8
  store double %.732.us.1.1.peel, ptr %8, align 8
  %9 = getelementptr i8, ptr %5, i64 16
  %.732.us.2.1.peel = load double, ptr %9, align 8
  %10 = getelementptr i8, ptr %6, i64 16
  store double %.732.us.2.1.peel, ptr %10, align 8
  %.idx = shl i64 %arg.room.5.2, 4
  %11 = getelementptr i8, ptr %0, i64 %.idx
  %.idx1 = shl i64 %arg.o.5.2, 4
  %12 = getelementptr i8, ptr %arg.o.4, i64 %.idx1
  %.732.us.2358.peel = load double, ptr %11, align 8
  store double %.732.us.2358.peel, ptr %12, align 8
  %13 = getelementptr i8, ptr %11, i64 8
  %.732.us.1.2.peel = load double, ptr %13, align 8
  %14 = getelementptr i8, ptr %12, i64 8
  store double %.732.us.1.2.peel, ptr %14, align 8
  %15 = getelementptr i8, ptr %11, i64 16
  %.732.us.2.2.peel = load double, ptr %15, align 8
  %16 = getelementptr i8, ptr %12, i64 16
  store double %.732.us.2.2.peel, ptr %16, align 8
  %.idx360 = mul i64 %arg.room.5.2, 24
  %17 = getelementptr i8, ptr %0, i64 %.idx360
  %.idx2 = mul i64 %arg.o.5.2, 24
  %18 = getelementptr i8, ptr %arg.o.4, i64 %.idx2
  %.732.us.3.peel = load double, ptr %17, align 8
  store double %.732.us.3.peel, ptr %18, align 8
  %19 = getelementptr i8, ptr %17, i64 8
  %.732.us.1.3.peel = load double, ptr %19, align 8
  %20 = getelementptr i8, ptr %18, i64 8
  store double %.732.us.1.3.peel, ptr %20, align 8
  %21 = getelementptr i8, ptr %17, i64 16
  %.732.us.2.3.peel = load double, ptr %21, align 8
  %22 = getelementptr i8, ptr %18, i64 16
  store double %.732.us.2.3.peel, ptr %22, align 8
  %.idx361 = shl i64 %arg.room.5.2, 5
  %23 = getelementptr i8, ptr %0, i64 %.idx361
  %.idx3 = shl i64 %arg.o.5.2, 5
  %24 = getelementptr i8, ptr %arg.o.4, i64 %.idx3
  %.732.us.4.peel = load double, ptr %23, align 8
  store double %.732.us.4.peel, ptr %24, align 8
  %25 = getelementptr i8, ptr %23, i64 8
  %.732.us.1.4.peel = load double, ptr %25, align 8
  %26 = getelementptr i8, ptr %24, i64 8
  store double %.732.us.1.4.peel, ptr %26, align 8
  %27 = getelementptr i8, ptr %23, i64 16
  %.732.us.2.4.peel = load double, ptr %27, align 8
  %28 = getelementptr i8, ptr %24, i64 16
  store double %.732.us.2.4.peel, ptr %28, align 8
  %.idx362 = mul i64 %arg.room.5.2, 40
  %29 = getelementptr i8, ptr %0, i64 %.idx362
  %.idx4 = mul i64 %arg.o.5.2, 40
  %30 = getelementptr i8, ptr %arg.o.4, i64 %.idx4
  %.732.us.5.peel = load double, ptr %29, align 8
  store double %.732.us.5.peel, ptr %30, align 8
  %31 = getelementptr i8, ptr %29, i64 8
  %.732.us.1.5.peel = load double, ptr %31, align 8
  %32 = getelementptr i8, ptr %30, i64 8
  store double %.732.us.1.5.peel, ptr %32, align 8
  %33 = getelementptr i8, ptr %29, i64 16
  %.732.us.2.5.peel = load double, ptr %33, align 8
  %34 = getelementptr i8, ptr %30, i64 16
  store double %.732.us.2.5.peel, ptr %34, align 8
  %.idx363 = mul i64 %arg.room.5.2, 48
  %35 = getelementptr i8, ptr %0, i64 %.idx363
  %.idx5 = mul i64 %arg.o.5.2, 48
  %36 = getelementptr i8, ptr %arg.o.4, i64 %.idx5
  %.732.us.6.peel = load double, ptr %35, align 8
  store double %.732.us.6.peel, ptr %36, align 8
  %37 = getelementptr i8, ptr %35, i64 8
  %.732.us.1.6.peel = load double, ptr %37, align 8
  %38 = getelementptr i8, ptr %36, i64 8
  store double %.732.us.1.6.peel, ptr %38, align 8
  %39 = getelementptr i8, ptr %35, i64 16
  %.732.us.2.6.peel = load double, ptr %39, align 8
  %40 = getelementptr i8, ptr %36, i64 16
  store double %.732.us.2.6.peel, ptr %40, align 8
  %exitcond.peel.not = icmp eq i64 %arg.q.5.0, 1
  br i1 %exitcond.peel.not, label %B224, label %B62.preheader

B62.preheader:                                    ; preds = %B62.lr.ph
  %41 = shl i64 %arg.o.5.1, 3
  %42 = mul i64 %41, %arg.o.5.2
  %43 = add nsw i64 %arg.q.5.0, -1
  %44 = shl i64 %arg.o.5.2, 3
  %sunkaddr39 = shl i64 %arg.room.5.2, 3
  %sunkaddr40 = getelementptr i8, ptr %0, i64 %sunkaddr39
  %sunkaddr43 = getelementptr i8, ptr %sunkaddr40, i64 8
  %sunkaddr46 = getelementptr i8, ptr %sunkaddr40, i64 16
  br label %B62

B62:                                              ; preds = %B62, %B62.preheader
  %lsr.iv17 = phi i64 [ %43, %B62.preheader ], [ %lsr.iv.next, %B62 ]
  %arg.q.4.pn = phi ptr [ %arg.q.4, %B62.preheader ], [ %lsr.iv15, %B62 ]
  %arg.o.4.pn = phi ptr [ %arg.o.4, %B62.preheader ], [ %lsr.iv, %B62 ]
  %lsr.iv15 = getelementptr i8, ptr %arg.q.4.pn, i64 %arg.q.6.0
  call fastcc void @part.1(ptr nonnull %.369, ptr %arg.chain.4, i64 %arg.chain.5.1, ptr %arg.X_WC.4, i64 %arg.X_WC.6.0, i64 %arg.X_WC.6.1, ptr %arg.ride.4, i64 %arg.ride.6.0, i64 %arg.ride.6.1, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr nonnull %arg.room.4, i64 %arg.room.5.1, i64 %arg.room.5.2, ptr %lsr.iv15, i64 %arg.q.5.1, i64 %arg.q.6.1)
  %lsr.iv = getelementptr i8, ptr %arg.o.4.pn, i64 %42
  %.732.us = load double, ptr %0, align 8
  store double %.732.us, ptr %lsr.iv, align 8
  %.732.us.1 = load double, ptr %1, align 8
  %scevgep18 = getelementptr i8, ptr %lsr.iv, i64 8
  store double %.732.us.1, ptr %scevgep18, align 8
  %.732.us.2 = load double, ptr %3, align 8
  %scevgep19 = getelementptr i8, ptr %lsr.iv, i64 16
  store double %.732.us.2, ptr %scevgep19, align 8
  %.732.us.1357 = load double, ptr %sunkaddr40, align 8
  %scevgep20 = getelementptr i8, ptr %lsr.iv, i64 %44
  store double %.732.us.1357, ptr %scevgep20, align 8
  %.732.us.1.1 = load double, ptr %sunkaddr43, align 8
  %sunkaddr84 = getelementptr i8, ptr %scevgep20, i64 8
  store double %.732.us.1.1, ptr %sunkaddr84, align 8
  %.732.us.2.1 = load double, ptr %sunkaddr46, align 8
  %sunkaddr87 = getelementptr i8, ptr %scevgep20, i64 16
  store double %.732.us.2.1, ptr %sunkaddr87, align 8
  %.732.us.2358 = load double, ptr %11, align 8
  %scevgep23 = getelementptr i8, ptr %scevgep20, i64 %44
  store double %.732.us.2358, ptr %scevgep23, align 8
  %.732.us.1.2 = load double, ptr %13, align 8
  %sunkaddr92 = getelementptr i8, ptr %scevgep23, i64 8
  store double %.732.us.1.2, ptr %sunkaddr92, align 8
  %.732.us.2.2 = load double, ptr %15, align 8
  %sunkaddr95 = getelementptr i8, ptr %scevgep23, i64 16
  store double %.732.us.2.2, ptr %sunkaddr95, align 8
  %.732.us.3 = load double, ptr %17, align 8
  %scevgep26 = getelementptr i8, ptr %scevgep23, i64 %44
  store double %.732.us.3, ptr %scevgep26, align 8
  %.732.us.1.3 = load double, ptr %19, align 8
  %sunkaddr100 = getelementptr i8, ptr %scevgep26, i64 8
  store double %.732.us.1.3, ptr %sunkaddr100, align 8
  %.732.us.2.3 = load double, ptr %21, align 8
  %sunkaddr103 = getelementptr i8, ptr %scevgep26, i64 16
  store double %.732.us.2.3, ptr %sunkaddr103, align 8
  %.732.us.4 = load double, ptr %23, align 8
  %scevgep29 = getelementptr i8, ptr %scevgep26, i64 %44
  store double %.732.us.4, ptr %scevgep29, align 8
  %.732.us.1.4 = load double, ptr %25, align 8
  %sunkaddr108 = getelementptr i8, ptr %scevgep29, i64 8
  store double %.732.us.1.4, ptr %sunkaddr108, align 8
  %.732.us.2.4 = load double, ptr %27, align 8
  %sunkaddr111 = getelementptr i8, ptr %scevgep29, i64 16
  store double %.732.us.2.4, ptr %sunkaddr111, align 8
  %.732.us.5 = load double, ptr %29, align 8
  %scevgep32 = getelementptr i8, ptr %scevgep29, i64 %44
  store double %.732.us.5, ptr %scevgep32, align 8
  %.732.us.1.5 = load double, ptr %31, align 8
  %sunkaddr116 = getelementptr i8, ptr %scevgep32, i64 8
  store double %.732.us.1.5, ptr %sunkaddr116, align 8
  %.732.us.2.5 = load double, ptr %33, align 8
  %sunkaddr119 = getelementptr i8, ptr %scevgep32, i64 16
  store double %.732.us.2.5, ptr %sunkaddr119, align 8
  %.732.us.6 = load double, ptr %35, align 8
  %sunkaddr69 = getelementptr i8, ptr %scevgep32, i64 %44
  store double %.732.us.6, ptr %sunkaddr69, align 8
  %.732.us.1.6 = load double, ptr %37, align 8
  %sunkaddr74 = getelementptr i8, ptr %sunkaddr69, i64 8
  store double %.732.us.1.6, ptr %sunkaddr74, align 8
  %.732.us.2.6 = load double, ptr %39, align 8
  %sunkaddr79 = getelementptr i8, ptr %sunkaddr69, i64 16
  store double %.732.us.2.6, ptr %sunkaddr79, align 8
  %lsr.iv.next = add nsw i64 %lsr.iv17, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond.not, label %B224, label %B62, !llvm.loop !5

B224:                                             ; preds = %B62, %B62.lr.ph, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @part.1(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.chain.4, i64 %arg.chain.5.1, ptr readonly captures(none) %arg.X_WC.4, i64 %arg.X_WC.6.0, i64 %arg.X_WC.6.1, ptr readonly captures(none) %arg.ride.4, i64 %arg.ride.6.0, i64 %arg.ride.6.1, ptr readonly captures(none) %arg.X_6T.4, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr %arg.room.4, i64 %arg.room.5.1, i64 %arg.room.5.2, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.6.0) unnamed_addr #0 {
B0.endif.endif:
  %.168 = mul i64 %arg.room.5.2, %arg.room.5.1
  %.348.idx = shl i64 %.168, 4
  %.348 = getelementptr i8, ptr %arg.room.4, i64 %.348.idx
  %.447 = add nsw i64 %arg.q.5.0, -6
  %.622 = mul i64 %arg.X_WC.6.1, 3
  %invariant.gep1184 = getelementptr i8, ptr %arg.X_WC.4, i64 %.622
  %.721 = icmp slt i64 %arg.q.5.0, 7
  %..447 = select i1 %.721, i64 0, i64 %.447
  %.7631173 = icmp sgt i64 %..447, 0
  %.627.us = load double, ptr %invariant.gep1184, align 8
  store double %.627.us, ptr %.348, align 8
  br i1 %.7631173, label %B184.us.preheader, label %B120.endif.preheader

B184.us.preheader:                                ; preds = %B0.endif.endif
  %0 = icmp eq i64 %..447, 1
  br i1 %0, label %B184.us.epil.preheader, label %B184.us.preheader.new

B184.us.preheader.new:                            ; preds = %B184.us.preheader
  %unroll_iter = and i64 %..447, 9223372036854775806
  %1 = shl i64 %arg.ride.6.0, 1
  %2 = shl i64 %arg.q.6.0, 1
  %3 = add nsw i64 %..447, -2
  %4 = lshr i64 %3, 1
  %5 = icmp eq i64 %4, 0
  br i1 %5, label %B184.us.epil.preheader3, label %B184.us.preheader.new.new

B184.us.preheader.new.new:                        ; preds = %B184.us.preheader.new
  %6 = add nuw nsw i64 %4, 1
  %unroll_iter12 = and i64 %6, 9223372036854775806
  br label %B184.us

B120.endif.preheader:                             ; preds = %B0.endif.endif
  %.1170 = load double, ptr %arg.X_WC.4, align 8
  store double %.1170, ptr %arg.room.4, align 8
  %.1168.1 = getelementptr i8, ptr %arg.X_WC.4, i64 %arg.X_WC.6.1
  %.1170.1 = load double, ptr %.1168.1, align 8
  %gep1179.1 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  store double %.1170.1, ptr %gep1179.1, align 8
  %.1165.2 = shl i64 %arg.X_WC.6.1, 1
  %.1168.2 = getelementptr i8, ptr %arg.X_WC.4, i64 %.1165.2
  %.1170.2 = load double, ptr %.1168.2, align 8
  %.1220.2 = shl i64 %arg.room.5.2, 1
  %gep1179.2 = getelementptr double, ptr %arg.room.4, i64 %.1220.2
  store double %.1170.2, ptr %gep1179.2, align 8
  %gep1185.1 = getelementptr i8, ptr %invariant.gep1184, i64 %arg.X_WC.6.0
  %.627.1 = load double, ptr %gep1185.1, align 8
  %.681.1 = getelementptr i8, ptr %.348, i64 8
  store double %.627.1, ptr %.681.1, align 8
  %7 = getelementptr i8, ptr %arg.X_WC.4, i64 %arg.X_WC.6.0
  %invariant.gep1178.1 = getelementptr i8, ptr %arg.room.4, i64 8
  %.1170.11251 = load double, ptr %7, align 8
  store double %.1170.11251, ptr %invariant.gep1178.1, align 8
  %.1168.1.1 = getelementptr i8, ptr %7, i64 %arg.X_WC.6.1
  %.1170.1.1 = load double, ptr %.1168.1.1, align 8
  %gep1179.1.1 = getelementptr double, ptr %invariant.gep1178.1, i64 %arg.room.5.2
  store double %.1170.1.1, ptr %gep1179.1.1, align 8
  %.1168.2.1 = getelementptr i8, ptr %7, i64 %.1165.2
  %.1170.2.1 = load double, ptr %.1168.2.1, align 8
  %gep1179.2.1 = getelementptr double, ptr %invariant.gep1178.1, i64 %.1220.2
  store double %.1170.2.1, ptr %gep1179.2.1, align 8
  %.621.2 = shl i64 %arg.X_WC.6.0, 1
  %gep1185.2 = getelementptr i8, ptr %invariant.gep1184, i64 %.621.2
  %.627.2 = load double, ptr %gep1185.2, align 8
  %.681.2 = getelementptr i8, ptr %.348, i64 16
  store double %.627.2, ptr %.681.2, align 8
  br label %B652.endif.2.peel.next

B184.us.1:                                        ; preds = %B182.B258.endif.endif_crit_edge.us.new.new, %B184.us.1
  %lsr.iv81 = phi i64 [ %lsr.iv.next82, %B184.us.1 ], [ %unroll_iter32, %B182.B258.endif.endif_crit_edge.us.new.new ]
  %lsr.iv71 = phi ptr [ %scevgep88, %B184.us.1 ], [ %arg.q.4, %B182.B258.endif.endif_crit_edge.us.new.new ]
  %lsr.iv68 = phi ptr [ %scevgep85, %B184.us.1 ], [ %invariant.gep.us.1, %B182.B258.endif.endif_crit_edge.us.new.new ]
  %.9431177.us.1 = phi double [ %.943.us.1.1.1, %B184.us.1 ], [ %.627.us.1, %B182.B258.endif.endif_crit_edge.us.new.new ]
  %.908.us.1 = load double, ptr %lsr.iv68, align 8
  %.941.us.1 = load double, ptr %lsr.iv71, align 8
  %.942.us.1 = fmul double %.908.us.1, %.941.us.1
  %.943.us.1 = fadd double %.9431177.us.1, %.942.us.1
  store double %.943.us.1, ptr %.681.us.1, align 8
  %scevgep70 = getelementptr i8, ptr %lsr.iv68, i64 %arg.ride.6.0
  %.908.us.1.1 = load double, ptr %scevgep70, align 8
  %scevgep73 = getelementptr i8, ptr %lsr.iv71, i64 %arg.q.6.0
  %.941.us.1.1 = load double, ptr %scevgep73, align 8
  %.942.us.1.1 = fmul double %.908.us.1.1, %.941.us.1.1
  %.943.us.1.1 = fadd double %.943.us.1, %.942.us.1.1
  store double %.943.us.1.1, ptr %.681.us.1, align 8
  %scevgep83 = getelementptr i8, ptr %scevgep70, i64 %arg.ride.6.0
  %.908.us.1.134 = load double, ptr %scevgep83, align 8
  %scevgep86 = getelementptr i8, ptr %scevgep73, i64 %arg.q.6.0
  %.941.us.1.135 = load double, ptr %scevgep86, align 8
  %.942.us.1.136 = fmul double %.908.us.1.134, %.941.us.1.135
  %.943.us.1.137 = fadd double %.943.us.1.1, %.942.us.1.136
  store double %.943.us.1.137, ptr %.681.us.1, align 8
  %scevgep84 = getelementptr i8, ptr %scevgep83, i64 %arg.ride.6.0
  %.908.us.1.1.1 = load double, ptr %scevgep84, align 8
  %scevgep87 = getelementptr i8, ptr %scevgep86, i64 %arg.q.6.0
  %.941.us.1.1.1 = load double, ptr %scevgep87, align 8
  %.942.us.1.1.1 = fmul double %.908.us.1.1.1, %.941.us.1.1.1
  %.943.us.1.1.1 = fadd double %.943.us.1.137, %.942.us.1.1.1
  store double %.943.us.1.1.1, ptr %.681.us.1, align 8
  %lsr.iv.next82 = add i64 %lsr.iv81, -2
  %niter33.ncmp.1 = icmp eq i64 %lsr.iv.next82, 0
  %scevgep85 = getelementptr i8, ptr %scevgep84, i64 %arg.ride.6.0
  %scevgep88 = getelementptr i8, ptr %scevgep87, i64 %arg.q.6.0
  br i1 %niter33.ncmp.1, label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa, label %B184.us.1

B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa: ; preds = %B184.us.1
  %scevgep72 = getelementptr i8, ptr %lsr.iv71, i64 %20
  %scevgep72.1 = getelementptr i8, ptr %scevgep72, i64 %20
  %scevgep69 = getelementptr i8, ptr %lsr.iv68, i64 %19
  %scevgep69.1 = getelementptr i8, ptr %scevgep69, i64 %19
  %8 = and i64 %21, 2
  %lcmp.mod29.not.not = icmp eq i64 %8, 0
  br i1 %lcmp.mod29.not.not, label %B184.us.1.epil.preheader21, label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa

B184.us.1.epil.preheader21:                       ; preds = %B182.B258.endif.endif_crit_edge.us.new, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa
  %lsr.iv71.epil.init = phi ptr [ %arg.q.4, %B182.B258.endif.endif_crit_edge.us.new ], [ %scevgep72.1, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa ]
  %lsr.iv68.epil.init = phi ptr [ %invariant.gep.us.1, %B182.B258.endif.endif_crit_edge.us.new ], [ %scevgep69.1, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa ]
  %.9431177.us.1.epil.init27 = phi double [ %.627.us.1, %B182.B258.endif.endif_crit_edge.us.new ], [ %.943.us.1.1.1, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa ]
  %.908.us.1.epil23 = load double, ptr %lsr.iv68.epil.init, align 8
  %.941.us.1.epil24 = load double, ptr %lsr.iv71.epil.init, align 8
  %.942.us.1.epil25 = fmul double %.908.us.1.epil23, %.941.us.1.epil24
  %.943.us.1.epil26 = fadd double %.9431177.us.1.epil.init27, %.942.us.1.epil25
  store double %.943.us.1.epil26, ptr %.681.us.1, align 8
  %scevgep70.epil = getelementptr i8, ptr %lsr.iv68.epil.init, i64 %arg.ride.6.0
  %.908.us.1.1.epil = load double, ptr %scevgep70.epil, align 8
  %scevgep73.epil = getelementptr i8, ptr %lsr.iv71.epil.init, i64 %arg.q.6.0
  %.941.us.1.1.epil = load double, ptr %scevgep73.epil, align 8
  %.942.us.1.1.epil = fmul double %.908.us.1.1.epil, %.941.us.1.1.epil
  %.943.us.1.1.epil = fadd double %.943.us.1.epil26, %.942.us.1.1.epil
  store double %.943.us.1.1.epil, ptr %.681.us.1, align 8
  br label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa

B182.B258.endif.endif_crit_edge.us.1.unr-lcssa:   ; preds = %B184.us.1.epil.preheader21, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa
  %.943.us.1.1.lcssa = phi double [ %.943.us.1.1.1, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa ], [ %.943.us.1.1.epil, %B184.us.1.epil.preheader21 ]
  %9 = and i64 %..447, 1
  %lcmp.mod22.not = icmp eq i64 %9, 0
  br i1 %lcmp.mod22.not, label %B182.B258.endif.endif_crit_edge.us.1, label %B184.us.1.epil.preheader

B184.us.1.epil.preheader:                         ; preds = %B182.B258.endif.endif_crit_edge.us, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa
  %.9431177.us.1.epil.init = phi double [ %.627.us.1, %B182.B258.endif.endif_crit_edge.us ], [ %.943.us.1.1.lcssa, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa ]
  %.76911721174.us.1.epil.init = phi i64 [ 0, %B182.B258.endif.endif_crit_edge.us ], [ %unroll_iter24, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa ]
  %.902.us.1.epil = mul i64 %.76911721174.us.1.epil.init, %arg.ride.6.0
  %gep.us.1.epil = getelementptr i8, ptr %invariant.gep.us.1, i64 %.902.us.1.epil
  %.908.us.1.epil = load double, ptr %gep.us.1.epil, align 8
  %.937.us.1.epil = mul i64 %.76911721174.us.1.epil.init, %arg.q.6.0
  %.939.us.1.epil = getelementptr i8, ptr %arg.q.4, i64 %.937.us.1.epil
  %.941.us.1.epil = load double, ptr %.939.us.1.epil, align 8
  %.942.us.1.epil = fmul double %.908.us.1.epil, %.941.us.1.epil
  %.943.us.1.epil = fadd double %.9431177.us.1.epil.init, %.942.us.1.epil
  store double %.943.us.1.epil, ptr %.681.us.1, align 8
  br label %B182.B258.endif.endif_crit_edge.us.1

B182.B258.endif.endif_crit_edge.us.1:             ; preds = %B184.us.1.epil.preheader, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa
  %10 = getelementptr i8, ptr %arg.X_WC.4, i64 %arg.X_WC.6.0
  %invariant.gep1178.us.1 = getelementptr i8, ptr %arg.room.4, i64 8
  %.1170.us.11255 = load double, ptr %10, align 8
  store double %.1170.us.11255, ptr %invariant.gep1178.us.1, align 8
  %.1168.us.1.1 = getelementptr i8, ptr %10, i64 %arg.X_WC.6.1
  %.1170.us.1.1 = load double, ptr %.1168.us.1.1, align 8
  %gep1179.us.1.1 = getelementptr double, ptr %invariant.gep1178.us.1, i64 %arg.room.5.2
  store double %.1170.us.1.1, ptr %gep1179.us.1.1, align 8
  %sunkaddr100 = getelementptr i8, ptr %10, i64 %.1165.us.2
  %.1170.us.2.1 = load double, ptr %sunkaddr100, align 8
  %gep1179.us.2.1 = getelementptr double, ptr %invariant.gep1178.us.1, i64 %.1220.us.2
  store double %.1170.us.2.1, ptr %gep1179.us.2.1, align 8
  %.621.us.2 = shl i64 %arg.X_WC.6.0, 1
  %gep1185.us.2 = getelementptr i8, ptr %invariant.gep1184, i64 %.621.us.2
  %.627.us.2 = load double, ptr %gep1185.us.2, align 8
  %.681.us.2 = getelementptr i8, ptr %.348, i64 16
  store double %.627.us.2, ptr %.681.us.2, align 8
  %.903.us.2 = shl i64 %arg.ride.6.1, 1
  %invariant.gep.us.2 = getelementptr i8, ptr %arg.ride.4, i64 %.903.us.2
  br i1 %0, label %B184.us.2.epil.preheader, label %B182.B258.endif.endif_crit_edge.us.1.new

B182.B258.endif.endif_crit_edge.us.1.new:         ; preds = %B182.B258.endif.endif_crit_edge.us.1
  %unroll_iter29 = and i64 %..447, 9223372036854775806
  %11 = shl i64 %arg.ride.6.0, 1
  %12 = shl i64 %arg.q.6.0, 1
  %13 = add nsw i64 %..447, -2
  %14 = lshr i64 %13, 1
  %15 = icmp eq i64 %14, 0
  br i1 %15, label %B184.us.2.epil.preheader38, label %B182.B258.endif.endif_crit_edge.us.1.new.new

B182.B258.endif.endif_crit_edge.us.1.new.new:     ; preds = %B182.B258.endif.endif_crit_edge.us.1.new
  %16 = add nuw nsw i64 %14, 1
  %unroll_iter49 = and i64 %16, 9223372036854775806
  br label %B184.us.2

B184.us.2:                                        ; preds = %B184.us.2, %B182.B258.endif.endif_crit_edge.us.1.new.new
  %lsr.iv63 = phi i64 [ %lsr.iv.next64, %B184.us.2 ], [ %unroll_iter49, %B182.B258.endif.endif_crit_edge.us.1.new.new ]
  %lsr.iv65 = phi ptr [ %scevgep80, %B184.us.2 ], [ %arg.q.4, %B182.B258.endif.endif_crit_edge.us.1.new.new ]
  %lsr.iv62 = phi ptr [ %scevgep71, %B184.us.2 ], [ %invariant.gep.us.2, %B182.B258.endif.endif_crit_edge.us.1.new.new ]
  %.9431177.us.2 = phi double [ %.943.us.2.1.1, %B184.us.2 ], [ %.627.us.2, %B182.B258.endif.endif_crit_edge.us.1.new.new ]
  %.908.us.2 = load double, ptr %lsr.iv62, align 8
  %.941.us.2 = load double, ptr %lsr.iv65, align 8
  %.942.us.2 = fmul double %.908.us.2, %.941.us.2
  %.943.us.2 = fadd double %.9431177.us.2, %.942.us.2
  store double %.943.us.2, ptr %.681.us.2, align 8
  %scevgep64 = getelementptr i8, ptr %lsr.iv62, i64 %arg.ride.6.0
  %.908.us.2.1 = load double, ptr %scevgep64, align 8
  %scevgep67 = getelementptr i8, ptr %lsr.iv65, i64 %arg.q.6.0
  %.941.us.2.1 = load double, ptr %scevgep67, align 8
  %.942.us.2.1 = fmul double %.908.us.2.1, %.941.us.2.1
  %.943.us.2.1 = fadd double %.943.us.2, %.942.us.2.1
  store double %.943.us.2.1, ptr %.681.us.2, align 8
  %scevgep65 = getelementptr i8, ptr %scevgep64, i64 %arg.ride.6.0
  %.908.us.2.151 = load double, ptr %scevgep65, align 8
  %scevgep74 = getelementptr i8, ptr %scevgep67, i64 %arg.q.6.0
  %.941.us.2.152 = load double, ptr %scevgep74, align 8
  %.942.us.2.153 = fmul double %.908.us.2.151, %.941.us.2.152
  %.943.us.2.154 = fadd double %.943.us.2.1, %.942.us.2.153
  store double %.943.us.2.154, ptr %.681.us.2, align 8
  %scevgep68 = getelementptr i8, ptr %scevgep65, i64 %arg.ride.6.0
  %.908.us.2.1.1 = load double, ptr %scevgep68, align 8
  %scevgep77 = getelementptr i8, ptr %scevgep74, i64 %arg.q.6.0
  %.941.us.2.1.1 = load double, ptr %scevgep77, align 8
  %.942.us.2.1.1 = fmul double %.908.us.2.1.1, %.941.us.2.1.1
  %.943.us.2.1.1 = fadd double %.943.us.2.154, %.942.us.2.1.1
  store double %.943.us.2.1.1, ptr %.681.us.2, align 8
  %lsr.iv.next64 = add i64 %lsr.iv63, -2
  %niter50.ncmp.1 = icmp eq i64 %lsr.iv.next64, 0
  %scevgep71 = getelementptr i8, ptr %scevgep68, i64 %arg.ride.6.0
  %scevgep80 = getelementptr i8, ptr %scevgep77, i64 %arg.q.6.0
  br i1 %niter50.ncmp.1, label %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa, label %B184.us.2

B184.us:                                          ; preds = %B184.us, %B184.us.preheader.new.new
  %lsr.iv89 = phi i64 [ %lsr.iv.next90, %B184.us ], [ %unroll_iter12, %B184.us.preheader.new.new ]
  %lsr.iv77 = phi ptr [ %scevgep96, %B184.us ], [ %arg.q.4, %B184.us.preheader.new.new ]
  %lsr.iv74 = phi ptr [ %scevgep93, %B184.us ], [ %arg.ride.4, %B184.us.preheader.new.new ]
  %.9431177.us = phi double [ %.943.us.119.1, %B184.us ], [ %.627.us, %B184.us.preheader.new.new ]
  %.908.us = load double, ptr %lsr.iv74, align 8
  %.941.us = load double, ptr %lsr.iv77, align 8
  %.942.us = fmul double %.908.us, %.941.us
  %.943.us = fadd double %.9431177.us, %.942.us
  store double %.943.us, ptr %.348, align 8
  %scevgep76 = getelementptr i8, ptr %lsr.iv74, i64 %arg.ride.6.0
  %.908.us.114 = load double, ptr %scevgep76, align 8
  %scevgep79 = getelementptr i8, ptr %lsr.iv77, i64 %arg.q.6.0
  %.941.us.117 = load double, ptr %scevgep79, align 8
  %.942.us.118 = fmul double %.908.us.114, %.941.us.117
  %.943.us.119 = fadd double %.943.us, %.942.us.118
  store double %.943.us.119, ptr %.348, align 8
  %scevgep91 = getelementptr i8, ptr %scevgep76, i64 %arg.ride.6.0
  %.908.us.115 = load double, ptr %scevgep91, align 8
  %scevgep94 = getelementptr i8, ptr %scevgep79, i64 %arg.q.6.0
  %.941.us.116 = load double, ptr %scevgep94, align 8
  %.942.us.117 = fmul double %.908.us.115, %.941.us.116
  %.943.us.118 = fadd double %.943.us.119, %.942.us.117
  store double %.943.us.118, ptr %.348, align 8
  %scevgep92 = getelementptr i8, ptr %scevgep91, i64 %arg.ride.6.0
  %.908.us.114.1 = load double, ptr %scevgep92, align 8
  %scevgep95 = getelementptr i8, ptr %scevgep94, i64 %arg.q.6.0
  %.941.us.117.1 = load double, ptr %scevgep95, align 8
  %.942.us.118.1 = fmul double %.908.us.114.1, %.941.us.117.1
  %.943.us.119.1 = fadd double %.943.us.118, %.942.us.118.1
  store double %.943.us.119.1, ptr %.348, align 8
  %lsr.iv.next90 = add i64 %lsr.iv89, -2
  %niter.ncmp.119 = icmp eq i64 %lsr.iv.next90, 0
  %scevgep93 = getelementptr i8, ptr %scevgep92, i64 %arg.ride.6.0
  %scevgep96 = getelementptr i8, ptr %scevgep95, i64 %arg.q.6.0
  br i1 %niter.ncmp.119, label %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa, label %B184.us

B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa: ; preds = %B184.us
  %scevgep78 = getelementptr i8, ptr %lsr.iv77, i64 %2
  %scevgep78.1 = getelementptr i8, ptr %scevgep78, i64 %2
  %scevgep75 = getelementptr i8, ptr %lsr.iv74, i64 %1
  %scevgep75.1 = getelementptr i8, ptr %scevgep75, i64 %1
  %17 = and i64 %3, 2
  %lcmp.mod.not55.not = icmp eq i64 %17, 0
  br i1 %lcmp.mod.not55.not, label %B184.us.epil.preheader3, label %B182.B258.endif.endif_crit_edge.us.unr-lcssa

B184.us.epil.preheader3:                          ; preds = %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa, %B184.us.preheader.new
  %lsr.iv77.epil.init = phi ptr [ %arg.q.4, %B184.us.preheader.new ], [ %scevgep78.1, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa ]
  %lsr.iv74.epil.init = phi ptr [ %arg.ride.4, %B184.us.preheader.new ], [ %scevgep75.1, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa ]
  %.9431177.us.epil.init8 = phi double [ %.627.us, %B184.us.preheader.new ], [ %.943.us.119.1, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa ]
  %.908.us.epil4 = load double, ptr %lsr.iv74.epil.init, align 8
  %.941.us.epil5 = load double, ptr %lsr.iv77.epil.init, align 8
  %.942.us.epil6 = fmul double %.908.us.epil4, %.941.us.epil5
  %.943.us.epil7 = fadd double %.9431177.us.epil.init8, %.942.us.epil6
  store double %.943.us.epil7, ptr %.348, align 8
  %scevgep76.epil = getelementptr i8, ptr %lsr.iv74.epil.init, i64 %arg.ride.6.0
  %.908.us.114.epil = load double, ptr %scevgep76.epil, align 8
  %scevgep79.epil = getelementptr i8, ptr %lsr.iv77.epil.init, i64 %arg.q.6.0
  %.941.us.117.epil = load double, ptr %scevgep79.epil, align 8
  %.942.us.118.epil = fmul double %.908.us.114.epil, %.941.us.117.epil
  %.943.us.119.epil = fadd double %.943.us.epil7, %.942.us.118.epil
  store double %.943.us.119.epil, ptr %.348, align 8
  br label %B182.B258.endif.endif_crit_edge.us.unr-lcssa

B182.B258.endif.endif_crit_edge.us.unr-lcssa:     ; preds = %B184.us.epil.preheader3, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa
  %.943.us.119.lcssa = phi double [ %.943.us.119.1, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa ], [ %.943.us.119.epil, %B184.us.epil.preheader3 ]
  %18 = and i64 %..447, 1
  %lcmp.mod.not = icmp eq i64 %18, 0
  br i1 %lcmp.mod.not, label %B182.B258.endif.endif_crit_edge.us, label %B184.us.epil.preheader

B184.us.epil.preheader:                           ; preds = %B182.B258.endif.endif_crit_edge.us.unr-lcssa, %B184.us.preheader
  %.9431177.us.epil.init = phi double [ %.627.us, %B184.us.preheader ], [ %.943.us.119.lcssa, %B182.B258.endif.endif_crit_edge.us.unr-lcssa ]
  %.76911721174.us.epil.init = phi i64 [ 0, %B184.us.preheader ], [ %unroll_iter, %B182.B258.endif.endif_crit_edge.us.unr-lcssa ]
  %.902.us.epil = mul i64 %.76911721174.us.epil.init, %arg.ride.6.0
  %gep.us.epil = getelementptr i8, ptr %arg.ride.4, i64 %.902.us.epil
  %.908.us.epil = load double, ptr %gep.us.epil, align 8
  %.937.us.epil = mul i64 %.76911721174.us.epil.init, %arg.q.6.0
  %.939.us.epil = getelementptr i8, ptr %arg.q.4, i64 %.937.us.epil
  %.941.us.epil = load double, ptr %.939.us.epil, align 8
  %.942.us.epil = fmul double %.908.us.epil, %.941.us.epil
  %.943.us.epil = fadd double %.9431177.us.epil.init, %.942.us.epil
  store double %.943.us.epil, ptr %.348, align 8
  br label %B182.B258.endif.endif_crit_edge.us

B182.B258.endif.endif_crit_edge.us:               ; preds = %B184.us.epil.preheader, %B182.B258.endif.endif_crit_edge.us.unr-lcssa
  %.1170.us = load double, ptr %arg.X_WC.4, align 8
  store double %.1170.us, ptr %arg.room.4, align 8
  %.1168.us.1 = getelementptr i8, ptr %arg.X_WC.4, i64 %arg.X_WC.6.1
  %.1170.us.1 = load double, ptr %.1168.us.1, align 8
  %gep1179.us.1 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  store double %.1170.us.1, ptr %gep1179.us.1, align 8
  %.1165.us.2 = shl i64 %arg.X_WC.6.1, 1
  %.1168.us.2 = getelementptr i8, ptr %arg.X_WC.4, i64 %.1165.us.2
  %.1170.us.2 = load double, ptr %.1168.us.2, align 8
  %.1220.us.2 = shl i64 %arg.room.5.2, 1
  %gep1179.us.2 = getelementptr double, ptr %arg.room.4, i64 %.1220.us.2
  store double %.1170.us.2, ptr %gep1179.us.2, align 8
  %gep1185.us.1 = getelementptr i8, ptr %invariant.gep1184, i64 %arg.X_WC.6.0
  %.627.us.1 = load double, ptr %gep1185.us.1, align 8
  %.681.us.1 = getelementptr i8, ptr %.348, i64 8
  store double %.627.us.1, ptr %.681.us.1, align 8
  %invariant.gep.us.1 = getelementptr i8, ptr %arg.ride.4, i64 %arg.ride.6.1
  br i1 %0, label %B184.us.1.epil.preheader, label %B182.B258.endif.endif_crit_edge.us.new

B182.B258.endif.endif_crit_edge.us.new:           ; preds = %B182.B258.endif.endif_crit_edge.us
  %unroll_iter24 = and i64 %..447, 9223372036854775806
  %19 = shl i64 %arg.ride.6.0, 1
  %20 = shl i64 %arg.q.6.0, 1
  %21 = add nsw i64 %..447, -2
  %22 = lshr i64 %21, 1
  %23 = icmp eq i64 %22, 0
  br i1 %23, label %B184.us.1.epil.preheader21, label %B182.B258.endif.endif_crit_edge.us.new.new

B182.B258.endif.endif_crit_edge.us.new.new:       ; preds = %B182.B258.endif.endif_crit_edge.us.new
  %24 = add nuw nsw i64 %22, 1
  %unroll_iter32 = and i64 %24, 9223372036854775806
  br label %B184.us.1

common.ret:                                       ; preds = %B652.endif.2
  %.idx = mul i64 %arg.room.5.2, 40
  %25 = getelementptr i8, ptr %.348, i64 %.idx
  %.3175 = mul i64 %arg.X_6T.6.1, 3
  %.3178 = getelementptr i8, ptr %arg.X_6T.4, i64 %.3175
  %26 = getelementptr i8, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0
  %.3288 = getelementptr i8, ptr %26, i64 %.3175
  %.3394 = shl i64 %arg.X_6T.6.0, 1
  %27 = getelementptr i8, ptr %arg.X_6T.4, i64 %.3394
  %.3398 = getelementptr i8, ptr %27, i64 %.3175
  %.idx1168 = mul i64 %arg.room.5.2, 48
  %28 = getelementptr i8, ptr %.348, i64 %.idx1168
  %.3072 = load double, ptr %25, align 8
  %.3126 = load double, ptr %arg.room.4, align 8
  %.3180 = load double, ptr %.3178, align 8
  %.3181 = fmul double %.3126, %.3180
  %.3182 = fadd double %.3072, %.3181
  %.3236 = load double, ptr %sunkaddr134, align 8
  %.3290 = load double, ptr %.3288, align 8
  %.3291 = fmul double %.3236, %.3290
  %.3292 = fadd double %.3182, %.3291
  %.3346 = load double, ptr %33, align 8
  %.3400 = load double, ptr %.3398, align 8
  %.3401 = fmul double %.3346, %.3400
  %.3402 = fadd double %.3292, %.3401
  store double %.3402, ptr %28, align 8
  %.3071.1 = getelementptr i8, ptr %25, i64 8
  %.3072.1 = load double, ptr %.3071.1, align 8
  %.3126.1 = load double, ptr %.2054.1, align 8
  %.3180.1 = load double, ptr %.3178, align 8
  %.3181.1 = fmul double %.3126.1, %.3180.1
  %.3182.1 = fadd double %.3072.1, %.3181.1
  %.3236.1 = load double, ptr %sunkaddr139, align 8
  %.3290.1 = load double, ptr %.3288, align 8
  %.3291.1 = fmul double %.3236.1, %.3290.1
  %.3292.1 = fadd double %.3182.1, %.3291.1
  %.3346.1 = load double, ptr %.2276.1, align 8
  %.3400.1 = load double, ptr %.3398, align 8
  %.3401.1 = fmul double %.3346.1, %.3400.1
  %.3402.1 = fadd double %.3292.1, %.3401.1
  %.3455.1 = getelementptr i8, ptr %28, i64 8
  store double %.3402.1, ptr %.3455.1, align 8
  %.3071.2 = getelementptr i8, ptr %25, i64 16
  %.3072.2 = load double, ptr %.3071.2, align 8
  %.3126.2 = load double, ptr %invariant.gep1178.2, align 8
  %.3180.2 = load double, ptr %.3178, align 8
  %.3181.2 = fmul double %.3126.2, %.3180.2
  %.3182.2 = fadd double %.3072.2, %.3181.2
  %.3236.2 = load double, ptr %sunkaddr145, align 8
  %.3290.2 = load double, ptr %.3288, align 8
  %.3291.2 = fmul double %.3236.2, %.3290.2
  %.3292.2 = fadd double %.3182.2, %.3291.2
  %.3346.2 = load double, ptr %.2276.2, align 8
  %.3400.2 = load double, ptr %.3398, align 8
  %.3401.2 = fmul double %.3346.2, %.3400.2
  %.3402.2 = fadd double %.3292.2, %.3401.2
  %.3455.2 = getelementptr i8, ptr %28, i64 16
  store double %.3402.2, ptr %.3455.2, align 8
  store ptr null, ptr %retptr, align 8
  ret void

B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa: ; preds = %B184.us.2
  %scevgep66 = getelementptr i8, ptr %lsr.iv65, i64 %12
  %scevgep66.1 = getelementptr i8, ptr %scevgep66, i64 %12
  %scevgep63 = getelementptr i8, ptr %lsr.iv62, i64 %11
  %scevgep63.1 = getelementptr i8, ptr %scevgep63, i64 %11
  %29 = and i64 %13, 2
  %lcmp.mod46.not.not = icmp eq i64 %29, 0
  br i1 %lcmp.mod46.not.not, label %B184.us.2.epil.preheader38, label %B652.endif.2.peel.next.loopexit.unr-lcssa

B184.us.2.epil.preheader38:                       ; preds = %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa, %B182.B258.endif.endif_crit_edge.us.1.new
  %lsr.iv65.epil.init = phi ptr [ %arg.q.4, %B182.B258.endif.endif_crit_edge.us.1.new ], [ %scevgep66.1, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa ]
  %lsr.iv62.epil.init = phi ptr [ %invariant.gep.us.2, %B182.B258.endif.endif_crit_edge.us.1.new ], [ %scevgep63.1, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa ]
  %.9431177.us.2.epil.init44 = phi double [ %.627.us.2, %B182.B258.endif.endif_crit_edge.us.1.new ], [ %.943.us.2.1.1, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa ]
  %.908.us.2.epil40 = load double, ptr %lsr.iv62.epil.init, align 8
  %.941.us.2.epil41 = load double, ptr %lsr.iv65.epil.init, align 8
  %.942.us.2.epil42 = fmul double %.908.us.2.epil40, %.941.us.2.epil41
  %.943.us.2.epil43 = fadd double %.9431177.us.2.epil.init44, %.942.us.2.epil42
  store double %.943.us.2.epil43, ptr %.681.us.2, align 8
  %scevgep64.epil = getelementptr i8, ptr %lsr.iv62.epil.init, i64 %arg.ride.6.0
  %.908.us.2.1.epil = load double, ptr %scevgep64.epil, align 8
  %scevgep67.epil = getelementptr i8, ptr %lsr.iv65.epil.init, i64 %arg.q.6.0
  %.941.us.2.1.epil = load double, ptr %scevgep67.epil, align 8
  %.942.us.2.1.epil = fmul double %.908.us.2.1.epil, %.941.us.2.1.epil
  %.943.us.2.1.epil = fadd double %.943.us.2.epil43, %.942.us.2.1.epil
  store double %.943.us.2.1.epil, ptr %.681.us.2, align 8
  br label %B652.endif.2.peel.next.loopexit.unr-lcssa

B652.endif.2.peel.next.loopexit.unr-lcssa:        ; preds = %B184.us.2.epil.preheader38, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa
  %.943.us.2.1.lcssa = phi double [ %.943.us.2.1.1, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa ], [ %.943.us.2.1.epil, %B184.us.2.epil.preheader38 ]
  %30 = and i64 %..447, 1
  %lcmp.mod27.not = icmp eq i64 %30, 0
  br i1 %lcmp.mod27.not, label %B652.endif.2.peel.next, label %B184.us.2.epil.preheader

B184.us.2.epil.preheader:                         ; preds = %B652.endif.2.peel.next.loopexit.unr-lcssa, %B182.B258.endif.endif_crit_edge.us.1
  %.9431177.us.2.epil.init = phi double [ %.627.us.2, %B182.B258.endif.endif_crit_edge.us.1 ], [ %.943.us.2.1.lcssa, %B652.endif.2.peel.next.loopexit.unr-lcssa ]
  %.76911721174.us.2.epil.init = phi i64 [ 0, %B182.B258.endif.endif_crit_edge.us.1 ], [ %unroll_iter29, %B652.endif.2.peel.next.loopexit.unr-lcssa ]
  %.902.us.2.epil = mul i64 %.76911721174.us.2.epil.init, %arg.ride.6.0
  %gep.us.2.epil = getelementptr i8, ptr %invariant.gep.us.2, i64 %.902.us.2.epil
  %.908.us.2.epil = load double, ptr %gep.us.2.epil, align 8
  %.937.us.2.epil = mul i64 %.76911721174.us.2.epil.init, %arg.q.6.0
  %.939.us.2.epil = getelementptr i8, ptr %arg.q.4, i64 %.937.us.2.epil
  %.941.us.2.epil = load double, ptr %.939.us.2.epil, align 8
  %.942.us.2.epil = fmul double %.908.us.2.epil, %.941.us.2.epil
  %.943.us.2.epil = fadd double %.9431177.us.2.epil.init, %.942.us.2.epil
  store double %.943.us.2.epil, ptr %.681.us.2, align 8
  br label %B652.endif.2.peel.next

B652.endif.2.peel.next:                           ; preds = %B184.us.2.epil.preheader, %B652.endif.2.peel.next.loopexit.unr-lcssa, %B120.endif.preheader
  %.621.2.sink = phi i64 [ %.621.2, %B120.endif.preheader ], [ %.621.us.2, %B652.endif.2.peel.next.loopexit.unr-lcssa ], [ %.621.us.2, %B184.us.2.epil.preheader ]
  %.1165.2.sink = phi i64 [ %.1165.2, %B120.endif.preheader ], [ %.1165.us.2, %B652.endif.2.peel.next.loopexit.unr-lcssa ], [ %.1165.us.2, %B184.us.2.epil.preheader ]
  %.1220.2.sink = phi i64 [ %.1220.2, %B120.endif.preheader ], [ %.1220.us.2, %B652.endif.2.peel.next.loopexit.unr-lcssa ], [ %.1220.us.2, %B184.us.2.epil.preheader ]
  %31 = getelementptr i8, ptr %arg.X_WC.4, i64 %.621.2.sink
  %invariant.gep1178.2 = getelementptr i8, ptr %arg.room.4, i64 16
  %.1170.21252 = load double, ptr %31, align 8
  store double %.1170.21252, ptr %invariant.gep1178.2, align 8
  %.1168.1.2 = getelementptr i8, ptr %31, i64 %arg.X_WC.6.1
  %.1170.1.2 = load double, ptr %.1168.1.2, align 8
  %gep1179.1.2 = getelementptr double, ptr %invariant.gep1178.2, i64 %arg.room.5.2
  store double %.1170.1.2, ptr %gep1179.1.2, align 8
  %.1168.2.2 = getelementptr i8, ptr %31, i64 %.1165.2.sink
  %.1170.2.2 = load double, ptr %.1168.2.2, align 8
  %gep1179.2.2 = getelementptr double, ptr %invariant.gep1178.2, i64 %.1220.2.sink
  store double %.1170.2.2, ptr %gep1179.2.2, align 8
  %32 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  %.idx1169 = shl i64 %arg.room.5.2, 4
  %33 = getelementptr i8, ptr %arg.room.4, i64 %.idx1169
  %.2054.1 = getelementptr i8, ptr %arg.room.4, i64 8
  %.2165.1 = getelementptr i8, ptr %32, i64 8
  %.2276.1 = getelementptr i8, ptr %33, i64 8
  %.2165.2 = getelementptr i8, ptr %32, i64 16
  %.2276.2 = getelementptr i8, ptr %33, i64 16
  %.1431.peel = getelementptr i8, ptr %arg.chain.4, i64 8
  %.1432.peel = load double, ptr %.1431.peel, align 8
  %.1449.peel = icmp slt i64 %arg.q.5.0, 6
  %.1450.peel = select i1 %.1449.peel, i64 %arg.q.5.0, i64 0
  %.1451.peel = add i64 %.1450.peel, %.447
  %.1462.peel = mul i64 %.1451.peel, %arg.q.6.0
  %.1464.peel = getelementptr i8, ptr %arg.q.4, i64 %.1462.peel
  %.1466.peel = load double, ptr %.1464.peel, align 8
  %.1467.peel = fmul double %.1432.peel, %.1466.peel
  %.1521.peel = getelementptr i8, ptr %arg.chain.4, i64 16
  %.1522.peel = load double, ptr %.1521.peel, align 8
  %.1523.peel = fadd double %.1467.peel, %.1522.peel
  %.1577.peel = getelementptr i8, ptr %arg.chain.4, i64 48
  %.1578.peel = load double, ptr %.1577.peel, align 8
  %.1580.peel = fmul double %.1578.peel, 0.000000e+00
  %.1583.peel = fsub double %.1523.peel, %.1580.peel
  %.1621.peel = tail call double @llvm.cos.f64(double %.1583.peel)
  %.1622.peel = tail call double @llvm.sin.f64(double %.1583.peel)
  %.1683.peel = load double, ptr %arg.chain.4, align 8
  %.5.i.peel = fptosi double %.1683.peel to i64
  %.1712.peel = add nsw i64 %.5.i.peel, 1
  %.1732.peel = srem i64 %.1712.peel, 3
  %.1734.peel = icmp slt i64 %.1732.peel, 0
  %.1743.peel = add nsw i64 %.1732.peel, 3
  %.1723.1.peel = select i1 %.1734.peel, i64 %.1743.peel, i64 %.1732.peel
  %.1754.peel = add nsw i64 %.5.i.peel, 2
  %.1774.peel = srem i64 %.1754.peel, 3
  %.1776.peel = icmp slt i64 %.1774.peel, 0
  %.1785.peel = add nsw i64 %.1774.peel, 3
  %.1765.1.peel = select i1 %.1776.peel, i64 %.1785.peel, i64 %.1774.peel
  %.2109.peel = getelementptr i8, ptr %arg.chain.4, i64 24
  %.2220.peel = getelementptr i8, ptr %arg.chain.4, i64 32
  %.2331.peel = getelementptr i8, ptr %arg.chain.4, i64 40
  %.2415.peel = icmp slt i64 %.5.i.peel, 0
  %.2416.peel = select i1 %.2415.peel, i64 %arg.room.5.1, i64 0
  %.2417.peel = add i64 %.2416.peel, %.5.i.peel
  %.2437.peel = mul i64 %.2417.peel, %arg.room.5.2
  %34 = getelementptr double, ptr %arg.room.4, i64 %.2437.peel
  %.1999.peel = load double, ptr %.348, align 8
  %.2055.peel = load double, ptr %arg.room.4, align 8
  %.2110.peel = load double, ptr %.2109.peel, align 8
  %.2111.peel = fmul double %.2055.peel, %.2110.peel
  %.2112.peel = fadd double %.1999.peel, %.2111.peel
  %.2166.peel = load double, ptr %32, align 8
  %.2221.peel = load double, ptr %.2220.peel, align 8
  %.2222.peel = fmul double %.2166.peel, %.2221.peel
  %.2223.peel = fadd double %.2112.peel, %.2222.peel
  %.2277.peel = load double, ptr %33, align 8
  %.2332.peel = load double, ptr %.2331.peel, align 8
  %.2333.peel = fmul double %.2277.peel, %.2332.peel
  %.2334.peel = fadd double %.2223.peel, %.2333.peel
  store double %.2334.peel, ptr %.348, align 8
  %.2442.peel = load double, ptr %34, align 8
  %sunkaddr101 = shl i64 %.168, 3
  %sunkaddr102 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr101
  store double %.2442.peel, ptr %sunkaddr102, align 8
  %sunkaddr130 = getelementptr i8, ptr %.348, i64 8
  %.1999.1.peel = load double, ptr %sunkaddr130, align 8
  %.2055.1.peel = load double, ptr %.2054.1, align 8
  %.2110.1.peel = load double, ptr %.2109.peel, align 8
  %.2111.1.peel = fmul double %.2055.1.peel, %.2110.1.peel
  %.2112.1.peel = fadd double %.1999.1.peel, %.2111.1.peel
  %.2166.1.peel = load double, ptr %.2165.1, align 8
  %.2221.1.peel = load double, ptr %.2220.peel, align 8
  %.2222.1.peel = fmul double %.2166.1.peel, %.2221.1.peel
  %.2223.1.peel = fadd double %.2112.1.peel, %.2222.1.peel
  %.2277.1.peel = load double, ptr %.2276.1, align 8
  %.2332.1.peel = load double, ptr %.2331.peel, align 8
  %.2333.1.peel = fmul double %.2277.1.peel, %.2332.1.peel
  %.2334.1.peel = fadd double %.2223.1.peel, %.2333.1.peel
  store double %.2334.1.peel, ptr %sunkaddr130, align 8
  %.2441.1.peel = getelementptr i8, ptr %34, i64 8
  %.2442.1.peel = load double, ptr %.2441.1.peel, align 8
  %sunkaddr107 = getelementptr i8, ptr %sunkaddr102, i64 8
  store double %.2442.1.peel, ptr %sunkaddr107, align 8
  %sunkaddr132 = getelementptr i8, ptr %.348, i64 16
  %.1999.2.peel = load double, ptr %sunkaddr132, align 8
  %.2055.2.peel = load double, ptr %invariant.gep1178.2, align 8
  %.2110.2.peel = load double, ptr %.2109.peel, align 8
  %.2111.2.peel = fmul double %.2055.2.peel, %.2110.2.peel
  %.2112.2.peel = fadd double %.1999.2.peel, %.2111.2.peel
  %.2166.2.peel = load double, ptr %.2165.2, align 8
  %.2221.2.peel = load double, ptr %.2220.peel, align 8
  %.2222.2.peel = fmul double %.2166.2.peel, %.2221.2.peel
  %.2223.2.peel = fadd double %.2112.2.peel, %.2222.2.peel
  %.2277.2.peel = load double, ptr %.2276.2, align 8
  %.2332.2.peel = load double, ptr %.2331.peel, align 8
  %.2333.2.peel = fmul double %.2277.2.peel, %.2332.2.peel
  %.2334.2.peel = fadd double %.2223.2.peel, %.2333.2.peel
  store double %.2334.2.peel, ptr %sunkaddr132, align 8
  %.2441.2.peel = getelementptr i8, ptr %34, i64 16
  %.2442.2.peel = load double, ptr %.2441.2.peel, align 8
  %sunkaddr112 = getelementptr i8, ptr %sunkaddr102, i64 16
  store double %.2442.2.peel, ptr %sunkaddr112, align 8
  %.2651.peel = icmp slt i64 %.1723.1.peel, 0
  %.2652.peel = select i1 %.2651.peel, i64 %arg.room.5.1, i64 0
  %.2653.peel = add i64 %.2652.peel, %.1723.1.peel
  %.2673.peel = mul i64 %.2653.peel, %arg.room.5.2
  %35 = getelementptr double, ptr %arg.room.4, i64 %.2673.peel
  %.2706.peel = icmp slt i64 %.1765.1.peel, 0
  %.2707.peel = select i1 %.2706.peel, i64 %arg.room.5.1, i64 0
  %.2708.peel = add i64 %.2707.peel, %.1765.1.peel
  %.2728.peel = mul i64 %.2708.peel, %arg.room.5.2
  %36 = getelementptr double, ptr %arg.room.4, i64 %.2728.peel
  %.2678.peel = load double, ptr %35, align 8
  %.2733.peel = load double, ptr %36, align 8
  %.2737.peel = fmul double %.1621.peel, %.2678.peel
  %.2739.peel = fmul double %.1622.peel, %.2733.peel
  %.2740.peel = fadd double %.2737.peel, %.2739.peel
  %.2742.peel = fmul double %.1621.peel, %.2733.peel
  %.2744.peel = fmul double %.1622.peel, %.2678.peel
  %.2745.peel = fsub double %.2742.peel, %.2744.peel
  store double %.2740.peel, ptr %35, align 8
  store double %.2745.peel, ptr %36, align 8
  %.2677.1.peel = getelementptr i8, ptr %35, i64 8
  %.2678.1.peel = load double, ptr %.2677.1.peel, align 8
  %.2732.1.peel = getelementptr i8, ptr %36, i64 8
  %.2733.1.peel = load double, ptr %.2732.1.peel, align 8
  %.2737.1.peel = fmul double %.1621.peel, %.2678.1.peel
  %.2739.1.peel = fmul double %.1622.peel, %.2733.1.peel
  %.2740.1.peel = fadd double %.2737.1.peel, %.2739.1.peel
  %.2742.1.peel = fmul double %.1621.peel, %.2733.1.peel
  %.2744.1.peel = fmul double %.1622.peel, %.2678.1.peel
  %.2745.1.peel = fsub double %.2742.1.peel, %.2744.1.peel
  store double %.2740.1.peel, ptr %.2677.1.peel, align 8
  store double %.2745.1.peel, ptr %.2732.1.peel, align 8
  %.2677.2.peel = getelementptr i8, ptr %35, i64 16
  %.2678.2.peel = load double, ptr %.2677.2.peel, align 8
  %.2732.2.peel = getelementptr i8, ptr %36, i64 16
  %.2733.2.peel = load double, ptr %.2732.2.peel, align 8
  %.2737.2.peel = fmul double %.1621.peel, %.2678.2.peel
  %.2739.2.peel = fmul double %.1622.peel, %.2733.2.peel
  %.2740.2.peel = fadd double %.2737.2.peel, %.2739.2.peel
  %.2742.2.peel = fmul double %.1621.peel, %.2733.2.peel
  %.2744.2.peel = fmul double %.1622.peel, %.2678.2.peel
  %.2745.2.peel = fsub double %.2742.2.peel, %.2744.2.peel
  store double %.2740.2.peel, ptr %.2677.2.peel, align 8
  store double %.2745.2.peel, ptr %.2732.2.peel, align 8
  %37 = add i64 %.348.idx, 16
  %38 = shl i64 %arg.room.5.2, 3
  %39 = shl i64 %arg.room.5.1, 4
  %40 = or disjoint i64 %39, 8
  %41 = mul i64 %40, %arg.room.5.2
  %42 = add i64 %41, 16
  %43 = shl i64 %arg.room.5.1, 3
  %44 = add i64 %43, 8
  %45 = mul i64 %44, %arg.room.5.2
  %46 = add i64 %45, 16
  %47 = shl i64 %arg.chain.5.1, 3
  %48 = getelementptr i8, ptr %arg.chain.4, i64 %47
  %scevgep49 = getelementptr i8, ptr %48, i64 48
  %49 = add i64 %arg.q.5.0, -5
  %sunkaddr134 = getelementptr i8, ptr %arg.room.4, i64 %38
  %sunkaddr139 = getelementptr i8, ptr %sunkaddr134, i64 8
  %sunkaddr145 = getelementptr i8, ptr %sunkaddr134, i64 16
  br label %B652.endif.2

B652.endif.2:                                     ; preds = %B652.endif.2, %B652.endif.2.peel.next
  %lsr.iv60 = phi i64 [ 5, %B652.endif.2.peel.next ], [ %lsr.iv.next61, %B652.endif.2 ]
  %lsr.iv58 = phi i64 [ %49, %B652.endif.2.peel.next ], [ %lsr.iv.next59, %B652.endif.2 ]
  %lsr.iv50 = phi ptr [ %scevgep49, %B652.endif.2.peel.next ], [ %scevgep51, %B652.endif.2 ]
  %lsr.iv42 = phi i64 [ %46, %B652.endif.2.peel.next ], [ %lsr.iv.next43, %B652.endif.2 ]
  %lsr.iv35 = phi i64 [ %42, %B652.endif.2.peel.next ], [ %lsr.iv.next36, %B652.endif.2 ]
  %lsr.iv = phi i64 [ %37, %B652.endif.2.peel.next ], [ %lsr.iv.next, %B652.endif.2 ]
  %before.2.01232 = phi double [ %.1466.peel, %B652.endif.2.peel.next ], [ %.1466, %B652.endif.2 ]
  %scevgep55 = getelementptr i8, ptr %lsr.iv50, i64 -48
  %scevgep57 = getelementptr i8, ptr %lsr.iv50, i64 -40
  %.1432 = load double, ptr %scevgep57, align 8
  %.1449 = icmp slt i64 %lsr.iv58, 0
  %.1450 = select i1 %.1449, i64 %arg.q.5.0, i64 0
  %50 = add i64 %.1450, %lsr.iv58
  %.1462 = mul i64 %50, %arg.q.6.0
  %.1464 = getelementptr i8, ptr %arg.q.4, i64 %.1462
  %.1466 = load double, ptr %.1464, align 8
  %.1467 = fmul double %.1432, %.1466
  %scevgep56 = getelementptr i8, ptr %lsr.iv50, i64 -32
  %.1522 = load double, ptr %scevgep56, align 8
  %.1523 = fadd double %.1467, %.1522
  %.1578 = load double, ptr %lsr.iv50, align 8
  %.1580 = fmul double %before.2.01232, %.1578
  %.1583 = fsub double %.1523, %.1580
  %.1621 = tail call double @llvm.cos.f64(double %.1583)
  %.1622 = tail call double @llvm.sin.f64(double %.1583)
  %.1683 = load double, ptr %scevgep55, align 8
  %.5.i = fptosi double %.1683 to i64
  %.1712 = add nsw i64 %.5.i, 1
  %.1732 = srem i64 %.1712, 3
  %.1734 = icmp slt i64 %.1732, 0
  %.1743 = add nsw i64 %.1732, 3
  %.1723.1 = select i1 %.1734, i64 %.1743, i64 %.1732
  %.1754 = add nsw i64 %.5.i, 2
  %.1774 = srem i64 %.1754, 3
  %.1776 = icmp slt i64 %.1774, 0
  %.1785 = add nsw i64 %.1774, 3
  %.1765.1 = select i1 %.1776, i64 %.1785, i64 %.1774
  %scevgep54 = getelementptr i8, ptr %lsr.iv50, i64 -24
  %scevgep53 = getelementptr i8, ptr %lsr.iv50, i64 -16
  %scevgep52 = getelementptr i8, ptr %lsr.iv50, i64 -8
  %.2415 = icmp slt i64 %.5.i, 0
  %.2416 = select i1 %.2415, i64 %arg.room.5.1, i64 0
  %.2417 = add i64 %.2416, %.5.i
  %.2437 = mul i64 %.2417, %arg.room.5.2
  %51 = getelementptr double, ptr %arg.room.4, i64 %.2437
  %scevgep33 = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv
  %scevgep34 = getelementptr i8, ptr %scevgep33, i64 -16
  %.1999 = load double, ptr %scevgep34, align 8
  %.2055 = load double, ptr %arg.room.4, align 8
  %.2110 = load double, ptr %scevgep54, align 8
  %.2111 = fmul double %.2055, %.2110
  %.2112 = fadd double %.1999, %.2111
  %.2166 = load double, ptr %sunkaddr134, align 8
  %.2221 = load double, ptr %scevgep53, align 8
  %.2222 = fmul double %.2166, %.2221
  %.2223 = fadd double %.2112, %.2222
  %.2277 = load double, ptr %33, align 8
  %.2332 = load double, ptr %scevgep52, align 8
  %.2333 = fmul double %.2277, %.2332
  %.2334 = fadd double %.2223, %.2333
  %scevgep37 = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv35
  %scevgep38 = getelementptr i8, ptr %scevgep37, i64 -16
  store double %.2334, ptr %scevgep38, align 8
  %.2442 = load double, ptr %51, align 8
  %scevgep44 = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv42
  %scevgep45 = getelementptr i8, ptr %scevgep44, i64 -16
  store double %.2442, ptr %scevgep45, align 8
  %scevgep62 = getelementptr i8, ptr %scevgep33, i64 -8
  %.1999.1 = load double, ptr %scevgep62, align 8
  %.2055.1 = load double, ptr %.2054.1, align 8
  %.2110.1 = load double, ptr %scevgep54, align 8
  %.2111.1 = fmul double %.2055.1, %.2110.1
  %.2112.1 = fadd double %.1999.1, %.2111.1
  %.2166.1 = load double, ptr %sunkaddr139, align 8
  %.2221.1 = load double, ptr %scevgep53, align 8
  %.2222.1 = fmul double %.2166.1, %.2221.1
  %.2223.1 = fadd double %.2112.1, %.2222.1
  %.2277.1 = load double, ptr %.2276.1, align 8
  %.2332.1 = load double, ptr %scevgep52, align 8
  %.2333.1 = fmul double %.2277.1, %.2332.1
  %.2334.1 = fadd double %.2223.1, %.2333.1
  %scevgep60 = getelementptr i8, ptr %scevgep37, i64 -8
  store double %.2334.1, ptr %scevgep60, align 8
  %.2441.1 = getelementptr i8, ptr %51, i64 8
  %.2442.1 = load double, ptr %.2441.1, align 8
  %scevgep58 = getelementptr i8, ptr %scevgep44, i64 -8
  store double %.2442.1, ptr %scevgep58, align 8
  %.1999.2 = load double, ptr %scevgep33, align 8
  %.2055.2 = load double, ptr %invariant.gep1178.2, align 8
  %.2110.2 = load double, ptr %scevgep54, align 8
  %.2111.2 = fmul double %.2055.2, %.2110.2
  %.2112.2 = fadd double %.1999.2, %.2111.2
  %.2166.2 = load double, ptr %sunkaddr145, align 8
  %.2221.2 = load double, ptr %scevgep53, align 8
  %.2222.2 = fmul double %.2166.2, %.2221.2
  %.2223.2 = fadd double %.2112.2, %.2222.2
  %.2277.2 = load double, ptr %.2276.2, align 8
  %.2332.2 = load double, ptr %scevgep52, align 8
  %.2333.2 = fmul double %.2277.2, %.2332.2
  %.2334.2 = fadd double %.2223.2, %.2333.2
  store double %.2334.2, ptr %scevgep37, align 8
  %.2441.2 = getelementptr i8, ptr %51, i64 16
  %.2442.2 = load double, ptr %.2441.2, align 8
  store double %.2442.2, ptr %scevgep44, align 8
  %.2651 = icmp slt i64 %.1723.1, 0
  %.2652 = select i1 %.2651, i64 %arg.room.5.1, i64 0
  %.2653 = add i64 %.2652, %.1723.1
  %.2673 = mul i64 %.2653, %arg.room.5.2
  %52 = getelementptr double, ptr %arg.room.4, i64 %.2673
  %.2706 = icmp slt i64 %.1765.1, 0
  %.2707 = select i1 %.2706, i64 %arg.room.5.1, i64 0
  %.2708 = add i64 %.2707, %.1765.1
  %.2728 = mul i64 %.2708, %arg.room.5.2
  %53 = getelementptr double, ptr %arg.room.4, i64 %.2728
  %.2678 = load double, ptr %52, align 8
  %.2733 = load double, ptr %53, align 8
  %.2737 = fmul double %.1621, %.2678
  %.2739 = fmul double %.1622, %.2733
  %.2740 = fadd double %.2737, %.2739
  %.2742 = fmul double %.1621, %.2733
  %.2744 = fmul double %.1622, %.2678
  %.2745 = fsub double %.2742, %.2744
  store double %.2740, ptr %52, align 8
  store double %.2745, ptr %53, align 8
  %.2677.1 = getelementptr i8, ptr %52, i64 8
  %.2678.1 = load double, ptr %.2677.1, align 8
  %.2732.1 = getelementptr i8, ptr %53, i64 8
  %.2733.1 = load double, ptr %.2732.1, align 8
  %.2737.1 = fmul double %.1621, %.2678.1
  %.2739.1 = fmul double %.1622, %.2733.1
  %.2740.1 = fadd double %.2737.1, %.2739.1
  %.2742.1 = fmul double %.1621, %.2733.1
  %.2744.1 = fmul double %.1622, %.2678.1
  %.2745.1 = fsub double %.2742.1, %.2744.1
  store double %.2740.1, ptr %.2677.1, align 8
  store double %.2745.1, ptr %.2732.1, align 8
  %.2677.2 = getelementptr i8, ptr %52, i64 16
  %.2678.2 = load double, ptr %.2677.2, align 8
  %.2732.2 = getelementptr i8, ptr %53, i64 16
  %.2733.2 = load double, ptr %.2732.2, align 8
  %.2737.2 = fmul double %.1621, %.2678.2
  %.2739.2 = fmul double %.1622, %.2733.2
  %.2740.2 = fadd double %.2737.2, %.2739.2
  %.2742.2 = fmul double %.1621, %.2733.2
  %.2744.2 = fmul double %.1622, %.2678.2
  %.2745.2 = fsub double %.2742.2, %.2744.2
  store double %.2740.2, ptr %.2677.2, align 8
  store double %.2745.2, ptr %.2732.2, align 8
  %lsr.iv.next = add i64 %lsr.iv, %38
  %lsr.iv.next36 = add i64 %lsr.iv35, %38
  %lsr.iv.next43 = add i64 %lsr.iv42, %38
  %scevgep51 = getelementptr i8, ptr %lsr.iv50, i64 %47
  %lsr.iv.next59 = add i64 %lsr.iv58, 1
  %lsr.iv.next61 = add nsw i64 %lsr.iv60, -1
  %exitcond1259.not = icmp eq i64 %lsr.iv.next61, 0
  br i1 %exitcond1259.not, label %common.ret, label %B652.endif.2, !llvm.loop !6
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.jacobians(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.chain.0, ptr readnone captures(none) %arg.chain.1, i64 %arg.chain.2, i64 %arg.chain.3, ptr readonly captures(none) %arg.chain.4, i64 %arg.chain.5.0, i64 %arg.chain.5.1, i64 %arg.chain.6.0, i64 %arg.chain.6.1, ptr readnone captures(none) %arg.X_WC.0, ptr readnone captures(none) %arg.X_WC.1, i64 %arg.X_WC.2, i64 %arg.X_WC.3, ptr readonly captures(none) %arg.X_WC.4, i64 %arg.X_WC.5.0, i64 %arg.X_WC.5.1, i64 %arg.X_WC.6.0, i64 %arg.X_WC.6.1, ptr readnone captures(none) %arg.ride.0, ptr readnone captures(none) %arg.ride.1, i64 %arg.ride.2, i64 %arg.ride.3, ptr readonly captures(none) %arg.ride.4, i64 %arg.ride.5.0, i64 %arg.ride.5.1, i64 %arg.ride.6.0, i64 %arg.ride.6.1, ptr readnone captures(none) %arg.X_6T.0, ptr readnone captures(none) %arg.X_6T.1, i64 %arg.X_6T.2, i64 %arg.X_6T.3, ptr readonly captures(none) %arg.X_6T.4, i64 %arg.X_6T.5.0, i64 %arg.X_6T.5.1, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr readnone captures(none) %arg.room.0, ptr readnone captures(none) %arg.room.1, i64 %arg.room.2, i64 %arg.room.3, ptr %arg.room.4, i64 %arg.room.5.0, i64 %arg.room.5.1, i64 %arg.room.5.2, i64 %arg.room.6.0, i64 %arg.room.6.1, i64 %arg.room.6.2, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.5.1, i64 %arg.q.6.0, i64 %arg.q.6.1, ptr readnone captures(none) %arg.J.0, ptr readnone captures(none) %arg.J.1, i64 %arg.J.2, i64 %arg.J.3, ptr captures(none) %arg.J.4, i64 %arg.J.5.0, i64 %arg.J.5.1, i64 %arg.J.5.2, i64 %arg.J.6.0, i64 %arg.J.6.1, i64 %arg.J.6.2) local_unnamed_addr #0 {
B0.endif:
  %.171 = add nsw i64 %arg.q.5.1, -6
  %.269444.not = icmp slt i64 %arg.q.5.0, 1
  br i1 %.269444.not, label %B326, label %B94.lr.ph

B94.lr.ph:                                        ; preds = %B0.endif
  %.488 = mul i64 %arg.J.5.2, %arg.J.5.1
  %.614 = icmp slt i64 %arg.q.5.1, 7
  %..171 = select i1 %.614, i64 0, i64 %.171
  %gep409.us.idx = mul i64 %arg.J.5.2, 24
  %gep409.us.1.idx = shl i64 %arg.J.5.2, 5
  %.861.us.2 = shl i64 %arg.ride.6.1, 1
  %gep.us.2.idx = shl i64 %arg.J.5.2, 4
  %gep409.us.2.idx = mul i64 %arg.J.5.2, 40
  %0 = add i64 %..171, -1
  %scevgep = getelementptr i8, ptr %arg.ride.4, i64 %arg.ride.6.1
  %scevgep12 = getelementptr i8, ptr %arg.ride.4, i64 %.861.us.2
  %1 = add nsw i64 %arg.q.5.0, -1
  %2 = mul i64 %.488, %1
  %3 = shl i64 %..171, 3
  %4 = add i64 %2, %..171
  %5 = shl i64 %4, 3
  %scevgep14 = getelementptr i8, ptr %arg.J.4, i64 %5
  %6 = shl i64 %.488, 3
  %scevgep15 = getelementptr i8, ptr %arg.J.4, i64 %gep409.us.idx
  %7 = shl i64 %1, 3
  %8 = mul i64 %7, %arg.J.5.1
  %9 = add i64 %8, 24
  %10 = mul i64 %9, %arg.J.5.2
  %11 = getelementptr i8, ptr %arg.J.4, i64 %10
  %scevgep16 = getelementptr i8, ptr %11, i64 %3
  %12 = shl i64 %arg.J.5.2, 3
  %scevgep17 = getelementptr i8, ptr %arg.J.4, i64 %12
  %13 = add i64 %8, 8
  %14 = mul i64 %13, %arg.J.5.2
  %15 = getelementptr i8, ptr %arg.J.4, i64 %14
  %scevgep18 = getelementptr i8, ptr %15, i64 %3
  %scevgep19 = getelementptr i8, ptr %arg.J.4, i64 %gep409.us.1.idx
  %16 = add i64 %8, 32
  %17 = mul i64 %16, %arg.J.5.2
  %18 = getelementptr i8, ptr %arg.J.4, i64 %17
  %scevgep20 = getelementptr i8, ptr %18, i64 %3
  %scevgep21 = getelementptr i8, ptr %arg.J.4, i64 %gep.us.2.idx
  %19 = add i64 %8, 16
  %20 = mul i64 %19, %arg.J.5.2
  %21 = getelementptr i8, ptr %arg.J.4, i64 %20
  %scevgep22 = getelementptr i8, ptr %21, i64 %3
  %scevgep23 = getelementptr i8, ptr %arg.J.4, i64 %gep409.us.2.idx
  %22 = add i64 %8, 40
  %23 = mul i64 %22, %arg.J.5.2
  %24 = getelementptr i8, ptr %arg.J.4, i64 %23
  %scevgep24 = getelementptr i8, ptr %24, i64 %3
  %25 = getelementptr i8, ptr %arg.ride.4, i64 %..171
  %scevgep25 = getelementptr i8, ptr %25, i64 7
  %26 = getelementptr i8, ptr %25, i64 %arg.ride.6.1
  %scevgep27 = getelementptr i8, ptr %26, i64 7
  %27 = getelementptr i8, ptr %25, i64 %.861.us.2
  %scevgep29 = getelementptr i8, ptr %27, i64 7
  %ident.check = icmp ne i64 %arg.ride.6.0, 1
  %28 = getelementptr i8, ptr %arg.ride.4, i64 %0
  %29 = icmp ult ptr %28, %arg.ride.4
  %30 = getelementptr i8, ptr %scevgep, i64 %0
  %31 = icmp ult ptr %30, %scevgep
  %32 = getelementptr i8, ptr %scevgep12, i64 %0
  %33 = icmp ult ptr %32, %scevgep12
  %34 = or i1 %ident.check, %29
  %35 = or i1 %31, %34
  %36 = or i1 %33, %35
  %bound0 = icmp ult ptr %arg.J.4, %scevgep16
  %bound1 = icmp ult ptr %scevgep15, %scevgep14
  %found.conflict = and i1 %bound0, %bound1
  %bound031 = icmp ult ptr %arg.J.4, %scevgep18
  %bound132 = icmp ult ptr %scevgep17, %scevgep14
  %found.conflict33 = and i1 %bound031, %bound132
  %stride.check34 = icmp slt i64 %6, 0
  %37 = or i1 %found.conflict33, %found.conflict
  %bound036 = icmp ult ptr %arg.J.4, %scevgep20
  %bound137 = icmp ult ptr %scevgep19, %scevgep14
  %found.conflict38 = and i1 %bound036, %bound137
  %38 = or i1 %found.conflict38, %37
  %bound042 = icmp ult ptr %arg.J.4, %scevgep22
  %bound143 = icmp ult ptr %scevgep21, %scevgep14
  %found.conflict44 = and i1 %bound042, %bound143
  %39 = or i1 %found.conflict44, %38
  %bound048 = icmp ult ptr %arg.J.4, %scevgep24
  %bound149 = icmp ult ptr %scevgep23, %scevgep14
  %found.conflict50 = and i1 %bound048, %bound149
  %40 = or i1 %found.conflict50, %39
  %bound054 = icmp ult ptr %arg.J.4, %scevgep25
  %bound155 = icmp ult ptr %arg.ride.4, %scevgep14
  %found.conflict56 = and i1 %bound054, %bound155
  %41 = or i1 %found.conflict56, %40
  %bound059 = icmp ult ptr %arg.J.4, %scevgep27
  %bound160 = icmp ult ptr %scevgep, %scevgep14
  %found.conflict61 = and i1 %bound059, %bound160
  %42 = or i1 %found.conflict61, %41
  %bound064 = icmp ult ptr %arg.J.4, %scevgep29
  %bound165 = icmp ult ptr %scevgep12, %scevgep14
  %found.conflict66 = and i1 %bound064, %bound165
  %43 = or i1 %found.conflict66, %42
  %bound069 = icmp ult ptr %scevgep15, %scevgep18
  %bound170 = icmp ult ptr %scevgep17, %scevgep16
  %found.conflict71 = and i1 %bound069, %bound170
  %44 = or i1 %found.conflict71, %43
  %bound075 = icmp ult ptr %scevgep15, %scevgep20
  %bound176 = icmp ult ptr %scevgep19, %scevgep16
  %found.conflict77 = and i1 %bound075, %bound176
  %45 = or i1 %found.conflict77, %44
  %bound081 = icmp ult ptr %scevgep15, %scevgep22
  %bound182 = icmp ult ptr %scevgep21, %scevgep16
  %found.conflict83 = and i1 %bound081, %bound182
  %46 = or i1 %45, %found.conflict83
  %bound087 = icmp ult ptr %scevgep15, %scevgep24
  %bound188 = icmp ult ptr %scevgep23, %scevgep16
  %found.conflict89 = and i1 %bound087, %bound188
  %47 = or i1 %46, %found.conflict89
  %bound093 = icmp ult ptr %scevgep15, %scevgep25
  %bound194 = icmp ult ptr %arg.ride.4, %scevgep16
  %found.conflict95 = and i1 %bound093, %bound194
  %48 = or i1 %47, %found.conflict95
  %bound098 = icmp ult ptr %scevgep15, %scevgep27
  %bound199 = icmp ult ptr %scevgep, %scevgep16
  %found.conflict100 = and i1 %bound098, %bound199
  %49 = or i1 %48, %found.conflict100
  %bound0103 = icmp ult ptr %scevgep15, %scevgep29
  %bound1104 = icmp ult ptr %scevgep12, %scevgep16
  %found.conflict105 = and i1 %bound0103, %bound1104
  %50 = or i1 %49, %found.conflict105
  %bound0108 = icmp ult ptr %scevgep17, %scevgep20
  %bound1109 = icmp ult ptr %scevgep19, %scevgep18
  %found.conflict110 = and i1 %bound0108, %bound1109
  %51 = or i1 %50, %found.conflict110
  %bound0114 = icmp ult ptr %scevgep17, %scevgep22
  %bound1115 = icmp ult ptr %scevgep21, %scevgep18
  %found.conflict116 = and i1 %bound0114, %bound1115
  %52 = or i1 %51, %found.conflict116
  %bound0120 = icmp ult ptr %scevgep17, %scevgep24
  %bound1121 = icmp ult ptr %scevgep23, %scevgep18
  %found.conflict122 = and i1 %bound0120, %bound1121
  %53 = or i1 %52, %found.conflict122
  %bound0126 = icmp ult ptr %scevgep17, %scevgep25
  %bound1127 = icmp ult ptr %arg.ride.4, %scevgep18
  %found.conflict128 = and i1 %bound0126, %bound1127
  %54 = or i1 %53, %found.conflict128
  %bound0131 = icmp ult ptr %scevgep17, %scevgep27
  %bound1132 = icmp ult ptr %scevgep, %scevgep18
  %found.conflict133 = and i1 %bound0131, %bound1132
  %55 = or i1 %54, %found.conflict133
  %bound0136 = icmp ult ptr %scevgep17, %scevgep29
  %bound1137 = icmp ult ptr %scevgep12, %scevgep18
  %found.conflict138 = and i1 %bound0136, %bound1137
  %56 = or i1 %55, %found.conflict138
  %bound0141 = icmp ult ptr %scevgep19, %scevgep22
  %bound1142 = icmp ult ptr %scevgep21, %scevgep20
  %found.conflict143 = and i1 %bound0141, %bound1142
  %57 = or i1 %56, %found.conflict143
  %bound0147 = icmp ult ptr %scevgep19, %scevgep24
  %bound1148 = icmp ult ptr %scevgep23, %scevgep20
  %found.conflict149 = and i1 %bound0147, %bound1148
  %58 = or i1 %57, %found.conflict149
  %bound0153 = icmp ult ptr %scevgep19, %scevgep25
  %bound1154 = icmp ult ptr %arg.ride.4, %scevgep20
  %found.conflict155 = and i1 %bound0153, %bound1154
  %59 = or i1 %58, %found.conflict155
  %bound0158 = icmp ult ptr %scevgep19, %scevgep27
  %bound1159 = icmp ult ptr %scevgep, %scevgep20
  %found.conflict160 = and i1 %bound0158, %bound1159
  %60 = or i1 %59, %found.conflict160
  %conflict.rdx162 = or i1 %60, %stride.check34
  %bound0163 = icmp ult ptr %scevgep19, %scevgep29
  %bound1164 = icmp ult ptr %scevgep12, %scevgep20
  %found.conflict165 = and i1 %bound0163, %bound1164
  %conflict.rdx167 = or i1 %conflict.rdx162, %found.conflict165
  %bound0168 = icmp ult ptr %scevgep21, %scevgep24
  %bound1169 = icmp ult ptr %scevgep23, %scevgep22
  %found.conflict170 = and i1 %bound0168, %bound1169
  %conflict.rdx173 = or i1 %found.conflict170, %conflict.rdx167
  %bound0174 = icmp ult ptr %scevgep21, %scevgep25
  %bound1175 = icmp ult ptr %arg.ride.4, %scevgep22
  %found.conflict176 = and i1 %bound0174, %bound1175
  %conflict.rdx178 = or i1 %found.conflict176, %conflict.rdx173
  %bound0179 = icmp ult ptr %scevgep21, %scevgep27
  %bound1180 = icmp ult ptr %scevgep, %scevgep22
  %found.conflict181 = and i1 %bound0179, %bound1180
  %conflict.rdx183 = or i1 %found.conflict181, %conflict.rdx178
  %bound0184 = icmp ult ptr %scevgep21, %scevgep29
  %bound1185 = icmp ult ptr %scevgep12, %scevgep22
  %found.conflict186 = and i1 %bound0184, %bound1185
  %conflict.rdx188 = or i1 %found.conflict186, %conflict.rdx183
  %bound0189 = icmp ult ptr %scevgep23, %scevgep25
  %bound1190 = icmp ult ptr %arg.ride.4, %scevgep24
  %found.conflict191 = and i1 %bound0189, %bound1190
  %conflict.rdx193 = or i1 %found.conflict191, %conflict.rdx188
  %bound0194 = icmp ult ptr %scevgep23, %scevgep27
  %bound1195 = icmp ult ptr %scevgep, %scevgep24
  %found.conflict196 = and i1 %bound0194, %bound1195
  %conflict.rdx198 = or i1 %found.conflict196, %conflict.rdx193
  %bound0199 = icmp ult ptr %scevgep23, %scevgep29
  %bound1200 = icmp ult ptr %scevgep12, %scevgep24
  %found.conflict201 = and i1 %bound0199, %bound1200
  %conflict.rdx203 = or i1 %found.conflict201, %conflict.rdx198
  %n.vec = and i64 %..171, 9223372036854775806
  %scevgep210 = getelementptr i8, ptr %scevgep, i64 1
  %scevgep214 = getelementptr i8, ptr %scevgep12, i64 1
  %.168.i = mul i64 %arg.room.5.2, %arg.room.5.1
  %.348.idx.i = shl i64 %.168.i, 4
  %.348.i = getelementptr i8, ptr %arg.room.4, i64 %.348.idx.i
  %.622.i = mul i64 %arg.X_WC.6.1, 3
  %invariant.gep1184.i = getelementptr i8, ptr %arg.X_WC.4, i64 %.622.i
  %.7631173.i = icmp sgt i64 %..171, 0
  %invariant.gep1178.2.i = getelementptr i8, ptr %arg.room.4, i64 16
  %gep1179.1.2.i = getelementptr double, ptr %invariant.gep1178.2.i, i64 %arg.room.5.2
  %61 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  %.idx1169.i = shl i64 %arg.room.5.2, 4
  %62 = getelementptr i8, ptr %arg.room.4, i64 %.idx1169.i
  %.2054.1.i = getelementptr i8, ptr %arg.room.4, i64 8
  %.2165.1.i = getelementptr i8, ptr %61, i64 8
  %.2276.1.i = getelementptr i8, ptr %62, i64 8
  %.2165.2.i = getelementptr i8, ptr %61, i64 16
  %.2276.2.i = getelementptr i8, ptr %62, i64 16
  %.1431.peel.i = getelementptr i8, ptr %arg.chain.4, i64 8
  %.1449.peel.i = icmp slt i64 %arg.q.5.1, 6
  %.1450.peel.i = select i1 %.1449.peel.i, i64 %arg.q.5.1, i64 0
  %.1451.peel.i = add i64 %.1450.peel.i, %.171
  %.1462.peel.i = mul i64 %.1451.peel.i, %arg.q.6.1
  %.1521.peel.i = getelementptr i8, ptr %arg.chain.4, i64 16
  %.1577.peel.i = getelementptr i8, ptr %arg.chain.4, i64 48
  %.2109.peel.i = getelementptr i8, ptr %arg.chain.4, i64 24
  %.2220.peel.i = getelementptr i8, ptr %arg.chain.4, i64 32
  %.2331.peel.i = getelementptr i8, ptr %arg.chain.4, i64 40
  %sunkaddr101.i = shl i64 %.168.i, 3
  %sunkaddr102.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr101.i
  %sunkaddr130.i = getelementptr i8, ptr %.348.i, i64 8
  %sunkaddr107.i = getelementptr i8, ptr %sunkaddr102.i, i64 8
  %sunkaddr132.i = getelementptr i8, ptr %.348.i, i64 16
  %sunkaddr112.i = getelementptr i8, ptr %sunkaddr102.i, i64 16
  %63 = add i64 %.348.idx.i, 16
  %64 = shl i64 %arg.room.5.2, 3
  %65 = shl i64 %arg.room.5.1, 4
  %66 = or disjoint i64 %65, 8
  %67 = mul i64 %66, %arg.room.5.2
  %68 = add i64 %67, 16
  %69 = shl i64 %arg.room.5.1, 3
  %70 = add i64 %69, 8
  %71 = mul i64 %70, %arg.room.5.2
  %72 = add i64 %71, 16
  %73 = shl i64 %arg.chain.5.1, 3
  %74 = getelementptr i8, ptr %arg.chain.4, i64 %73
  %scevgep49.i = getelementptr i8, ptr %74, i64 48
  %75 = add i64 %arg.q.5.1, -5
  %sunkaddr134.i = getelementptr i8, ptr %arg.room.4, i64 %64
  %sunkaddr139.i = getelementptr i8, ptr %sunkaddr134.i, i64 8
  %sunkaddr145.i = getelementptr i8, ptr %sunkaddr134.i, i64 16
  %.idx.i = mul i64 %arg.room.5.2, 40
  %76 = getelementptr i8, ptr %.348.i, i64 %.idx.i
  %.3175.i = mul i64 %arg.X_6T.6.1, 3
  %.3178.i = getelementptr i8, ptr %arg.X_6T.4, i64 %.3175.i
  %77 = getelementptr i8, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0
  %.3288.i = getelementptr i8, ptr %77, i64 %.3175.i
  %.3394.i = shl i64 %arg.X_6T.6.0, 1
  %78 = getelementptr i8, ptr %arg.X_6T.4, i64 %.3394.i
  %.3398.i = getelementptr i8, ptr %78, i64 %.3175.i
  %.idx1168.i = mul i64 %arg.room.5.2, 48
  %79 = getelementptr i8, ptr %.348.i, i64 %.idx1168.i
  %.3071.1.i = getelementptr i8, ptr %76, i64 8
  %.3455.1.i = getelementptr i8, ptr %79, i64 8
  %.3071.2.i = getelementptr i8, ptr %76, i64 16
  %.3455.2.i = getelementptr i8, ptr %79, i64 16
  %.121.i = getelementptr double, ptr %arg.room.4, i64 %.168.i
  %80 = shl i64 %.171, 3
  %81 = add i64 %arg.J.5.2, %.171
  %82 = shl i64 %81, 3
  %.1168.1.i = getelementptr i8, ptr %arg.X_WC.4, i64 %arg.X_WC.6.1
  %.1165.2.i = shl i64 %arg.X_WC.6.1, 1
  %.1168.2.i = getelementptr i8, ptr %arg.X_WC.4, i64 %.1165.2.i
  %.1220.2.i = shl i64 %arg.room.5.2, 1
  %gep1179.2.i = getelementptr double, ptr %arg.room.4, i64 %.1220.2.i
  %gep1185.1.i = getelementptr i8, ptr %invariant.gep1184.i, i64 %arg.X_WC.6.0
  %83 = getelementptr i8, ptr %arg.X_WC.4, i64 %arg.X_WC.6.0
  %.1168.1.1.i = getelementptr i8, ptr %83, i64 %arg.X_WC.6.1
  %gep1179.1.1.i = getelementptr double, ptr %.2054.1.i, i64 %arg.room.5.2
  %.1168.2.1.i = getelementptr i8, ptr %83, i64 %.1165.2.i
  %gep1179.2.1.i = getelementptr double, ptr %.2054.1.i, i64 %.1220.2.i
  %.621.2.i = shl i64 %arg.X_WC.6.0, 1
  %gep1185.2.i = getelementptr i8, ptr %invariant.gep1184.i, i64 %.621.2.i
  %84 = icmp eq i64 %..171, 1
  %85 = shl i64 %arg.ride.6.0, 1
  %86 = shl i64 %arg.q.6.1, 1
  %87 = add nsw i64 %..171, -2
  %88 = lshr i64 %87, 1
  %89 = icmp eq i64 %88, 0
  %90 = add nuw nsw i64 %88, 1
  %unroll_iter12.i = and i64 %90, 9223372036854775806
  %91 = and i64 %87, 2
  %lcmp.mod.not55.not.i = icmp eq i64 %91, 0
  %92 = and i64 %..171, 1
  %lcmp.mod.not.i = icmp eq i64 %92, 0
  %.902.us.epil.i = mul i64 %n.vec, %arg.ride.6.0
  %gep.us.epil.i = getelementptr i8, ptr %arg.ride.4, i64 %.902.us.epil.i
  %.937.us.epil.i = mul i64 %n.vec, %arg.q.6.1
  %gep.us.1.epil.i = getelementptr i8, ptr %scevgep, i64 %.902.us.epil.i
  %gep.us.2.epil.i = getelementptr i8, ptr %scevgep12, i64 %.902.us.epil.i
  %93 = icmp samesign ult i64 %..171, 82
  %brmerge = select i1 %93, i1 true, i1 %36
  %brmerge205 = select i1 %brmerge, i1 true, i1 %conflict.rdx203
  %94 = icmp eq i64 %..171, %n.vec
  %95 = getelementptr i8, ptr %arg.X_WC.4, i64 %.621.2.i
  %.1168.1.2.i = getelementptr i8, ptr %95, i64 %arg.X_WC.6.1
  %.1168.2.2.i = getelementptr i8, ptr %95, i64 %.1165.2.i
  %gep1179.2.2.i = getelementptr double, ptr %invariant.gep1178.2.i, i64 %.1220.2.i
  br label %B94

B92.loopexit:                                     ; preds = %B228.endif.endif.us, %middle.block, %part.2
  %scevgep219 = getelementptr i8, ptr %lsr.iv, i64 %6
  %scevgep223 = getelementptr i8, ptr %lsr.iv222, i64 %6
  %scevgep227 = getelementptr i8, ptr %lsr.iv226, i64 %6
  %scevgep231 = getelementptr i8, ptr %lsr.iv230, i64 %6
  %scevgep235 = getelementptr i8, ptr %lsr.iv234, i64 %6
  %scevgep238 = getelementptr i8, ptr %lsr.iv237, i64 %6
  %exitcond467.not = icmp eq i64 %.282, %arg.q.5.0
  br i1 %exitcond467.not, label %B326, label %B94

B94:                                              ; preds = %B92.loopexit, %B94.lr.ph
  %lsr.iv237 = phi ptr [ %arg.J.4, %B94.lr.ph ], [ %scevgep238, %B92.loopexit ]
  %lsr.iv234 = phi ptr [ %scevgep15, %B94.lr.ph ], [ %scevgep235, %B92.loopexit ]
  %lsr.iv230 = phi ptr [ %scevgep17, %B94.lr.ph ], [ %scevgep231, %B92.loopexit ]
  %lsr.iv226 = phi ptr [ %scevgep19, %B94.lr.ph ], [ %scevgep227, %B92.loopexit ]
  %lsr.iv222 = phi ptr [ %scevgep21, %B94.lr.ph ], [ %scevgep223, %B92.loopexit ]
  %lsr.iv = phi ptr [ %scevgep23, %B94.lr.ph ], [ %scevgep219, %B92.loopexit ]
  %.275428449 = phi i64 [ 0, %B94.lr.ph ], [ %.282, %B92.loopexit ]
  %.282 = add nuw nsw i64 %.275428449, 1
  %.348 = mul i64 %.275428449, %arg.q.6.0
  %.350 = getelementptr i8, ptr %arg.q.4, i64 %.348
  %.627.us.i = load double, ptr %invariant.gep1184.i, align 8, !noalias !7
  store double %.627.us.i, ptr %.348.i, align 8, !noalias !7
  br i1 %.7631173.i, label %B184.us.preheader.i, label %B120.endif.preheader.i

B184.us.preheader.i:                              ; preds = %B94
  br i1 %84, label %B184.us.epil.preheader.i, label %B184.us.preheader.new.i

B184.us.preheader.new.i:                          ; preds = %B184.us.preheader.i
  br i1 %89, label %B184.us.epil.preheader3.i, label %B184.us.i

B120.endif.preheader.i:                           ; preds = %B94
  %.1170.i = load double, ptr %arg.X_WC.4, align 8, !noalias !7
  store double %.1170.i, ptr %arg.room.4, align 8, !noalias !7
  %.1170.1.i = load double, ptr %.1168.1.i, align 8, !noalias !7
  store double %.1170.1.i, ptr %61, align 8, !noalias !7
  %.1170.2.i = load double, ptr %.1168.2.i, align 8, !noalias !7
  store double %.1170.2.i, ptr %gep1179.2.i, align 8, !noalias !7
  %.627.1.i = load double, ptr %gep1185.1.i, align 8, !noalias !7
  store double %.627.1.i, ptr %sunkaddr130.i, align 8, !noalias !7
  %.1170.11251.i = load double, ptr %83, align 8, !noalias !7
  store double %.1170.11251.i, ptr %.2054.1.i, align 8, !noalias !7
  %.1170.1.1.i = load double, ptr %.1168.1.1.i, align 8, !noalias !7
  store double %.1170.1.1.i, ptr %gep1179.1.1.i, align 8, !noalias !7
  %.1170.2.1.i = load double, ptr %.1168.2.1.i, align 8, !noalias !7
  store double %.1170.2.1.i, ptr %gep1179.2.1.i, align 8, !noalias !7
  %.627.2.i = load double, ptr %gep1185.2.i, align 8, !noalias !7
  br label %B652.endif.2.peel.next.i.sink.split

B184.us.1.i:                                      ; preds = %B182.B258.endif.endif_crit_edge.us.new.i, %B184.us.1.i
  %lsr.iv81.i = phi i64 [ %lsr.iv.next82.i, %B184.us.1.i ], [ %unroll_iter12.i, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %lsr.iv71.i = phi ptr [ %scevgep88.i, %B184.us.1.i ], [ %.350, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %lsr.iv68.i = phi ptr [ %scevgep85.i, %B184.us.1.i ], [ %scevgep, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %.9431177.us.1.i = phi double [ %.943.us.1.1.1.i, %B184.us.1.i ], [ %.627.us.1.i, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %.908.us.1.i = load double, ptr %lsr.iv68.i, align 8, !noalias !7
  %.941.us.1.i = load double, ptr %lsr.iv71.i, align 8, !noalias !7
  %.942.us.1.i = fmul double %.908.us.1.i, %.941.us.1.i
  %.943.us.1.i = fadd double %.9431177.us.1.i, %.942.us.1.i
  store double %.943.us.1.i, ptr %sunkaddr130.i, align 8, !noalias !7
  %scevgep70.i = getelementptr i8, ptr %lsr.iv68.i, i64 %arg.ride.6.0
  %.908.us.1.1.i = load double, ptr %scevgep70.i, align 8, !noalias !7
  %scevgep73.i = getelementptr i8, ptr %lsr.iv71.i, i64 %arg.q.6.1
  %.941.us.1.1.i = load double, ptr %scevgep73.i, align 8, !noalias !7
  %.942.us.1.1.i = fmul double %.908.us.1.1.i, %.941.us.1.1.i
  %.943.us.1.1.i = fadd double %.943.us.1.i, %.942.us.1.1.i
  store double %.943.us.1.1.i, ptr %sunkaddr130.i, align 8, !noalias !7
  %scevgep83.i = getelementptr i8, ptr %scevgep70.i, i64 %arg.ride.6.0
  %.908.us.1.134.i = load double, ptr %scevgep83.i, align 8, !noalias !7
  %scevgep86.i = getelementptr i8, ptr %scevgep73.i, i64 %arg.q.6.1
  %.941.us.1.135.i = load double, ptr %scevgep86.i, align 8, !noalias !7
  %.942.us.1.136.i = fmul double %.908.us.1.134.i, %.941.us.1.135.i
  %.943.us.1.137.i = fadd double %.943.us.1.1.i, %.942.us.1.136.i
  store double %.943.us.1.137.i, ptr %sunkaddr130.i, align 8, !noalias !7
  %scevgep84.i = getelementptr i8, ptr %scevgep83.i, i64 %arg.ride.6.0
  %.908.us.1.1.1.i = load double, ptr %scevgep84.i, align 8, !noalias !7
  %scevgep87.i = getelementptr i8, ptr %scevgep86.i, i64 %arg.q.6.1
  %.941.us.1.1.1.i = load double, ptr %scevgep87.i, align 8, !noalias !7
  %.942.us.1.1.1.i = fmul double %.908.us.1.1.1.i, %.941.us.1.1.1.i
  %.943.us.1.1.1.i = fadd double %.943.us.1.137.i, %.942.us.1.1.1.i
  store double %.943.us.1.1.1.i, ptr %sunkaddr130.i, align 8, !noalias !7
  %lsr.iv.next82.i = add i64 %lsr.iv81.i, -2
  %niter33.ncmp.1.i = icmp eq i64 %lsr.iv.next82.i, 0
  %scevgep85.i = getelementptr i8, ptr %scevgep84.i, i64 %arg.ride.6.0
  %scevgep88.i = getelementptr i8, ptr %scevgep87.i, i64 %arg.q.6.1
  br i1 %niter33.ncmp.1.i, label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i, label %B184.us.1.i

B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i: ; preds = %B184.us.1.i
  %scevgep72.i = getelementptr i8, ptr %lsr.iv71.i, i64 %86
  %scevgep72.1.i = getelementptr i8, ptr %scevgep72.i, i64 %86
  %scevgep69.i = getelementptr i8, ptr %lsr.iv68.i, i64 %85
  %scevgep69.1.i = getelementptr i8, ptr %scevgep69.i, i64 %85
  br i1 %lcmp.mod.not55.not.i, label %B184.us.1.epil.preheader21.i, label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i

B184.us.1.epil.preheader21.i:                     ; preds = %B182.B258.endif.endif_crit_edge.us.new.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i
  %lsr.iv71.epil.init.i = phi ptr [ %.350, %B182.B258.endif.endif_crit_edge.us.new.i ], [ %scevgep72.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ]
  %lsr.iv68.epil.init.i = phi ptr [ %scevgep, %B182.B258.endif.endif_crit_edge.us.new.i ], [ %scevgep69.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ]
  %.9431177.us.1.epil.init27.i = phi double [ %.627.us.1.i, %B182.B258.endif.endif_crit_edge.us.new.i ], [ %.943.us.1.1.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ]
  %.908.us.1.epil23.i = load double, ptr %lsr.iv68.epil.init.i, align 8, !noalias !7
  %.941.us.1.epil24.i = load double, ptr %lsr.iv71.epil.init.i, align 8, !noalias !7
  %.942.us.1.epil25.i = fmul double %.908.us.1.epil23.i, %.941.us.1.epil24.i
  %.943.us.1.epil26.i = fadd double %.9431177.us.1.epil.init27.i, %.942.us.1.epil25.i
  store double %.943.us.1.epil26.i, ptr %sunkaddr130.i, align 8, !noalias !7
  %scevgep70.epil.i = getelementptr i8, ptr %lsr.iv68.epil.init.i, i64 %arg.ride.6.0
  %.908.us.1.1.epil.i = load double, ptr %scevgep70.epil.i, align 8, !noalias !7
  %scevgep73.epil.i = getelementptr i8, ptr %lsr.iv71.epil.init.i, i64 %arg.q.6.1
  %.941.us.1.1.epil.i = load double, ptr %scevgep73.epil.i, align 8, !noalias !7
  %.942.us.1.1.epil.i = fmul double %.908.us.1.1.epil.i, %.941.us.1.1.epil.i
  %.943.us.1.1.epil.i = fadd double %.943.us.1.epil26.i, %.942.us.1.1.epil.i
  store double %.943.us.1.1.epil.i, ptr %sunkaddr130.i, align 8, !noalias !7
  br label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i

B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i: ; preds = %B184.us.1.epil.preheader21.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i
  %.943.us.1.1.lcssa.i = phi double [ %.943.us.1.1.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ], [ %.943.us.1.1.epil.i, %B184.us.1.epil.preheader21.i ]
  br i1 %lcmp.mod.not.i, label %B182.B258.endif.endif_crit_edge.us.1.i, label %B184.us.1.epil.preheader.i

B184.us.1.epil.preheader.i:                       ; preds = %B182.B258.endif.endif_crit_edge.us.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i
  %.9431177.us.1.epil.init.i = phi double [ %.627.us.1.i, %B182.B258.endif.endif_crit_edge.us.i ], [ %.943.us.1.1.lcssa.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i ]
  %.908.us.1.epil.i = load double, ptr %gep.us.1.epil.i, align 8, !noalias !7
  %.939.us.1.epil.i = getelementptr i8, ptr %.350, i64 %.937.us.epil.i
  %.941.us.1.epil.i = load double, ptr %.939.us.1.epil.i, align 8, !noalias !7
  %.942.us.1.epil.i = fmul double %.908.us.1.epil.i, %.941.us.1.epil.i
  %.943.us.1.epil.i = fadd double %.9431177.us.1.epil.init.i, %.942.us.1.epil.i
  store double %.943.us.1.epil.i, ptr %sunkaddr130.i, align 8, !noalias !7
  br label %B182.B258.endif.endif_crit_edge.us.1.i

B182.B258.endif.endif_crit_edge.us.1.i:           ; preds = %B184.us.1.epil.preheader.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i
  %.1170.us.11255.i = load double, ptr %83, align 8, !noalias !7
  store double %.1170.us.11255.i, ptr %.2054.1.i, align 8, !noalias !7
  %.1170.us.1.1.i = load double, ptr %.1168.1.1.i, align 8, !noalias !7
  store double %.1170.us.1.1.i, ptr %gep1179.1.1.i, align 8, !noalias !7
  %.1170.us.2.1.i = load double, ptr %.1168.2.1.i, align 8, !noalias !7
  store double %.1170.us.2.1.i, ptr %gep1179.2.1.i, align 8, !noalias !7
  %.627.us.2.i = load double, ptr %gep1185.2.i, align 8, !noalias !7
  store double %.627.us.2.i, ptr %sunkaddr132.i, align 8, !noalias !7
  br i1 %84, label %B184.us.2.epil.preheader.i, label %B182.B258.endif.endif_crit_edge.us.1.new.i

B182.B258.endif.endif_crit_edge.us.1.new.i:       ; preds = %B182.B258.endif.endif_crit_edge.us.1.i
  br i1 %89, label %B184.us.2.epil.preheader38.i, label %B184.us.2.i

B184.us.2.i:                                      ; preds = %B182.B258.endif.endif_crit_edge.us.1.new.i, %B184.us.2.i
  %lsr.iv63.i = phi i64 [ %lsr.iv.next64.i, %B184.us.2.i ], [ %unroll_iter12.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %lsr.iv65.i = phi ptr [ %scevgep80.i, %B184.us.2.i ], [ %.350, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %lsr.iv62.i = phi ptr [ %scevgep71.i, %B184.us.2.i ], [ %scevgep12, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %.9431177.us.2.i = phi double [ %.943.us.2.1.1.i, %B184.us.2.i ], [ %.627.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %.908.us.2.i = load double, ptr %lsr.iv62.i, align 8, !noalias !7
  %.941.us.2.i = load double, ptr %lsr.iv65.i, align 8, !noalias !7
  %.942.us.2.i = fmul double %.908.us.2.i, %.941.us.2.i
  %.943.us.2.i = fadd double %.9431177.us.2.i, %.942.us.2.i
  store double %.943.us.2.i, ptr %sunkaddr132.i, align 8, !noalias !7
  %scevgep64.i = getelementptr i8, ptr %lsr.iv62.i, i64 %arg.ride.6.0
  %.908.us.2.1.i = load double, ptr %scevgep64.i, align 8, !noalias !7
  %scevgep67.i = getelementptr i8, ptr %lsr.iv65.i, i64 %arg.q.6.1
  %.941.us.2.1.i = load double, ptr %scevgep67.i, align 8, !noalias !7
  %.942.us.2.1.i = fmul double %.908.us.2.1.i, %.941.us.2.1.i
  %.943.us.2.1.i = fadd double %.943.us.2.i, %.942.us.2.1.i
  store double %.943.us.2.1.i, ptr %sunkaddr132.i, align 8, !noalias !7
  %scevgep65.i = getelementptr i8, ptr %scevgep64.i, i64 %arg.ride.6.0
  %.908.us.2.151.i = load double, ptr %scevgep65.i, align 8, !noalias !7
  %scevgep74.i = getelementptr i8, ptr %scevgep67.i, i64 %arg.q.6.1
  %.941.us.2.152.i = load double, ptr %scevgep74.i, align 8, !noalias !7
  %.942.us.2.153.i = fmul double %.908.us.2.151.i, %.941.us.2.152.i
  %.943.us.2.154.i = fadd double %.943.us.2.1.i, %.942.us.2.153.i
  store double %.943.us.2.154.i, ptr %sunkaddr132.i, align 8, !noalias !7
  %scevgep68.i = getelementptr i8, ptr %scevgep65.i, i64 %arg.ride.6.0
  %.908.us.2.1.1.i = load double, ptr %scevgep68.i, align 8, !noalias !7
  %scevgep77.i = getelementptr i8, ptr %scevgep74.i, i64 %arg.q.6.1
  %.941.us.2.1.1.i = load double, ptr %scevgep77.i, align 8, !noalias !7
  %.942.us.2.1.1.i = fmul double %.908.us.2.1.1.i, %.941.us.2.1.1.i
  %.943.us.2.1.1.i = fadd double %.943.us.2.154.i, %.942.us.2.1.1.i
  store double %.943.us.2.1.1.i, ptr %sunkaddr132.i, align 8, !noalias !7
  %lsr.iv.next64.i = add i64 %lsr.iv63.i, -2
  %niter50.ncmp.1.i = icmp eq i64 %lsr.iv.next64.i, 0
  %scevgep71.i = getelementptr i8, ptr %scevgep68.i, i64 %arg.ride.6.0
  %scevgep80.i = getelementptr i8, ptr %scevgep77.i, i64 %arg.q.6.1
  br i1 %niter50.ncmp.1.i, label %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i, label %B184.us.2.i

B184.us.i:                                        ; preds = %B184.us.preheader.new.i, %B184.us.i
  %lsr.iv89.i = phi i64 [ %lsr.iv.next90.i, %B184.us.i ], [ %unroll_iter12.i, %B184.us.preheader.new.i ]
  %lsr.iv77.i = phi ptr [ %scevgep96.i, %B184.us.i ], [ %.350, %B184.us.preheader.new.i ]
  %lsr.iv74.i = phi ptr [ %scevgep93.i, %B184.us.i ], [ %arg.ride.4, %B184.us.preheader.new.i ]
  %.9431177.us.i = phi double [ %.943.us.119.1.i, %B184.us.i ], [ %.627.us.i, %B184.us.preheader.new.i ]
  %.908.us.i = load double, ptr %lsr.iv74.i, align 8, !noalias !7
  %.941.us.i = load double, ptr %lsr.iv77.i, align 8, !noalias !7
  %.942.us.i = fmul double %.908.us.i, %.941.us.i
  %.943.us.i = fadd double %.9431177.us.i, %.942.us.i
  store double %.943.us.i, ptr %.348.i, align 8, !noalias !7
  %scevgep76.i = getelementptr i8, ptr %lsr.iv74.i, i64 %arg.ride.6.0
  %.908.us.114.i = load double, ptr %scevgep76.i, align 8, !noalias !7
  %scevgep79.i = getelementptr i8, ptr %lsr.iv77.i, i64 %arg.q.6.1
  %.941.us.117.i = load double, ptr %scevgep79.i, align 8, !noalias !7
  %.942.us.118.i = fmul double %.908.us.114.i, %.941.us.117.i
  %.943.us.119.i = fadd double %.943.us.i, %.942.us.118.i
  store double %.943.us.119.i, ptr %.348.i, align 8, !noalias !7
  %scevgep91.i = getelementptr i8, ptr %scevgep76.i, i64 %arg.ride.6.0
  %.908.us.115.i = load double, ptr %scevgep91.i, align 8, !noalias !7
  %scevgep94.i = getelementptr i8, ptr %scevgep79.i, i64 %arg.q.6.1
  %.941.us.116.i = load double, ptr %scevgep94.i, align 8, !noalias !7
  %.942.us.117.i = fmul double %.908.us.115.i, %.941.us.116.i
  %.943.us.118.i = fadd double %.943.us.119.i, %.942.us.117.i
  store double %.943.us.118.i, ptr %.348.i, align 8, !noalias !7
  %scevgep92.i = getelementptr i8, ptr %scevgep91.i, i64 %arg.ride.6.0
  %.908.us.114.1.i = load double, ptr %scevgep92.i, align 8, !noalias !7
  %scevgep95.i = getelementptr i8, ptr %scevgep94.i, i64 %arg.q.6.1
  %.941.us.117.1.i = load double, ptr %scevgep95.i, align 8, !noalias !7
  %.942.us.118.1.i = fmul double %.908.us.114.1.i, %.941.us.117.1.i
  %.943.us.119.1.i = fadd double %.943.us.118.i, %.942.us.118.1.i
  store double %.943.us.119.1.i, ptr %.348.i, align 8, !noalias !7
  %lsr.iv.next90.i = add i64 %lsr.iv89.i, -2
  %niter.ncmp.119.i = icmp eq i64 %lsr.iv.next90.i, 0
  %scevgep93.i = getelementptr i8, ptr %scevgep92.i, i64 %arg.ride.6.0
  %scevgep96.i = getelementptr i8, ptr %scevgep95.i, i64 %arg.q.6.1
  br i1 %niter.ncmp.119.i, label %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i, label %B184.us.i

B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i: ; preds = %B184.us.i
  %scevgep78.i = getelementptr i8, ptr %lsr.iv77.i, i64 %86
  %scevgep78.1.i = getelementptr i8, ptr %scevgep78.i, i64 %86
  %scevgep75.i = getelementptr i8, ptr %lsr.iv74.i, i64 %85
  %scevgep75.1.i = getelementptr i8, ptr %scevgep75.i, i64 %85
  br i1 %lcmp.mod.not55.not.i, label %B184.us.epil.preheader3.i, label %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i

B184.us.epil.preheader3.i:                        ; preds = %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i, %B184.us.preheader.new.i
  %lsr.iv77.epil.init.i = phi ptr [ %.350, %B184.us.preheader.new.i ], [ %scevgep78.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ]
  %lsr.iv74.epil.init.i = phi ptr [ %arg.ride.4, %B184.us.preheader.new.i ], [ %scevgep75.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ]
  %.9431177.us.epil.init8.i = phi double [ %.627.us.i, %B184.us.preheader.new.i ], [ %.943.us.119.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ]
  %.908.us.epil4.i = load double, ptr %lsr.iv74.epil.init.i, align 8, !noalias !7
  %.941.us.epil5.i = load double, ptr %lsr.iv77.epil.init.i, align 8, !noalias !7
  %.942.us.epil6.i = fmul double %.908.us.epil4.i, %.941.us.epil5.i
  %.943.us.epil7.i = fadd double %.9431177.us.epil.init8.i, %.942.us.epil6.i
  store double %.943.us.epil7.i, ptr %.348.i, align 8, !noalias !7
  %scevgep76.epil.i = getelementptr i8, ptr %lsr.iv74.epil.init.i, i64 %arg.ride.6.0
  %.908.us.114.epil.i = load double, ptr %scevgep76.epil.i, align 8, !noalias !7
  %scevgep79.epil.i = getelementptr i8, ptr %lsr.iv77.epil.init.i, i64 %arg.q.6.1
  %.941.us.117.epil.i = load double, ptr %scevgep79.epil.i, align 8, !noalias !7
  %.942.us.118.epil.i = fmul double %.908.us.114.epil.i, %.941.us.117.epil.i
  %.943.us.119.epil.i = fadd double %.943.us.epil7.i, %.942.us.118.epil.i
  store double %.943.us.119.epil.i, ptr %.348.i, align 8, !noalias !7
  br label %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i

B182.B258.endif.endif_crit_edge.us.unr-lcssa.i:   ; preds = %B184.us.epil.preheader3.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i
  %.943.us.119.lcssa.i = phi double [ %.943.us.119.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ], [ %.943.us.119.epil.i, %B184.us.epil.preheader3.i ]
  br i1 %lcmp.mod.not.i, label %B182.B258.endif.endif_crit_edge.us.i, label %B184.us.epil.preheader.i

B184.us.epil.preheader.i:                         ; preds = %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i, %B184.us.preheader.i
  %.9431177.us.epil.init.i = phi double [ %.627.us.i, %B184.us.preheader.i ], [ %.943.us.119.lcssa.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i ]
  %.908.us.epil.i = load double, ptr %gep.us.epil.i, align 8, !noalias !7
  %.939.us.epil.i = getelementptr i8, ptr %.350, i64 %.937.us.epil.i
  %.941.us.epil.i = load double, ptr %.939.us.epil.i, align 8, !noalias !7
  %.942.us.epil.i = fmul double %.908.us.epil.i, %.941.us.epil.i
  %.943.us.epil.i = fadd double %.9431177.us.epil.init.i, %.942.us.epil.i
  store double %.943.us.epil.i, ptr %.348.i, align 8, !noalias !7
  br label %B182.B258.endif.endif_crit_edge.us.i

B182.B258.endif.endif_crit_edge.us.i:             ; preds = %B184.us.epil.preheader.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i
  %.1170.us.i = load double, ptr %arg.X_WC.4, align 8, !noalias !7
  store double %.1170.us.i, ptr %arg.room.4, align 8, !noalias !7
  %.1170.us.1.i = load double, ptr %.1168.1.i, align 8, !noalias !7
  store double %.1170.us.1.i, ptr %61, align 8, !noalias !7
  %.1170.us.2.i = load double, ptr %.1168.2.i, align 8, !noalias !7
  store double %.1170.us.2.i, ptr %gep1179.2.i, align 8, !noalias !7
  %.627.us.1.i = load double, ptr %gep1185.1.i, align 8, !noalias !7
  store double %.627.us.1.i, ptr %sunkaddr130.i, align 8, !noalias !7
  br i1 %84, label %B184.us.1.epil.preheader.i, label %B182.B258.endif.endif_crit_edge.us.new.i

B182.B258.endif.endif_crit_edge.us.new.i:         ; preds = %B182.B258.endif.endif_crit_edge.us.i
  br i1 %89, label %B184.us.1.epil.preheader21.i, label %B184.us.1.i

B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i: ; preds = %B184.us.2.i
  %scevgep66.i = getelementptr i8, ptr %lsr.iv65.i, i64 %86
  %scevgep66.1.i = getelementptr i8, ptr %scevgep66.i, i64 %86
  %scevgep63.i = getelementptr i8, ptr %lsr.iv62.i, i64 %85
  %scevgep63.1.i = getelementptr i8, ptr %scevgep63.i, i64 %85
  br i1 %lcmp.mod.not55.not.i, label %B184.us.2.epil.preheader38.i, label %B652.endif.2.peel.next.loopexit.unr-lcssa.i

B184.us.2.epil.preheader38.i:                     ; preds = %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i, %B182.B258.endif.endif_crit_edge.us.1.new.i
  %lsr.iv65.epil.init.i = phi ptr [ %.350, %B182.B258.endif.endif_crit_edge.us.1.new.i ], [ %scevgep66.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ]
  %lsr.iv62.epil.init.i = phi ptr [ %scevgep12, %B182.B258.endif.endif_crit_edge.us.1.new.i ], [ %scevgep63.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ]
  %.9431177.us.2.epil.init44.i = phi double [ %.627.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ], [ %.943.us.2.1.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ]
  %.908.us.2.epil40.i = load double, ptr %lsr.iv62.epil.init.i, align 8, !noalias !7
  %.941.us.2.epil41.i = load double, ptr %lsr.iv65.epil.init.i, align 8, !noalias !7
  %.942.us.2.epil42.i = fmul double %.908.us.2.epil40.i, %.941.us.2.epil41.i
  %.943.us.2.epil43.i = fadd double %.9431177.us.2.epil.init44.i, %.942.us.2.epil42.i
  store double %.943.us.2.epil43.i, ptr %sunkaddr132.i, align 8, !noalias !7
  %scevgep64.epil.i = getelementptr i8, ptr %lsr.iv62.epil.init.i, i64 %arg.ride.6.0
  %.908.us.2.1.epil.i = load double, ptr %scevgep64.epil.i, align 8, !noalias !7
  %scevgep67.epil.i = getelementptr i8, ptr %lsr.iv65.epil.init.i, i64 %arg.q.6.1
  %.941.us.2.1.epil.i = load double, ptr %scevgep67.epil.i, align 8, !noalias !7
  %.942.us.2.1.epil.i = fmul double %.908.us.2.1.epil.i, %.941.us.2.1.epil.i
  %.943.us.2.1.epil.i = fadd double %.943.us.2.epil43.i, %.942.us.2.1.epil.i
  store double %.943.us.2.1.epil.i, ptr %sunkaddr132.i, align 8, !noalias !7
  br label %B652.endif.2.peel.next.loopexit.unr-lcssa.i

B652.endif.2.peel.next.loopexit.unr-lcssa.i:      ; preds = %B184.us.2.epil.preheader38.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i
  %.943.us.2.1.lcssa.i = phi double [ %.943.us.2.1.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ], [ %.943.us.2.1.epil.i, %B184.us.2.epil.preheader38.i ]
  br i1 %lcmp.mod.not.i, label %B652.endif.2.peel.next.i, label %B184.us.2.epil.preheader.i

B184.us.2.epil.preheader.i:                       ; preds = %B652.endif.2.peel.next.loopexit.unr-lcssa.i, %B182.B258.endif.endif_crit_edge.us.1.i
  %.9431177.us.2.epil.init.i = phi double [ %.627.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.i ], [ %.943.us.2.1.lcssa.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.i ]
  %.908.us.2.epil.i = load double, ptr %gep.us.2.epil.i, align 8, !noalias !7
  %.939.us.2.epil.i = getelementptr i8, ptr %.350, i64 %.937.us.epil.i
  %.941.us.2.epil.i = load double, ptr %.939.us.2.epil.i, align 8, !noalias !7
  %.942.us.2.epil.i = fmul double %.908.us.2.epil.i, %.941.us.2.epil.i
  %.943.us.2.epil.i = fadd double %.9431177.us.2.epil.init.i, %.942.us.2.epil.i
  br label %B652.endif.2.peel.next.i.sink.split

B652.endif.2.peel.next.i.sink.split:              ; preds = %B120.endif.preheader.i, %B184.us.2.epil.preheader.i
  %.943.us.2.epil.i.sink = phi double [ %.943.us.2.epil.i, %B184.us.2.epil.preheader.i ], [ %.627.2.i, %B120.endif.preheader.i ]
  store double %.943.us.2.epil.i.sink, ptr %sunkaddr132.i, align 8, !noalias !7
  br label %B652.endif.2.peel.next.i

B652.endif.2.peel.next.i:                         ; preds = %B652.endif.2.peel.next.i.sink.split, %B652.endif.2.peel.next.loopexit.unr-lcssa.i
  %.1170.21252.i = load double, ptr %95, align 8, !noalias !7
  store double %.1170.21252.i, ptr %invariant.gep1178.2.i, align 8, !noalias !7
  %.1170.1.2.i = load double, ptr %.1168.1.2.i, align 8, !noalias !7
  store double %.1170.1.2.i, ptr %gep1179.1.2.i, align 8, !noalias !7
  %.1170.2.2.i = load double, ptr %.1168.2.2.i, align 8, !noalias !7
  store double %.1170.2.2.i, ptr %gep1179.2.2.i, align 8, !noalias !7
  %.1432.peel.i = load double, ptr %.1431.peel.i, align 8, !noalias !7
  %.1464.peel.i = getelementptr i8, ptr %.350, i64 %.1462.peel.i
  %.1466.peel.i = load double, ptr %.1464.peel.i, align 8, !noalias !7
  %.1467.peel.i = fmul double %.1432.peel.i, %.1466.peel.i
  %.1522.peel.i = load double, ptr %.1521.peel.i, align 8, !noalias !7
  %.1523.peel.i = fadd double %.1467.peel.i, %.1522.peel.i
  %.1578.peel.i = load double, ptr %.1577.peel.i, align 8, !noalias !7
  %.1580.peel.i = fmul double %.1578.peel.i, 0.000000e+00
  %.1583.peel.i = fsub double %.1523.peel.i, %.1580.peel.i
  %.1621.peel.i = tail call double @llvm.cos.f64(double %.1583.peel.i)
  %.1622.peel.i = tail call double @llvm.sin.f64(double %.1583.peel.i)
  %.1683.peel.i = load double, ptr %arg.chain.4, align 8, !noalias !7
  %.5.i.peel.i = fptosi double %.1683.peel.i to i64
  %.1712.peel.i = add nsw i64 %.5.i.peel.i, 1
  %.1732.peel.i = srem i64 %.1712.peel.i, 3
  %.1734.peel.i = icmp slt i64 %.1732.peel.i, 0
  %.1743.peel.i = add nsw i64 %.1732.peel.i, 3
  %.1723.1.peel.i = select i1 %.1734.peel.i, i64 %.1743.peel.i, i64 %.1732.peel.i
  %.1754.peel.i = add nsw i64 %.5.i.peel.i, 2
  %.1774.peel.i = srem i64 %.1754.peel.i, 3
  %.1776.peel.i = icmp slt i64 %.1774.peel.i, 0
  %.1785.peel.i = add nsw i64 %.1774.peel.i, 3
  %.1765.1.peel.i = select i1 %.1776.peel.i, i64 %.1785.peel.i, i64 %.1774.peel.i
  %.2415.peel.i = icmp slt i64 %.5.i.peel.i, 0
  %.2416.peel.i = select i1 %.2415.peel.i, i64 %arg.room.5.1, i64 0
  %.2417.peel.i = add i64 %.2416.peel.i, %.5.i.peel.i
  %.2437.peel.i = mul i64 %.2417.peel.i, %arg.room.5.2
  %96 = getelementptr double, ptr %arg.room.4, i64 %.2437.peel.i
  %.1999.peel.i = load double, ptr %.348.i, align 8, !noalias !7
  %.2055.peel.i = load double, ptr %arg.room.4, align 8, !noalias !7
  %.2110.peel.i = load double, ptr %.2109.peel.i, align 8, !noalias !7
  %.2111.peel.i = fmul double %.2055.peel.i, %.2110.peel.i
  %.2112.peel.i = fadd double %.1999.peel.i, %.2111.peel.i
  %.2166.peel.i = load double, ptr %61, align 8, !noalias !7
  %.2221.peel.i = load double, ptr %.2220.peel.i, align 8, !noalias !7
  %.2222.peel.i = fmul double %.2166.peel.i, %.2221.peel.i
  %.2223.peel.i = fadd double %.2112.peel.i, %.2222.peel.i
  %.2277.peel.i = load double, ptr %62, align 8, !noalias !7
  %.2332.peel.i = load double, ptr %.2331.peel.i, align 8, !noalias !7
  %.2333.peel.i = fmul double %.2277.peel.i, %.2332.peel.i
  %.2334.peel.i = fadd double %.2223.peel.i, %.2333.peel.i
  store double %.2334.peel.i, ptr %.348.i, align 8, !noalias !7
  %.2442.peel.i = load double, ptr %96, align 8, !noalias !7
  store double %.2442.peel.i, ptr %sunkaddr102.i, align 8, !noalias !7
  %.1999.1.peel.i = load double, ptr %sunkaddr130.i, align 8, !noalias !7
  %.2055.1.peel.i = load double, ptr %.2054.1.i, align 8, !noalias !7
  %.2110.1.peel.i = load double, ptr %.2109.peel.i, align 8, !noalias !7
  %.2111.1.peel.i = fmul double %.2055.1.peel.i, %.2110.1.peel.i
  %.2112.1.peel.i = fadd double %.1999.1.peel.i, %.2111.1.peel.i
  %.2166.1.peel.i = load double, ptr %.2165.1.i, align 8, !noalias !7
  %.2221.1.peel.i = load double, ptr %.2220.peel.i, align 8, !noalias !7
  %.2222.1.peel.i = fmul double %.2166.1.peel.i, %.2221.1.peel.i
  %.2223.1.peel.i = fadd double %.2112.1.peel.i, %.2222.1.peel.i
  %.2277.1.peel.i = load double, ptr %.2276.1.i, align 8, !noalias !7
  %.2332.1.peel.i = load double, ptr %.2331.peel.i, align 8, !noalias !7
  %.2333.1.peel.i = fmul double %.2277.1.peel.i, %.2332.1.peel.i
  %.2334.1.peel.i = fadd double %.2223.1.peel.i, %.2333.1.peel.i
  store double %.2334.1.peel.i, ptr %sunkaddr130.i, align 8, !noalias !7
  %.2441.1.peel.i = getelementptr i8, ptr %96, i64 8
  %.2442.1.peel.i = load double, ptr %.2441.1.peel.i, align 8, !noalias !7
  store double %.2442.1.peel.i, ptr %sunkaddr107.i, align 8, !noalias !7
  %.1999.2.peel.i = load double, ptr %sunkaddr132.i, align 8, !noalias !7
  %.2055.2.peel.i = load double, ptr %invariant.gep1178.2.i, align 8, !noalias !7
  %.2110.2.peel.i = load double, ptr %.2109.peel.i, align 8, !noalias !7
  %.2111.2.peel.i = fmul double %.2055.2.peel.i, %.2110.2.peel.i
  %.2112.2.peel.i = fadd double %.1999.2.peel.i, %.2111.2.peel.i
  %.2166.2.peel.i = load double, ptr %.2165.2.i, align 8, !noalias !7
  %.2221.2.peel.i = load double, ptr %.2220.peel.i, align 8, !noalias !7
  %.2222.2.peel.i = fmul double %.2166.2.peel.i, %.2221.2.peel.i
  %.2223.2.peel.i = fadd double %.2112.2.peel.i, %.2222.2.peel.i
  %.2277.2.peel.i = load double, ptr %.2276.2.i, align 8, !noalias !7
  %.2332.2.peel.i = load double, ptr %.2331.peel.i, align 8, !noalias !7
  %.2333.2.peel.i = fmul double %.2277.2.peel.i, %.2332.2.peel.i
  %.2334.2.peel.i = fadd double %.2223.2.peel.i, %.2333.2.peel.i
  store double %.2334.2.peel.i, ptr %sunkaddr132.i, align 8, !noalias !7
  %.2441.2.peel.i = getelementptr i8, ptr %96, i64 16
  %.2442.2.peel.i = load double, ptr %.2441.2.peel.i, align 8, !noalias !7
  store double %.2442.2.peel.i, ptr %sunkaddr112.i, align 8, !noalias !7
  %.2651.peel.i = icmp slt i64 %.1723.1.peel.i, 0
  %.2652.peel.i = select i1 %.2651.peel.i, i64 %arg.room.5.1, i64 0
  %.2653.peel.i = add i64 %.2652.peel.i, %.1723.1.peel.i
  %.2673.peel.i = mul i64 %.2653.peel.i, %arg.room.5.2
  %97 = getelementptr double, ptr %arg.room.4, i64 %.2673.peel.i
  %.2706.peel.i = icmp slt i64 %.1765.1.peel.i, 0
  %.2707.peel.i = select i1 %.2706.peel.i, i64 %arg.room.5.1, i64 0
  %.2708.peel.i = add i64 %.2707.peel.i, %.1765.1.peel.i
  %.2728.peel.i = mul i64 %.2708.peel.i, %arg.room.5.2
  %98 = getelementptr double, ptr %arg.room.4, i64 %.2728.peel.i
  %.2678.peel.i = load double, ptr %97, align 8, !noalias !7
  %.2733.peel.i = load double, ptr %98, align 8, !noalias !7
  %.2737.peel.i = fmul double %.1621.peel.i, %.2678.peel.i
  %.2739.peel.i = fmul double %.1622.peel.i, %.2733.peel.i
  %.2740.peel.i = fadd double %.2737.peel.i, %.2739.peel.i
  %.2742.peel.i = fmul double %.1621.peel.i, %.2733.peel.i
  %.2744.peel.i = fmul double %.1622.peel.i, %.2678.peel.i
  %.2745.peel.i = fsub double %.2742.peel.i, %.2744.peel.i
  store double %.2740.peel.i, ptr %97, align 8, !noalias !7
  store double %.2745.peel.i, ptr %98, align 8, !noalias !7
  %.2677.1.peel.i = getelementptr i8, ptr %97, i64 8
  %.2678.1.peel.i = load double, ptr %.2677.1.peel.i, align 8, !noalias !7
  %.2732.1.peel.i = getelementptr i8, ptr %98, i64 8
  %.2733.1.peel.i = load double, ptr %.2732.1.peel.i, align 8, !noalias !7
  %.2737.1.peel.i = fmul double %.1621.peel.i, %.2678.1.peel.i
  %.2739.1.peel.i = fmul double %.1622.peel.i, %.2733.1.peel.i
  %.2740.1.peel.i = fadd double %.2737.1.peel.i, %.2739.1.peel.i
  %.2742.1.peel.i = fmul double %.1621.peel.i, %.2733.1.peel.i
  %.2744.1.peel.i = fmul double %.1622.peel.i, %.2678.1.peel.i
  %.2745.1.peel.i = fsub double %.2742.1.peel.i, %.2744.1.peel.i
  store double %.2740.1.peel.i, ptr %.2677.1.peel.i, align 8, !noalias !7
  store double %.2745.1.peel.i, ptr %.2732.1.peel.i, align 8, !noalias !7
  %.2677.2.peel.i = getelementptr i8, ptr %97, i64 16
  %.2678.2.peel.i = load double, ptr %.2677.2.peel.i, align 8, !noalias !7
  %.2732.2.peel.i = getelementptr i8, ptr %98, i64 16
  %.2733.2.peel.i = load double, ptr %.2732.2.peel.i, align 8, !noalias !7
  %.2737.2.peel.i = fmul double %.1621.peel.i, %.2678.2.peel.i
  %.2739.2.peel.i = fmul double %.1622.peel.i, %.2733.2.peel.i
  %.2740.2.peel.i = fadd double %.2737.2.peel.i, %.2739.2.peel.i
  %.2742.2.peel.i = fmul double %.1621.peel.i, %.2733.2.peel.i
  %.2744.2.peel.i = fmul double %.1622.peel.i, %.2678.2.peel.i
  %.2745.2.peel.i = fsub double %.2742.2.peel.i, %.2744.2.peel.i
  store double %.2740.2.peel.i, ptr %.2677.2.peel.i, align 8, !noalias !7
  store double %.2745.2.peel.i, ptr %.2732.2.peel.i, align 8, !noalias !7
  br label %B652.endif.2.i

B652.endif.2.i:                                   ; preds = %B652.endif.2.i, %B652.endif.2.peel.next.i
  %lsr.iv60.i = phi i64 [ 5, %B652.endif.2.peel.next.i ], [ %lsr.iv.next61.i, %B652.endif.2.i ]
  %lsr.iv58.i = phi i64 [ %75, %B652.endif.2.peel.next.i ], [ %lsr.iv.next59.i, %B652.endif.2.i ]
  %lsr.iv50.i = phi ptr [ %scevgep49.i, %B652.endif.2.peel.next.i ], [ %scevgep51.i, %B652.endif.2.i ]
  %lsr.iv42.i = phi i64 [ %72, %B652.endif.2.peel.next.i ], [ %lsr.iv.next43.i, %B652.endif.2.i ]
  %lsr.iv35.i = phi i64 [ %68, %B652.endif.2.peel.next.i ], [ %lsr.iv.next36.i, %B652.endif.2.i ]
  %lsr.iv.i = phi i64 [ %63, %B652.endif.2.peel.next.i ], [ %lsr.iv.next.i, %B652.endif.2.i ]
  %before.2.01232.i = phi double [ %.1466.peel.i, %B652.endif.2.peel.next.i ], [ %.1466.i, %B652.endif.2.i ]
  %scevgep55.i = getelementptr i8, ptr %lsr.iv50.i, i64 -48
  %scevgep57.i = getelementptr i8, ptr %lsr.iv50.i, i64 -40
  %.1432.i = load double, ptr %scevgep57.i, align 8, !noalias !7
  %.1449.i = icmp slt i64 %lsr.iv58.i, 0
  %.1450.i = select i1 %.1449.i, i64 %arg.q.5.1, i64 0
  %99 = add i64 %.1450.i, %lsr.iv58.i
  %.1462.i = mul i64 %99, %arg.q.6.1
  %.1464.i = getelementptr i8, ptr %.350, i64 %.1462.i
  %.1466.i = load double, ptr %.1464.i, align 8, !noalias !7
  %.1467.i = fmul double %.1432.i, %.1466.i
  %scevgep56.i = getelementptr i8, ptr %lsr.iv50.i, i64 -32
  %.1522.i = load double, ptr %scevgep56.i, align 8, !noalias !7
  %.1523.i = fadd double %.1467.i, %.1522.i
  %.1578.i = load double, ptr %lsr.iv50.i, align 8, !noalias !7
  %.1580.i = fmul double %before.2.01232.i, %.1578.i
  %.1583.i = fsub double %.1523.i, %.1580.i
  %.1621.i = tail call double @llvm.cos.f64(double %.1583.i)
  %.1622.i = tail call double @llvm.sin.f64(double %.1583.i)
  %.1683.i = load double, ptr %scevgep55.i, align 8, !noalias !7
  %.5.i.i = fptosi double %.1683.i to i64
  %.1712.i = add nsw i64 %.5.i.i, 1
  %.1732.i = srem i64 %.1712.i, 3
  %.1734.i = icmp slt i64 %.1732.i, 0
  %.1743.i = add nsw i64 %.1732.i, 3
  %.1723.1.i = select i1 %.1734.i, i64 %.1743.i, i64 %.1732.i
  %.1754.i = add nsw i64 %.5.i.i, 2
  %.1774.i = srem i64 %.1754.i, 3
  %.1776.i = icmp slt i64 %.1774.i, 0
  %.1785.i = add nsw i64 %.1774.i, 3
  %.1765.1.i = select i1 %.1776.i, i64 %.1785.i, i64 %.1774.i
  %scevgep54.i = getelementptr i8, ptr %lsr.iv50.i, i64 -24
  %scevgep53.i = getelementptr i8, ptr %lsr.iv50.i, i64 -16
  %scevgep52.i = getelementptr i8, ptr %lsr.iv50.i, i64 -8
  %.2415.i = icmp slt i64 %.5.i.i, 0
  %.2416.i = select i1 %.2415.i, i64 %arg.room.5.1, i64 0
  %.2417.i = add i64 %.2416.i, %.5.i.i
  %.2437.i = mul i64 %.2417.i, %arg.room.5.2
  %100 = getelementptr double, ptr %arg.room.4, i64 %.2437.i
  %scevgep33.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv.i
  %scevgep34.i = getelementptr i8, ptr %scevgep33.i, i64 -16
  %.1999.i = load double, ptr %scevgep34.i, align 8, !noalias !7
  %.2055.i = load double, ptr %arg.room.4, align 8, !noalias !7
  %.2110.i = load double, ptr %scevgep54.i, align 8, !noalias !7
  %.2111.i = fmul double %.2055.i, %.2110.i
  %.2112.i = fadd double %.1999.i, %.2111.i
  %.2166.i = load double, ptr %sunkaddr134.i, align 8, !noalias !7
  %.2221.i = load double, ptr %scevgep53.i, align 8, !noalias !7
  %.2222.i = fmul double %.2166.i, %.2221.i
  %.2223.i = fadd double %.2112.i, %.2222.i
  %.2277.i = load double, ptr %62, align 8, !noalias !7
  %.2332.i = load double, ptr %scevgep52.i, align 8, !noalias !7
  %.2333.i = fmul double %.2277.i, %.2332.i
  %.2334.i = fadd double %.2223.i, %.2333.i
  %scevgep37.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv35.i
  %scevgep38.i = getelementptr i8, ptr %scevgep37.i, i64 -16
  store double %.2334.i, ptr %scevgep38.i, align 8, !noalias !7
  %.2442.i = load double, ptr %100, align 8, !noalias !7
  %scevgep44.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv42.i
  %scevgep45.i = getelementptr i8, ptr %scevgep44.i, i64 -16
  store double %.2442.i, ptr %scevgep45.i, align 8, !noalias !7
  %scevgep62.i = getelementptr i8, ptr %scevgep33.i, i64 -8
  %.1999.1.i = load double, ptr %scevgep62.i, align 8, !noalias !7
  %.2055.1.i = load double, ptr %.2054.1.i, align 8, !noalias !7
  %.2110.1.i = load double, ptr %scevgep54.i, align 8, !noalias !7
  %.2111.1.i = fmul double %.2055.1.i, %.2110.1.i
  %.2112.1.i = fadd double %.1999.1.i, %.2111.1.i
  %.2166.1.i = load double, ptr %sunkaddr139.i, align 8, !noalias !7
  %.2221.1.i = load double, ptr %scevgep53.i, align 8, !noalias !7
  %.2222.1.i = fmul double %.2166.1.i, %.2221.1.i
  %.2223.1.i = fadd double %.2112.1.i, %.2222.1.i
  %.2277.1.i = load double, ptr %.2276.1.i, align 8, !noalias !7
  %.2332.1.i = load double, ptr %scevgep52.i, align 8, !noalias !7
  %.2333.1.i = fmul double %.2277.1.i, %.2332.1.i
  %.2334.1.i = fadd double %.2223.1.i, %.2333.1.i
  %scevgep60.i = getelementptr i8, ptr %scevgep37.i, i64 -8
  store double %.2334.1.i, ptr %scevgep60.i, align 8, !noalias !7
  %.2441.1.i = getelementptr i8, ptr %100, i64 8
  %.2442.1.i = load double, ptr %.2441.1.i, align 8, !noalias !7
  %scevgep58.i = getelementptr i8, ptr %scevgep44.i, i64 -8
  store double %.2442.1.i, ptr %scevgep58.i, align 8, !noalias !7
  %.1999.2.i = load double, ptr %scevgep33.i, align 8, !noalias !7
  %.2055.2.i = load double, ptr %invariant.gep1178.2.i, align 8, !noalias !7
  %.2110.2.i = load double, ptr %scevgep54.i, align 8, !noalias !7
  %.2111.2.i = fmul double %.2055.2.i, %.2110.2.i
  %.2112.2.i = fadd double %.1999.2.i, %.2111.2.i
  %.2166.2.i = load double, ptr %sunkaddr145.i, align 8, !noalias !7
  %.2221.2.i = load double, ptr %scevgep53.i, align 8, !noalias !7
  %.2222.2.i = fmul double %.2166.2.i, %.2221.2.i
  %.2223.2.i = fadd double %.2112.2.i, %.2222.2.i
  %.2277.2.i = load double, ptr %.2276.2.i, align 8, !noalias !7
  %.2332.2.i = load double, ptr %scevgep52.i, align 8, !noalias !7
  %.2333.2.i = fmul double %.2277.2.i, %.2332.2.i
  %.2334.2.i = fadd double %.2223.2.i, %.2333.2.i
  store double %.2334.2.i, ptr %scevgep37.i, align 8, !noalias !7
  %.2441.2.i = getelementptr i8, ptr %100, i64 16
  %.2442.2.i = load double, ptr %.2441.2.i, align 8, !noalias !7
  store double %.2442.2.i, ptr %scevgep44.i, align 8, !noalias !7
  %.2651.i = icmp slt i64 %.1723.1.i, 0
  %.2652.i = select i1 %.2651.i, i64 %arg.room.5.1, i64 0
  %.2653.i = add i64 %.2652.i, %.1723.1.i
  %.2673.i = mul i64 %.2653.i, %arg.room.5.2
  %101 = getelementptr double, ptr %arg.room.4, i64 %.2673.i
  %.2706.i = icmp slt i64 %.1765.1.i, 0
  %.2707.i = select i1 %.2706.i, i64 %arg.room.5.1, i64 0
  %.2708.i = add i64 %.2707.i, %.1765.1.i
  %.2728.i = mul i64 %.2708.i, %arg.room.5.2
  %102 = getelementptr double, ptr %arg.room.4, i64 %.2728.i
  %.2678.i = load double, ptr %101, align 8, !noalias !7
  %.2733.i = load double, ptr %102, align 8, !noalias !7
  %.2737.i = fmul double %.1621.i, %.2678.i
  %.2739.i = fmul double %.1622.i, %.2733.i
  %.2740.i = fadd double %.2737.i, %.2739.i
  %.2742.i = fmul double %.1621.i, %.2733.i
  %.2744.i = fmul double %.1622.i, %.2678.i
  %.2745.i = fsub double %.2742.i, %.2744.i
  store double %.2740.i, ptr %101, align 8, !noalias !7
  store double %.2745.i, ptr %102, align 8, !noalias !7
  %.2677.1.i = getelementptr i8, ptr %101, i64 8
  %.2678.1.i = load double, ptr %.2677.1.i, align 8, !noalias !7
  %.2732.1.i = getelementptr i8, ptr %102, i64 8
  %.2733.1.i = load double, ptr %.2732.1.i, align 8, !noalias !7
  %.2737.1.i = fmul double %.1621.i, %.2678.1.i
  %.2739.1.i = fmul double %.1622.i, %.2733.1.i
  %.2740.1.i = fadd double %.2737.1.i, %.2739.1.i
  %.2742.1.i = fmul double %.1621.i, %.2733.1.i
  %.2744.1.i = fmul double %.1622.i, %.2678.1.i
  %.2745.1.i = fsub double %.2742.1.i, %.2744.1.i
  store double %.2740.1.i, ptr %.2677.1.i, align 8, !noalias !7
  store double %.2745.1.i, ptr %.2732.1.i, align 8, !noalias !7
  %.2677.2.i = getelementptr i8, ptr %101, i64 16
  %.2678.2.i = load double, ptr %.2677.2.i, align 8, !noalias !7
  %.2732.2.i = getelementptr i8, ptr %102, i64 16
  %.2733.2.i = load double, ptr %.2732.2.i, align 8, !noalias !7
  %.2737.2.i = fmul double %.1621.i, %.2678.2.i
  %.2739.2.i = fmul double %.1622.i, %.2733.2.i
  %.2740.2.i = fadd double %.2737.2.i, %.2739.2.i
  %.2742.2.i = fmul double %.1621.i, %.2733.2.i
  %.2744.2.i = fmul double %.1622.i, %.2678.2.i
  %.2745.2.i = fsub double %.2742.2.i, %.2744.2.i
  store double %.2740.2.i, ptr %.2677.2.i, align 8, !noalias !7
  store double %.2745.2.i, ptr %.2732.2.i, align 8, !noalias !7
  %lsr.iv.next.i = add i64 %lsr.iv.i, %64
  %lsr.iv.next36.i = add i64 %lsr.iv35.i, %64
  %lsr.iv.next43.i = add i64 %lsr.iv42.i, %64
  %scevgep51.i = getelementptr i8, ptr %lsr.iv50.i, i64 %73
  %lsr.iv.next59.i = add i64 %lsr.iv58.i, 1
  %lsr.iv.next61.i = add nsw i64 %lsr.iv60.i, -1
  %exitcond1259.not.i = icmp eq i64 %lsr.iv.next61.i, 0
  br i1 %exitcond1259.not.i, label %part.0, label %B652.endif.2.i, !llvm.loop !10

part.0: ; preds = %B652.endif.2.i
  %.3072.i = load double, ptr %76, align 8, !noalias !7
  %.3126.i = load double, ptr %arg.room.4, align 8, !noalias !7
  %.3180.i = load double, ptr %.3178.i, align 8, !noalias !7
  %.3181.i = fmul double %.3126.i, %.3180.i
  %.3182.i = fadd double %.3072.i, %.3181.i
  %.3236.i = load double, ptr %sunkaddr134.i, align 8, !noalias !7
  %.3290.i = load double, ptr %.3288.i, align 8, !noalias !7
  %.3291.i = fmul double %.3236.i, %.3290.i
  %.3292.i = fadd double %.3182.i, %.3291.i
  %.3346.i = load double, ptr %62, align 8, !noalias !7
  %.3400.i = load double, ptr %.3398.i, align 8, !noalias !7
  %.3401.i = fmul double %.3346.i, %.3400.i
  %.3402.i = fadd double %.3292.i, %.3401.i
  store double %.3402.i, ptr %79, align 8, !noalias !7
  %.3072.1.i = load double, ptr %.3071.1.i, align 8, !noalias !7
  %.3126.1.i = load double, ptr %.2054.1.i, align 8, !noalias !7
  %.3180.1.i = load double, ptr %.3178.i, align 8, !noalias !7
  %.3181.1.i = fmul double %.3126.1.i, %.3180.1.i
  %.3182.1.i = fadd double %.3072.1.i, %.3181.1.i
  %.3236.1.i = load double, ptr %sunkaddr139.i, align 8, !noalias !7
  %.3290.1.i = load double, ptr %.3288.i, align 8, !noalias !7
  %.3291.1.i = fmul double %.3236.1.i, %.3290.1.i
  %.3292.1.i = fadd double %.3182.1.i, %.3291.1.i
  %.3346.1.i = load double, ptr %.2276.1.i, align 8, !noalias !7
  %.3400.1.i = load double, ptr %.3398.i, align 8, !noalias !7
  %.3401.1.i = fmul double %.3346.1.i, %.3400.1.i
  %.3402.1.i = fadd double %.3292.1.i, %.3401.1.i
  store double %.3402.1.i, ptr %.3455.1.i, align 8, !noalias !7
  %.3072.2.i = load double, ptr %.3071.2.i, align 8, !noalias !7
  %.3126.2.i = load double, ptr %invariant.gep1178.2.i, align 8, !noalias !7
  %.3180.2.i = load double, ptr %.3178.i, align 8, !noalias !7
  %.3181.2.i = fmul double %.3126.2.i, %.3180.2.i
  %.3182.2.i = fadd double %.3072.2.i, %.3181.2.i
  %.3236.2.i = load double, ptr %sunkaddr145.i, align 8, !noalias !7
  %.3290.2.i = load double, ptr %.3288.i, align 8, !noalias !7
  %.3291.2.i = fmul double %.3236.2.i, %.3290.2.i
  %.3292.2.i = fadd double %.3182.2.i, %.3291.2.i
  %.3346.2.i = load double, ptr %.2276.2.i, align 8, !noalias !7
  %.3400.2.i = load double, ptr %.3398.i, align 8, !noalias !7
  %.3401.2.i = fmul double %.3346.2.i, %.3400.2.i
  %.3402.2.i = fadd double %.3292.2.i, %.3401.2.i
  store double %.3402.2.i, ptr %.3455.2.i, align 8, !noalias !7
  %.490 = mul i64 %.275428449, %.488
  %.492 = getelementptr double, ptr %arg.J.4, i64 %.490
  %scevgep17.i = getelementptr i8, ptr %.492, i64 %82
  %103 = getelementptr i8, ptr %.492, i64 %gep.us.2.idx
  %scevgep21.i = getelementptr i8, ptr %103, i64 %80
  %scevgep25.i = getelementptr i8, ptr %.492, i64 %80
  %104 = getelementptr i8, ptr %.492, i64 %gep409.us.2.idx
  %scevgep29.i = getelementptr i8, ptr %104, i64 %80
  %105 = getelementptr i8, ptr %.492, i64 %gep409.us.1.idx
  %scevgep33.i1 = getelementptr i8, ptr %105, i64 %80
  %106 = getelementptr i8, ptr %.492, i64 %gep409.us.idx
  %scevgep37.i2 = getelementptr i8, ptr %106, i64 %80
  br label %switch.end.i

switch.end.1727.i:                                ; preds = %switch.end.1.i, %switch.end.i
  %.1258.1.i = load double, ptr %scevgep2.i, align 8, !noalias !11
  %.1274.1.i = fmul double %.958.i, %.1258.1.i
  %.1383.1.i = load double, ptr %scevgep6.i, align 8, !noalias !11
  %.1386.1.i = fmul double %.1258.1.i, %.1383.1.i
  %scevgep41.i = getelementptr i8, ptr %scevgep17.i, i64 %111
  %scevgep60.i9 = getelementptr i8, ptr %scevgep41.i, i64 %112
  store double %.1274.1.i, ptr %scevgep60.i9, align 8, !noalias !11
  %scevgep49.i10 = getelementptr i8, ptr %scevgep33.i1, i64 %111
  %scevgep59.i = getelementptr i8, ptr %scevgep49.i10, i64 %112
  store double %.1386.1.i, ptr %scevgep59.i, align 8, !noalias !11
  %.1558.1.i = load double, ptr %lsr.iv.i3, align 8, !noalias !11
  %.1560.1.i = fcmp une double %.1558.1.i, 0.000000e+00
  br i1 %.1560.1.i, label %switch.end.1.1.i, label %switch.end.2.i

switch.end.1.1.i:                                 ; preds = %switch.end.1727.i
  %107 = shl i64 %.1595.i, 3
  %scevgep18.i = getelementptr i8, ptr %scevgep17.i, i64 %107
  %scevgep57.i14 = getelementptr i8, ptr %scevgep18.i, i64 %112
  %scevgep58.i15 = getelementptr i8, ptr %scevgep57.i14, i64 -8
  %.1618.1.i = load double, ptr %scevgep58.i15, align 8, !noalias !11
  %.1689.1.i = fmul double %.958.i, %.1558.1.i
  %.1690.1.i = fsub double %.1618.1.i, %.1689.1.i
  store double %.1690.1.i, ptr %scevgep58.i15, align 8, !noalias !11
  %scevgep34.i16 = getelementptr i8, ptr %scevgep33.i1, i64 %107
  %scevgep55.i17 = getelementptr i8, ptr %scevgep34.i16, i64 %112
  %scevgep56.i18 = getelementptr i8, ptr %scevgep55.i17, i64 -8
  %.1798.1.i = load double, ptr %scevgep56.i18, align 8, !noalias !11
  %.1853.1.i = load double, ptr %lsr.iv.i3, align 8, !noalias !11
  %.1909.1.i = load double, ptr %scevgep6.i, align 8, !noalias !11
  %.1912.1.i = fmul double %.1853.1.i, %.1909.1.i
  %.1913.1.i = fsub double %.1798.1.i, %.1912.1.i
  store double %.1913.1.i, ptr %scevgep56.i18, align 8, !noalias !11
  br label %switch.end.2.i

switch.end.2.i:                                   ; preds = %switch.end.1.1.i, %switch.end.1727.i
  %.1258.2.i = load double, ptr %scevgep2.i, align 8, !noalias !11
  %.1274.2.i = fmul double %.1071.i, %.1258.2.i
  %.1383.2.i = load double, ptr %scevgep3.i, align 8, !noalias !11
  %.1386.2.i = fmul double %.1258.2.i, %.1383.2.i
  %scevgep43.i = getelementptr i8, ptr %scevgep21.i, i64 %111
  %scevgep54.i11 = getelementptr i8, ptr %scevgep43.i, i64 %112
  store double %.1274.2.i, ptr %scevgep54.i11, align 8, !noalias !11
  %scevgep47.i = getelementptr i8, ptr %scevgep29.i, i64 %111
  %scevgep53.i12 = getelementptr i8, ptr %scevgep47.i, i64 %112
  store double %.1386.2.i, ptr %scevgep53.i12, align 8, !noalias !11
  %.1558.2.i = load double, ptr %lsr.iv.i3, align 8, !noalias !11
  %.1560.2.i = fcmp une double %.1558.2.i, 0.000000e+00
  br i1 %.1560.2.i, label %switch.end.1.2.i, label %B702.2.i

switch.end.1.2.i:                                 ; preds = %switch.end.2.i
  %108 = shl i64 %.1595.i, 3
  %scevgep22.i = getelementptr i8, ptr %scevgep21.i, i64 %108
  %scevgep27.i = getelementptr i8, ptr %scevgep22.i, i64 %112
  %scevgep28.i = getelementptr i8, ptr %scevgep27.i, i64 -8
  %.1618.2.i = load double, ptr %scevgep28.i, align 8, !noalias !11
  %.1689.2.i = fmul double %.1071.i, %.1558.2.i
  %.1690.2.i = fsub double %.1618.2.i, %.1689.2.i
  store double %.1690.2.i, ptr %scevgep28.i, align 8, !noalias !11
  %scevgep30.i = getelementptr i8, ptr %scevgep29.i, i64 %108
  %scevgep12.i = getelementptr i8, ptr %scevgep30.i, i64 %112
  %scevgep13.i = getelementptr i8, ptr %scevgep12.i, i64 -8
  %.1798.2.i = load double, ptr %scevgep13.i, align 8, !noalias !11
  %.1853.2.i = load double, ptr %lsr.iv.i3, align 8, !noalias !11
  %.1909.2.i = load double, ptr %scevgep3.i, align 8, !noalias !11
  %.1912.2.i = fmul double %.1853.2.i, %.1909.2.i
  %.1913.2.i = fsub double %.1798.2.i, %.1912.2.i
  store double %.1913.2.i, ptr %scevgep13.i, align 8, !noalias !11
  br label %B702.2.i

B702.2.i:                                         ; preds = %switch.end.1.2.i, %switch.end.2.i
  %scevgep1.i = getelementptr i8, ptr %lsr.iv.i3, i64 %73
  %lsr.iv.next.i13 = add i64 %lsr.iv3.i, %arg.room.5.2
  %exitcond.not.i = icmp eq i64 %.375.i, 6
  br i1 %exitcond.not.i, label %part.2, label %switch.end.i

switch.end.i:                                     ; preds = %B702.2.i, %part.0
  %lsr.iv3.i = phi i64 [ %lsr.iv.next.i13, %B702.2.i ], [ 2, %part.0 ]
  %lsr.iv.i3 = phi ptr [ %scevgep1.i, %B702.2.i ], [ %.1577.peel.i, %part.0 ]
  %.368714721.i = phi i64 [ %.375.i, %B702.2.i ], [ 0, %part.0 ]
  %.375.i = add nuw nsw i64 %.368714721.i, 1
  %.456.i = load double, ptr %79, align 8, !noalias !11
  %109 = shl i64 %lsr.iv3.i, 3
  %scevgep15.i = getelementptr i8, ptr %.348.i, i64 %109
  %scevgep16.i = getelementptr i8, ptr %scevgep15.i, i64 -16
  %.511.i = load double, ptr %scevgep16.i, align 8, !noalias !11
  %.512.i = fsub double %.456.i, %.511.i
  %.566.i = load double, ptr %.3455.1.i, align 8, !noalias !11
  %scevgep9.i = getelementptr i8, ptr %scevgep15.i, i64 -8
  %.621.i = load double, ptr %scevgep9.i, align 8, !noalias !11
  %.622.i4 = fsub double %.566.i, %.621.i
  %.676.i = load double, ptr %.3455.2.i, align 8, !noalias !11
  %.731.i = load double, ptr %scevgep15.i, align 8, !noalias !11
  %.732.i = fsub double %.676.i, %.731.i
  %scevgep3.i = getelementptr i8, ptr %.121.i, i64 %109
  %scevgep6.i = getelementptr i8, ptr %scevgep3.i, i64 -8
  %.787.i = load double, ptr %scevgep6.i, align 8, !noalias !11
  %.788.i = fmul double %.787.i, %.732.i
  %.843.i = load double, ptr %scevgep3.i, align 8, !noalias !11
  %.844.i = fmul double %.622.i4, %.843.i
  %.845.i = fsub double %.788.i, %.844.i
  %.901.i = fmul double %.512.i, %.843.i
  %scevgep5.i = getelementptr i8, ptr %scevgep3.i, i64 -16
  %.956.i = load double, ptr %scevgep5.i, align 8, !noalias !11
  %.957.i = fmul double %.732.i, %.956.i
  %.958.i = fsub double %.901.i, %.957.i
  %.1014.i = fmul double %.622.i4, %.956.i
  %.1070.i = fmul double %.512.i, %.787.i
  %.1071.i = fsub double %.1014.i, %.1070.i
  %scevgep2.i = getelementptr i8, ptr %lsr.iv.i3, i64 -40
  %110 = add nsw i64 %.368714721.i, %.171
  %.1418.i = icmp slt i64 %110, 0
  %111 = select i1 %.1418.i, i64 %12, i64 0
  %scevgep45.i5 = getelementptr i8, ptr %scevgep25.i, i64 %111
  %112 = shl nuw nsw i64 %.368714721.i, 3
  %scevgep66.i6 = getelementptr i8, ptr %scevgep45.i5, i64 %112
  %.1594.inv.i = icmp sgt i64 %110, 0
  %.1595.i = select i1 %.1594.inv.i, i64 0, i64 %arg.J.5.2
  %.1258.i = load double, ptr %scevgep2.i, align 8, !noalias !11
  %.1274.i = fmul double %.1258.i, %.845.i
  %.1386.i = fmul double %.956.i, %.1258.i
  store double %.1274.i, ptr %scevgep66.i6, align 8, !noalias !11
  %scevgep51.i7 = getelementptr i8, ptr %scevgep37.i2, i64 %111
  %scevgep65.i8 = getelementptr i8, ptr %scevgep51.i7, i64 %112
  store double %.1386.i, ptr %scevgep65.i8, align 8, !noalias !11
  %.1558.i = load double, ptr %lsr.iv.i3, align 8, !noalias !11
  %.1560.i = fcmp une double %.1558.i, 0.000000e+00
  br i1 %.1560.i, label %switch.end.1.i, label %switch.end.1727.i

switch.end.1.i:                                   ; preds = %switch.end.i
  %113 = shl i64 %.1595.i, 3
  %scevgep26.i = getelementptr i8, ptr %scevgep25.i, i64 %113
  %scevgep63.i19 = getelementptr i8, ptr %scevgep26.i, i64 %112
  %scevgep64.i20 = getelementptr i8, ptr %scevgep63.i19, i64 -8
  %.1618.i = load double, ptr %scevgep64.i20, align 8, !noalias !11
  %.1689.i = fmul double %.845.i, %.1558.i
  %.1690.i = fsub double %.1618.i, %.1689.i
  store double %.1690.i, ptr %scevgep64.i20, align 8, !noalias !11
  %scevgep38.i21 = getelementptr i8, ptr %scevgep37.i2, i64 %113
  %scevgep61.i = getelementptr i8, ptr %scevgep38.i21, i64 %112
  %scevgep62.i22 = getelementptr i8, ptr %scevgep61.i, i64 -8
  %.1798.i = load double, ptr %scevgep62.i22, align 8, !noalias !11
  %.1853.i = load double, ptr %lsr.iv.i3, align 8, !noalias !11
  %.1909.i = load double, ptr %scevgep5.i, align 8, !noalias !11
  %.1912.i = fmul double %.1853.i, %.1909.i
  %.1913.i = fsub double %.1798.i, %.1912.i
  store double %.1913.i, ptr %scevgep62.i22, align 8, !noalias !11
  br label %switch.end.1727.i

part.2: ; preds = %B702.2.i
  br i1 %.7631173.i, label %B228.endif.endif.us.preheader, label %B92.loopexit

B326:                                             ; preds = %B92.loopexit, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B228.endif.endif.us.preheader:                    ; preds = %part.2
  br i1 %brmerge205, label %B228.endif.endif.us.preheader204, label %vector.body

vector.body:                                      ; preds = %B228.endif.endif.us.preheader, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %B228.endif.endif.us.preheader ]
  %114 = shl i64 %index, 3
  %scevgep239 = getelementptr i8, ptr %lsr.iv237, i64 %114
  %sunkaddr = getelementptr i8, ptr %arg.ride.4, i64 %index
  %115 = load double, ptr %sunkaddr, align 8, !alias.scope !14
  %sunkaddr259 = getelementptr i8, ptr %sunkaddr, i64 1
  %116 = load double, ptr %sunkaddr259, align 8, !alias.scope !14
  %117 = insertelement <2 x double> poison, double %115, i64 0
  %118 = insertelement <2 x double> %117, double %116, i64 1
  store <2 x double> %118, ptr %scevgep239, align 8, !alias.scope !17, !noalias !19
  %scevgep236 = getelementptr i8, ptr %lsr.iv234, i64 %114
  store <2 x double> zeroinitializer, ptr %scevgep236, align 8, !alias.scope !27, !noalias !28
  %scevgep212 = getelementptr i8, ptr %scevgep210, i64 %index
  %scevgep213 = getelementptr i8, ptr %scevgep212, i64 -1
  %119 = load double, ptr %scevgep213, align 8, !alias.scope !29
  %120 = load double, ptr %scevgep212, align 8, !alias.scope !29
  %121 = insertelement <2 x double> poison, double %119, i64 0
  %122 = insertelement <2 x double> %121, double %120, i64 1
  %scevgep232 = getelementptr i8, ptr %lsr.iv230, i64 %114
  store <2 x double> %122, ptr %scevgep232, align 8, !alias.scope !30, !noalias !31
  %scevgep228 = getelementptr i8, ptr %lsr.iv226, i64 %114
  store <2 x double> zeroinitializer, ptr %scevgep228, align 8, !alias.scope !32, !noalias !33
  %scevgep216 = getelementptr i8, ptr %scevgep214, i64 %index
  %scevgep217 = getelementptr i8, ptr %scevgep216, i64 -1
  %123 = load double, ptr %scevgep217, align 8, !alias.scope !34
  %124 = load double, ptr %scevgep216, align 8, !alias.scope !34
  %125 = insertelement <2 x double> poison, double %123, i64 0
  %126 = insertelement <2 x double> %125, double %124, i64 1
  %scevgep224 = getelementptr i8, ptr %lsr.iv222, i64 %114
  store <2 x double> %126, ptr %scevgep224, align 8, !alias.scope !35, !noalias !36
  %scevgep220 = getelementptr i8, ptr %lsr.iv, i64 %114
  store <2 x double> zeroinitializer, ptr %scevgep220, align 8, !alias.scope !37, !noalias !38
  %index.next = add nuw nsw i64 %index, 2
  %127 = icmp eq i64 %n.vec, %index.next
  br i1 %127, label %middle.block, label %vector.body, !llvm.loop !39

middle.block:                                     ; preds = %vector.body
  br i1 %94, label %B92.loopexit, label %B228.endif.endif.us.preheader204

B228.endif.endif.us.preheader204:                 ; preds = %B228.endif.endif.us.preheader, %middle.block
  %.662411417.us.ph = phi i64 [ %n.vec, %middle.block ], [ 0, %B228.endif.endif.us.preheader ]
  %128 = shl i64 %.662411417.us.ph, 3
  %scevgep240 = getelementptr i8, ptr %lsr.iv, i64 %128
  %scevgep243 = getelementptr i8, ptr %lsr.iv222, i64 %128
  %scevgep245 = getelementptr i8, ptr %lsr.iv226, i64 %128
  %scevgep247 = getelementptr i8, ptr %lsr.iv234, i64 %128
  %scevgep249 = getelementptr i8, ptr %lsr.iv237, i64 %128
  %scevgep251 = getelementptr i8, ptr %lsr.iv230, i64 %128
  %129 = mul i64 %.662411417.us.ph, %arg.ride.6.0
  %scevgep253 = getelementptr i8, ptr %arg.ride.4, i64 %129
  %130 = sub nsw i64 %..171, %.662411417.us.ph
  br label %B228.endif.endif.us

B228.endif.endif.us:                              ; preds = %B228.endif.endif.us, %B228.endif.endif.us.preheader204
  %lsr.iv254 = phi ptr [ %scevgep253, %B228.endif.endif.us.preheader204 ], [ %scevgep255, %B228.endif.endif.us ]
  %lsr.iv241 = phi i64 [ 0, %B228.endif.endif.us.preheader204 ], [ %lsr.iv.next, %B228.endif.endif.us ]
  %131 = shl i64 %lsr.iv241, 3
  %scevgep250 = getelementptr i8, ptr %scevgep249, i64 %131
  %.866.us = load double, ptr %lsr.iv254, align 8
  store double %.866.us, ptr %scevgep250, align 8
  %scevgep248 = getelementptr i8, ptr %scevgep247, i64 %131
  store double 0.000000e+00, ptr %scevgep248, align 8
  %scevgep257 = getelementptr i8, ptr %lsr.iv254, i64 %arg.ride.6.1
  %.866.us.1 = load double, ptr %scevgep257, align 8
  %scevgep252 = getelementptr i8, ptr %scevgep251, i64 %131
  store double %.866.us.1, ptr %scevgep252, align 8
  %scevgep246 = getelementptr i8, ptr %scevgep245, i64 %131
  store double 0.000000e+00, ptr %scevgep246, align 8
  %sunkaddr261 = getelementptr i8, ptr %lsr.iv254, i64 %.861.us.2
  %.866.us.2 = load double, ptr %sunkaddr261, align 8
  %scevgep244 = getelementptr i8, ptr %scevgep243, i64 %131
  store double %.866.us.2, ptr %scevgep244, align 8
  %scevgep242 = getelementptr i8, ptr %scevgep240, i64 %131
  store double 0.000000e+00, ptr %scevgep242, align 8
  %lsr.iv.next = add i64 %lsr.iv241, 1
  %scevgep255 = getelementptr i8, ptr %lsr.iv254, i64 %arg.ride.6.0
  %exitcond.not = icmp eq i64 %130, %lsr.iv.next
  br i1 %exitcond.not, label %B92.loopexit, label %B228.endif.endif.us, !llvm.loop !42
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.motions(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.chain.0, ptr readnone captures(none) %arg.chain.1, i64 %arg.chain.2, i64 %arg.chain.3, ptr readonly captures(none) %arg.chain.4, i64 %arg.chain.5.0, i64 %arg.chain.5.1, i64 %arg.chain.6.0, i64 %arg.chain.6.1, ptr readnone captures(none) %arg.X_WC.0, ptr readnone captures(none) %arg.X_WC.1, i64 %arg.X_WC.2, i64 %arg.X_WC.3, ptr readonly captures(none) %arg.X_WC.4, i64 %arg.X_WC.5.0, i64 %arg.X_WC.5.1, i64 %arg.X_WC.6.0, i64 %arg.X_WC.6.1, ptr readnone captures(none) %arg.ride.0, ptr readnone captures(none) %arg.ride.1, i64 %arg.ride.2, i64 %arg.ride.3, ptr readonly captures(none) %arg.ride.4, i64 %arg.ride.5.0, i64 %arg.ride.5.1, i64 %arg.ride.6.0, i64 %arg.ride.6.1, ptr readnone captures(none) %arg.X_6T.0, ptr readnone captures(none) %arg.X_6T.1, i64 %arg.X_6T.2, i64 %arg.X_6T.3, ptr readonly captures(none) %arg.X_6T.4, i64 %arg.X_6T.5.0, i64 %arg.X_6T.5.1, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr readnone captures(none) %arg.room.0, ptr readnone captures(none) %arg.room.1, i64 %arg.room.2, i64 %arg.room.3, ptr %arg.room.4, i64 %arg.room.5.0, i64 %arg.room.5.1, i64 %arg.room.5.2, i64 %arg.room.6.0, i64 %arg.room.6.1, i64 %arg.room.6.2, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.5.1, i64 %arg.q.6.0, i64 %arg.q.6.1, ptr readnone captures(none) %arg.qd.0, ptr readnone captures(none) %arg.qd.1, i64 %arg.qd.2, i64 %arg.qd.3, ptr readonly captures(none) %arg.qd.4, i64 %arg.qd.5.0, i64 %arg.qd.5.1, i64 %arg.qd.6.0, i64 %arg.qd.6.1, ptr readnone captures(none) %arg.qdd.0, ptr readnone captures(none) %arg.qdd.1, i64 %arg.qdd.2, i64 %arg.qdd.3, ptr readonly captures(none) %arg.qdd.4, i64 %arg.qdd.5.0, i64 %arg.qdd.5.1, i64 %arg.qdd.6.0, i64 %arg.qdd.6.1, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.5.1, i64 %arg.out.5.2, i64 %arg.out.6.0, i64 %arg.out.6.1, i64 %arg.out.6.2) local_unnamed_addr #0 {
B0.endif:
  %.290309.not = icmp slt i64 %arg.q.5.0, 1
  br i1 %.290309.not, label %B194, label %B62.lr.ph

B62.lr.ph:                                        ; preds = %B0.endif
  %.646 = shl i64 %arg.out.5.1, 3
  %0 = mul i64 %.646, %arg.out.5.2
  %.168.i = mul i64 %arg.room.5.2, %arg.room.5.1
  %.348.idx.i = shl i64 %.168.i, 4
  %.348.i = getelementptr i8, ptr %arg.room.4, i64 %.348.idx.i
  %.447.i = add nsw i64 %arg.q.5.1, -6
  %.622.i = mul i64 %arg.X_WC.6.1, 3
  %invariant.gep1184.i = getelementptr i8, ptr %arg.X_WC.4, i64 %.622.i
  %.721.i = icmp slt i64 %arg.q.5.1, 7
  %..447.i = select i1 %.721.i, i64 0, i64 %.447.i
  %.7631173.i = icmp sgt i64 %..447.i, 0
  %invariant.gep1178.2.i = getelementptr i8, ptr %arg.room.4, i64 16
  %gep1179.1.2.i = getelementptr double, ptr %invariant.gep1178.2.i, i64 %arg.room.5.2
  %1 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  %.idx1169.i = shl i64 %arg.room.5.2, 4
  %2 = getelementptr i8, ptr %arg.room.4, i64 %.idx1169.i
  %.2054.1.i = getelementptr i8, ptr %arg.room.4, i64 8
  %.2165.1.i = getelementptr i8, ptr %1, i64 8
  %.2276.1.i = getelementptr i8, ptr %2, i64 8
  %.2165.2.i = getelementptr i8, ptr %1, i64 16
  %.2276.2.i = getelementptr i8, ptr %2, i64 16
  %.1431.peel.i = getelementptr i8, ptr %arg.chain.4, i64 8
  %.1449.peel.i = icmp slt i64 %arg.q.5.1, 6
  %.1450.peel.i = select i1 %.1449.peel.i, i64 %arg.q.5.1, i64 0
  %.1451.peel.i = add i64 %.1450.peel.i, %.447.i
  %.1462.peel.i = mul i64 %.1451.peel.i, %arg.q.6.1
  %.1521.peel.i = getelementptr i8, ptr %arg.chain.4, i64 16
  %.1577.peel.i = getelementptr i8, ptr %arg.chain.4, i64 48
  %.2109.peel.i = getelementptr i8, ptr %arg.chain.4, i64 24
  %.2220.peel.i = getelementptr i8, ptr %arg.chain.4, i64 32
  %.2331.peel.i = getelementptr i8, ptr %arg.chain.4, i64 40
  %sunkaddr101.i = shl i64 %.168.i, 3
  %sunkaddr102.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr101.i
  %sunkaddr130.i = getelementptr i8, ptr %.348.i, i64 8
  %sunkaddr107.i = getelementptr i8, ptr %sunkaddr102.i, i64 8
  %sunkaddr132.i = getelementptr i8, ptr %.348.i, i64 16
  %sunkaddr112.i = getelementptr i8, ptr %sunkaddr102.i, i64 16
  %3 = add i64 %.348.idx.i, 16
  %4 = shl i64 %arg.room.5.2, 3
  %5 = shl i64 %arg.room.5.1, 4
  %6 = or disjoint i64 %5, 8
  %7 = mul i64 %6, %arg.room.5.2
  %8 = add i64 %7, 16
  %9 = shl i64 %arg.room.5.1, 3
  %10 = add i64 %9, 8
  %11 = mul i64 %10, %arg.room.5.2
  %12 = add i64 %11, 16
  %13 = shl i64 %arg.chain.5.1, 3
  %14 = getelementptr i8, ptr %arg.chain.4, i64 %13
  %scevgep49.i = getelementptr i8, ptr %14, i64 48
  %15 = add i64 %arg.q.5.1, -5
  %sunkaddr134.i = getelementptr i8, ptr %arg.room.4, i64 %4
  %sunkaddr139.i = getelementptr i8, ptr %sunkaddr134.i, i64 8
  %sunkaddr145.i = getelementptr i8, ptr %sunkaddr134.i, i64 16
  %.idx.i = mul i64 %arg.room.5.2, 40
  %16 = getelementptr i8, ptr %.348.i, i64 %.idx.i
  %.3175.i = mul i64 %arg.X_6T.6.1, 3
  %.3178.i = getelementptr i8, ptr %arg.X_6T.4, i64 %.3175.i
  %17 = getelementptr i8, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0
  %.3288.i = getelementptr i8, ptr %17, i64 %.3175.i
  %.3394.i = shl i64 %arg.X_6T.6.0, 1
  %18 = getelementptr i8, ptr %arg.X_6T.4, i64 %.3394.i
  %.3398.i = getelementptr i8, ptr %18, i64 %.3175.i
  %.idx1168.i = mul i64 %arg.room.5.2, 48
  %19 = getelementptr i8, ptr %.348.i, i64 %.idx1168.i
  %.3071.1.i = getelementptr i8, ptr %16, i64 8
  %.3455.1.i = getelementptr i8, ptr %19, i64 8
  %.3071.2.i = getelementptr i8, ptr %16, i64 16
  %.3455.2.i = getelementptr i8, ptr %19, i64 16
  %20 = tail call i64 @llvm.smax.i64(i64 %arg.qd.5.1, i64 6)
  %..335.i = add nsw i64 %20, -6
  %.7631553.i = icmp sgt i64 %arg.qd.5.1, 6
  %arg.out.5.1..i = tail call i64 @llvm.smin.i64(i64 %arg.out.5.2, i64 3)
  %sunkaddr27.i = shl i64 %arg.out.5.1..i, 3
  %.1168.1.i = getelementptr i8, ptr %arg.X_WC.4, i64 %arg.X_WC.6.1
  %.1165.2.i = shl i64 %arg.X_WC.6.1, 1
  %.1168.2.i = getelementptr i8, ptr %arg.X_WC.4, i64 %.1165.2.i
  %.1220.2.i = shl i64 %arg.room.5.2, 1
  %gep1179.2.i = getelementptr double, ptr %arg.room.4, i64 %.1220.2.i
  %gep1185.1.i = getelementptr i8, ptr %invariant.gep1184.i, i64 %arg.X_WC.6.0
  %21 = getelementptr i8, ptr %arg.X_WC.4, i64 %arg.X_WC.6.0
  %.1168.1.1.i = getelementptr i8, ptr %21, i64 %arg.X_WC.6.1
  %gep1179.1.1.i = getelementptr double, ptr %.2054.1.i, i64 %arg.room.5.2
  %.1168.2.1.i = getelementptr i8, ptr %21, i64 %.1165.2.i
  %gep1179.2.1.i = getelementptr double, ptr %.2054.1.i, i64 %.1220.2.i
  %.621.2.i = shl i64 %arg.X_WC.6.0, 1
  %gep1185.2.i = getelementptr i8, ptr %invariant.gep1184.i, i64 %.621.2.i
  %22 = icmp eq i64 %..447.i, 1
  %unroll_iter.i = and i64 %..447.i, 9223372036854775806
  %23 = shl i64 %arg.ride.6.0, 1
  %24 = shl i64 %arg.q.6.1, 1
  %25 = add nsw i64 %..447.i, -2
  %26 = lshr i64 %25, 1
  %27 = icmp eq i64 %26, 0
  %28 = add nuw nsw i64 %26, 1
  %unroll_iter12.i = and i64 %28, 9223372036854775806
  %29 = and i64 %25, 2
  %lcmp.mod.not55.not.i = icmp eq i64 %29, 0
  %30 = and i64 %..447.i, 1
  %lcmp.mod.not.i = icmp eq i64 %30, 0
  %invariant.gep.us.1.i = getelementptr i8, ptr %arg.ride.4, i64 %arg.ride.6.1
  %.903.us.2.i = shl i64 %arg.ride.6.1, 1
  %invariant.gep.us.2.i = getelementptr i8, ptr %arg.ride.4, i64 %.903.us.2.i
  %31 = add nsw i64 %20, -7
  %xtraiter.i = and i64 %20, 1
  %lcmp.mod.not.i13 = icmp eq i64 %xtraiter.i, 0
  %scevgep36.prol.i = getelementptr i8, ptr %invariant.gep.us.1.i, i64 %arg.ride.6.0
  %32 = icmp eq i64 %31, 0
  %.902.us.epil.i = mul i64 %unroll_iter.i, %arg.ride.6.0
  %gep.us.epil.i = getelementptr i8, ptr %arg.ride.4, i64 %.902.us.epil.i
  %.937.us.epil.i = mul i64 %unroll_iter.i, %arg.q.6.1
  %.902.us.1.epil.i = mul i64 %unroll_iter.i, %arg.ride.6.0
  %gep.us.1.epil.i = getelementptr i8, ptr %invariant.gep.us.1.i, i64 %.902.us.1.epil.i
  %.937.us.1.epil.i = mul i64 %unroll_iter.i, %arg.q.6.1
  %.902.us.2.epil.i = mul i64 %unroll_iter.i, %arg.ride.6.0
  %gep.us.2.epil.i = getelementptr i8, ptr %invariant.gep.us.2.i, i64 %.902.us.2.epil.i
  %.937.us.2.epil.i = mul i64 %unroll_iter.i, %arg.q.6.1
  %33 = getelementptr i8, ptr %arg.X_WC.4, i64 %.621.2.i
  %.1168.1.2.i = getelementptr i8, ptr %33, i64 %arg.X_WC.6.1
  %.1168.2.2.i = getelementptr i8, ptr %33, i64 %.1165.2.i
  %gep1179.2.2.i = getelementptr double, ptr %invariant.gep1178.2.i, i64 %.1220.2.i
  %scevgep28.prol.i = getelementptr i8, ptr %invariant.gep.us.2.i, i64 %arg.ride.6.0
  br label %B62

B62:                                              ; preds = %part.3, %B62.lr.ph
  %lsr.iv17 = phi i64 [ %arg.q.5.0, %B62.lr.ph ], [ %lsr.iv.next, %part.3 ]
  %lsr.iv15 = phi ptr [ %arg.q.4, %B62.lr.ph ], [ %scevgep16, %part.3 ]
  %lsr.iv13 = phi ptr [ %arg.qd.4, %B62.lr.ph ], [ %scevgep14, %part.3 ]
  %lsr.iv11 = phi ptr [ %arg.qdd.4, %B62.lr.ph ], [ %scevgep12, %part.3 ]
  %lsr.iv = phi ptr [ %arg.out.4, %B62.lr.ph ], [ %scevgep, %part.3 ]
  %.627.us.i = load double, ptr %invariant.gep1184.i, align 8, !noalias !43
  store double %.627.us.i, ptr %.348.i, align 8, !noalias !43
  br i1 %.7631173.i, label %B184.us.preheader.i, label %B120.endif.preheader.i

B184.us.preheader.i:                              ; preds = %B62
  br i1 %22, label %B184.us.epil.preheader.i, label %B184.us.preheader.new.i

B184.us.preheader.new.i:                          ; preds = %B184.us.preheader.i
  br i1 %27, label %B184.us.epil.preheader3.i, label %B184.us.i

B120.endif.preheader.i:                           ; preds = %B62
  %.1170.i = load double, ptr %arg.X_WC.4, align 8, !noalias !43
  store double %.1170.i, ptr %arg.room.4, align 8, !noalias !43
  %.1170.1.i = load double, ptr %.1168.1.i, align 8, !noalias !43
  store double %.1170.1.i, ptr %1, align 8, !noalias !43
  %.1170.2.i = load double, ptr %.1168.2.i, align 8, !noalias !43
  store double %.1170.2.i, ptr %gep1179.2.i, align 8, !noalias !43
  %.627.1.i = load double, ptr %gep1185.1.i, align 8, !noalias !43
  store double %.627.1.i, ptr %sunkaddr130.i, align 8, !noalias !43
  %.1170.11251.i = load double, ptr %21, align 8, !noalias !43
  store double %.1170.11251.i, ptr %.2054.1.i, align 8, !noalias !43
  %.1170.1.1.i = load double, ptr %.1168.1.1.i, align 8, !noalias !43
  store double %.1170.1.1.i, ptr %gep1179.1.1.i, align 8, !noalias !43
  %.1170.2.1.i = load double, ptr %.1168.2.1.i, align 8, !noalias !43
  store double %.1170.2.1.i, ptr %gep1179.2.1.i, align 8, !noalias !43
  %.627.2.i = load double, ptr %gep1185.2.i, align 8, !noalias !43
  br label %B652.endif.2.peel.next.i.sink.split

B184.us.1.i:                                      ; preds = %B182.B258.endif.endif_crit_edge.us.new.i, %B184.us.1.i
  %lsr.iv81.i = phi i64 [ %lsr.iv.next82.i, %B184.us.1.i ], [ %unroll_iter12.i, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %lsr.iv71.i = phi ptr [ %scevgep88.i, %B184.us.1.i ], [ %lsr.iv15, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %lsr.iv68.i = phi ptr [ %scevgep85.i, %B184.us.1.i ], [ %invariant.gep.us.1.i, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %.9431177.us.1.i = phi double [ %.943.us.1.1.1.i, %B184.us.1.i ], [ %.627.us.1.i, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %.908.us.1.i = load double, ptr %lsr.iv68.i, align 8, !noalias !43
  %.941.us.1.i = load double, ptr %lsr.iv71.i, align 8, !noalias !43
  %.942.us.1.i = fmul double %.908.us.1.i, %.941.us.1.i
  %.943.us.1.i = fadd double %.9431177.us.1.i, %.942.us.1.i
  store double %.943.us.1.i, ptr %sunkaddr130.i, align 8, !noalias !43
  %scevgep70.i = getelementptr i8, ptr %lsr.iv68.i, i64 %arg.ride.6.0
  %.908.us.1.1.i = load double, ptr %scevgep70.i, align 8, !noalias !43
  %scevgep73.i = getelementptr i8, ptr %lsr.iv71.i, i64 %arg.q.6.1
  %.941.us.1.1.i = load double, ptr %scevgep73.i, align 8, !noalias !43
  %.942.us.1.1.i = fmul double %.908.us.1.1.i, %.941.us.1.1.i
  %.943.us.1.1.i = fadd double %.943.us.1.i, %.942.us.1.1.i
  store double %.943.us.1.1.i, ptr %sunkaddr130.i, align 8, !noalias !43
  %scevgep83.i = getelementptr i8, ptr %scevgep70.i, i64 %arg.ride.6.0
  %.908.us.1.134.i = load double, ptr %scevgep83.i, align 8, !noalias !43
  %scevgep86.i = getelementptr i8, ptr %scevgep73.i, i64 %arg.q.6.1
  %.941.us.1.135.i = load double, ptr %scevgep86.i, align 8, !noalias !43
  %.942.us.1.136.i = fmul double %.908.us.1.134.i, %.941.us.1.135.i
  %.943.us.1.137.i = fadd double %.943.us.1.1.i, %.942.us.1.136.i
  store double %.943.us.1.137.i, ptr %sunkaddr130.i, align 8, !noalias !43
  %scevgep84.i = getelementptr i8, ptr %scevgep83.i, i64 %arg.ride.6.0
  %.908.us.1.1.1.i = load double, ptr %scevgep84.i, align 8, !noalias !43
  %scevgep87.i = getelementptr i8, ptr %scevgep86.i, i64 %arg.q.6.1
  %.941.us.1.1.1.i = load double, ptr %scevgep87.i, align 8, !noalias !43
  %.942.us.1.1.1.i = fmul double %.908.us.1.1.1.i, %.941.us.1.1.1.i
  %.943.us.1.1.1.i = fadd double %.943.us.1.137.i, %.942.us.1.1.1.i
  store double %.943.us.1.1.1.i, ptr %sunkaddr130.i, align 8, !noalias !43
  %lsr.iv.next82.i = add i64 %lsr.iv81.i, -2
  %niter33.ncmp.1.i = icmp eq i64 %lsr.iv.next82.i, 0
  %scevgep85.i = getelementptr i8, ptr %scevgep84.i, i64 %arg.ride.6.0
  %scevgep88.i = getelementptr i8, ptr %scevgep87.i, i64 %arg.q.6.1
  br i1 %niter33.ncmp.1.i, label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i, label %B184.us.1.i

B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i: ; preds = %B184.us.1.i
  %scevgep72.i = getelementptr i8, ptr %lsr.iv71.i, i64 %24
  %scevgep72.1.i = getelementptr i8, ptr %scevgep72.i, i64 %24
  %scevgep69.i = getelementptr i8, ptr %lsr.iv68.i, i64 %23
  %scevgep69.1.i = getelementptr i8, ptr %scevgep69.i, i64 %23
  br i1 %lcmp.mod.not55.not.i, label %B184.us.1.epil.preheader21.i, label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i

B184.us.1.epil.preheader21.i:                     ; preds = %B182.B258.endif.endif_crit_edge.us.new.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i
  %lsr.iv71.epil.init.i = phi ptr [ %lsr.iv15, %B182.B258.endif.endif_crit_edge.us.new.i ], [ %scevgep72.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ]
  %lsr.iv68.epil.init.i = phi ptr [ %invariant.gep.us.1.i, %B182.B258.endif.endif_crit_edge.us.new.i ], [ %scevgep69.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ]
  %.9431177.us.1.epil.init27.i = phi double [ %.627.us.1.i, %B182.B258.endif.endif_crit_edge.us.new.i ], [ %.943.us.1.1.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ]
  %.908.us.1.epil23.i = load double, ptr %lsr.iv68.epil.init.i, align 8, !noalias !43
  %.941.us.1.epil24.i = load double, ptr %lsr.iv71.epil.init.i, align 8, !noalias !43
  %.942.us.1.epil25.i = fmul double %.908.us.1.epil23.i, %.941.us.1.epil24.i
  %.943.us.1.epil26.i = fadd double %.9431177.us.1.epil.init27.i, %.942.us.1.epil25.i
  store double %.943.us.1.epil26.i, ptr %sunkaddr130.i, align 8, !noalias !43
  %scevgep70.epil.i = getelementptr i8, ptr %lsr.iv68.epil.init.i, i64 %arg.ride.6.0
  %.908.us.1.1.epil.i = load double, ptr %scevgep70.epil.i, align 8, !noalias !43
  %scevgep73.epil.i = getelementptr i8, ptr %lsr.iv71.epil.init.i, i64 %arg.q.6.1
  %.941.us.1.1.epil.i = load double, ptr %scevgep73.epil.i, align 8, !noalias !43
  %.942.us.1.1.epil.i = fmul double %.908.us.1.1.epil.i, %.941.us.1.1.epil.i
  %.943.us.1.1.epil.i = fadd double %.943.us.1.epil26.i, %.942.us.1.1.epil.i
  store double %.943.us.1.1.epil.i, ptr %sunkaddr130.i, align 8, !noalias !43
  br label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i

B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i: ; preds = %B184.us.1.epil.preheader21.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i
  %.943.us.1.1.lcssa.i = phi double [ %.943.us.1.1.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ], [ %.943.us.1.1.epil.i, %B184.us.1.epil.preheader21.i ]
  br i1 %lcmp.mod.not.i, label %B182.B258.endif.endif_crit_edge.us.1.i, label %B184.us.1.epil.preheader.i

B184.us.1.epil.preheader.i:                       ; preds = %B182.B258.endif.endif_crit_edge.us.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i
  %.9431177.us.1.epil.init.i = phi double [ %.627.us.1.i, %B182.B258.endif.endif_crit_edge.us.i ], [ %.943.us.1.1.lcssa.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i ]
  %.908.us.1.epil.i = load double, ptr %gep.us.1.epil.i, align 8, !noalias !43
  %.939.us.1.epil.i = getelementptr i8, ptr %lsr.iv15, i64 %.937.us.1.epil.i
  %.941.us.1.epil.i = load double, ptr %.939.us.1.epil.i, align 8, !noalias !43
  %.942.us.1.epil.i = fmul double %.908.us.1.epil.i, %.941.us.1.epil.i
  %.943.us.1.epil.i = fadd double %.9431177.us.1.epil.init.i, %.942.us.1.epil.i
  store double %.943.us.1.epil.i, ptr %sunkaddr130.i, align 8, !noalias !43
  br label %B182.B258.endif.endif_crit_edge.us.1.i

B182.B258.endif.endif_crit_edge.us.1.i:           ; preds = %B184.us.1.epil.preheader.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i
  %.1170.us.11255.i = load double, ptr %21, align 8, !noalias !43
  store double %.1170.us.11255.i, ptr %.2054.1.i, align 8, !noalias !43
  %.1170.us.1.1.i = load double, ptr %.1168.1.1.i, align 8, !noalias !43
  store double %.1170.us.1.1.i, ptr %gep1179.1.1.i, align 8, !noalias !43
  %.1170.us.2.1.i = load double, ptr %.1168.2.1.i, align 8, !noalias !43
  store double %.1170.us.2.1.i, ptr %gep1179.2.1.i, align 8, !noalias !43
  %.627.us.2.i = load double, ptr %gep1185.2.i, align 8, !noalias !43
  store double %.627.us.2.i, ptr %sunkaddr132.i, align 8, !noalias !43
  br i1 %22, label %B184.us.2.epil.preheader.i, label %B182.B258.endif.endif_crit_edge.us.1.new.i

B182.B258.endif.endif_crit_edge.us.1.new.i:       ; preds = %B182.B258.endif.endif_crit_edge.us.1.i
  br i1 %27, label %B184.us.2.epil.preheader38.i, label %B184.us.2.i

B184.us.2.i:                                      ; preds = %B182.B258.endif.endif_crit_edge.us.1.new.i, %B184.us.2.i
  %lsr.iv63.i = phi i64 [ %lsr.iv.next64.i, %B184.us.2.i ], [ %unroll_iter12.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %lsr.iv65.i = phi ptr [ %scevgep80.i, %B184.us.2.i ], [ %lsr.iv15, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %lsr.iv62.i = phi ptr [ %scevgep71.i, %B184.us.2.i ], [ %invariant.gep.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %.9431177.us.2.i = phi double [ %.943.us.2.1.1.i, %B184.us.2.i ], [ %.627.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %.908.us.2.i = load double, ptr %lsr.iv62.i, align 8, !noalias !43
  %.941.us.2.i = load double, ptr %lsr.iv65.i, align 8, !noalias !43
  %.942.us.2.i = fmul double %.908.us.2.i, %.941.us.2.i
  %.943.us.2.i = fadd double %.9431177.us.2.i, %.942.us.2.i
  store double %.943.us.2.i, ptr %sunkaddr132.i, align 8, !noalias !43
  %scevgep64.i = getelementptr i8, ptr %lsr.iv62.i, i64 %arg.ride.6.0
  %.908.us.2.1.i = load double, ptr %scevgep64.i, align 8, !noalias !43
  %scevgep67.i = getelementptr i8, ptr %lsr.iv65.i, i64 %arg.q.6.1
  %.941.us.2.1.i = load double, ptr %scevgep67.i, align 8, !noalias !43
  %.942.us.2.1.i = fmul double %.908.us.2.1.i, %.941.us.2.1.i
  %.943.us.2.1.i = fadd double %.943.us.2.i, %.942.us.2.1.i
  store double %.943.us.2.1.i, ptr %sunkaddr132.i, align 8, !noalias !43
  %scevgep65.i = getelementptr i8, ptr %scevgep64.i, i64 %arg.ride.6.0
  %.908.us.2.151.i = load double, ptr %scevgep65.i, align 8, !noalias !43
  %scevgep74.i = getelementptr i8, ptr %scevgep67.i, i64 %arg.q.6.1
  %.941.us.2.152.i = load double, ptr %scevgep74.i, align 8, !noalias !43
  %.942.us.2.153.i = fmul double %.908.us.2.151.i, %.941.us.2.152.i
  %.943.us.2.154.i = fadd double %.943.us.2.1.i, %.942.us.2.153.i
  store double %.943.us.2.154.i, ptr %sunkaddr132.i, align 8, !noalias !43
  %scevgep68.i = getelementptr i8, ptr %scevgep65.i, i64 %arg.ride.6.0
  %.908.us.2.1.1.i = load double, ptr %scevgep68.i, align 8, !noalias !43
  %scevgep77.i = getelementptr i8, ptr %scevgep74.i, i64 %arg.q.6.1
  %.941.us.2.1.1.i = load double, ptr %scevgep77.i, align 8, !noalias !43
  %.942.us.2.1.1.i = fmul double %.908.us.2.1.1.i, %.941.us.2.1.1.i
  %.943.us.2.1.1.i = fadd double %.943.us.2.154.i, %.942.us.2.1.1.i
  store double %.943.us.2.1.1.i, ptr %sunkaddr132.i, align 8, !noalias !43
  %lsr.iv.next64.i = add i64 %lsr.iv63.i, -2
  %niter50.ncmp.1.i = icmp eq i64 %lsr.iv.next64.i, 0
  %scevgep71.i = getelementptr i8, ptr %scevgep68.i, i64 %arg.ride.6.0
  %scevgep80.i = getelementptr i8, ptr %scevgep77.i, i64 %arg.q.6.1
  br i1 %niter50.ncmp.1.i, label %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i, label %B184.us.2.i

B184.us.i:                                        ; preds = %B184.us.preheader.new.i, %B184.us.i
  %lsr.iv89.i = phi i64 [ %lsr.iv.next90.i, %B184.us.i ], [ %unroll_iter12.i, %B184.us.preheader.new.i ]
  %lsr.iv77.i = phi ptr [ %scevgep96.i, %B184.us.i ], [ %lsr.iv15, %B184.us.preheader.new.i ]
  %lsr.iv74.i = phi ptr [ %scevgep93.i, %B184.us.i ], [ %arg.ride.4, %B184.us.preheader.new.i ]
  %.9431177.us.i = phi double [ %.943.us.119.1.i, %B184.us.i ], [ %.627.us.i, %B184.us.preheader.new.i ]
  %.908.us.i = load double, ptr %lsr.iv74.i, align 8, !noalias !43
  %.941.us.i = load double, ptr %lsr.iv77.i, align 8, !noalias !43
  %.942.us.i = fmul double %.908.us.i, %.941.us.i
  %.943.us.i = fadd double %.9431177.us.i, %.942.us.i
  store double %.943.us.i, ptr %.348.i, align 8, !noalias !43
  %scevgep76.i = getelementptr i8, ptr %lsr.iv74.i, i64 %arg.ride.6.0
  %.908.us.114.i = load double, ptr %scevgep76.i, align 8, !noalias !43
  %scevgep79.i = getelementptr i8, ptr %lsr.iv77.i, i64 %arg.q.6.1
  %.941.us.117.i = load double, ptr %scevgep79.i, align 8, !noalias !43
  %.942.us.118.i = fmul double %.908.us.114.i, %.941.us.117.i
  %.943.us.119.i = fadd double %.943.us.i, %.942.us.118.i
  store double %.943.us.119.i, ptr %.348.i, align 8, !noalias !43
  %scevgep91.i = getelementptr i8, ptr %scevgep76.i, i64 %arg.ride.6.0
  %.908.us.115.i = load double, ptr %scevgep91.i, align 8, !noalias !43
  %scevgep94.i = getelementptr i8, ptr %scevgep79.i, i64 %arg.q.6.1
  %.941.us.116.i = load double, ptr %scevgep94.i, align 8, !noalias !43
  %.942.us.117.i = fmul double %.908.us.115.i, %.941.us.116.i
  %.943.us.118.i = fadd double %.943.us.119.i, %.942.us.117.i
  store double %.943.us.118.i, ptr %.348.i, align 8, !noalias !43
  %scevgep92.i = getelementptr i8, ptr %scevgep91.i, i64 %arg.ride.6.0
  %.908.us.114.1.i = load double, ptr %scevgep92.i, align 8, !noalias !43
  %scevgep95.i = getelementptr i8, ptr %scevgep94.i, i64 %arg.q.6.1
  %.941.us.117.1.i = load double, ptr %scevgep95.i, align 8, !noalias !43
  %.942.us.118.1.i = fmul double %.908.us.114.1.i, %.941.us.117.1.i
  %.943.us.119.1.i = fadd double %.943.us.118.i, %.942.us.118.1.i
  store double %.943.us.119.1.i, ptr %.348.i, align 8, !noalias !43
  %lsr.iv.next90.i = add i64 %lsr.iv89.i, -2
  %niter.ncmp.119.i = icmp eq i64 %lsr.iv.next90.i, 0
  %scevgep93.i = getelementptr i8, ptr %scevgep92.i, i64 %arg.ride.6.0
  %scevgep96.i = getelementptr i8, ptr %scevgep95.i, i64 %arg.q.6.1
  br i1 %niter.ncmp.119.i, label %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i, label %B184.us.i

B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i: ; preds = %B184.us.i
  %scevgep78.i = getelementptr i8, ptr %lsr.iv77.i, i64 %24
  %scevgep78.1.i = getelementptr i8, ptr %scevgep78.i, i64 %24
  %scevgep75.i = getelementptr i8, ptr %lsr.iv74.i, i64 %23
  %scevgep75.1.i = getelementptr i8, ptr %scevgep75.i, i64 %23
  br i1 %lcmp.mod.not55.not.i, label %B184.us.epil.preheader3.i, label %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i

B184.us.epil.preheader3.i:                        ; preds = %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i, %B184.us.preheader.new.i
  %lsr.iv77.epil.init.i = phi ptr [ %lsr.iv15, %B184.us.preheader.new.i ], [ %scevgep78.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ]
  %lsr.iv74.epil.init.i = phi ptr [ %arg.ride.4, %B184.us.preheader.new.i ], [ %scevgep75.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ]
  %.9431177.us.epil.init8.i = phi double [ %.627.us.i, %B184.us.preheader.new.i ], [ %.943.us.119.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ]
  %.908.us.epil4.i = load double, ptr %lsr.iv74.epil.init.i, align 8, !noalias !43
  %.941.us.epil5.i = load double, ptr %lsr.iv77.epil.init.i, align 8, !noalias !43
  %.942.us.epil6.i = fmul double %.908.us.epil4.i, %.941.us.epil5.i
  %.943.us.epil7.i = fadd double %.9431177.us.epil.init8.i, %.942.us.epil6.i
  store double %.943.us.epil7.i, ptr %.348.i, align 8, !noalias !43
  %scevgep76.epil.i = getelementptr i8, ptr %lsr.iv74.epil.init.i, i64 %arg.ride.6.0
  %.908.us.114.epil.i = load double, ptr %scevgep76.epil.i, align 8, !noalias !43
  %scevgep79.epil.i = getelementptr i8, ptr %lsr.iv77.epil.init.i, i64 %arg.q.6.1
  %.941.us.117.epil.i = load double, ptr %scevgep79.epil.i, align 8, !noalias !43
  %.942.us.118.epil.i = fmul double %.908.us.114.epil.i, %.941.us.117.epil.i
  %.943.us.119.epil.i = fadd double %.943.us.epil7.i, %.942.us.118.epil.i
  store double %.943.us.119.epil.i, ptr %.348.i, align 8, !noalias !43
  br label %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i

B182.B258.endif.endif_crit_edge.us.unr-lcssa.i:   ; preds = %B184.us.epil.preheader3.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i
  %.943.us.119.lcssa.i = phi double [ %.943.us.119.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ], [ %.943.us.119.epil.i, %B184.us.epil.preheader3.i ]
  br i1 %lcmp.mod.not.i, label %B182.B258.endif.endif_crit_edge.us.i, label %B184.us.epil.preheader.i

B184.us.epil.preheader.i:                         ; preds = %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i, %B184.us.preheader.i
  %.9431177.us.epil.init.i = phi double [ %.627.us.i, %B184.us.preheader.i ], [ %.943.us.119.lcssa.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i ]
  %.908.us.epil.i = load double, ptr %gep.us.epil.i, align 8, !noalias !43
  %.939.us.epil.i = getelementptr i8, ptr %lsr.iv15, i64 %.937.us.epil.i
  %.941.us.epil.i = load double, ptr %.939.us.epil.i, align 8, !noalias !43
  %.942.us.epil.i = fmul double %.908.us.epil.i, %.941.us.epil.i
  %.943.us.epil.i = fadd double %.9431177.us.epil.init.i, %.942.us.epil.i
  store double %.943.us.epil.i, ptr %.348.i, align 8, !noalias !43
  br label %B182.B258.endif.endif_crit_edge.us.i

B182.B258.endif.endif_crit_edge.us.i:             ; preds = %B184.us.epil.preheader.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i
  %.1170.us.i = load double, ptr %arg.X_WC.4, align 8, !noalias !43
  store double %.1170.us.i, ptr %arg.room.4, align 8, !noalias !43
  %.1170.us.1.i = load double, ptr %.1168.1.i, align 8, !noalias !43
  store double %.1170.us.1.i, ptr %1, align 8, !noalias !43
  %.1170.us.2.i = load double, ptr %.1168.2.i, align 8, !noalias !43
  store double %.1170.us.2.i, ptr %gep1179.2.i, align 8, !noalias !43
  %.627.us.1.i = load double, ptr %gep1185.1.i, align 8, !noalias !43
  store double %.627.us.1.i, ptr %sunkaddr130.i, align 8, !noalias !43
  br i1 %22, label %B184.us.1.epil.preheader.i, label %B182.B258.endif.endif_crit_edge.us.new.i

B182.B258.endif.endif_crit_edge.us.new.i:         ; preds = %B182.B258.endif.endif_crit_edge.us.i
  br i1 %27, label %B184.us.1.epil.preheader21.i, label %B184.us.1.i

B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i: ; preds = %B184.us.2.i
  %scevgep66.i = getelementptr i8, ptr %lsr.iv65.i, i64 %24
  %scevgep66.1.i = getelementptr i8, ptr %scevgep66.i, i64 %24
  %scevgep63.i = getelementptr i8, ptr %lsr.iv62.i, i64 %23
  %scevgep63.1.i = getelementptr i8, ptr %scevgep63.i, i64 %23
  br i1 %lcmp.mod.not55.not.i, label %B184.us.2.epil.preheader38.i, label %B652.endif.2.peel.next.loopexit.unr-lcssa.i

B184.us.2.epil.preheader38.i:                     ; preds = %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i, %B182.B258.endif.endif_crit_edge.us.1.new.i
  %lsr.iv65.epil.init.i = phi ptr [ %lsr.iv15, %B182.B258.endif.endif_crit_edge.us.1.new.i ], [ %scevgep66.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ]
  %lsr.iv62.epil.init.i = phi ptr [ %invariant.gep.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ], [ %scevgep63.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ]
  %.9431177.us.2.epil.init44.i = phi double [ %.627.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ], [ %.943.us.2.1.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ]
  %.908.us.2.epil40.i = load double, ptr %lsr.iv62.epil.init.i, align 8, !noalias !43
  %.941.us.2.epil41.i = load double, ptr %lsr.iv65.epil.init.i, align 8, !noalias !43
  %.942.us.2.epil42.i = fmul double %.908.us.2.epil40.i, %.941.us.2.epil41.i
  %.943.us.2.epil43.i = fadd double %.9431177.us.2.epil.init44.i, %.942.us.2.epil42.i
  store double %.943.us.2.epil43.i, ptr %sunkaddr132.i, align 8, !noalias !43
  %scevgep64.epil.i = getelementptr i8, ptr %lsr.iv62.epil.init.i, i64 %arg.ride.6.0
  %.908.us.2.1.epil.i = load double, ptr %scevgep64.epil.i, align 8, !noalias !43
  %scevgep67.epil.i = getelementptr i8, ptr %lsr.iv65.epil.init.i, i64 %arg.q.6.1
  %.941.us.2.1.epil.i = load double, ptr %scevgep67.epil.i, align 8, !noalias !43
  %.942.us.2.1.epil.i = fmul double %.908.us.2.1.epil.i, %.941.us.2.1.epil.i
  %.943.us.2.1.epil.i = fadd double %.943.us.2.epil43.i, %.942.us.2.1.epil.i
  store double %.943.us.2.1.epil.i, ptr %sunkaddr132.i, align 8, !noalias !43
  br label %B652.endif.2.peel.next.loopexit.unr-lcssa.i

B652.endif.2.peel.next.loopexit.unr-lcssa.i:      ; preds = %B184.us.2.epil.preheader38.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i
  %.943.us.2.1.lcssa.i = phi double [ %.943.us.2.1.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ], [ %.943.us.2.1.epil.i, %B184.us.2.epil.preheader38.i ]
  br i1 %lcmp.mod.not.i, label %B652.endif.2.peel.next.i, label %B184.us.2.epil.preheader.i

B184.us.2.epil.preheader.i:                       ; preds = %B652.endif.2.peel.next.loopexit.unr-lcssa.i, %B182.B258.endif.endif_crit_edge.us.1.i
  %.9431177.us.2.epil.init.i = phi double [ %.627.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.i ], [ %.943.us.2.1.lcssa.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.i ]
  %.908.us.2.epil.i = load double, ptr %gep.us.2.epil.i, align 8, !noalias !43
  %.939.us.2.epil.i = getelementptr i8, ptr %lsr.iv15, i64 %.937.us.2.epil.i
  %.941.us.2.epil.i = load double, ptr %.939.us.2.epil.i, align 8, !noalias !43
  %.942.us.2.epil.i = fmul double %.908.us.2.epil.i, %.941.us.2.epil.i
  %.943.us.2.epil.i = fadd double %.9431177.us.2.epil.init.i, %.942.us.2.epil.i
  br label %B652.endif.2.peel.next.i.sink.split

B652.endif.2.peel.next.i.sink.split:              ; preds = %B120.endif.preheader.i, %B184.us.2.epil.preheader.i
  %.943.us.2.epil.i.sink = phi double [ %.943.us.2.epil.i, %B184.us.2.epil.preheader.i ], [ %.627.2.i, %B120.endif.preheader.i ]
  store double %.943.us.2.epil.i.sink, ptr %sunkaddr132.i, align 8, !noalias !43
  br label %B652.endif.2.peel.next.i

B652.endif.2.peel.next.i:                         ; preds = %B652.endif.2.peel.next.i.sink.split, %B652.endif.2.peel.next.loopexit.unr-lcssa.i
  %.1170.21252.i = load double, ptr %33, align 8, !noalias !43
  store double %.1170.21252.i, ptr %invariant.gep1178.2.i, align 8, !noalias !43
  %.1170.1.2.i = load double, ptr %.1168.1.2.i, align 8, !noalias !43
  store double %.1170.1.2.i, ptr %gep1179.1.2.i, align 8, !noalias !43
  %.1170.2.2.i = load double, ptr %.1168.2.2.i, align 8, !noalias !43
  store double %.1170.2.2.i, ptr %gep1179.2.2.i, align 8, !noalias !43
  %.1432.peel.i = load double, ptr %.1431.peel.i, align 8, !noalias !43
  %.1464.peel.i = getelementptr i8, ptr %lsr.iv15, i64 %.1462.peel.i
  %.1466.peel.i = load double, ptr %.1464.peel.i, align 8, !noalias !43
  %.1467.peel.i = fmul double %.1432.peel.i, %.1466.peel.i
  %.1522.peel.i = load double, ptr %.1521.peel.i, align 8, !noalias !43
  %.1523.peel.i = fadd double %.1467.peel.i, %.1522.peel.i
  %.1578.peel.i = load double, ptr %.1577.peel.i, align 8, !noalias !43
  %.1580.peel.i = fmul double %.1578.peel.i, 0.000000e+00
  %.1583.peel.i = fsub double %.1523.peel.i, %.1580.peel.i
  %.1621.peel.i = tail call double @llvm.cos.f64(double %.1583.peel.i)
  %.1622.peel.i = tail call double @llvm.sin.f64(double %.1583.peel.i)
  %.1683.peel.i = load double, ptr %arg.chain.4, align 8, !noalias !43
  %.5.i.peel.i = fptosi double %.1683.peel.i to i64
  %.1712.peel.i = add nsw i64 %.5.i.peel.i, 1
  %.1732.peel.i = srem i64 %.1712.peel.i, 3
  %.1734.peel.i = icmp slt i64 %.1732.peel.i, 0
  %.1743.peel.i = add nsw i64 %.1732.peel.i, 3
  %.1723.1.peel.i = select i1 %.1734.peel.i, i64 %.1743.peel.i, i64 %.1732.peel.i
  %.1754.peel.i = add nsw i64 %.5.i.peel.i, 2
  %.1774.peel.i = srem i64 %.1754.peel.i, 3
  %.1776.peel.i = icmp slt i64 %.1774.peel.i, 0
  %.1785.peel.i = add nsw i64 %.1774.peel.i, 3
  %.1765.1.peel.i = select i1 %.1776.peel.i, i64 %.1785.peel.i, i64 %.1774.peel.i
  %.2415.peel.i = icmp slt i64 %.5.i.peel.i, 0
  %.2416.peel.i = select i1 %.2415.peel.i, i64 %arg.room.5.1, i64 0
  %.2417.peel.i = add i64 %.2416.peel.i, %.5.i.peel.i
  %.2437.peel.i = mul i64 %.2417.peel.i, %arg.room.5.2
  %34 = getelementptr double, ptr %arg.room.4, i64 %.2437.peel.i
  %.1999.peel.i = load double, ptr %.348.i, align 8, !noalias !43
  %.2055.peel.i = load double, ptr %arg.room.4, align 8, !noalias !43
  %.2110.peel.i = load double, ptr %.2109.peel.i, align 8, !noalias !43
  %.2111.peel.i = fmul double %.2055.peel.i, %.2110.peel.i
  %.2112.peel.i = fadd double %.1999.peel.i, %.2111.peel.i
  %.2166.peel.i = load double, ptr %1, align 8, !noalias !43
  %.2221.peel.i = load double, ptr %.2220.peel.i, align 8, !noalias !43
  %.2222.peel.i = fmul double %.2166.peel.i, %.2221.peel.i
  %.2223.peel.i = fadd double %.2112.peel.i, %.2222.peel.i
  %.2277.peel.i = load double, ptr %2, align 8, !noalias !43
  %.2332.peel.i = load double, ptr %.2331.peel.i, align 8, !noalias !43
  %.2333.peel.i = fmul double %.2277.peel.i, %.2332.peel.i
  %.2334.peel.i = fadd double %.2223.peel.i, %.2333.peel.i
  store double %.2334.peel.i, ptr %.348.i, align 8, !noalias !43
  %.2442.peel.i = load double, ptr %34, align 8, !noalias !43
  store double %.2442.peel.i, ptr %sunkaddr102.i, align 8, !noalias !43
  %.1999.1.peel.i = load double, ptr %sunkaddr130.i, align 8, !noalias !43
  %.2055.1.peel.i = load double, ptr %.2054.1.i, align 8, !noalias !43
  %.2110.1.peel.i = load double, ptr %.2109.peel.i, align 8, !noalias !43
  %.2111.1.peel.i = fmul double %.2055.1.peel.i, %.2110.1.peel.i
  %.2112.1.peel.i = fadd double %.1999.1.peel.i, %.2111.1.peel.i
  %.2166.1.peel.i = load double, ptr %.2165.1.i, align 8, !noalias !43
  %.2221.1.peel.i = load double, ptr %.2220.peel.i, align 8, !noalias !43
  %.2222.1.peel.i = fmul double %.2166.1.peel.i, %.2221.1.peel.i
  %.2223.1.peel.i = fadd double %.2112.1.peel.i, %.2222.1.peel.i
  %.2277.1.peel.i = load double, ptr %.2276.1.i, align 8, !noalias !43
  %.2332.1.peel.i = load double, ptr %.2331.peel.i, align 8, !noalias !43
  %.2333.1.peel.i = fmul double %.2277.1.peel.i, %.2332.1.peel.i
  %.2334.1.peel.i = fadd double %.2223.1.peel.i, %.2333.1.peel.i
  store double %.2334.1.peel.i, ptr %sunkaddr130.i, align 8, !noalias !43
  %.2441.1.peel.i = getelementptr i8, ptr %34, i64 8
  %.2442.1.peel.i = load double, ptr %.2441.1.peel.i, align 8, !noalias !43
  store double %.2442.1.peel.i, ptr %sunkaddr107.i, align 8, !noalias !43
  %.1999.2.peel.i = load double, ptr %sunkaddr132.i, align 8, !noalias !43
  %.2055.2.peel.i = load double, ptr %invariant.gep1178.2.i, align 8, !noalias !43
  %.2110.2.peel.i = load double, ptr %.2109.peel.i, align 8, !noalias !43
  %.2111.2.peel.i = fmul double %.2055.2.peel.i, %.2110.2.peel.i
  %.2112.2.peel.i = fadd double %.1999.2.peel.i, %.2111.2.peel.i
  %.2166.2.peel.i = load double, ptr %.2165.2.i, align 8, !noalias !43
  %.2221.2.peel.i = load double, ptr %.2220.peel.i, align 8, !noalias !43
  %.2222.2.peel.i = fmul double %.2166.2.peel.i, %.2221.2.peel.i
  %.2223.2.peel.i = fadd double %.2112.2.peel.i, %.2222.2.peel.i
  %.2277.2.peel.i = load double, ptr %.2276.2.i, align 8, !noalias !43
  %.2332.2.peel.i = load double, ptr %.2331.peel.i, align 8, !noalias !43
  %.2333.2.peel.i = fmul double %.2277.2.peel.i, %.2332.2.peel.i
  %.2334.2.peel.i = fadd double %.2223.2.peel.i, %.2333.2.peel.i
  store double %.2334.2.peel.i, ptr %sunkaddr132.i, align 8, !noalias !43
  %.2441.2.peel.i = getelementptr i8, ptr %34, i64 16
  %.2442.2.peel.i = load double, ptr %.2441.2.peel.i, align 8, !noalias !43
  store double %.2442.2.peel.i, ptr %sunkaddr112.i, align 8, !noalias !43
  %.2651.peel.i = icmp slt i64 %.1723.1.peel.i, 0
  %.2652.peel.i = select i1 %.2651.peel.i, i64 %arg.room.5.1, i64 0
  %.2653.peel.i = add i64 %.2652.peel.i, %.1723.1.peel.i
  %.2673.peel.i = mul i64 %.2653.peel.i, %arg.room.5.2
  %35 = getelementptr double, ptr %arg.room.4, i64 %.2673.peel.i
  %.2706.peel.i = icmp slt i64 %.1765.1.peel.i, 0
  %.2707.peel.i = select i1 %.2706.peel.i, i64 %arg.room.5.1, i64 0
  %.2708.peel.i = add i64 %.2707.peel.i, %.1765.1.peel.i
  %.2728.peel.i = mul i64 %.2708.peel.i, %arg.room.5.2
  %36 = getelementptr double, ptr %arg.room.4, i64 %.2728.peel.i
  %.2678.peel.i = load double, ptr %35, align 8, !noalias !43
  %.2733.peel.i = load double, ptr %36, align 8, !noalias !43
  %.2737.peel.i = fmul double %.1621.peel.i, %.2678.peel.i
  %.2739.peel.i = fmul double %.1622.peel.i, %.2733.peel.i
  %.2740.peel.i = fadd double %.2737.peel.i, %.2739.peel.i
  %.2742.peel.i = fmul double %.1621.peel.i, %.2733.peel.i
  %.2744.peel.i = fmul double %.1622.peel.i, %.2678.peel.i
  %.2745.peel.i = fsub double %.2742.peel.i, %.2744.peel.i
  store double %.2740.peel.i, ptr %35, align 8, !noalias !43
  store double %.2745.peel.i, ptr %36, align 8, !noalias !43
  %.2677.1.peel.i = getelementptr i8, ptr %35, i64 8
  %.2678.1.peel.i = load double, ptr %.2677.1.peel.i, align 8, !noalias !43
  %.2732.1.peel.i = getelementptr i8, ptr %36, i64 8
  %.2733.1.peel.i = load double, ptr %.2732.1.peel.i, align 8, !noalias !43
  %.2737.1.peel.i = fmul double %.1621.peel.i, %.2678.1.peel.i
  %.2739.1.peel.i = fmul double %.1622.peel.i, %.2733.1.peel.i
  %.2740.1.peel.i = fadd double %.2737.1.peel.i, %.2739.1.peel.i
  %.2742.1.peel.i = fmul double %.1621.peel.i, %.2733.1.peel.i
  %.2744.1.peel.i = fmul double %.1622.peel.i, %.2678.1.peel.i
  %.2745.1.peel.i = fsub double %.2742.1.peel.i, %.2744.1.peel.i
  store double %.2740.1.peel.i, ptr %.2677.1.peel.i, align 8, !noalias !43
  store double %.2745.1.peel.i, ptr %.2732.1.peel.i, align 8, !noalias !43
  %.2677.2.peel.i = getelementptr i8, ptr %35, i64 16
  %.2678.2.peel.i = load double, ptr %.2677.2.peel.i, align 8, !noalias !43
  %.2732.2.peel.i = getelementptr i8, ptr %36, i64 16
  %.2733.2.peel.i = load double, ptr %.2732.2.peel.i, align 8, !noalias !43
  %.2737.2.peel.i = fmul double %.1621.peel.i, %.2678.2.peel.i
  %.2739.2.peel.i = fmul double %.1622.peel.i, %.2733.2.peel.i
  %.2740.2.peel.i = fadd double %.2737.2.peel.i, %.2739.2.peel.i
  %.2742.2.peel.i = fmul double %.1621.peel.i, %.2733.2.peel.i
  %.2744.2.peel.i = fmul double %.1622.peel.i, %.2678.2.peel.i
  %.2745.2.peel.i = fsub double %.2742.2.peel.i, %.2744.2.peel.i
  store double %.2740.2.peel.i, ptr %.2677.2.peel.i, align 8, !noalias !43
  store double %.2745.2.peel.i, ptr %.2732.2.peel.i, align 8, !noalias !43
  br label %B652.endif.2.i

B652.endif.2.i:                                   ; preds = %B652.endif.2.i, %B652.endif.2.peel.next.i
  %lsr.iv60.i = phi i64 [ 5, %B652.endif.2.peel.next.i ], [ %lsr.iv.next61.i, %B652.endif.2.i ]
  %lsr.iv58.i = phi i64 [ %15, %B652.endif.2.peel.next.i ], [ %lsr.iv.next59.i, %B652.endif.2.i ]
  %lsr.iv50.i = phi ptr [ %scevgep49.i, %B652.endif.2.peel.next.i ], [ %scevgep51.i, %B652.endif.2.i ]
  %lsr.iv42.i = phi i64 [ %12, %B652.endif.2.peel.next.i ], [ %lsr.iv.next43.i, %B652.endif.2.i ]
  %lsr.iv35.i = phi i64 [ %8, %B652.endif.2.peel.next.i ], [ %lsr.iv.next36.i, %B652.endif.2.i ]
  %lsr.iv.i = phi i64 [ %3, %B652.endif.2.peel.next.i ], [ %lsr.iv.next.i, %B652.endif.2.i ]
  %before.2.01232.i = phi double [ %.1466.peel.i, %B652.endif.2.peel.next.i ], [ %.1466.i, %B652.endif.2.i ]
  %scevgep55.i = getelementptr i8, ptr %lsr.iv50.i, i64 -48
  %scevgep57.i = getelementptr i8, ptr %lsr.iv50.i, i64 -40
  %.1432.i = load double, ptr %scevgep57.i, align 8, !noalias !43
  %.1449.i = icmp slt i64 %lsr.iv58.i, 0
  %.1450.i = select i1 %.1449.i, i64 %arg.q.5.1, i64 0
  %37 = add i64 %.1450.i, %lsr.iv58.i
  %.1462.i = mul i64 %37, %arg.q.6.1
  %.1464.i = getelementptr i8, ptr %lsr.iv15, i64 %.1462.i
  %.1466.i = load double, ptr %.1464.i, align 8, !noalias !43
  %.1467.i = fmul double %.1432.i, %.1466.i
  %scevgep56.i = getelementptr i8, ptr %lsr.iv50.i, i64 -32
  %.1522.i = load double, ptr %scevgep56.i, align 8, !noalias !43
  %.1523.i = fadd double %.1467.i, %.1522.i
  %.1578.i = load double, ptr %lsr.iv50.i, align 8, !noalias !43
  %.1580.i = fmul double %before.2.01232.i, %.1578.i
  %.1583.i = fsub double %.1523.i, %.1580.i
  %.1621.i = tail call double @llvm.cos.f64(double %.1583.i)
  %.1622.i = tail call double @llvm.sin.f64(double %.1583.i)
  %.1683.i = load double, ptr %scevgep55.i, align 8, !noalias !43
  %.5.i.i = fptosi double %.1683.i to i64
  %.1712.i = add nsw i64 %.5.i.i, 1
  %.1732.i = srem i64 %.1712.i, 3
  %.1734.i = icmp slt i64 %.1732.i, 0
  %.1743.i = add nsw i64 %.1732.i, 3
  %.1723.1.i = select i1 %.1734.i, i64 %.1743.i, i64 %.1732.i
  %.1754.i = add nsw i64 %.5.i.i, 2
  %.1774.i = srem i64 %.1754.i, 3
  %.1776.i = icmp slt i64 %.1774.i, 0
  %.1785.i = add nsw i64 %.1774.i, 3
  %.1765.1.i = select i1 %.1776.i, i64 %.1785.i, i64 %.1774.i
  %scevgep54.i = getelementptr i8, ptr %lsr.iv50.i, i64 -24
  %scevgep53.i = getelementptr i8, ptr %lsr.iv50.i, i64 -16
  %scevgep52.i = getelementptr i8, ptr %lsr.iv50.i, i64 -8
  %.2415.i = icmp slt i64 %.5.i.i, 0
  %.2416.i = select i1 %.2415.i, i64 %arg.room.5.1, i64 0
  %.2417.i = add i64 %.2416.i, %.5.i.i
  %.2437.i = mul i64 %.2417.i, %arg.room.5.2
  %38 = getelementptr double, ptr %arg.room.4, i64 %.2437.i
  %scevgep33.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv.i
  %scevgep34.i = getelementptr i8, ptr %scevgep33.i, i64 -16
  %.1999.i = load double, ptr %scevgep34.i, align 8, !noalias !43
  %.2055.i = load double, ptr %arg.room.4, align 8, !noalias !43
  %.2110.i = load double, ptr %scevgep54.i, align 8, !noalias !43
  %.2111.i = fmul double %.2055.i, %.2110.i
  %.2112.i = fadd double %.1999.i, %.2111.i
  %.2166.i = load double, ptr %sunkaddr134.i, align 8, !noalias !43
  %.2221.i = load double, ptr %scevgep53.i, align 8, !noalias !43
  %.2222.i = fmul double %.2166.i, %.2221.i
  %.2223.i = fadd double %.2112.i, %.2222.i
  %.2277.i = load double, ptr %2, align 8, !noalias !43
  %.2332.i = load double, ptr %scevgep52.i, align 8, !noalias !43
  %.2333.i = fmul double %.2277.i, %.2332.i
  %.2334.i = fadd double %.2223.i, %.2333.i
  %scevgep37.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv35.i
  %scevgep38.i = getelementptr i8, ptr %scevgep37.i, i64 -16
  store double %.2334.i, ptr %scevgep38.i, align 8, !noalias !43
  %.2442.i = load double, ptr %38, align 8, !noalias !43
  %scevgep44.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv42.i
  %scevgep45.i = getelementptr i8, ptr %scevgep44.i, i64 -16
  store double %.2442.i, ptr %scevgep45.i, align 8, !noalias !43
  %scevgep62.i = getelementptr i8, ptr %scevgep33.i, i64 -8
  %.1999.1.i = load double, ptr %scevgep62.i, align 8, !noalias !43
  %.2055.1.i = load double, ptr %.2054.1.i, align 8, !noalias !43
  %.2110.1.i = load double, ptr %scevgep54.i, align 8, !noalias !43
  %.2111.1.i = fmul double %.2055.1.i, %.2110.1.i
  %.2112.1.i = fadd double %.1999.1.i, %.2111.1.i
  %.2166.1.i = load double, ptr %sunkaddr139.i, align 8, !noalias !43
  %.2221.1.i = load double, ptr %scevgep53.i, align 8, !noalias !43
  %.2222.1.i = fmul double %.2166.1.i, %.2221.1.i
  %.2223.1.i = fadd double %.2112.1.i, %.2222.1.i
  %.2277.1.i = load double, ptr %.2276.1.i, align 8, !noalias !43
  %.2332.1.i = load double, ptr %scevgep52.i, align 8, !noalias !43
  %.2333.1.i = fmul double %.2277.1.i, %.2332.1.i
  %.2334.1.i = fadd double %.2223.1.i, %.2333.1.i
  %scevgep60.i = getelementptr i8, ptr %scevgep37.i, i64 -8
  store double %.2334.1.i, ptr %scevgep60.i, align 8, !noalias !43
  %.2441.1.i = getelementptr i8, ptr %38, i64 8
  %.2442.1.i = load double, ptr %.2441.1.i, align 8, !noalias !43
  %scevgep58.i = getelementptr i8, ptr %scevgep44.i, i64 -8
  store double %.2442.1.i, ptr %scevgep58.i, align 8, !noalias !43
  %.1999.2.i = load double, ptr %scevgep33.i, align 8, !noalias !43
  %.2055.2.i = load double, ptr %invariant.gep1178.2.i, align 8, !noalias !43
  %.2110.2.i = load double, ptr %scevgep54.i, align 8, !noalias !43
  %.2111.2.i = fmul double %.2055.2.i, %.2110.2.i
  %.2112.2.i = fadd double %.1999.2.i, %.2111.2.i
  %.2166.2.i = load double, ptr %sunkaddr145.i, align 8, !noalias !43
  %.2221.2.i = load double, ptr %scevgep53.i, align 8, !noalias !43
  %.2222.2.i = fmul double %.2166.2.i, %.2221.2.i
  %.2223.2.i = fadd double %.2112.2.i, %.2222.2.i
  %.2277.2.i = load double, ptr %.2276.2.i, align 8, !noalias !43
  %.2332.2.i = load double, ptr %scevgep52.i, align 8, !noalias !43
  %.2333.2.i = fmul double %.2277.2.i, %.2332.2.i
  %.2334.2.i = fadd double %.2223.2.i, %.2333.2.i
  store double %.2334.2.i, ptr %scevgep37.i, align 8, !noalias !43
  %.2441.2.i = getelementptr i8, ptr %38, i64 16
  %.2442.2.i = load double, ptr %.2441.2.i, align 8, !noalias !43
  store double %.2442.2.i, ptr %scevgep44.i, align 8, !noalias !43
  %.2651.i = icmp slt i64 %.1723.1.i, 0
  %.2652.i = select i1 %.2651.i, i64 %arg.room.5.1, i64 0
  %.2653.i = add i64 %.2652.i, %.1723.1.i
  %.2673.i = mul i64 %.2653.i, %arg.room.5.2
  %39 = getelementptr double, ptr %arg.room.4, i64 %.2673.i
  %.2706.i = icmp slt i64 %.1765.1.i, 0
  %.2707.i = select i1 %.2706.i, i64 %arg.room.5.1, i64 0
  %.2708.i = add i64 %.2707.i, %.1765.1.i
  %.2728.i = mul i64 %.2708.i, %arg.room.5.2
  %40 = getelementptr double, ptr %arg.room.4, i64 %.2728.i
  %.2678.i = load double, ptr %39, align 8, !noalias !43
  %.2733.i = load double, ptr %40, align 8, !noalias !43
  %.2737.i = fmul double %.1621.i, %.2678.i
  %.2739.i = fmul double %.1622.i, %.2733.i
  %.2740.i = fadd double %.2737.i, %.2739.i
  %.2742.i = fmul double %.1621.i, %.2733.i
  %.2744.i = fmul double %.1622.i, %.2678.i
  %.2745.i = fsub double %.2742.i, %.2744.i
  store double %.2740.i, ptr %39, align 8, !noalias !43
  store double %.2745.i, ptr %40, align 8, !noalias !43
  %.2677.1.i = getelementptr i8, ptr %39, i64 8
  %.2678.1.i = load double, ptr %.2677.1.i, align 8, !noalias !43
  %.2732.1.i = getelementptr i8, ptr %40, i64 8
  %.2733.1.i = load double, ptr %.2732.1.i, align 8, !noalias !43
  %.2737.1.i = fmul double %.1621.i, %.2678.1.i
  %.2739.1.i = fmul double %.1622.i, %.2733.1.i
  %.2740.1.i = fadd double %.2737.1.i, %.2739.1.i
  %.2742.1.i = fmul double %.1621.i, %.2733.1.i
  %.2744.1.i = fmul double %.1622.i, %.2678.1.i
  %.2745.1.i = fsub double %.2742.1.i, %.2744.1.i
  store double %.2740.1.i, ptr %.2677.1.i, align 8, !noalias !43
  store double %.2745.1.i, ptr %.2732.1.i, align 8, !noalias !43
  %.2677.2.i = getelementptr i8, ptr %39, i64 16
  %.2678.2.i = load double, ptr %.2677.2.i, align 8, !noalias !43
  %.2732.2.i = getelementptr i8, ptr %40, i64 16
  %.2733.2.i = load double, ptr %.2732.2.i, align 8, !noalias !43
  %.2737.2.i = fmul double %.1621.i, %.2678.2.i
  %.2739.2.i = fmul double %.1622.i, %.2733.2.i
  %.2740.2.i = fadd double %.2737.2.i, %.2739.2.i
  %.2742.2.i = fmul double %.1621.i, %.2733.2.i
  %.2744.2.i = fmul double %.1622.i, %.2678.2.i
  %.2745.2.i = fsub double %.2742.2.i, %.2744.2.i
  store double %.2740.2.i, ptr %.2677.2.i, align 8, !noalias !43
  store double %.2745.2.i, ptr %.2732.2.i, align 8, !noalias !43
  %lsr.iv.next.i = add i64 %lsr.iv.i, %4
  %lsr.iv.next36.i = add i64 %lsr.iv35.i, %4
  %lsr.iv.next43.i = add i64 %lsr.iv42.i, %4
  %scevgep51.i = getelementptr i8, ptr %lsr.iv50.i, i64 %13
  %lsr.iv.next59.i = add i64 %lsr.iv58.i, 1
  %lsr.iv.next61.i = add nsw i64 %lsr.iv60.i, -1
  %exitcond1259.not.i = icmp eq i64 %lsr.iv.next61.i, 0
  br i1 %exitcond1259.not.i, label %part.0, label %B652.endif.2.i, !llvm.loop !46

part.0: ; preds = %B652.endif.2.i
  %.3072.i = load double, ptr %16, align 8, !noalias !43
  %.3126.i = load double, ptr %arg.room.4, align 8, !noalias !43
  %.3180.i = load double, ptr %.3178.i, align 8, !noalias !43
  %.3181.i = fmul double %.3126.i, %.3180.i
  %.3182.i = fadd double %.3072.i, %.3181.i
  %.3236.i = load double, ptr %sunkaddr134.i, align 8, !noalias !43
  %.3290.i = load double, ptr %.3288.i, align 8, !noalias !43
  %.3291.i = fmul double %.3236.i, %.3290.i
  %.3292.i = fadd double %.3182.i, %.3291.i
  %.3346.i = load double, ptr %2, align 8, !noalias !43
  %.3400.i = load double, ptr %.3398.i, align 8, !noalias !43
  %.3401.i = fmul double %.3346.i, %.3400.i
  %.3402.i = fadd double %.3292.i, %.3401.i
  store double %.3402.i, ptr %19, align 8, !noalias !43
  %.3072.1.i = load double, ptr %.3071.1.i, align 8, !noalias !43
  %.3126.1.i = load double, ptr %.2054.1.i, align 8, !noalias !43
  %.3180.1.i = load double, ptr %.3178.i, align 8, !noalias !43
  %.3181.1.i = fmul double %.3126.1.i, %.3180.1.i
  %.3182.1.i = fadd double %.3072.1.i, %.3181.1.i
  %.3236.1.i = load double, ptr %sunkaddr139.i, align 8, !noalias !43
  %.3290.1.i = load double, ptr %.3288.i, align 8, !noalias !43
  %.3291.1.i = fmul double %.3236.1.i, %.3290.1.i
  %.3292.1.i = fadd double %.3182.1.i, %.3291.1.i
  %.3346.1.i = load double, ptr %.2276.1.i, align 8, !noalias !43
  %.3400.1.i = load double, ptr %.3398.i, align 8, !noalias !43
  %.3401.1.i = fmul double %.3346.1.i, %.3400.1.i
  %.3402.1.i = fadd double %.3292.1.i, %.3401.1.i
  store double %.3402.1.i, ptr %.3455.1.i, align 8, !noalias !43
  %.3072.2.i = load double, ptr %.3071.2.i, align 8, !noalias !43
  %.3126.2.i = load double, ptr %invariant.gep1178.2.i, align 8, !noalias !43
  %.3180.2.i = load double, ptr %.3178.i, align 8, !noalias !43
  %.3181.2.i = fmul double %.3126.2.i, %.3180.2.i
  %.3182.2.i = fadd double %.3072.2.i, %.3181.2.i
  %.3236.2.i = load double, ptr %sunkaddr145.i, align 8, !noalias !43
  %.3290.2.i = load double, ptr %.3288.i, align 8, !noalias !43
  %.3291.2.i = fmul double %.3236.2.i, %.3290.2.i
  %.3292.2.i = fadd double %.3182.2.i, %.3291.2.i
  %.3346.2.i = load double, ptr %.2276.2.i, align 8, !noalias !43
  %.3400.2.i = load double, ptr %.3398.i, align 8, !noalias !43
  %.3401.2.i = fmul double %.3346.2.i, %.3400.2.i
  %.3402.2.i = fadd double %.3292.2.i, %.3401.2.i
  store double %.3402.2.i, ptr %.3455.2.i, align 8, !noalias !43
  %41 = getelementptr double, ptr %lsr.iv, i64 %arg.out.5.2
  store double 0.000000e+00, ptr %lsr.iv, align 8, !noalias !47
  store double 0.000000e+00, ptr %41, align 8, !noalias !47
  %.625.us.i = getelementptr i8, ptr %lsr.iv, i64 24
  store double 0.000000e+00, ptr %.625.us.i, align 8, !noalias !47
  %.681.us.i = getelementptr i8, ptr %41, i64 24
  store double 0.000000e+00, ptr %.681.us.i, align 8, !noalias !47
  br i1 %.7631553.i, label %B206.us.i, label %B104.endif.preheader.i

B104.endif.preheader.i:                           ; preds = %part.0
  %.514.1.i = getelementptr i8, ptr %lsr.iv, i64 8
  store double 0.000000e+00, ptr %.514.1.i, align 8, !noalias !47
  %.569.1.i = getelementptr i8, ptr %41, i64 8
  store double 0.000000e+00, ptr %.569.1.i, align 8, !noalias !47
  %.625.1.i = getelementptr i8, ptr %lsr.iv, i64 32
  store double 0.000000e+00, ptr %.625.1.i, align 8, !noalias !47
  %.681.1.i1 = getelementptr i8, ptr %41, i64 32
  store double 0.000000e+00, ptr %.681.1.i1, align 8, !noalias !47
  %.514.2.i = getelementptr i8, ptr %lsr.iv, i64 16
  store double 0.000000e+00, ptr %.514.2.i, align 8, !noalias !47
  %.569.2.i = getelementptr i8, ptr %41, i64 16
  store double 0.000000e+00, ptr %.569.2.i, align 8, !noalias !47
  %.625.2.i = getelementptr i8, ptr %lsr.iv, i64 40
  store double 0.000000e+00, ptr %.625.2.i, align 8, !noalias !47
  %.681.2.i2 = getelementptr i8, ptr %41, i64 40
  store double 0.000000e+00, ptr %.681.2.i2, align 8, !noalias !47
  br label %B352.else.endif.i

B206.us.i:                                        ; preds = %part.0, %B206.us.i
  %lsr.iv45.i = phi i64 [ %lsr.iv.next46.i, %B206.us.i ], [ %..335.i, %part.0 ]
  %lsr.iv43.i = phi ptr [ %scevgep44.i10, %B206.us.i ], [ %arg.ride.4, %part.0 ]
  %lsr.iv41.i = phi ptr [ %scevgep42.i, %B206.us.i ], [ %lsr.iv13, %part.0 ]
  %lsr.iv39.i = phi ptr [ %scevgep40.i, %B206.us.i ], [ %lsr.iv11, %part.0 ]
  %.855.us.i = load double, ptr %lsr.iv, align 8, !noalias !47
  %.908.us.i6 = load double, ptr %lsr.iv43.i, align 8, !noalias !47
  %.941.us.i7 = load double, ptr %lsr.iv41.i, align 8, !noalias !47
  %.942.us.i8 = fmul double %.908.us.i6, %.941.us.i7
  %.943.us.i9 = fadd double %.855.us.i, %.942.us.i8
  store double %.943.us.i9, ptr %lsr.iv, align 8, !noalias !47
  %.1050.us.i = load double, ptr %41, align 8, !noalias !47
  %.1103.us.i = load double, ptr %lsr.iv43.i, align 8, !noalias !47
  %.1136.us.i = load double, ptr %lsr.iv39.i, align 8, !noalias !47
  %.1137.us.i = fmul double %.1103.us.i, %.1136.us.i
  %.1138.us.i = fadd double %.1050.us.i, %.1137.us.i
  store double %.1138.us.i, ptr %41, align 8, !noalias !47
  %scevgep40.i = getelementptr i8, ptr %lsr.iv39.i, i64 %arg.qdd.6.1
  %scevgep42.i = getelementptr i8, ptr %lsr.iv41.i, i64 %arg.qd.6.1
  %scevgep44.i10 = getelementptr i8, ptr %lsr.iv43.i, i64 %arg.ride.6.0
  %lsr.iv.next46.i = add nsw i64 %lsr.iv45.i, -1
  %exitcond.not.i = icmp eq i64 %lsr.iv.next46.i, 0
  br i1 %exitcond.not.i, label %B204.B350_crit_edge.us.i, label %B206.us.i

B204.B350_crit_edge.us.i:                         ; preds = %B206.us.i
  %.514.us.1.i = getelementptr i8, ptr %lsr.iv, i64 8
  store double 0.000000e+00, ptr %.514.us.1.i, align 8, !noalias !47
  %.569.us.1.i = getelementptr i8, ptr %41, i64 8
  store double 0.000000e+00, ptr %.569.us.1.i, align 8, !noalias !47
  %.625.us.1.i = getelementptr i8, ptr %lsr.iv, i64 32
  store double 0.000000e+00, ptr %.625.us.1.i, align 8, !noalias !47
  %.681.us.1.i11 = getelementptr i8, ptr %41, i64 32
  store double 0.000000e+00, ptr %.681.us.1.i11, align 8, !noalias !47
  br i1 %lcmp.mod.not.i13, label %B206.us.1.prol.loopexit.i, label %B206.us.1.prol.i

B206.us.1.prol.i:                                 ; preds = %B204.B350_crit_edge.us.i
  %.855.us.1.prol.i = load double, ptr %.514.us.1.i, align 8, !noalias !47
  %.908.us.1.prol.i = load double, ptr %invariant.gep.us.1.i, align 8, !noalias !47
  %.941.us.1.prol.i = load double, ptr %lsr.iv13, align 8, !noalias !47
  %.942.us.1.prol.i = fmul double %.908.us.1.prol.i, %.941.us.1.prol.i
  %.943.us.1.prol.i = fadd double %.855.us.1.prol.i, %.942.us.1.prol.i
  store double %.943.us.1.prol.i, ptr %.514.us.1.i, align 8, !noalias !47
  %.1050.us.1.prol.i = load double, ptr %.569.us.1.i, align 8, !noalias !47
  %.1103.us.1.prol.i = load double, ptr %invariant.gep.us.1.i, align 8, !noalias !47
  %.1136.us.1.prol.i = load double, ptr %lsr.iv11, align 8, !noalias !47
  %.1137.us.1.prol.i = fmul double %.1103.us.1.prol.i, %.1136.us.1.prol.i
  %.1138.us.1.prol.i = fadd double %.1050.us.1.prol.i, %.1137.us.1.prol.i
  store double %.1138.us.1.prol.i, ptr %.569.us.1.i, align 8, !noalias !47
  %scevgep32.prol.i = getelementptr i8, ptr %lsr.iv11, i64 %arg.qdd.6.1
  %scevgep34.prol.i = getelementptr i8, ptr %lsr.iv13, i64 %arg.qd.6.1
  br label %B206.us.1.prol.loopexit.i

B206.us.1.prol.loopexit.i:                        ; preds = %B206.us.1.prol.i, %B204.B350_crit_edge.us.i
  %lsr.iv37.unr.i = phi i64 [ %..335.i, %B204.B350_crit_edge.us.i ], [ %31, %B206.us.1.prol.i ]
  %lsr.iv35.unr.i = phi ptr [ %invariant.gep.us.1.i, %B204.B350_crit_edge.us.i ], [ %scevgep36.prol.i, %B206.us.1.prol.i ]
  %lsr.iv33.unr.i = phi ptr [ %lsr.iv13, %B204.B350_crit_edge.us.i ], [ %scevgep34.prol.i, %B206.us.1.prol.i ]
  %lsr.iv31.unr.i = phi ptr [ %lsr.iv11, %B204.B350_crit_edge.us.i ], [ %scevgep32.prol.i, %B206.us.1.prol.i ]
  br i1 %32, label %B204.B350_crit_edge.us.1.thread.i, label %B206.us.1.i

B204.B350_crit_edge.us.1.thread.i:                ; preds = %B206.us.1.prol.loopexit.i
  %.514.us.21.i = getelementptr i8, ptr %lsr.iv, i64 16
  store double 0.000000e+00, ptr %.514.us.21.i, align 8, !noalias !47
  %.569.us.22.i = getelementptr i8, ptr %41, i64 16
  store double 0.000000e+00, ptr %.569.us.22.i, align 8, !noalias !47
  %.625.us.23.i = getelementptr i8, ptr %lsr.iv, i64 40
  store double 0.000000e+00, ptr %.625.us.23.i, align 8, !noalias !47
  %.681.us.24.i = getelementptr i8, ptr %41, i64 40
  store double 0.000000e+00, ptr %.681.us.24.i, align 8, !noalias !47
  br label %B206.us.2.prol.loopexit.i

B206.us.1.i:                                      ; preds = %B206.us.1.prol.loopexit.i, %B206.us.1.i
  %lsr.iv37.i = phi i64 [ %lsr.iv.next38.1.i, %B206.us.1.i ], [ %lsr.iv37.unr.i, %B206.us.1.prol.loopexit.i ]
  %lsr.iv35.i14 = phi ptr [ %scevgep36.1.i, %B206.us.1.i ], [ %lsr.iv35.unr.i, %B206.us.1.prol.loopexit.i ]
  %lsr.iv33.i = phi ptr [ %scevgep34.1.i, %B206.us.1.i ], [ %lsr.iv33.unr.i, %B206.us.1.prol.loopexit.i ]
  %lsr.iv31.i = phi ptr [ %scevgep32.1.i, %B206.us.1.i ], [ %lsr.iv31.unr.i, %B206.us.1.prol.loopexit.i ]
  %.855.us.1.i = load double, ptr %.514.us.1.i, align 8, !noalias !47
  %.908.us.1.i15 = load double, ptr %lsr.iv35.i14, align 8, !noalias !47
  %.941.us.1.i16 = load double, ptr %lsr.iv33.i, align 8, !noalias !47
  %.942.us.1.i17 = fmul double %.908.us.1.i15, %.941.us.1.i16
  %.943.us.1.i18 = fadd double %.855.us.1.i, %.942.us.1.i17
  store double %.943.us.1.i18, ptr %.514.us.1.i, align 8, !noalias !47
  %.1050.us.1.i = load double, ptr %.569.us.1.i, align 8, !noalias !47
  %.1103.us.1.i = load double, ptr %lsr.iv35.i14, align 8, !noalias !47
  %.1136.us.1.i = load double, ptr %lsr.iv31.i, align 8, !noalias !47
  %.1137.us.1.i = fmul double %.1103.us.1.i, %.1136.us.1.i
  %.1138.us.1.i = fadd double %.1050.us.1.i, %.1137.us.1.i
  store double %.1138.us.1.i, ptr %.569.us.1.i, align 8, !noalias !47
  %scevgep32.i = getelementptr i8, ptr %lsr.iv31.i, i64 %arg.qdd.6.1
  %scevgep34.i19 = getelementptr i8, ptr %lsr.iv33.i, i64 %arg.qd.6.1
  %scevgep36.i = getelementptr i8, ptr %lsr.iv35.i14, i64 %arg.ride.6.0
  %.855.us.1.1.i = load double, ptr %.514.us.1.i, align 8, !noalias !47
  %.908.us.1.1.i20 = load double, ptr %scevgep36.i, align 8, !noalias !47
  %.941.us.1.1.i21 = load double, ptr %scevgep34.i19, align 8, !noalias !47
  %.942.us.1.1.i22 = fmul double %.908.us.1.1.i20, %.941.us.1.1.i21
  %.943.us.1.1.i23 = fadd double %.855.us.1.1.i, %.942.us.1.1.i22
  store double %.943.us.1.1.i23, ptr %.514.us.1.i, align 8, !noalias !47
  %.1050.us.1.1.i = load double, ptr %.569.us.1.i, align 8, !noalias !47
  %.1103.us.1.1.i = load double, ptr %scevgep36.i, align 8, !noalias !47
  %.1136.us.1.1.i = load double, ptr %scevgep32.i, align 8, !noalias !47
  %.1137.us.1.1.i = fmul double %.1103.us.1.1.i, %.1136.us.1.1.i
  %.1138.us.1.1.i = fadd double %.1050.us.1.1.i, %.1137.us.1.1.i
  store double %.1138.us.1.1.i, ptr %.569.us.1.i, align 8, !noalias !47
  %scevgep32.1.i = getelementptr i8, ptr %scevgep32.i, i64 %arg.qdd.6.1
  %scevgep34.1.i = getelementptr i8, ptr %scevgep34.i19, i64 %arg.qd.6.1
  %scevgep36.1.i = getelementptr i8, ptr %scevgep36.i, i64 %arg.ride.6.0
  %lsr.iv.next38.1.i = add nsw i64 %lsr.iv37.i, -2
  %exitcond.1.not.1.i = icmp eq i64 %lsr.iv.next38.1.i, 0
  br i1 %exitcond.1.not.1.i, label %B204.B350_crit_edge.us.1.i, label %B206.us.1.i

B204.B350_crit_edge.us.1.i:                       ; preds = %B206.us.1.i
  %.514.us.2.i = getelementptr i8, ptr %lsr.iv, i64 16
  store double 0.000000e+00, ptr %.514.us.2.i, align 8, !noalias !47
  %.569.us.2.i = getelementptr i8, ptr %41, i64 16
  store double 0.000000e+00, ptr %.569.us.2.i, align 8, !noalias !47
  %.625.us.2.i = getelementptr i8, ptr %lsr.iv, i64 40
  store double 0.000000e+00, ptr %.625.us.2.i, align 8, !noalias !47
  %.681.us.2.i24 = getelementptr i8, ptr %41, i64 40
  store double 0.000000e+00, ptr %.681.us.2.i24, align 8, !noalias !47
  br i1 %lcmp.mod.not.i13, label %B206.us.2.preheader.i, label %B206.us.2.prol.loopexit.i

B206.us.2.prol.loopexit.i:                        ; preds = %B204.B350_crit_edge.us.1.i, %B204.B350_crit_edge.us.1.thread.i
  %.569.us.29.i = phi ptr [ %.569.us.22.i, %B204.B350_crit_edge.us.1.thread.i ], [ %.569.us.2.i, %B204.B350_crit_edge.us.1.i ]
  %.514.us.27.i = phi ptr [ %.514.us.21.i, %B204.B350_crit_edge.us.1.thread.i ], [ %.514.us.2.i, %B204.B350_crit_edge.us.1.i ]
  %.855.us.2.prol.i = load double, ptr %.514.us.27.i, align 8, !noalias !47
  %.908.us.2.prol.i = load double, ptr %invariant.gep.us.2.i, align 8, !noalias !47
  %.941.us.2.prol.i = load double, ptr %lsr.iv13, align 8, !noalias !47
  %.942.us.2.prol.i = fmul double %.908.us.2.prol.i, %.941.us.2.prol.i
  %.943.us.2.prol.i = fadd double %.855.us.2.prol.i, %.942.us.2.prol.i
  store double %.943.us.2.prol.i, ptr %.514.us.27.i, align 8, !noalias !47
  %.1050.us.2.prol.i = load double, ptr %.569.us.29.i, align 8, !noalias !47
  %.1103.us.2.prol.i = load double, ptr %invariant.gep.us.2.i, align 8, !noalias !47
  %.1136.us.2.prol.i = load double, ptr %lsr.iv11, align 8, !noalias !47
  %.1137.us.2.prol.i = fmul double %.1103.us.2.prol.i, %.1136.us.2.prol.i
  %.1138.us.2.prol.i = fadd double %.1050.us.2.prol.i, %.1137.us.2.prol.i
  store double %.1138.us.2.prol.i, ptr %.569.us.29.i, align 8, !noalias !47
  %scevgep24.prol.i = getelementptr i8, ptr %lsr.iv11, i64 %arg.qdd.6.1
  %scevgep26.prol.i = getelementptr i8, ptr %lsr.iv13, i64 %arg.qd.6.1
  br i1 %32, label %B352.else.endif.i, label %B206.us.2.preheader.i

B206.us.2.preheader.i:                            ; preds = %B206.us.2.prol.loopexit.i, %B204.B350_crit_edge.us.1.i
  %lsr.iv23.unr23.i = phi ptr [ %scevgep24.prol.i, %B206.us.2.prol.loopexit.i ], [ %lsr.iv11, %B204.B350_crit_edge.us.1.i ]
  %lsr.iv25.unr22.i = phi ptr [ %scevgep26.prol.i, %B206.us.2.prol.loopexit.i ], [ %lsr.iv13, %B204.B350_crit_edge.us.1.i ]
  %lsr.iv27.unr21.i = phi ptr [ %scevgep28.prol.i, %B206.us.2.prol.loopexit.i ], [ %invariant.gep.us.2.i, %B204.B350_crit_edge.us.1.i ]
  %lsr.iv29.unr20.i = phi i64 [ %31, %B206.us.2.prol.loopexit.i ], [ %..335.i, %B204.B350_crit_edge.us.1.i ]
  %.514.us.2819.i = phi ptr [ %.514.us.27.i, %B206.us.2.prol.loopexit.i ], [ %.514.us.2.i, %B204.B350_crit_edge.us.1.i ]
  %.569.us.21018.i = phi ptr [ %.569.us.29.i, %B206.us.2.prol.loopexit.i ], [ %.569.us.2.i, %B204.B350_crit_edge.us.1.i ]
  br label %B206.us.2.i

B206.us.2.i:                                      ; preds = %B206.us.2.i, %B206.us.2.preheader.i
  %lsr.iv29.i = phi i64 [ %lsr.iv.next30.1.i, %B206.us.2.i ], [ %lsr.iv29.unr20.i, %B206.us.2.preheader.i ]
  %lsr.iv27.i = phi ptr [ %scevgep28.1.i, %B206.us.2.i ], [ %lsr.iv27.unr21.i, %B206.us.2.preheader.i ]
  %lsr.iv25.i = phi ptr [ %scevgep26.1.i, %B206.us.2.i ], [ %lsr.iv25.unr22.i, %B206.us.2.preheader.i ]
  %lsr.iv23.i = phi ptr [ %scevgep24.1.i, %B206.us.2.i ], [ %lsr.iv23.unr23.i, %B206.us.2.preheader.i ]
  %.855.us.2.i = load double, ptr %.514.us.2819.i, align 8, !noalias !47
  %.908.us.2.i27 = load double, ptr %lsr.iv27.i, align 8, !noalias !47
  %.941.us.2.i28 = load double, ptr %lsr.iv25.i, align 8, !noalias !47
  %.942.us.2.i29 = fmul double %.908.us.2.i27, %.941.us.2.i28
  %.943.us.2.i30 = fadd double %.855.us.2.i, %.942.us.2.i29
  store double %.943.us.2.i30, ptr %.514.us.2819.i, align 8, !noalias !47
  %.1050.us.2.i = load double, ptr %.569.us.21018.i, align 8, !noalias !47
  %.1103.us.2.i = load double, ptr %lsr.iv27.i, align 8, !noalias !47
  %.1136.us.2.i = load double, ptr %lsr.iv23.i, align 8, !noalias !47
  %.1137.us.2.i = fmul double %.1103.us.2.i, %.1136.us.2.i
  %.1138.us.2.i = fadd double %.1050.us.2.i, %.1137.us.2.i
  store double %.1138.us.2.i, ptr %.569.us.21018.i, align 8, !noalias !47
  %scevgep24.i = getelementptr i8, ptr %lsr.iv23.i, i64 %arg.qdd.6.1
  %scevgep26.i = getelementptr i8, ptr %lsr.iv25.i, i64 %arg.qd.6.1
  %scevgep28.i = getelementptr i8, ptr %lsr.iv27.i, i64 %arg.ride.6.0
  %.855.us.2.1.i = load double, ptr %.514.us.2819.i, align 8, !noalias !47
  %.908.us.2.1.i31 = load double, ptr %scevgep28.i, align 8, !noalias !47
  %.941.us.2.1.i32 = load double, ptr %scevgep26.i, align 8, !noalias !47
  %.942.us.2.1.i33 = fmul double %.908.us.2.1.i31, %.941.us.2.1.i32
  %.943.us.2.1.i34 = fadd double %.855.us.2.1.i, %.942.us.2.1.i33
  store double %.943.us.2.1.i34, ptr %.514.us.2819.i, align 8, !noalias !47
  %.1050.us.2.1.i = load double, ptr %.569.us.21018.i, align 8, !noalias !47
  %.1103.us.2.1.i = load double, ptr %scevgep28.i, align 8, !noalias !47
  %.1136.us.2.1.i = load double, ptr %scevgep24.i, align 8, !noalias !47
  %.1137.us.2.1.i = fmul double %.1103.us.2.1.i, %.1136.us.2.1.i
  %.1138.us.2.1.i = fadd double %.1050.us.2.1.i, %.1137.us.2.1.i
  store double %.1138.us.2.1.i, ptr %.569.us.21018.i, align 8, !noalias !47
  %scevgep24.1.i = getelementptr i8, ptr %scevgep24.i, i64 %arg.qdd.6.1
  %scevgep26.1.i = getelementptr i8, ptr %scevgep26.i, i64 %arg.qd.6.1
  %scevgep28.1.i = getelementptr i8, ptr %scevgep28.i, i64 %arg.ride.6.0
  %lsr.iv.next30.1.i = add nsw i64 %lsr.iv29.i, -2
  %exitcond.2.not.1.i = icmp eq i64 %lsr.iv.next30.1.i, 0
  br i1 %exitcond.2.not.1.i, label %B352.else.endif.i, label %B206.us.2.i

B352.else.endif.i:                                ; preds = %B206.us.2.i, %B206.us.2.prol.loopexit.i, %B104.endif.preheader.i
  %sunkaddr28.i = getelementptr i8, ptr %41, i64 %sunkaddr27.i
  %sunkaddr30.i = getelementptr i8, ptr %lsr.iv, i64 %sunkaddr27.i
  %sunkaddr31.i = getelementptr i8, ptr %sunkaddr30.i, i64 8
  %sunkaddr34.i = getelementptr i8, ptr %sunkaddr30.i, i64 16
  %sunkaddr37.i = getelementptr i8, ptr %sunkaddr28.i, i64 8
  %sunkaddr42.i = getelementptr i8, ptr %sunkaddr28.i, i64 16
  %sunkaddr43.i = getelementptr i8, ptr %41, i64 8
  %sunkaddr44.i = getelementptr i8, ptr %41, i64 16
  %sunkaddr45.i = getelementptr i8, ptr %lsr.iv, i64 8
  %sunkaddr46.i = getelementptr i8, ptr %lsr.iv, i64 16
  br label %switch.end.2.i

switch.end.2.i:                                   ; preds = %switch.end.2.i, %B352.else.endif.i
  %lsr.iv3.i = phi i64 [ %lsr.iv.next.i5, %switch.end.2.i ], [ -6, %B352.else.endif.i ]
  %lsr.iv14.i = phi ptr [ %scevgep15.i, %switch.end.2.i ], [ %.1577.peel.i, %B352.else.endif.i ]
  %lsr.iv.i3 = phi ptr [ %scevgep2.i, %switch.end.2.i ], [ %invariant.gep1178.2.i, %B352.else.endif.i ]
  %before_2.2.01580.i = phi double [ %.1987.i, %switch.end.2.i ], [ 0.000000e+00, %B352.else.endif.i ]
  %before.2.01579.i = phi double [ %.1840.i, %switch.end.2.i ], [ 0.000000e+00, %B352.else.endif.i ]
  %scevgep16.i = getelementptr i8, ptr %lsr.iv14.i, i64 -40
  %.1807.i = load double, ptr %scevgep16.i, align 8, !noalias !47
  %42 = add i64 %lsr.iv3.i, %arg.qd.5.1
  %.1823.i = icmp slt i64 %42, 0
  %.1824.i = select i1 %.1823.i, i64 %arg.qd.5.1, i64 0
  %43 = add i64 %.1824.i, %42
  %.1836.i = mul i64 %43, %arg.qd.6.1
  %.1838.i = getelementptr i8, ptr %lsr.iv13, i64 %.1836.i
  %.1840.i = load double, ptr %.1838.i, align 8, !noalias !47
  %.1841.i = fmul double %.1807.i, %.1840.i
  %.1895.i = load double, ptr %lsr.iv14.i, align 8, !noalias !47
  %.1897.i = fmul double %before.2.01579.i, %.1895.i
  %.1900.i = fsub double %.1841.i, %.1897.i
  %.1971.i = select i1 %.1823.i, i64 %arg.qdd.5.1, i64 0
  %44 = add i64 %.1971.i, %42
  %.1983.i = mul i64 %44, %arg.qdd.6.1
  %.1985.i = getelementptr i8, ptr %lsr.iv11, i64 %.1983.i
  %.1987.i = load double, ptr %.1985.i, align 8, !noalias !47
  %.1988.i = fmul double %.1807.i, %.1987.i
  %.2044.i = fmul double %before_2.2.01580.i, %.1895.i
  %.2047.i = fsub double %.1988.i, %.2044.i
  %sunkaddr20.i = getelementptr i8, ptr %lsr.iv.i3, i64 %sunkaddr101.i
  %sunkaddr21.i = getelementptr i8, ptr %sunkaddr20.i, i64 -16
  %.2173.i = load double, ptr %sunkaddr21.i, align 8, !noalias !47
  %sunkaddr24.i = getelementptr i8, ptr %sunkaddr20.i, i64 -8
  %.2227.i = load double, ptr %sunkaddr24.i, align 8, !noalias !47
  %.2281.i = load double, ptr %sunkaddr20.i, align 8, !noalias !47
  %.2311.i = load double, ptr %sunkaddr28.i, align 8, !noalias !47
  %.2312.i = fmul double %.2173.i, %.2047.i
  %.2342.i = load double, ptr %sunkaddr31.i, align 8, !noalias !47
  %.2343.i = fmul double %.2281.i, %.2342.i
  %.2373.i = load double, ptr %sunkaddr34.i, align 8, !noalias !47
  %.2374.i = fmul double %.2227.i, %.2373.i
  %.2375.i = fsub double %.2343.i, %.2374.i
  %.2376.i = fmul double %.1900.i, %.2375.i
  %.2377.i = fadd double %.2312.i, %.2376.i
  %.2378.i = fadd double %.2311.i, %.2377.i
  store double %.2378.i, ptr %sunkaddr28.i, align 8, !noalias !47
  %.2438.i = load double, ptr %sunkaddr37.i, align 8, !noalias !47
  %.2439.i = fmul double %.2047.i, %.2227.i
  %.2469.i = load double, ptr %sunkaddr34.i, align 8, !noalias !47
  %.2470.i = fmul double %.2173.i, %.2469.i
  %.2500.i = load double, ptr %sunkaddr30.i, align 8, !noalias !47
  %.2501.i = fmul double %.2281.i, %.2500.i
  %.2502.i = fsub double %.2470.i, %.2501.i
  %.2503.i = fmul double %.1900.i, %.2502.i
  %.2504.i = fadd double %.2439.i, %.2503.i
  %.2505.i = fadd double %.2438.i, %.2504.i
  store double %.2505.i, ptr %sunkaddr37.i, align 8, !noalias !47
  %.2565.i = load double, ptr %sunkaddr42.i, align 8, !noalias !47
  %.2566.i = fmul double %.2047.i, %.2281.i
  %.2596.i = load double, ptr %sunkaddr30.i, align 8, !noalias !47
  %.2597.i = fmul double %.2227.i, %.2596.i
  %.2627.i = load double, ptr %sunkaddr31.i, align 8, !noalias !47
  %.2628.i = fmul double %.2173.i, %.2627.i
  %.2629.i = fsub double %.2597.i, %.2628.i
  %.2630.i = fmul double %.1900.i, %.2629.i
  %.2631.i = fadd double %.2566.i, %.2630.i
  %.2632.i = fadd double %.2565.i, %.2631.i
  store double %.2632.i, ptr %sunkaddr42.i, align 8, !noalias !47
  %.2692.i = load double, ptr %sunkaddr30.i, align 8, !noalias !47
  %.2693.i = fmul double %.1900.i, %.2173.i
  %.2694.i = fadd double %.2693.i, %.2692.i
  store double %.2694.i, ptr %sunkaddr30.i, align 8, !noalias !47
  %.2754.i = load double, ptr %sunkaddr31.i, align 8, !noalias !47
  %.2755.i = fmul double %.1900.i, %.2227.i
  %.2756.i = fadd double %.2755.i, %.2754.i
  store double %.2756.i, ptr %sunkaddr31.i, align 8, !noalias !47
  %.2816.i = load double, ptr %sunkaddr34.i, align 8, !noalias !47
  %.2817.i = fmul double %.1900.i, %.2281.i
  %.2818.i = fadd double %.2817.i, %.2816.i
  store double %.2818.i, ptr %sunkaddr34.i, align 8, !noalias !47
  %scevgep8.i = getelementptr i8, ptr %lsr.iv.i3, i64 %7
  %scevgep11.i = getelementptr i8, ptr %scevgep8.i, i64 -16
  %.2903.i = load double, ptr %scevgep11.i, align 8, !noalias !47
  %scevgep3.i = getelementptr i8, ptr %lsr.iv.i3, i64 %.348.idx.i
  %scevgep4.i = getelementptr i8, ptr %scevgep3.i, i64 -16
  %.2957.i = load double, ptr %scevgep4.i, align 8, !noalias !47
  %.2958.i = fsub double %.2903.i, %.2957.i
  %scevgep10.i = getelementptr i8, ptr %scevgep8.i, i64 -8
  %.3013.i = load double, ptr %scevgep10.i, align 8, !noalias !47
  %scevgep6.i = getelementptr i8, ptr %scevgep3.i, i64 -8
  %.3067.i = load double, ptr %scevgep6.i, align 8, !noalias !47
  %.3068.i = fsub double %.3013.i, %.3067.i
  %.3123.i = load double, ptr %scevgep8.i, align 8, !noalias !47
  %.3177.i = load double, ptr %scevgep3.i, align 8, !noalias !47
  %.3178.i4 = fsub double %.3123.i, %.3177.i
  %.3209.i = fmul double %.2756.i, %.3178.i4
  %.3240.i = fmul double %.2818.i, %.3068.i
  %.3241.i = fsub double %.3209.i, %.3240.i
  %.3272.i = fmul double %.2818.i, %.2958.i
  %.3303.i = fmul double %.2694.i, %.3178.i4
  %.3304.i = fsub double %.3272.i, %.3303.i
  %.3335.i = fmul double %.2694.i, %.3068.i
  %.3366.i = fmul double %.2756.i, %.2958.i
  %.3367.i = fsub double %.3335.i, %.3366.i
  %.3433.i = load double, ptr %41, align 8, !noalias !47
  %.3463.i = load double, ptr %sunkaddr37.i, align 8, !noalias !47
  %.3464.i = fmul double %.3178.i4, %.3463.i
  %.3494.i = load double, ptr %sunkaddr42.i, align 8, !noalias !47
  %.3495.i = fmul double %.3068.i, %.3494.i
  %.3496.i = fsub double %.3464.i, %.3495.i
  %.3529.i = fmul double %.2756.i, %.3367.i
  %.3530.i = fadd double %.3529.i, %.3496.i
  %.3563.i = fmul double %.2818.i, %.3304.i
  %.3564.i = fsub double %.3530.i, %.3563.i
  %.3565.i = fadd double %.3433.i, %.3564.i
  store double %.3565.i, ptr %41, align 8, !noalias !47
  %.3673.i = load double, ptr %sunkaddr43.i, align 8, !noalias !47
  %.3703.i = load double, ptr %sunkaddr42.i, align 8, !noalias !47
  %.3704.i = fmul double %.2958.i, %.3703.i
  %.3734.i = load double, ptr %sunkaddr28.i, align 8, !noalias !47
  %.3735.i = fmul double %.3178.i4, %.3734.i
  %.3736.i = fsub double %.3704.i, %.3735.i
  %.3766.i = load double, ptr %sunkaddr34.i, align 8, !noalias !47
  %.3769.i = fmul double %.3241.i, %.3766.i
  %.3770.i = fadd double %.3736.i, %.3769.i
  %.3800.i = load double, ptr %sunkaddr30.i, align 8, !noalias !47
  %.3803.i = fmul double %.3367.i, %.3800.i
  %.3804.i = fsub double %.3770.i, %.3803.i
  %.3805.i = fadd double %.3673.i, %.3804.i
  store double %.3805.i, ptr %sunkaddr43.i, align 8, !noalias !47
  %.3913.i = load double, ptr %sunkaddr44.i, align 8, !noalias !47
  %.3943.i = load double, ptr %sunkaddr28.i, align 8, !noalias !47
  %.3944.i = fmul double %.3068.i, %.3943.i
  %.3974.i = load double, ptr %sunkaddr37.i, align 8, !noalias !47
  %.3975.i = fmul double %.2958.i, %.3974.i
  %.3976.i = fsub double %.3944.i, %.3975.i
  %.4006.i = load double, ptr %sunkaddr30.i, align 8, !noalias !47
  %.4009.i = fmul double %.3304.i, %.4006.i
  %.4010.i = fadd double %.3976.i, %.4009.i
  %.4040.i = load double, ptr %sunkaddr31.i, align 8, !noalias !47
  %.4043.i = fmul double %.3241.i, %.4040.i
  %.4044.i = fsub double %.4010.i, %.4043.i
  %.4045.i = fadd double %.3913.i, %.4044.i
  store double %.4045.i, ptr %sunkaddr44.i, align 8, !noalias !47
  %.4268.i = load double, ptr %lsr.iv, align 8, !noalias !47
  %.4283.i = fadd double %.3241.i, %.4268.i
  store double %.4283.i, ptr %lsr.iv, align 8, !noalias !47
  %.4268.1.i = load double, ptr %sunkaddr45.i, align 8, !noalias !47
  %.4283.1.i = fadd double %.3304.i, %.4268.1.i
  store double %.4283.1.i, ptr %sunkaddr45.i, align 8, !noalias !47
  %.4268.2.i = load double, ptr %sunkaddr46.i, align 8, !noalias !47
  %.4283.2.i = fadd double %.3367.i, %.4268.2.i
  store double %.4283.2.i, ptr %sunkaddr46.i, align 8, !noalias !47
  %scevgep2.i = getelementptr i8, ptr %lsr.iv.i3, i64 %4
  %scevgep15.i = getelementptr i8, ptr %lsr.iv14.i, i64 %13
  %ov.i = icmp eq i64 %lsr.iv3.i, -1
  %lsr.iv.next.i5 = add nuw nsw i64 %lsr.iv3.i, 1
  br i1 %ov.i, label %part.3, label %switch.end.2.i

part.3: ; preds = %switch.end.2.i
  %scevgep = getelementptr i8, ptr %lsr.iv, i64 %0
  %scevgep12 = getelementptr i8, ptr %lsr.iv11, i64 %arg.qdd.6.0
  %scevgep14 = getelementptr i8, ptr %lsr.iv13, i64 %arg.qd.6.0
  %scevgep16 = getelementptr i8, ptr %lsr.iv15, i64 %arg.q.6.0
  %lsr.iv.next = add nsw i64 %lsr.iv17, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond.not, label %B194, label %B62

B194:                                             ; preds = %part.3, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.follow(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.chain.0, ptr readnone captures(none) %arg.chain.1, i64 %arg.chain.2, i64 %arg.chain.3, ptr readonly captures(none) %arg.chain.4, i64 %arg.chain.5.0, i64 %arg.chain.5.1, i64 %arg.chain.6.0, i64 %arg.chain.6.1, ptr readnone captures(none) %arg.X_WC.0, ptr readnone captures(none) %arg.X_WC.1, i64 %arg.X_WC.2, i64 %arg.X_WC.3, ptr readonly captures(none) %arg.X_WC.4, i64 %arg.X_WC.5.0, i64 %arg.X_WC.5.1, i64 %arg.X_WC.6.0, i64 %arg.X_WC.6.1, ptr readnone captures(none) %arg.ride.0, ptr readnone captures(none) %arg.ride.1, i64 %arg.ride.2, i64 %arg.ride.3, ptr readonly captures(none) %arg.ride.4, i64 %arg.ride.5.0, i64 %arg.ride.5.1, i64 %arg.ride.6.0, i64 %arg.ride.6.1, ptr readnone captures(none) %arg.X_6T.0, ptr readnone captures(none) %arg.X_6T.1, i64 %arg.X_6T.2, i64 %arg.X_6T.3, ptr readonly captures(none) %arg.X_6T.4, i64 %arg.X_6T.5.0, i64 %arg.X_6T.5.1, i64 %arg.X_6T.6.0, i64 %arg.X_6T.6.1, ptr readnone captures(none) %arg.room.0, ptr readnone captures(none) %arg.room.1, i64 %arg.room.2, i64 %arg.room.3, ptr %arg.room.4, i64 %arg.room.5.0, i64 %arg.room.5.1, i64 %arg.room.5.2, i64 %arg.room.6.0, i64 %arg.room.6.1, i64 %arg.room.6.2, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.5.1, i64 %arg.q.6.0, i64 %arg.q.6.1, ptr readnone captures(none) %arg.twist.0, ptr readnone captures(none) %arg.twist.1, i64 %arg.twist.2, i64 %arg.twist.3, ptr readonly captures(none) %arg.twist.4, i64 %arg.twist.5.0, i64 %arg.twist.5.1, i64 %arg.twist.6.0, i64 %arg.twist.6.1, ptr readnone captures(none) %arg.bend.0, ptr readnone captures(none) %arg.bend.1, i64 %arg.bend.2, i64 %arg.bend.3, ptr readonly captures(none) %arg.bend.4, i64 %arg.bend.5.0, i64 %arg.bend.5.1, i64 %arg.bend.6.0, i64 %arg.bend.6.1, ptr readnone captures(none) %arg.rail_rate.0, ptr readnone captures(none) %arg.rail_rate.1, i64 %arg.rail_rate.2, i64 %arg.rail_rate.3, ptr readonly captures(none) %arg.rail_rate.4, i64 %arg.rail_rate.5.0, i64 %arg.rail_rate.5.1, i64 %arg.rail_rate.6.0, i64 %arg.rail_rate.6.1, ptr readnone captures(none) %arg.rail_bend.0, ptr readnone captures(none) %arg.rail_bend.1, i64 %arg.rail_bend.2, i64 %arg.rail_bend.3, ptr readonly captures(none) %arg.rail_bend.4, i64 %arg.rail_bend.5.0, i64 %arg.rail_bend.5.1, i64 %arg.rail_bend.6.0, i64 %arg.rail_bend.6.1, ptr readnone captures(none) %arg.qd.0, ptr readnone captures(none) %arg.qd.1, i64 %arg.qd.2, i64 %arg.qd.3, ptr captures(none) %arg.qd.4, i64 %arg.qd.5.0, i64 %arg.qd.5.1, i64 %arg.qd.6.0, i64 %arg.qd.6.1, ptr readnone captures(none) %arg.qdd.0, ptr readnone captures(none) %arg.qdd.1, i64 %arg.qdd.2, i64 %arg.qdd.3, ptr captures(none) %arg.qdd.4, i64 %arg.qdd.5.0, i64 %arg.qdd.5.1, i64 %arg.qdd.6.0, i64 %arg.qdd.6.1) local_unnamed_addr #0 {
B0.else.endif:
  %.2460 = alloca ptr, align 8
  %.3338 = alloca ptr, align 8
  %.265 = add i64 %arg.q.5.1, -6
  %.336 = icmp slt i64 %arg.room.5.1, 1
  br i1 %.336, label %B0.endif.else.endif, label %B0.else.endif.endif.endif, !prof !50

B182:                                             ; preds = %B846.endif, %B182.lr.ph
  %lsr.iv178 = phi ptr [ %scevgep177, %B182.lr.ph ], [ %scevgep179, %B846.endif ]
  %lsr.iv171 = phi ptr [ %scevgep170, %B182.lr.ph ], [ %scevgep172, %B846.endif ]
  %lsr.iv163 = phi ptr [ %arg.rail_rate.4, %B182.lr.ph ], [ %scevgep164, %B846.endif ]
  %lsr.iv158 = phi ptr [ %arg.rail_bend.4, %B182.lr.ph ], [ %scevgep159, %B846.endif ]
  %lsr.iv152 = phi ptr [ %scevgep151, %B182.lr.ph ], [ %scevgep153, %B846.endif ]
  %lsr.iv146 = phi ptr [ %scevgep145, %B182.lr.ph ], [ %scevgep147, %B846.endif ]
  %lsr.iv136 = phi ptr [ %scevgep135, %B182.lr.ph ], [ %scevgep137, %B846.endif ]
  %lsr.iv = phi ptr [ %scevgep126, %B182.lr.ph ], [ %scevgep127, %B846.endif ]
  %.115211871270 = phi i64 [ 0, %B182.lr.ph ], [ %.1159, %B846.endif ]
  %0 = mul i64 %.115211871270, %arg.rail_rate.6.0
  %scevgep = getelementptr i8, ptr %arg.rail_rate.4, i64 %0
  %1 = mul i64 %.115211871270, %arg.rail_bend.6.0
  %scevgep69 = getelementptr i8, ptr %arg.rail_bend.4, i64 %1
  %.1159 = add nuw nsw i64 %.115211871270, 1
  %.1225 = mul i64 %.115211871270, %arg.q.6.0
  %.1227 = getelementptr i8, ptr %arg.q.4, i64 %.1225
  %.627.us.i = load double, ptr %invariant.gep1184.i, align 8, !noalias !51
  store double %.627.us.i, ptr %.348.i, align 8, !noalias !51
  br i1 %.7631173.i, label %B184.us.preheader.i, label %B120.endif.preheader.i

B184.us.preheader.i:                              ; preds = %B182
  br i1 %132, label %B184.us.epil.preheader.i, label %B184.us.preheader.new.i

B184.us.preheader.new.i:                          ; preds = %B184.us.preheader.i
  br i1 %136, label %B184.us.epil.preheader3.i, label %B184.us.i

B120.endif.preheader.i:                           ; preds = %B182
  %.1170.i = load double, ptr %arg.X_WC.4, align 8, !noalias !51
  store double %.1170.i, ptr %arg.room.4, align 8, !noalias !51
  %.1170.1.i = load double, ptr %.1168.1.i, align 8, !noalias !51
  store double %.1170.1.i, ptr %94, align 8, !noalias !51
  %.1170.2.i = load double, ptr %.1168.2.i, align 8, !noalias !51
  store double %.1170.2.i, ptr %gep1179.2.i, align 8, !noalias !51
  %.627.1.i = load double, ptr %gep1185.1.i, align 8, !noalias !51
  store double %.627.1.i, ptr %sunkaddr130.i, align 8, !noalias !51
  %.1170.11251.i = load double, ptr %131, align 8, !noalias !51
  store double %.1170.11251.i, ptr %.2054.1.i, align 8, !noalias !51
  %.1170.1.1.i = load double, ptr %.1168.1.1.i, align 8, !noalias !51
  store double %.1170.1.1.i, ptr %gep1179.1.1.i, align 8, !noalias !51
  %.1170.2.1.i = load double, ptr %.1168.2.1.i, align 8, !noalias !51
  store double %.1170.2.1.i, ptr %gep1179.2.1.i, align 8, !noalias !51
  %.627.2.i = load double, ptr %gep1185.2.i, align 8, !noalias !51
  br label %B652.endif.2.peel.next.i.sink.split

B184.us.1.i:                                      ; preds = %B182.B258.endif.endif_crit_edge.us.new.i, %B184.us.1.i
  %lsr.iv81.i = phi i64 [ %lsr.iv.next82.i, %B184.us.1.i ], [ %unroll_iter12.i, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %lsr.iv71.i = phi ptr [ %scevgep88.i, %B184.us.1.i ], [ %.1227, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %lsr.iv68.i = phi ptr [ %scevgep85.i, %B184.us.1.i ], [ %invariant.gep.1, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %.9431177.us.1.i = phi double [ %.943.us.1.1.1.i, %B184.us.1.i ], [ %.627.us.1.i, %B182.B258.endif.endif_crit_edge.us.new.i ]
  %.908.us.1.i = load double, ptr %lsr.iv68.i, align 8, !noalias !51
  %.941.us.1.i = load double, ptr %lsr.iv71.i, align 8, !noalias !51
  %.942.us.1.i = fmul double %.908.us.1.i, %.941.us.1.i
  %.943.us.1.i = fadd double %.9431177.us.1.i, %.942.us.1.i
  store double %.943.us.1.i, ptr %sunkaddr130.i, align 8, !noalias !51
  %scevgep70.i = getelementptr i8, ptr %lsr.iv68.i, i64 %arg.ride.6.0
  %.908.us.1.1.i = load double, ptr %scevgep70.i, align 8, !noalias !51
  %scevgep73.i = getelementptr i8, ptr %lsr.iv71.i, i64 %arg.q.6.1
  %.941.us.1.1.i = load double, ptr %scevgep73.i, align 8, !noalias !51
  %.942.us.1.1.i = fmul double %.908.us.1.1.i, %.941.us.1.1.i
  %.943.us.1.1.i = fadd double %.943.us.1.i, %.942.us.1.1.i
  store double %.943.us.1.1.i, ptr %sunkaddr130.i, align 8, !noalias !51
  %scevgep83.i = getelementptr i8, ptr %scevgep70.i, i64 %arg.ride.6.0
  %.908.us.1.134.i = load double, ptr %scevgep83.i, align 8, !noalias !51
  %scevgep86.i = getelementptr i8, ptr %scevgep73.i, i64 %arg.q.6.1
  %.941.us.1.135.i = load double, ptr %scevgep86.i, align 8, !noalias !51
  %.942.us.1.136.i = fmul double %.908.us.1.134.i, %.941.us.1.135.i
  %.943.us.1.137.i = fadd double %.943.us.1.1.i, %.942.us.1.136.i
  store double %.943.us.1.137.i, ptr %sunkaddr130.i, align 8, !noalias !51
  %scevgep84.i = getelementptr i8, ptr %scevgep83.i, i64 %arg.ride.6.0
  %.908.us.1.1.1.i = load double, ptr %scevgep84.i, align 8, !noalias !51
  %scevgep87.i = getelementptr i8, ptr %scevgep86.i, i64 %arg.q.6.1
  %.941.us.1.1.1.i = load double, ptr %scevgep87.i, align 8, !noalias !51
  %.942.us.1.1.1.i = fmul double %.908.us.1.1.1.i, %.941.us.1.1.1.i
  %.943.us.1.1.1.i = fadd double %.943.us.1.137.i, %.942.us.1.1.1.i
  store double %.943.us.1.1.1.i, ptr %sunkaddr130.i, align 8, !noalias !51
  %lsr.iv.next82.i = add i64 %lsr.iv81.i, -2
  %niter33.ncmp.1.i = icmp eq i64 %lsr.iv.next82.i, 0
  %scevgep85.i = getelementptr i8, ptr %scevgep84.i, i64 %arg.ride.6.0
  %scevgep88.i = getelementptr i8, ptr %scevgep87.i, i64 %arg.q.6.1
  br i1 %niter33.ncmp.1.i, label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i, label %B184.us.1.i

B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i: ; preds = %B184.us.1.i
  %scevgep72.i = getelementptr i8, ptr %lsr.iv71.i, i64 %133
  %scevgep72.1.i = getelementptr i8, ptr %scevgep72.i, i64 %133
  %scevgep69.i = getelementptr i8, ptr %lsr.iv68.i, i64 %93
  %scevgep69.1.i = getelementptr i8, ptr %scevgep69.i, i64 %93
  br i1 %lcmp.mod.not55.not.i, label %B184.us.1.epil.preheader21.i, label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i

B184.us.1.epil.preheader21.i:                     ; preds = %B182.B258.endif.endif_crit_edge.us.new.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i
  %lsr.iv71.epil.init.i = phi ptr [ %.1227, %B182.B258.endif.endif_crit_edge.us.new.i ], [ %scevgep72.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ]
  %lsr.iv68.epil.init.i = phi ptr [ %invariant.gep.1, %B182.B258.endif.endif_crit_edge.us.new.i ], [ %scevgep69.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ]
  %.9431177.us.1.epil.init27.i = phi double [ %.627.us.1.i, %B182.B258.endif.endif_crit_edge.us.new.i ], [ %.943.us.1.1.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ]
  %.908.us.1.epil23.i = load double, ptr %lsr.iv68.epil.init.i, align 8, !noalias !51
  %.941.us.1.epil24.i = load double, ptr %lsr.iv71.epil.init.i, align 8, !noalias !51
  %.942.us.1.epil25.i = fmul double %.908.us.1.epil23.i, %.941.us.1.epil24.i
  %.943.us.1.epil26.i = fadd double %.9431177.us.1.epil.init27.i, %.942.us.1.epil25.i
  store double %.943.us.1.epil26.i, ptr %sunkaddr130.i, align 8, !noalias !51
  %scevgep70.epil.i = getelementptr i8, ptr %lsr.iv68.epil.init.i, i64 %arg.ride.6.0
  %.908.us.1.1.epil.i = load double, ptr %scevgep70.epil.i, align 8, !noalias !51
  %scevgep73.epil.i = getelementptr i8, ptr %lsr.iv71.epil.init.i, i64 %arg.q.6.1
  %.941.us.1.1.epil.i = load double, ptr %scevgep73.epil.i, align 8, !noalias !51
  %.942.us.1.1.epil.i = fmul double %.908.us.1.1.epil.i, %.941.us.1.1.epil.i
  %.943.us.1.1.epil.i = fadd double %.943.us.1.epil26.i, %.942.us.1.1.epil.i
  store double %.943.us.1.1.epil.i, ptr %sunkaddr130.i, align 8, !noalias !51
  br label %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i

B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i: ; preds = %B184.us.1.epil.preheader21.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i
  %.943.us.1.1.lcssa.i = phi double [ %.943.us.1.1.1.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.unr-lcssa.i ], [ %.943.us.1.1.epil.i, %B184.us.1.epil.preheader21.i ]
  br i1 %lcmp.mod.not.i, label %B182.B258.endif.endif_crit_edge.us.1.i, label %B184.us.1.epil.preheader.i

B184.us.1.epil.preheader.i:                       ; preds = %B182.B258.endif.endif_crit_edge.us.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i
  %.9431177.us.1.epil.init.i = phi double [ %.627.us.1.i, %B182.B258.endif.endif_crit_edge.us.i ], [ %.943.us.1.1.lcssa.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i ]
  %.908.us.1.epil.i = load double, ptr %gep.us.1.epil.i, align 8, !noalias !51
  %.939.us.1.epil.i = getelementptr i8, ptr %.1227, i64 %.937.us.1.epil.i
  %.941.us.1.epil.i = load double, ptr %.939.us.1.epil.i, align 8, !noalias !51
  %.942.us.1.epil.i = fmul double %.908.us.1.epil.i, %.941.us.1.epil.i
  %.943.us.1.epil.i = fadd double %.9431177.us.1.epil.init.i, %.942.us.1.epil.i
  store double %.943.us.1.epil.i, ptr %sunkaddr130.i, align 8, !noalias !51
  br label %B182.B258.endif.endif_crit_edge.us.1.i

B182.B258.endif.endif_crit_edge.us.1.i:           ; preds = %B184.us.1.epil.preheader.i, %B182.B258.endif.endif_crit_edge.us.1.unr-lcssa.i
  %.1170.us.11255.i = load double, ptr %131, align 8, !noalias !51
  store double %.1170.us.11255.i, ptr %.2054.1.i, align 8, !noalias !51
  %.1170.us.1.1.i = load double, ptr %.1168.1.1.i, align 8, !noalias !51
  store double %.1170.us.1.1.i, ptr %gep1179.1.1.i, align 8, !noalias !51
  %.1170.us.2.1.i = load double, ptr %.1168.2.1.i, align 8, !noalias !51
  store double %.1170.us.2.1.i, ptr %gep1179.2.1.i, align 8, !noalias !51
  %.627.us.2.i = load double, ptr %gep1185.2.i, align 8, !noalias !51
  store double %.627.us.2.i, ptr %sunkaddr132.i, align 8, !noalias !51
  br i1 %132, label %B184.us.2.epil.preheader.i, label %B182.B258.endif.endif_crit_edge.us.1.new.i

B182.B258.endif.endif_crit_edge.us.1.new.i:       ; preds = %B182.B258.endif.endif_crit_edge.us.1.i
  br i1 %136, label %B184.us.2.epil.preheader38.i, label %B184.us.2.i

B184.us.2.i:                                      ; preds = %B182.B258.endif.endif_crit_edge.us.1.new.i, %B184.us.2.i
  %lsr.iv63.i = phi i64 [ %lsr.iv.next64.i, %B184.us.2.i ], [ %unroll_iter12.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %lsr.iv65.i = phi ptr [ %scevgep80.i, %B184.us.2.i ], [ %.1227, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %lsr.iv62.i = phi ptr [ %scevgep71.i, %B184.us.2.i ], [ %invariant.gep.2, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %.9431177.us.2.i = phi double [ %.943.us.2.1.1.i, %B184.us.2.i ], [ %.627.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ]
  %.908.us.2.i = load double, ptr %lsr.iv62.i, align 8, !noalias !51
  %.941.us.2.i = load double, ptr %lsr.iv65.i, align 8, !noalias !51
  %.942.us.2.i = fmul double %.908.us.2.i, %.941.us.2.i
  %.943.us.2.i = fadd double %.9431177.us.2.i, %.942.us.2.i
  store double %.943.us.2.i, ptr %sunkaddr132.i, align 8, !noalias !51
  %scevgep64.i = getelementptr i8, ptr %lsr.iv62.i, i64 %arg.ride.6.0
  %.908.us.2.1.i = load double, ptr %scevgep64.i, align 8, !noalias !51
  %scevgep67.i = getelementptr i8, ptr %lsr.iv65.i, i64 %arg.q.6.1
  %.941.us.2.1.i = load double, ptr %scevgep67.i, align 8, !noalias !51
  %.942.us.2.1.i = fmul double %.908.us.2.1.i, %.941.us.2.1.i
  %.943.us.2.1.i = fadd double %.943.us.2.i, %.942.us.2.1.i
  store double %.943.us.2.1.i, ptr %sunkaddr132.i, align 8, !noalias !51
  %scevgep65.i = getelementptr i8, ptr %scevgep64.i, i64 %arg.ride.6.0
  %.908.us.2.151.i = load double, ptr %scevgep65.i, align 8, !noalias !51
  %scevgep74.i = getelementptr i8, ptr %scevgep67.i, i64 %arg.q.6.1
  %.941.us.2.152.i = load double, ptr %scevgep74.i, align 8, !noalias !51
  %.942.us.2.153.i = fmul double %.908.us.2.151.i, %.941.us.2.152.i
  %.943.us.2.154.i = fadd double %.943.us.2.1.i, %.942.us.2.153.i
  store double %.943.us.2.154.i, ptr %sunkaddr132.i, align 8, !noalias !51
  %scevgep68.i = getelementptr i8, ptr %scevgep65.i, i64 %arg.ride.6.0
  %.908.us.2.1.1.i = load double, ptr %scevgep68.i, align 8, !noalias !51
  %scevgep77.i = getelementptr i8, ptr %scevgep74.i, i64 %arg.q.6.1
  %.941.us.2.1.1.i = load double, ptr %scevgep77.i, align 8, !noalias !51
  %.942.us.2.1.1.i = fmul double %.908.us.2.1.1.i, %.941.us.2.1.1.i
  %.943.us.2.1.1.i = fadd double %.943.us.2.154.i, %.942.us.2.1.1.i
  store double %.943.us.2.1.1.i, ptr %sunkaddr132.i, align 8, !noalias !51
  %lsr.iv.next64.i = add i64 %lsr.iv63.i, -2
  %niter50.ncmp.1.i = icmp eq i64 %lsr.iv.next64.i, 0
  %scevgep71.i = getelementptr i8, ptr %scevgep68.i, i64 %arg.ride.6.0
  %scevgep80.i = getelementptr i8, ptr %scevgep77.i, i64 %arg.q.6.1
  br i1 %niter50.ncmp.1.i, label %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i, label %B184.us.2.i

B184.us.i:                                        ; preds = %B184.us.preheader.new.i, %B184.us.i
  %lsr.iv89.i = phi i64 [ %lsr.iv.next90.i, %B184.us.i ], [ %unroll_iter12.i, %B184.us.preheader.new.i ]
  %lsr.iv77.i = phi ptr [ %scevgep96.i, %B184.us.i ], [ %.1227, %B184.us.preheader.new.i ]
  %lsr.iv74.i = phi ptr [ %scevgep93.i, %B184.us.i ], [ %arg.ride.4, %B184.us.preheader.new.i ]
  %.9431177.us.i = phi double [ %.943.us.119.1.i, %B184.us.i ], [ %.627.us.i, %B184.us.preheader.new.i ]
  %.908.us.i = load double, ptr %lsr.iv74.i, align 8, !noalias !51
  %.941.us.i = load double, ptr %lsr.iv77.i, align 8, !noalias !51
  %.942.us.i = fmul double %.908.us.i, %.941.us.i
  %.943.us.i = fadd double %.9431177.us.i, %.942.us.i
  store double %.943.us.i, ptr %.348.i, align 8, !noalias !51
  %scevgep76.i = getelementptr i8, ptr %lsr.iv74.i, i64 %arg.ride.6.0
  %.908.us.114.i = load double, ptr %scevgep76.i, align 8, !noalias !51
  %scevgep79.i = getelementptr i8, ptr %lsr.iv77.i, i64 %arg.q.6.1
  %.941.us.117.i = load double, ptr %scevgep79.i, align 8, !noalias !51
  %.942.us.118.i = fmul double %.908.us.114.i, %.941.us.117.i
  %.943.us.119.i = fadd double %.943.us.i, %.942.us.118.i
  store double %.943.us.119.i, ptr %.348.i, align 8, !noalias !51
  %scevgep91.i = getelementptr i8, ptr %scevgep76.i, i64 %arg.ride.6.0
  %.908.us.115.i = load double, ptr %scevgep91.i, align 8, !noalias !51
  %scevgep94.i = getelementptr i8, ptr %scevgep79.i, i64 %arg.q.6.1
  %.941.us.116.i = load double, ptr %scevgep94.i, align 8, !noalias !51
  %.942.us.117.i = fmul double %.908.us.115.i, %.941.us.116.i
  %.943.us.118.i = fadd double %.943.us.119.i, %.942.us.117.i
  store double %.943.us.118.i, ptr %.348.i, align 8, !noalias !51
  %scevgep92.i = getelementptr i8, ptr %scevgep91.i, i64 %arg.ride.6.0
  %.908.us.114.1.i = load double, ptr %scevgep92.i, align 8, !noalias !51
  %scevgep95.i = getelementptr i8, ptr %scevgep94.i, i64 %arg.q.6.1
  %.941.us.117.1.i = load double, ptr %scevgep95.i, align 8, !noalias !51
  %.942.us.118.1.i = fmul double %.908.us.114.1.i, %.941.us.117.1.i
  %.943.us.119.1.i = fadd double %.943.us.118.i, %.942.us.118.1.i
  store double %.943.us.119.1.i, ptr %.348.i, align 8, !noalias !51
  %lsr.iv.next90.i = add i64 %lsr.iv89.i, -2
  %niter.ncmp.119.i = icmp eq i64 %lsr.iv.next90.i, 0
  %scevgep93.i = getelementptr i8, ptr %scevgep92.i, i64 %arg.ride.6.0
  %scevgep96.i = getelementptr i8, ptr %scevgep95.i, i64 %arg.q.6.1
  br i1 %niter.ncmp.119.i, label %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i, label %B184.us.i

B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i: ; preds = %B184.us.i
  %scevgep78.i = getelementptr i8, ptr %lsr.iv77.i, i64 %133
  %scevgep78.1.i = getelementptr i8, ptr %scevgep78.i, i64 %133
  %scevgep75.i = getelementptr i8, ptr %lsr.iv74.i, i64 %93
  %scevgep75.1.i = getelementptr i8, ptr %scevgep75.i, i64 %93
  br i1 %lcmp.mod.not55.not.i, label %B184.us.epil.preheader3.i, label %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i

B184.us.epil.preheader3.i:                        ; preds = %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i, %B184.us.preheader.new.i
  %lsr.iv77.epil.init.i = phi ptr [ %.1227, %B184.us.preheader.new.i ], [ %scevgep78.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ]
  %lsr.iv74.epil.init.i = phi ptr [ %arg.ride.4, %B184.us.preheader.new.i ], [ %scevgep75.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ]
  %.9431177.us.epil.init8.i = phi double [ %.627.us.i, %B184.us.preheader.new.i ], [ %.943.us.119.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ]
  %.908.us.epil4.i = load double, ptr %lsr.iv74.epil.init.i, align 8, !noalias !51
  %.941.us.epil5.i = load double, ptr %lsr.iv77.epil.init.i, align 8, !noalias !51
  %.942.us.epil6.i = fmul double %.908.us.epil4.i, %.941.us.epil5.i
  %.943.us.epil7.i = fadd double %.9431177.us.epil.init8.i, %.942.us.epil6.i
  store double %.943.us.epil7.i, ptr %.348.i, align 8, !noalias !51
  %scevgep76.epil.i = getelementptr i8, ptr %lsr.iv74.epil.init.i, i64 %arg.ride.6.0
  %.908.us.114.epil.i = load double, ptr %scevgep76.epil.i, align 8, !noalias !51
  %scevgep79.epil.i = getelementptr i8, ptr %lsr.iv77.epil.init.i, i64 %arg.q.6.1
  %.941.us.117.epil.i = load double, ptr %scevgep79.epil.i, align 8, !noalias !51
  %.942.us.118.epil.i = fmul double %.908.us.114.epil.i, %.941.us.117.epil.i
  %.943.us.119.epil.i = fadd double %.943.us.epil7.i, %.942.us.118.epil.i
  store double %.943.us.119.epil.i, ptr %.348.i, align 8, !noalias !51
  br label %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i

B182.B258.endif.endif_crit_edge.us.unr-lcssa.i:   ; preds = %B184.us.epil.preheader3.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i
  %.943.us.119.lcssa.i = phi double [ %.943.us.119.1.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.unr-lcssa.i ], [ %.943.us.119.epil.i, %B184.us.epil.preheader3.i ]
  br i1 %lcmp.mod.not.i, label %B182.B258.endif.endif_crit_edge.us.i, label %B184.us.epil.preheader.i

B184.us.epil.preheader.i:                         ; preds = %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i, %B184.us.preheader.i
  %.9431177.us.epil.init.i = phi double [ %.627.us.i, %B184.us.preheader.i ], [ %.943.us.119.lcssa.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i ]
  %.908.us.epil.i = load double, ptr %gep.us.epil.i, align 8, !noalias !51
  %.939.us.epil.i = getelementptr i8, ptr %.1227, i64 %.937.us.epil.i
  %.941.us.epil.i = load double, ptr %.939.us.epil.i, align 8, !noalias !51
  %.942.us.epil.i = fmul double %.908.us.epil.i, %.941.us.epil.i
  %.943.us.epil.i = fadd double %.9431177.us.epil.init.i, %.942.us.epil.i
  store double %.943.us.epil.i, ptr %.348.i, align 8, !noalias !51
  br label %B182.B258.endif.endif_crit_edge.us.i

B182.B258.endif.endif_crit_edge.us.i:             ; preds = %B184.us.epil.preheader.i, %B182.B258.endif.endif_crit_edge.us.unr-lcssa.i
  %.1170.us.i = load double, ptr %arg.X_WC.4, align 8, !noalias !51
  store double %.1170.us.i, ptr %arg.room.4, align 8, !noalias !51
  %.1170.us.1.i = load double, ptr %.1168.1.i, align 8, !noalias !51
  store double %.1170.us.1.i, ptr %94, align 8, !noalias !51
  %.1170.us.2.i = load double, ptr %.1168.2.i, align 8, !noalias !51
  store double %.1170.us.2.i, ptr %gep1179.2.i, align 8, !noalias !51
  %.627.us.1.i = load double, ptr %gep1185.1.i, align 8, !noalias !51
  store double %.627.us.1.i, ptr %sunkaddr130.i, align 8, !noalias !51
  br i1 %132, label %B184.us.1.epil.preheader.i, label %B182.B258.endif.endif_crit_edge.us.new.i

B182.B258.endif.endif_crit_edge.us.new.i:         ; preds = %B182.B258.endif.endif_crit_edge.us.i
  br i1 %136, label %B184.us.1.epil.preheader21.i, label %B184.us.1.i

B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i: ; preds = %B184.us.2.i
  %scevgep66.i = getelementptr i8, ptr %lsr.iv65.i, i64 %133
  %scevgep66.1.i = getelementptr i8, ptr %scevgep66.i, i64 %133
  %scevgep63.i = getelementptr i8, ptr %lsr.iv62.i, i64 %93
  %scevgep63.1.i = getelementptr i8, ptr %scevgep63.i, i64 %93
  br i1 %lcmp.mod.not55.not.i, label %B184.us.2.epil.preheader38.i, label %B652.endif.2.peel.next.loopexit.unr-lcssa.i

B184.us.2.epil.preheader38.i:                     ; preds = %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i, %B182.B258.endif.endif_crit_edge.us.1.new.i
  %lsr.iv65.epil.init.i = phi ptr [ %.1227, %B182.B258.endif.endif_crit_edge.us.1.new.i ], [ %scevgep66.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ]
  %lsr.iv62.epil.init.i = phi ptr [ %invariant.gep.2, %B182.B258.endif.endif_crit_edge.us.1.new.i ], [ %scevgep63.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ]
  %.9431177.us.2.epil.init44.i = phi double [ %.627.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.new.i ], [ %.943.us.2.1.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ]
  %.908.us.2.epil40.i = load double, ptr %lsr.iv62.epil.init.i, align 8, !noalias !51
  %.941.us.2.epil41.i = load double, ptr %lsr.iv65.epil.init.i, align 8, !noalias !51
  %.942.us.2.epil42.i = fmul double %.908.us.2.epil40.i, %.941.us.2.epil41.i
  %.943.us.2.epil43.i = fadd double %.9431177.us.2.epil.init44.i, %.942.us.2.epil42.i
  store double %.943.us.2.epil43.i, ptr %sunkaddr132.i, align 8, !noalias !51
  %scevgep64.epil.i = getelementptr i8, ptr %lsr.iv62.epil.init.i, i64 %arg.ride.6.0
  %.908.us.2.1.epil.i = load double, ptr %scevgep64.epil.i, align 8, !noalias !51
  %scevgep67.epil.i = getelementptr i8, ptr %lsr.iv65.epil.init.i, i64 %arg.q.6.1
  %.941.us.2.1.epil.i = load double, ptr %scevgep67.epil.i, align 8, !noalias !51
  %.942.us.2.1.epil.i = fmul double %.908.us.2.1.epil.i, %.941.us.2.1.epil.i
  %.943.us.2.1.epil.i = fadd double %.943.us.2.epil43.i, %.942.us.2.1.epil.i
  store double %.943.us.2.1.epil.i, ptr %sunkaddr132.i, align 8, !noalias !51
  br label %B652.endif.2.peel.next.loopexit.unr-lcssa.i

B652.endif.2.peel.next.loopexit.unr-lcssa.i:      ; preds = %B184.us.2.epil.preheader38.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i
  %.943.us.2.1.lcssa.i = phi double [ %.943.us.2.1.1.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.unr-lcssa.i ], [ %.943.us.2.1.epil.i, %B184.us.2.epil.preheader38.i ]
  br i1 %lcmp.mod.not.i, label %B652.endif.2.peel.next.i, label %B184.us.2.epil.preheader.i

B184.us.2.epil.preheader.i:                       ; preds = %B652.endif.2.peel.next.loopexit.unr-lcssa.i, %B182.B258.endif.endif_crit_edge.us.1.i
  %.9431177.us.2.epil.init.i = phi double [ %.627.us.2.i, %B182.B258.endif.endif_crit_edge.us.1.i ], [ %.943.us.2.1.lcssa.i, %B652.endif.2.peel.next.loopexit.unr-lcssa.i ]
  %.908.us.2.epil.i = load double, ptr %gep.us.2.epil.i, align 8, !noalias !51
  %.939.us.2.epil.i = getelementptr i8, ptr %.1227, i64 %.937.us.2.epil.i
  %.941.us.2.epil.i = load double, ptr %.939.us.2.epil.i, align 8, !noalias !51
  %.942.us.2.epil.i = fmul double %.908.us.2.epil.i, %.941.us.2.epil.i
  %.943.us.2.epil.i = fadd double %.9431177.us.2.epil.init.i, %.942.us.2.epil.i
  br label %B652.endif.2.peel.next.i.sink.split

B652.endif.2.peel.next.i.sink.split:              ; preds = %B120.endif.preheader.i, %B184.us.2.epil.preheader.i
  %.943.us.2.epil.i.sink = phi double [ %.943.us.2.epil.i, %B184.us.2.epil.preheader.i ], [ %.627.2.i, %B120.endif.preheader.i ]
  store double %.943.us.2.epil.i.sink, ptr %sunkaddr132.i, align 8, !noalias !51
  br label %B652.endif.2.peel.next.i

B652.endif.2.peel.next.i:                         ; preds = %B652.endif.2.peel.next.i.sink.split, %B652.endif.2.peel.next.loopexit.unr-lcssa.i
  %.1170.21252.i = load double, ptr %145, align 8, !noalias !51
  store double %.1170.21252.i, ptr %invariant.gep1178.2.i, align 8, !noalias !51
  %.1170.1.2.i = load double, ptr %.1168.1.2.i, align 8, !noalias !51
  store double %.1170.1.2.i, ptr %gep1179.1.2.i, align 8, !noalias !51
  %.1170.2.2.i = load double, ptr %.1168.2.2.i, align 8, !noalias !51
  store double %.1170.2.2.i, ptr %gep1179.2.2.i, align 8, !noalias !51
  %.1432.peel.i = load double, ptr %.1431.peel.i, align 8, !noalias !51
  %.1464.peel.i = getelementptr i8, ptr %.1227, i64 %.1462.peel.i
  %.1466.peel.i = load double, ptr %.1464.peel.i, align 8, !noalias !51
  %.1467.peel.i = fmul double %.1432.peel.i, %.1466.peel.i
  %.1522.peel.i = load double, ptr %.1521.peel.i, align 8, !noalias !51
  %.1523.peel.i = fadd double %.1467.peel.i, %.1522.peel.i
  %.1578.peel.i = load double, ptr %.1577.peel.i, align 8, !noalias !51
  %.1580.peel.i = fmul double %.1578.peel.i, 0.000000e+00
  %.1583.peel.i = fsub double %.1523.peel.i, %.1580.peel.i
  %.1621.peel.i = tail call double @llvm.cos.f64(double %.1583.peel.i)
  %.1622.peel.i = tail call double @llvm.sin.f64(double %.1583.peel.i)
  %.1683.peel.i = load double, ptr %arg.chain.4, align 8, !noalias !51
  %.5.i.peel.i = fptosi double %.1683.peel.i to i64
  %.1712.peel.i = add nsw i64 %.5.i.peel.i, 1
  %.1732.peel.i = srem i64 %.1712.peel.i, 3
  %.1734.peel.i = icmp slt i64 %.1732.peel.i, 0
  %.1743.peel.i = add nsw i64 %.1732.peel.i, 3
  %.1723.1.peel.i = select i1 %.1734.peel.i, i64 %.1743.peel.i, i64 %.1732.peel.i
  %.1754.peel.i = add nsw i64 %.5.i.peel.i, 2
  %.1774.peel.i = srem i64 %.1754.peel.i, 3
  %.1776.peel.i = icmp slt i64 %.1774.peel.i, 0
  %.1785.peel.i = add nsw i64 %.1774.peel.i, 3
  %.1765.1.peel.i = select i1 %.1776.peel.i, i64 %.1785.peel.i, i64 %.1774.peel.i
  %.2415.peel.i = icmp slt i64 %.5.i.peel.i, 0
  %.2416.peel.i = select i1 %.2415.peel.i, i64 %arg.room.5.1, i64 0
  %.2417.peel.i = add i64 %.2416.peel.i, %.5.i.peel.i
  %.2437.peel.i = mul i64 %.2417.peel.i, %arg.room.5.2
  %2 = getelementptr double, ptr %arg.room.4, i64 %.2437.peel.i
  %.1999.peel.i = load double, ptr %.348.i, align 8, !noalias !51
  %.2055.peel.i = load double, ptr %arg.room.4, align 8, !noalias !51
  %.2110.peel.i = load double, ptr %.2109.peel.i, align 8, !noalias !51
  %.2111.peel.i = fmul double %.2055.peel.i, %.2110.peel.i
  %.2112.peel.i = fadd double %.1999.peel.i, %.2111.peel.i
  %.2166.peel.i = load double, ptr %94, align 8, !noalias !51
  %.2221.peel.i = load double, ptr %.2220.peel.i, align 8, !noalias !51
  %.2222.peel.i = fmul double %.2166.peel.i, %.2221.peel.i
  %.2223.peel.i = fadd double %.2112.peel.i, %.2222.peel.i
  %.2277.peel.i = load double, ptr %95, align 8, !noalias !51
  %.2332.peel.i = load double, ptr %.2331.peel.i, align 8, !noalias !51
  %.2333.peel.i = fmul double %.2277.peel.i, %.2332.peel.i
  %.2334.peel.i = fadd double %.2223.peel.i, %.2333.peel.i
  store double %.2334.peel.i, ptr %.348.i, align 8, !noalias !51
  %.2442.peel.i = load double, ptr %2, align 8, !noalias !51
  store double %.2442.peel.i, ptr %sunkaddr102.i, align 8, !noalias !51
  %.1999.1.peel.i = load double, ptr %sunkaddr130.i, align 8, !noalias !51
  %.2055.1.peel.i = load double, ptr %.2054.1.i, align 8, !noalias !51
  %.2110.1.peel.i = load double, ptr %.2109.peel.i, align 8, !noalias !51
  %.2111.1.peel.i = fmul double %.2055.1.peel.i, %.2110.1.peel.i
  %.2112.1.peel.i = fadd double %.1999.1.peel.i, %.2111.1.peel.i
  %.2166.1.peel.i = load double, ptr %.2165.1.i, align 8, !noalias !51
  %.2221.1.peel.i = load double, ptr %.2220.peel.i, align 8, !noalias !51
  %.2222.1.peel.i = fmul double %.2166.1.peel.i, %.2221.1.peel.i
  %.2223.1.peel.i = fadd double %.2112.1.peel.i, %.2222.1.peel.i
  %.2277.1.peel.i = load double, ptr %.2276.1.i, align 8, !noalias !51
  %.2332.1.peel.i = load double, ptr %.2331.peel.i, align 8, !noalias !51
  %.2333.1.peel.i = fmul double %.2277.1.peel.i, %.2332.1.peel.i
  %.2334.1.peel.i = fadd double %.2223.1.peel.i, %.2333.1.peel.i
  store double %.2334.1.peel.i, ptr %sunkaddr130.i, align 8, !noalias !51
  %.2441.1.peel.i = getelementptr i8, ptr %2, i64 8
  %.2442.1.peel.i = load double, ptr %.2441.1.peel.i, align 8, !noalias !51
  store double %.2442.1.peel.i, ptr %sunkaddr107.i, align 8, !noalias !51
  %.1999.2.peel.i = load double, ptr %sunkaddr132.i, align 8, !noalias !51
  %.2055.2.peel.i = load double, ptr %invariant.gep1178.2.i, align 8, !noalias !51
  %.2110.2.peel.i = load double, ptr %.2109.peel.i, align 8, !noalias !51
  %.2111.2.peel.i = fmul double %.2055.2.peel.i, %.2110.2.peel.i
  %.2112.2.peel.i = fadd double %.1999.2.peel.i, %.2111.2.peel.i
  %.2166.2.peel.i = load double, ptr %.2165.2.i, align 8, !noalias !51
  %.2221.2.peel.i = load double, ptr %.2220.peel.i, align 8, !noalias !51
  %.2222.2.peel.i = fmul double %.2166.2.peel.i, %.2221.2.peel.i
  %.2223.2.peel.i = fadd double %.2112.2.peel.i, %.2222.2.peel.i
  %.2277.2.peel.i = load double, ptr %.2276.2.i, align 8, !noalias !51
  %.2332.2.peel.i = load double, ptr %.2331.peel.i, align 8, !noalias !51
  %.2333.2.peel.i = fmul double %.2277.2.peel.i, %.2332.2.peel.i
  %.2334.2.peel.i = fadd double %.2223.2.peel.i, %.2333.2.peel.i
  store double %.2334.2.peel.i, ptr %sunkaddr132.i, align 8, !noalias !51
  %.2441.2.peel.i = getelementptr i8, ptr %2, i64 16
  %.2442.2.peel.i = load double, ptr %.2441.2.peel.i, align 8, !noalias !51
  store double %.2442.2.peel.i, ptr %sunkaddr112.i, align 8, !noalias !51
  %.2651.peel.i = icmp slt i64 %.1723.1.peel.i, 0
  %.2652.peel.i = select i1 %.2651.peel.i, i64 %arg.room.5.1, i64 0
  %.2653.peel.i = add i64 %.2652.peel.i, %.1723.1.peel.i
  %.2673.peel.i = mul i64 %.2653.peel.i, %arg.room.5.2
  %3 = getelementptr double, ptr %arg.room.4, i64 %.2673.peel.i
  %.2706.peel.i = icmp slt i64 %.1765.1.peel.i, 0
  %.2707.peel.i = select i1 %.2706.peel.i, i64 %arg.room.5.1, i64 0
  %.2708.peel.i = add i64 %.2707.peel.i, %.1765.1.peel.i
  %.2728.peel.i = mul i64 %.2708.peel.i, %arg.room.5.2
  %4 = getelementptr double, ptr %arg.room.4, i64 %.2728.peel.i
  %.2678.peel.i = load double, ptr %3, align 8, !noalias !51
  %.2733.peel.i = load double, ptr %4, align 8, !noalias !51
  %.2737.peel.i = fmul double %.1621.peel.i, %.2678.peel.i
  %.2739.peel.i = fmul double %.1622.peel.i, %.2733.peel.i
  %.2740.peel.i = fadd double %.2737.peel.i, %.2739.peel.i
  %.2742.peel.i = fmul double %.1621.peel.i, %.2733.peel.i
  %.2744.peel.i = fmul double %.1622.peel.i, %.2678.peel.i
  %.2745.peel.i = fsub double %.2742.peel.i, %.2744.peel.i
  store double %.2740.peel.i, ptr %3, align 8, !noalias !51
  store double %.2745.peel.i, ptr %4, align 8, !noalias !51
  %.2677.1.peel.i = getelementptr i8, ptr %3, i64 8
  %.2678.1.peel.i = load double, ptr %.2677.1.peel.i, align 8, !noalias !51
  %.2732.1.peel.i = getelementptr i8, ptr %4, i64 8
  %.2733.1.peel.i = load double, ptr %.2732.1.peel.i, align 8, !noalias !51
  %.2737.1.peel.i = fmul double %.1621.peel.i, %.2678.1.peel.i
  %.2739.1.peel.i = fmul double %.1622.peel.i, %.2733.1.peel.i
  %.2740.1.peel.i = fadd double %.2737.1.peel.i, %.2739.1.peel.i
  %.2742.1.peel.i = fmul double %.1621.peel.i, %.2733.1.peel.i
  %.2744.1.peel.i = fmul double %.1622.peel.i, %.2678.1.peel.i
  %.2745.1.peel.i = fsub double %.2742.1.peel.i, %.2744.1.peel.i
  store double %.2740.1.peel.i, ptr %.2677.1.peel.i, align 8, !noalias !51
  store double %.2745.1.peel.i, ptr %.2732.1.peel.i, align 8, !noalias !51
  %.2677.2.peel.i = getelementptr i8, ptr %3, i64 16
  %.2678.2.peel.i = load double, ptr %.2677.2.peel.i, align 8, !noalias !51
  %.2732.2.peel.i = getelementptr i8, ptr %4, i64 16
  %.2733.2.peel.i = load double, ptr %.2732.2.peel.i, align 8, !noalias !51
  %.2737.2.peel.i = fmul double %.1621.peel.i, %.2678.2.peel.i
  %.2739.2.peel.i = fmul double %.1622.peel.i, %.2733.2.peel.i
  %.2740.2.peel.i = fadd double %.2737.2.peel.i, %.2739.2.peel.i
  %.2742.2.peel.i = fmul double %.1621.peel.i, %.2733.2.peel.i
  %.2744.2.peel.i = fmul double %.1622.peel.i, %.2678.2.peel.i
  %.2745.2.peel.i = fsub double %.2742.2.peel.i, %.2744.2.peel.i
  store double %.2740.2.peel.i, ptr %.2677.2.peel.i, align 8, !noalias !51
  store double %.2745.2.peel.i, ptr %.2732.2.peel.i, align 8, !noalias !51
  br label %B652.endif.2.i

B652.endif.2.i:                                   ; preds = %B652.endif.2.i, %B652.endif.2.peel.next.i
  %lsr.iv60.i = phi i64 [ 5, %B652.endif.2.peel.next.i ], [ %lsr.iv.next61.i, %B652.endif.2.i ]
  %lsr.iv58.i = phi i64 [ %108, %B652.endif.2.peel.next.i ], [ %lsr.iv.next59.i, %B652.endif.2.i ]
  %lsr.iv50.i = phi ptr [ %scevgep49.i, %B652.endif.2.peel.next.i ], [ %scevgep51.i, %B652.endif.2.i ]
  %lsr.iv42.i = phi i64 [ %105, %B652.endif.2.peel.next.i ], [ %lsr.iv.next43.i, %B652.endif.2.i ]
  %lsr.iv35.i = phi i64 [ %101, %B652.endif.2.peel.next.i ], [ %lsr.iv.next36.i, %B652.endif.2.i ]
  %lsr.iv.i = phi i64 [ %96, %B652.endif.2.peel.next.i ], [ %lsr.iv.next.i, %B652.endif.2.i ]
  %before.2.01232.i = phi double [ %.1466.peel.i, %B652.endif.2.peel.next.i ], [ %.1466.i, %B652.endif.2.i ]
  %scevgep55.i = getelementptr i8, ptr %lsr.iv50.i, i64 -48
  %scevgep57.i = getelementptr i8, ptr %lsr.iv50.i, i64 -40
  %.1432.i = load double, ptr %scevgep57.i, align 8, !noalias !51
  %.1449.i = icmp slt i64 %lsr.iv58.i, 0
  %.1450.i = select i1 %.1449.i, i64 %arg.q.5.1, i64 0
  %5 = add i64 %.1450.i, %lsr.iv58.i
  %.1462.i = mul i64 %5, %arg.q.6.1
  %.1464.i = getelementptr i8, ptr %.1227, i64 %.1462.i
  %.1466.i = load double, ptr %.1464.i, align 8, !noalias !51
  %.1467.i = fmul double %.1432.i, %.1466.i
  %scevgep56.i = getelementptr i8, ptr %lsr.iv50.i, i64 -32
  %.1522.i = load double, ptr %scevgep56.i, align 8, !noalias !51
  %.1523.i = fadd double %.1467.i, %.1522.i
  %.1578.i = load double, ptr %lsr.iv50.i, align 8, !noalias !51
  %.1580.i = fmul double %before.2.01232.i, %.1578.i
  %.1583.i = fsub double %.1523.i, %.1580.i
  %.1621.i = tail call double @llvm.cos.f64(double %.1583.i)
  %.1622.i = tail call double @llvm.sin.f64(double %.1583.i)
  %.1683.i = load double, ptr %scevgep55.i, align 8, !noalias !51
  %.5.i.i = fptosi double %.1683.i to i64
  %.1712.i = add nsw i64 %.5.i.i, 1
  %.1732.i = srem i64 %.1712.i, 3
  %.1734.i = icmp slt i64 %.1732.i, 0
  %.1743.i = add nsw i64 %.1732.i, 3
  %.1723.1.i = select i1 %.1734.i, i64 %.1743.i, i64 %.1732.i
  %.1754.i = add nsw i64 %.5.i.i, 2
  %.1774.i = srem i64 %.1754.i, 3
  %.1776.i = icmp slt i64 %.1774.i, 0
  %.1785.i = add nsw i64 %.1774.i, 3
  %.1765.1.i = select i1 %.1776.i, i64 %.1785.i, i64 %.1774.i
  %scevgep54.i = getelementptr i8, ptr %lsr.iv50.i, i64 -24
  %scevgep53.i = getelementptr i8, ptr %lsr.iv50.i, i64 -16
  %scevgep52.i = getelementptr i8, ptr %lsr.iv50.i, i64 -8
  %.2415.i = icmp slt i64 %.5.i.i, 0
  %.2416.i = select i1 %.2415.i, i64 %arg.room.5.1, i64 0
  %.2417.i = add i64 %.2416.i, %.5.i.i
  %.2437.i = mul i64 %.2417.i, %arg.room.5.2
  %6 = getelementptr double, ptr %arg.room.4, i64 %.2437.i
  %scevgep33.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv.i
  %scevgep34.i = getelementptr i8, ptr %scevgep33.i, i64 -16
  %.1999.i = load double, ptr %scevgep34.i, align 8, !noalias !51
  %.2055.i = load double, ptr %arg.room.4, align 8, !noalias !51
  %.2110.i = load double, ptr %scevgep54.i, align 8, !noalias !51
  %.2111.i = fmul double %.2055.i, %.2110.i
  %.2112.i = fadd double %.1999.i, %.2111.i
  %.2166.i = load double, ptr %sunkaddr134.i, align 8, !noalias !51
  %.2221.i = load double, ptr %scevgep53.i, align 8, !noalias !51
  %.2222.i = fmul double %.2166.i, %.2221.i
  %.2223.i = fadd double %.2112.i, %.2222.i
  %.2277.i = load double, ptr %95, align 8, !noalias !51
  %.2332.i = load double, ptr %scevgep52.i, align 8, !noalias !51
  %.2333.i = fmul double %.2277.i, %.2332.i
  %.2334.i = fadd double %.2223.i, %.2333.i
  %scevgep37.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv35.i
  %scevgep38.i = getelementptr i8, ptr %scevgep37.i, i64 -16
  store double %.2334.i, ptr %scevgep38.i, align 8, !noalias !51
  %.2442.i = load double, ptr %6, align 8, !noalias !51
  %scevgep44.i = getelementptr i8, ptr %arg.room.4, i64 %lsr.iv42.i
  %scevgep45.i = getelementptr i8, ptr %scevgep44.i, i64 -16
  store double %.2442.i, ptr %scevgep45.i, align 8, !noalias !51
  %scevgep62.i = getelementptr i8, ptr %scevgep33.i, i64 -8
  %.1999.1.i = load double, ptr %scevgep62.i, align 8, !noalias !51
  %.2055.1.i = load double, ptr %.2054.1.i, align 8, !noalias !51
  %.2110.1.i = load double, ptr %scevgep54.i, align 8, !noalias !51
  %.2111.1.i = fmul double %.2055.1.i, %.2110.1.i
  %.2112.1.i = fadd double %.1999.1.i, %.2111.1.i
  %.2166.1.i = load double, ptr %sunkaddr139.i, align 8, !noalias !51
  %.2221.1.i = load double, ptr %scevgep53.i, align 8, !noalias !51
  %.2222.1.i = fmul double %.2166.1.i, %.2221.1.i
  %.2223.1.i = fadd double %.2112.1.i, %.2222.1.i
  %.2277.1.i = load double, ptr %.2276.1.i, align 8, !noalias !51
  %.2332.1.i = load double, ptr %scevgep52.i, align 8, !noalias !51
  %.2333.1.i = fmul double %.2277.1.i, %.2332.1.i
  %.2334.1.i = fadd double %.2223.1.i, %.2333.1.i
  %scevgep60.i = getelementptr i8, ptr %scevgep37.i, i64 -8
  store double %.2334.1.i, ptr %scevgep60.i, align 8, !noalias !51
  %.2441.1.i = getelementptr i8, ptr %6, i64 8
  %.2442.1.i = load double, ptr %.2441.1.i, align 8, !noalias !51
  %scevgep58.i = getelementptr i8, ptr %scevgep44.i, i64 -8
  store double %.2442.1.i, ptr %scevgep58.i, align 8, !noalias !51
  %.1999.2.i = load double, ptr %scevgep33.i, align 8, !noalias !51
  %.2055.2.i = load double, ptr %invariant.gep1178.2.i, align 8, !noalias !51
  %.2110.2.i = load double, ptr %scevgep54.i, align 8, !noalias !51
  %.2111.2.i = fmul double %.2055.2.i, %.2110.2.i
  %.2112.2.i = fadd double %.1999.2.i, %.2111.2.i
  %.2166.2.i = load double, ptr %sunkaddr145.i, align 8, !noalias !51
  %.2221.2.i = load double, ptr %scevgep53.i, align 8, !noalias !51
  %.2222.2.i = fmul double %.2166.2.i, %.2221.2.i
  %.2223.2.i = fadd double %.2112.2.i, %.2222.2.i
  %.2277.2.i = load double, ptr %.2276.2.i, align 8, !noalias !51
  %.2332.2.i = load double, ptr %scevgep52.i, align 8, !noalias !51
  %.2333.2.i = fmul double %.2277.2.i, %.2332.2.i
  %.2334.2.i = fadd double %.2223.2.i, %.2333.2.i
  store double %.2334.2.i, ptr %scevgep37.i, align 8, !noalias !51
  %.2441.2.i = getelementptr i8, ptr %6, i64 16
  %.2442.2.i = load double, ptr %.2441.2.i, align 8, !noalias !51
  store double %.2442.2.i, ptr %scevgep44.i, align 8, !noalias !51
  %.2651.i = icmp slt i64 %.1723.1.i, 0
  %.2652.i = select i1 %.2651.i, i64 %arg.room.5.1, i64 0
  %.2653.i = add i64 %.2652.i, %.1723.1.i
  %.2673.i = mul i64 %.2653.i, %arg.room.5.2
  %7 = getelementptr double, ptr %arg.room.4, i64 %.2673.i
  %.2706.i = icmp slt i64 %.1765.1.i, 0
  %.2707.i = select i1 %.2706.i, i64 %arg.room.5.1, i64 0
  %.2708.i = add i64 %.2707.i, %.1765.1.i
  %.2728.i = mul i64 %.2708.i, %arg.room.5.2
  %8 = getelementptr double, ptr %arg.room.4, i64 %.2728.i
  %.2678.i = load double, ptr %7, align 8, !noalias !51
  %.2733.i = load double, ptr %8, align 8, !noalias !51
  %.2737.i = fmul double %.1621.i, %.2678.i
  %.2739.i = fmul double %.1622.i, %.2733.i
  %.2740.i = fadd double %.2737.i, %.2739.i
  %.2742.i = fmul double %.1621.i, %.2733.i
  %.2744.i = fmul double %.1622.i, %.2678.i
  %.2745.i = fsub double %.2742.i, %.2744.i
  store double %.2740.i, ptr %7, align 8, !noalias !51
  store double %.2745.i, ptr %8, align 8, !noalias !51
  %.2677.1.i = getelementptr i8, ptr %7, i64 8
  %.2678.1.i = load double, ptr %.2677.1.i, align 8, !noalias !51
  %.2732.1.i = getelementptr i8, ptr %8, i64 8
  %.2733.1.i = load double, ptr %.2732.1.i, align 8, !noalias !51
  %.2737.1.i = fmul double %.1621.i, %.2678.1.i
  %.2739.1.i = fmul double %.1622.i, %.2733.1.i
  %.2740.1.i = fadd double %.2737.1.i, %.2739.1.i
  %.2742.1.i = fmul double %.1621.i, %.2733.1.i
  %.2744.1.i = fmul double %.1622.i, %.2678.1.i
  %.2745.1.i = fsub double %.2742.1.i, %.2744.1.i
  store double %.2740.1.i, ptr %.2677.1.i, align 8, !noalias !51
  store double %.2745.1.i, ptr %.2732.1.i, align 8, !noalias !51
  %.2677.2.i = getelementptr i8, ptr %7, i64 16
  %.2678.2.i = load double, ptr %.2677.2.i, align 8, !noalias !51
  %.2732.2.i = getelementptr i8, ptr %8, i64 16
  %.2733.2.i = load double, ptr %.2732.2.i, align 8, !noalias !51
  %.2737.2.i = fmul double %.1621.i, %.2678.2.i
  %.2739.2.i = fmul double %.1622.i, %.2733.2.i
  %.2740.2.i = fadd double %.2737.2.i, %.2739.2.i
  %.2742.2.i = fmul double %.1621.i, %.2733.2.i
  %.2744.2.i = fmul double %.1622.i, %.2678.2.i
  %.2745.2.i = fsub double %.2742.2.i, %.2744.2.i
  store double %.2740.2.i, ptr %.2677.2.i, align 8, !noalias !51
  store double %.2745.2.i, ptr %.2732.2.i, align 8, !noalias !51
  %lsr.iv.next.i = add i64 %lsr.iv.i, %97
  %lsr.iv.next36.i = add i64 %lsr.iv35.i, %97
  %lsr.iv.next43.i = add i64 %lsr.iv42.i, %97
  %scevgep51.i = getelementptr i8, ptr %lsr.iv50.i, i64 %106
  %lsr.iv.next59.i = add i64 %lsr.iv58.i, 1
  %lsr.iv.next61.i = add nsw i64 %lsr.iv60.i, -1
  %exitcond1259.not.i = icmp eq i64 %lsr.iv.next61.i, 0
  br i1 %exitcond1259.not.i, label %part.0, label %B652.endif.2.i, !llvm.loop !54

part.0: ; preds = %B652.endif.2.i
  %.3072.i = load double, ptr %109, align 8, !noalias !51
  %.3126.i = load double, ptr %arg.room.4, align 8, !noalias !51
  %.3180.i = load double, ptr %.3178.i, align 8, !noalias !51
  %.3181.i = fmul double %.3126.i, %.3180.i
  %.3182.i = fadd double %.3072.i, %.3181.i
  %.3236.i = load double, ptr %sunkaddr134.i, align 8, !noalias !51
  %.3290.i = load double, ptr %.3288.i, align 8, !noalias !51
  %.3291.i = fmul double %.3236.i, %.3290.i
  %.3292.i = fadd double %.3182.i, %.3291.i
  %.3346.i = load double, ptr %95, align 8, !noalias !51
  %.3400.i = load double, ptr %.3398.i, align 8, !noalias !51
  %.3401.i = fmul double %.3346.i, %.3400.i
  %.3402.i = fadd double %.3292.i, %.3401.i
  store double %.3402.i, ptr %112, align 8, !noalias !51
  %.3072.1.i = load double, ptr %.3071.1.i, align 8, !noalias !51
  %.3126.1.i = load double, ptr %.2054.1.i, align 8, !noalias !51
  %.3180.1.i = load double, ptr %.3178.i, align 8, !noalias !51
  %.3181.1.i = fmul double %.3126.1.i, %.3180.1.i
  %.3182.1.i = fadd double %.3072.1.i, %.3181.1.i
  %.3236.1.i = load double, ptr %sunkaddr139.i, align 8, !noalias !51
  %.3290.1.i = load double, ptr %.3288.i, align 8, !noalias !51
  %.3291.1.i = fmul double %.3236.1.i, %.3290.1.i
  %.3292.1.i = fadd double %.3182.1.i, %.3291.1.i
  %.3346.1.i = load double, ptr %.2276.1.i, align 8, !noalias !51
  %.3400.1.i = load double, ptr %.3398.i, align 8, !noalias !51
  %.3401.1.i = fmul double %.3346.1.i, %.3400.1.i
  %.3402.1.i = fadd double %.3292.1.i, %.3401.1.i
  store double %.3402.1.i, ptr %.3455.1.i, align 8, !noalias !51
  %.3072.2.i = load double, ptr %.3071.2.i, align 8, !noalias !51
  %.3126.2.i = load double, ptr %invariant.gep1178.2.i, align 8, !noalias !51
  %.3180.2.i = load double, ptr %.3178.i, align 8, !noalias !51
  %.3181.2.i = fmul double %.3126.2.i, %.3180.2.i
  %.3182.2.i = fadd double %.3072.2.i, %.3181.2.i
  %.3236.2.i = load double, ptr %sunkaddr145.i, align 8, !noalias !51
  %.3290.2.i = load double, ptr %.3288.i, align 8, !noalias !51
  %.3291.2.i = fmul double %.3236.2.i, %.3290.2.i
  %.3292.2.i = fadd double %.3182.2.i, %.3291.2.i
  %.3346.2.i = load double, ptr %.2276.2.i, align 8, !noalias !51
  %.3400.2.i = load double, ptr %.3398.i, align 8, !noalias !51
  %.3401.2.i = fmul double %.3346.2.i, %.3400.2.i
  %.3402.2.i = fadd double %.3292.2.i, %.3401.2.i
  store double %.3402.2.i, ptr %.3455.2.i, align 8, !noalias !51
  %.511.peel.i = load double, ptr %.348.i, align 8, !noalias !55
  %.512.peel.i = fsub double %.3402.i, %.511.peel.i
  %.621.peel.i = load double, ptr %sunkaddr130.i, align 8, !noalias !55
  %.622.peel.i = fsub double %.3402.1.i, %.621.peel.i
  %.731.peel.i = load double, ptr %sunkaddr132.i, align 8, !noalias !55
  %.732.peel.i = fsub double %.3402.2.i, %.731.peel.i
  %.787.peel.i = load double, ptr %.786.peel.i, align 8, !noalias !55
  %.788.peel.i = fmul double %.787.peel.i, %.732.peel.i
  %.843.peel.i = load double, ptr %.842.peel.i, align 8, !noalias !55
  %.844.peel.i = fmul double %.622.peel.i, %.843.peel.i
  %.845.peel.i = fsub double %.788.peel.i, %.844.peel.i
  %.901.peel.i = fmul double %.512.peel.i, %.843.peel.i
  %.956.peel.i = load double, ptr %.121.i, align 8, !noalias !55
  %.957.peel.i = fmul double %.732.peel.i, %.956.peel.i
  %.958.peel.i = fsub double %.901.peel.i, %.957.peel.i
  %.1014.peel.i = fmul double %.622.peel.i, %.956.peel.i
  %.1070.peel.i = fmul double %.512.peel.i, %.787.peel.i
  %.1071.peel.i = fsub double %.1014.peel.i, %.1070.peel.i
  %.1258.peel.i = load double, ptr %.1431.peel.i, align 8, !noalias !55
  %.1274.peel.i = fmul double %.1258.peel.i, %.845.peel.i
  %.1386.peel.i = fmul double %.956.peel.i, %.1258.peel.i
  store double %.1274.peel.i, ptr %.444, align 8, !noalias !55
  store double %.1386.peel.i, ptr %gep709.peel.i, align 8, !noalias !55
  %.1558.peel.i = load double, ptr %.1577.peel.i, align 8, !noalias !55
  %.1560.peel.i = fcmp une double %.1558.peel.i, 0.000000e+00
  br i1 %.1560.peel.i, label %switch.end.1.peel.i, label %switch.end.1727.peel.i

switch.end.1.peel.i:                              ; preds = %part.0
  %.1618.peel.i = load double, ptr %invariant.gep710.peel.i, align 8, !noalias !55
  %.1689.peel.i = fmul double %.845.peel.i, %.1558.peel.i
  %.1690.peel.i = fsub double %.1618.peel.i, %.1689.peel.i
  store double %.1690.peel.i, ptr %invariant.gep710.peel.i, align 8, !noalias !55
  %.1798.peel.i = load double, ptr %gep713.peel.i, align 8, !noalias !55
  %.1853.peel.i = load double, ptr %.1577.peel.i, align 8, !noalias !55
  %.1909.peel.i = load double, ptr %sunkaddr102.i, align 8, !noalias !55
  %.1912.peel.i = fmul double %.1853.peel.i, %.1909.peel.i
  %.1913.peel.i = fsub double %.1798.peel.i, %.1912.peel.i
  store double %.1913.peel.i, ptr %gep713.peel.i, align 8, !noalias !55
  br label %switch.end.1727.peel.i

switch.end.1727.peel.i:                           ; preds = %part.0, %switch.end.1.peel.i
  %.1258.1.peel.i = load double, ptr %.1431.peel.i, align 8, !noalias !55
  %.1274.1.peel.i = fmul double %.958.peel.i, %.1258.1.peel.i
  %.1383.1.peel.i = load double, ptr %sunkaddr107.i, align 8, !noalias !55
  %.1386.1.peel.i = fmul double %.1258.1.peel.i, %.1383.1.peel.i
  store double %.1274.1.peel.i, ptr %gep.1.peel.i, align 8, !noalias !55
  store double %.1386.1.peel.i, ptr %gep709.1.peel.i, align 8, !noalias !55
  %.1558.1.peel.i = load double, ptr %.1577.peel.i, align 8, !noalias !55
  %.1560.1.peel.i = fcmp une double %.1558.1.peel.i, 0.000000e+00
  br i1 %.1560.1.peel.i, label %switch.end.1.1.peel.i, label %switch.end.2.peel.i

switch.end.1.1.peel.i:                            ; preds = %switch.end.1727.peel.i
  %.1618.1.peel.i = load double, ptr %gep711.1.peel.i, align 8, !noalias !55
  %.1689.1.peel.i = fmul double %.958.peel.i, %.1558.1.peel.i
  %.1690.1.peel.i = fsub double %.1618.1.peel.i, %.1689.1.peel.i
  store double %.1690.1.peel.i, ptr %gep711.1.peel.i, align 8, !noalias !55
  %.1798.1.peel.i = load double, ptr %gep713.1.peel.i, align 8, !noalias !55
  %.1853.1.peel.i = load double, ptr %.1577.peel.i, align 8, !noalias !55
  %.1909.1.peel.i = load double, ptr %sunkaddr107.i, align 8, !noalias !55
  %.1912.1.peel.i = fmul double %.1853.1.peel.i, %.1909.1.peel.i
  %.1913.1.peel.i = fsub double %.1798.1.peel.i, %.1912.1.peel.i
  store double %.1913.1.peel.i, ptr %gep713.1.peel.i, align 8, !noalias !55
  br label %switch.end.2.peel.i

switch.end.2.peel.i:                              ; preds = %switch.end.1.1.peel.i, %switch.end.1727.peel.i
  %.1258.2.peel.i = load double, ptr %.1431.peel.i, align 8, !noalias !55
  %.1274.2.peel.i = fmul double %.1071.peel.i, %.1258.2.peel.i
  %.1383.2.peel.i = load double, ptr %sunkaddr112.i, align 8, !noalias !55
  %.1386.2.peel.i = fmul double %.1258.2.peel.i, %.1383.2.peel.i
  store double %.1274.2.peel.i, ptr %gep.2.peel.i, align 8, !noalias !55
  store double %.1386.2.peel.i, ptr %gep709.2.peel.i, align 8, !noalias !55
  %.1558.2.peel.i = load double, ptr %.1577.peel.i, align 8, !noalias !55
  %.1560.2.peel.i = fcmp une double %.1558.2.peel.i, 0.000000e+00
  br i1 %.1560.2.peel.i, label %switch.end.1.2.peel.i, label %switch.end.i.preheader

switch.end.1.2.peel.i:                            ; preds = %switch.end.2.peel.i
  %.1618.2.peel.i = load double, ptr %gep711.2.peel.i, align 8, !noalias !55
  %.1689.2.peel.i = fmul double %.1071.peel.i, %.1558.2.peel.i
  %.1690.2.peel.i = fsub double %.1618.2.peel.i, %.1689.2.peel.i
  store double %.1690.2.peel.i, ptr %gep711.2.peel.i, align 8, !noalias !55
  %.1798.2.peel.i = load double, ptr %gep713.2.peel.i, align 8, !noalias !55
  %.1853.2.peel.i = load double, ptr %.1577.peel.i, align 8, !noalias !55
  %.1909.2.peel.i = load double, ptr %sunkaddr112.i, align 8, !noalias !55
  %.1912.2.peel.i = fmul double %.1853.2.peel.i, %.1909.2.peel.i
  %.1913.2.peel.i = fsub double %.1798.2.peel.i, %.1912.2.peel.i
  store double %.1913.2.peel.i, ptr %gep713.2.peel.i, align 8, !noalias !55
  br label %switch.end.i.preheader

switch.end.i.preheader:                           ; preds = %switch.end.1.2.peel.i, %switch.end.2.peel.i
  br label %switch.end.i

switch.end.1727.i:                                ; preds = %switch.end.1.i, %switch.end.i
  %.1258.1.i = load double, ptr %scevgep3.i, align 8, !noalias !55
  %.1274.1.i = fmul double %.958.i, %.1258.1.i
  %.1383.1.i = load double, ptr %scevgep9.i, align 8, !noalias !55
  %.1386.1.i = fmul double %.1258.1.i, %.1383.1.i
  %scevgep43.i = getelementptr i8, ptr %scevgep41.i, i64 %lsr.iv21.i
  %scevgep44.i4 = getelementptr i8, ptr %scevgep43.i, i64 8
  store double %.1274.1.i, ptr %scevgep44.i4, align 8, !noalias !55
  %scevgep28.i = getelementptr i8, ptr %scevgep26.i, i64 %lsr.iv21.i
  %scevgep29.i = getelementptr i8, ptr %scevgep28.i, i64 8
  store double %.1386.1.i, ptr %scevgep29.i, align 8, !noalias !55
  %.1558.1.i = load double, ptr %lsr.iv.i2, align 8, !noalias !55
  %.1560.1.i = fcmp une double %.1558.1.i, 0.000000e+00
  br i1 %.1560.1.i, label %switch.end.1.1.i, label %switch.end.2.i

switch.end.1.1.i:                                 ; preds = %switch.end.1727.i
  %.1618.1.i = load double, ptr %scevgep43.i, align 8, !noalias !55
  %.1689.1.i = fmul double %.958.i, %.1558.1.i
  %.1690.1.i = fsub double %.1618.1.i, %.1689.1.i
  store double %.1690.1.i, ptr %scevgep43.i, align 8, !noalias !55
  %.1798.1.i = load double, ptr %scevgep28.i, align 8, !noalias !55
  %.1853.1.i = load double, ptr %lsr.iv.i2, align 8, !noalias !55
  %.1909.1.i = load double, ptr %scevgep9.i, align 8, !noalias !55
  %.1912.1.i = fmul double %.1853.1.i, %.1909.1.i
  %.1913.1.i = fsub double %.1798.1.i, %.1912.1.i
  store double %.1913.1.i, ptr %scevgep28.i, align 8, !noalias !55
  br label %switch.end.2.i

switch.end.2.i:                                   ; preds = %switch.end.1.1.i, %switch.end.1727.i
  %.1258.2.i = load double, ptr %scevgep3.i, align 8, !noalias !55
  %.1274.2.i = fmul double %.1071.i, %.1258.2.i
  %.1383.2.i = load double, ptr %scevgep6.i, align 8, !noalias !55
  %.1386.2.i = fmul double %.1258.2.i, %.1383.2.i
  %scevgep39.i = getelementptr i8, ptr %scevgep37.i1, i64 %lsr.iv21.i
  %scevgep40.i = getelementptr i8, ptr %scevgep39.i, i64 8
  store double %.1274.2.i, ptr %scevgep40.i, align 8, !noalias !55
  %scevgep32.i = getelementptr i8, ptr %scevgep30.i, i64 %lsr.iv21.i
  %scevgep33.i5 = getelementptr i8, ptr %scevgep32.i, i64 8
  store double %.1386.2.i, ptr %scevgep33.i5, align 8, !noalias !55
  %.1558.2.i = load double, ptr %lsr.iv.i2, align 8, !noalias !55
  %.1560.2.i = fcmp une double %.1558.2.i, 0.000000e+00
  br i1 %.1560.2.i, label %switch.end.1.2.i, label %B702.2.i

switch.end.1.2.i:                                 ; preds = %switch.end.2.i
  %.1618.2.i = load double, ptr %scevgep39.i, align 8, !noalias !55
  %.1689.2.i = fmul double %.1071.i, %.1558.2.i
  %.1690.2.i = fsub double %.1618.2.i, %.1689.2.i
  store double %.1690.2.i, ptr %scevgep39.i, align 8, !noalias !55
  %.1798.2.i = load double, ptr %scevgep32.i, align 8, !noalias !55
  %.1853.2.i = load double, ptr %lsr.iv.i2, align 8, !noalias !55
  %.1909.2.i = load double, ptr %scevgep6.i, align 8, !noalias !55
  %.1912.2.i = fmul double %.1853.2.i, %.1909.2.i
  %.1913.2.i = fsub double %.1798.2.i, %.1912.2.i
  store double %.1913.2.i, ptr %scevgep32.i, align 8, !noalias !55
  br label %B702.2.i

B702.2.i:                                         ; preds = %switch.end.1.2.i, %switch.end.2.i
  %scevgep2.i = getelementptr i8, ptr %lsr.iv.i2, i64 %106
  %lsr.iv.next22.i = add nuw nsw i64 %lsr.iv21.i, 8
  %scevgep5.i = getelementptr i8, ptr %lsr.iv2.i, i64 %97
  %exitcond.not.i = icmp eq i64 %lsr.iv.next22.i, 40
  br i1 %exitcond.not.i, label %part.4, label %switch.end.i, !llvm.loop !58

switch.end.i:                                     ; preds = %switch.end.i.preheader, %B702.2.i
  %lsr.iv2.i = phi ptr [ %scevgep5.i, %B702.2.i ], [ %invariant.gep1178.2.i, %switch.end.i.preheader ]
  %lsr.iv21.i = phi i64 [ %lsr.iv.next22.i, %B702.2.i ], [ 0, %switch.end.i.preheader ]
  %lsr.iv.i2 = phi ptr [ %scevgep2.i, %B702.2.i ], [ %scevgep49.i, %switch.end.i.preheader ]
  %.456.i = load double, ptr %112, align 8, !noalias !55
  %scevgep11.i = getelementptr i8, ptr %lsr.iv2.i, i64 %100
  %scevgep16.i = getelementptr i8, ptr %scevgep11.i, i64 -16
  %.511.i = load double, ptr %scevgep16.i, align 8, !noalias !55
  %.512.i = fsub double %.456.i, %.511.i
  %.566.i = load double, ptr %.3455.1.i, align 8, !noalias !55
  %scevgep15.i = getelementptr i8, ptr %scevgep11.i, i64 -8
  %.621.i = load double, ptr %scevgep15.i, align 8, !noalias !55
  %.622.i3 = fsub double %.566.i, %.621.i
  %.676.i = load double, ptr %.3455.2.i, align 8, !noalias !55
  %.731.i = load double, ptr %scevgep11.i, align 8, !noalias !55
  %.732.i = fsub double %.676.i, %.731.i
  %scevgep6.i = getelementptr i8, ptr %lsr.iv2.i, i64 %104
  %scevgep9.i = getelementptr i8, ptr %scevgep6.i, i64 -8
  %.787.i = load double, ptr %scevgep9.i, align 8, !noalias !55
  %.788.i = fmul double %.787.i, %.732.i
  %.843.i = load double, ptr %scevgep6.i, align 8, !noalias !55
  %.844.i = fmul double %.622.i3, %.843.i
  %.845.i = fsub double %.788.i, %.844.i
  %.901.i = fmul double %.512.i, %.843.i
  %scevgep8.i = getelementptr i8, ptr %scevgep6.i, i64 -16
  %.956.i = load double, ptr %scevgep8.i, align 8, !noalias !55
  %.957.i = fmul double %.732.i, %.956.i
  %.958.i = fsub double %.901.i, %.957.i
  %.1014.i = fmul double %.622.i3, %.956.i
  %.1070.i = fmul double %.512.i, %.787.i
  %.1071.i = fsub double %.1014.i, %.1070.i
  %scevgep3.i = getelementptr i8, ptr %lsr.iv.i2, i64 -40
  %scevgep35.i = getelementptr i8, ptr %.444, i64 %lsr.iv21.i
  %scevgep36.i = getelementptr i8, ptr %scevgep35.i, i64 8
  %.1258.i = load double, ptr %scevgep3.i, align 8, !noalias !55
  %.1274.i = fmul double %.1258.i, %.845.i
  %.1386.i = fmul double %.956.i, %.1258.i
  store double %.1274.i, ptr %scevgep36.i, align 8, !noalias !55
  %scevgep24.i = getelementptr i8, ptr %scevgep20.i, i64 %lsr.iv21.i
  %scevgep25.i = getelementptr i8, ptr %scevgep24.i, i64 8
  store double %.1386.i, ptr %scevgep25.i, align 8, !noalias !55
  %.1558.i = load double, ptr %lsr.iv.i2, align 8, !noalias !55
  %.1560.i = fcmp une double %.1558.i, 0.000000e+00
  br i1 %.1560.i, label %switch.end.1.i, label %switch.end.1727.i

switch.end.1.i:                                   ; preds = %switch.end.i
  %.1618.i = load double, ptr %scevgep35.i, align 8, !noalias !55
  %.1689.i = fmul double %.845.i, %.1558.i
  %.1690.i = fsub double %.1618.i, %.1689.i
  store double %.1690.i, ptr %scevgep35.i, align 8, !noalias !55
  %.1798.i = load double, ptr %scevgep24.i, align 8, !noalias !55
  %.1853.i = load double, ptr %lsr.iv.i2, align 8, !noalias !55
  %.1909.i = load double, ptr %scevgep8.i, align 8, !noalias !55
  %.1912.i = fmul double %.1853.i, %.1909.i
  %.1913.i = fsub double %.1798.i, %.1912.i
  store double %.1913.i, ptr %scevgep24.i, align 8, !noalias !55
  br label %switch.end.1727.i

part.4: ; preds = %B702.2.i
  store double 0.000000e+00, ptr %.546, align 8, !noalias !59
  store double 1.000000e+00, ptr %116, align 8, !noalias !59
  store double 2.000000e+00, ptr %117, align 8, !noalias !59
  store double 3.000000e+00, ptr %118, align 8, !noalias !59
  store double 4.000000e+00, ptr %119, align 8, !noalias !59
  store double 5.000000e+00, ptr %120, align 8, !noalias !59
  br label %B84.endif.i

B130.i:                                           ; preds = %B130.prol.loopexit.i, %B130.i
  %lsr.iv12.i = phi ptr [ %scevgep13.1.i, %B130.i ], [ %lsr.iv12.unr.i, %B130.prol.loopexit.i ]
  %p.2.1649.i = phi i64 [ %p.3.2.fr.1.i, %B130.i ], [ %p.2.1649.unr.i, %B130.prol.loopexit.i ]
  %.405645647.i = phi i64 [ %10, %B130.i ], [ %.405645647.unr.i, %B130.prol.loopexit.i ]
  %.497.i = load double, ptr %lsr.iv12.i, align 8, !noalias !59
  %.500.i = tail call double @llvm.fabs.f64(double %.497.i)
  %.529.i = icmp slt i64 %p.2.1649.i, 0
  %.530.i = select i1 %.529.i, i64 %.413, i64 0
  %.531.i = add i64 %.530.i, %p.2.1649.i
  %.551.i = mul i64 %.531.i, %arg.room.5.2
  %gep653.i = getelementptr double, ptr %invariant.gep.i, i64 %.551.i
  %.556.i = load double, ptr %gep653.i, align 8, !noalias !59
  %.559.i = tail call double @llvm.fabs.f64(double %.556.i)
  %.560.i = fcmp ogt double %.500.i, %.559.i
  %p.3.2.i = select i1 %.560.i, i64 %.405645647.i, i64 %p.2.1649.i
  %p.3.2.fr.i = freeze i64 %p.3.2.i
  %scevgep13.i = getelementptr i8, ptr %lsr.iv12.i, i64 %97
  %.497.1.i = load double, ptr %scevgep13.i, align 8, !noalias !59
  %.500.1.i = tail call double @llvm.fabs.f64(double %.497.1.i)
  %.529.1.i = icmp slt i64 %p.3.2.fr.i, 0
  %.530.1.i = select i1 %.529.1.i, i64 %.413, i64 0
  %.531.1.i = add i64 %.530.1.i, %p.3.2.fr.i
  %.551.1.i = mul i64 %.531.1.i, %arg.room.5.2
  %gep653.1.i = getelementptr double, ptr %invariant.gep.i, i64 %.551.1.i
  %.556.1.i = load double, ptr %gep653.1.i, align 8, !noalias !59
  %.559.1.i = tail call double @llvm.fabs.f64(double %.556.1.i)
  %.560.1.i = fcmp ogt double %.500.1.i, %.559.1.i
  %9 = add i64 %.405645647.i, 1
  %p.3.2.1.i = select i1 %.560.1.i, i64 %9, i64 %p.3.2.fr.i
  %p.3.2.fr.1.i = freeze i64 %p.3.2.1.i
  %scevgep13.1.i = getelementptr i8, ptr %scevgep13.i, i64 %97
  %10 = add i64 %.405645647.i, 2
  %exitcond.not.1.i = icmp eq i64 %10, 6
  br i1 %exitcond.not.1.i, label %B234.i, label %B130.i

B234.i:                                           ; preds = %B130.i, %B130.prol.loopexit.i
  %p.3.2.fr.lcssa.i = phi i64 [ %p.3.2.fr.lcssa.unr.i, %B130.prol.loopexit.i ], [ %p.3.2.fr.1.i, %B130.i ]
  %.606.i = icmp slt i64 %p.3.2.fr.lcssa.i, 0
  %spec.select.i = select i1 %.606.i, i64 %.413, i64 0
  br label %B234.thread.i

B234.thread.i:                                    ; preds = %B84.endif.i, %B234.i
  %p.2.1.lcssa4.i = phi i64 [ 5, %B84.endif.i ], [ %p.3.2.fr.lcssa.i, %B234.i ]
  %11 = phi i64 [ 0, %B84.endif.i ], [ %spec.select.i, %B234.i ]
  %.608.i = add i64 %11, %p.2.1.lcssa4.i
  %.628.i = mul i64 %.608.i, %arg.room.5.2
  %12 = getelementptr double, ptr %.444, i64 %.628.i
  %.632.i = getelementptr double, ptr %12, i64 %.279686707.i
  %.633.i = load double, ptr %.632.i, align 8, !noalias !59
  %.637.i = fcmp oeq double %.633.i, 0.000000e+00
  br i1 %.637.i, label %B262.i, label %B296.i

B262.i:                                           ; preds = %B234.thread.i
  %sunkaddr28.i = getelementptr i8, ptr %12, i64 %15
  store double 0x7FF8000000000000, ptr %sunkaddr28.i, align 8, !noalias !59
  br label %B296.i

B296.i:                                           ; preds = %B262.i, %B234.thread.i
  %.698.not.i = icmp eq i64 %p.2.1.lcssa4.i, %.279686707.i
  br i1 %.698.not.i, label %B452.endif.i, label %B308.endif.endif.i

B84.endif.loopexit.i:                             ; preds = %B584.B490.loopexit_crit_edge.us.loopexit.i, %B492.us.us.us.i
  %scevgep11.i32 = getelementptr i8, ptr %lsr.iv.i7, i64 %121
  %scevgep16.i33 = getelementptr i8, ptr %lsr.iv15.i, i64 %97
  %scevgep24.i34 = getelementptr i8, ptr %lsr.iv23.i, i64 %97
  %scevgep79.i35 = getelementptr i8, ptr %lsr.iv78.i, i64 %97
  %scevgep85.i36 = getelementptr i8, ptr %lsr.iv84.i, i64 %97
  br label %B84.endif.i

B84.endif.i:                                      ; preds = %B84.endif.loopexit.i, %part.4
  %lsr.iv84.i = phi ptr [ %scevgep85.i36, %B84.endif.loopexit.i ], [ %.444, %part.4 ]
  %lsr.iv78.i = phi ptr [ %scevgep79.i35, %B84.endif.loopexit.i ], [ %scevgep41.i, %part.4 ]
  %lsr.iv23.i = phi ptr [ %scevgep24.i34, %B84.endif.loopexit.i ], [ %scevgep22.i, %part.4 ]
  %lsr.iv15.i = phi ptr [ %scevgep16.i33, %B84.endif.loopexit.i ], [ %scevgep14.i, %part.4 ]
  %lsr.iv.i7 = phi ptr [ %scevgep11.i32, %B84.endif.loopexit.i ], [ %scevgep41.i, %part.4 ]
  %.279686707.i = phi i64 [ %.286.i, %B84.endif.loopexit.i ], [ 0, %part.4 ]
  %13 = mul i64 %.279686707.i, %97
  %14 = mul i64 %.279686707.i, %121
  %scevgep39.i8 = getelementptr i8, ptr %scevgep41.i, i64 %14
  %15 = shl i64 %.279686707.i, 3
  %scevgep40.i9 = getelementptr i8, ptr %122, i64 %15
  %scevgep41.i10 = getelementptr i8, ptr %.444, i64 %13
  %scevgep45.i11 = getelementptr i8, ptr %scevgep41.i10, i64 16
  %.286.i = add nuw nsw i64 %.279686707.i, 1
  %.357.not.i = icmp eq i64 %.279686707.i, 5
  br i1 %.357.not.i, label %B234.thread.i, label %B130.lr.ph.i

B130.lr.ph.i:                                     ; preds = %B84.endif.i
  %invariant.gep.i = getelementptr double, ptr %.444, i64 %.279686707.i
  %16 = and i64 %.279686707.i, 1
  %lcmp.mod.not.not.i = icmp eq i64 %16, 0
  br i1 %lcmp.mod.not.not.i, label %B130.prol.i, label %B130.prol.loopexit.i

B130.prol.i:                                      ; preds = %B130.lr.ph.i
  %.412.prol.i = add nuw nsw i64 %.279686707.i, 2
  %.497.prol.i = load double, ptr %lsr.iv.i7, align 8, !noalias !59
  %.500.prol.i = tail call double @llvm.fabs.f64(double %.497.prol.i)
  %.551.prol.i = mul i64 %.279686707.i, %arg.room.5.2
  %gep653.prol.i = getelementptr double, ptr %invariant.gep.i, i64 %.551.prol.i
  %.556.prol.i = load double, ptr %gep653.prol.i, align 8, !noalias !59
  %.559.prol.i = tail call double @llvm.fabs.f64(double %.556.prol.i)
  %.560.prol.i = fcmp ogt double %.500.prol.i, %.559.prol.i
  %p.3.2.prol.i = select i1 %.560.prol.i, i64 %.286.i, i64 %.279686707.i
  %p.3.2.fr.prol.i = freeze i64 %p.3.2.prol.i
  %scevgep13.prol.i = getelementptr i8, ptr %lsr.iv.i7, i64 %97
  br label %B130.prol.loopexit.i

B130.prol.loopexit.i:                             ; preds = %B130.prol.i, %B130.lr.ph.i
  %p.3.2.fr.lcssa.unr.i = phi i64 [ poison, %B130.lr.ph.i ], [ %p.3.2.fr.prol.i, %B130.prol.i ]
  %lsr.iv12.unr.i = phi ptr [ %lsr.iv.i7, %B130.lr.ph.i ], [ %scevgep13.prol.i, %B130.prol.i ]
  %p.2.1649.unr.i = phi i64 [ %.279686707.i, %B130.lr.ph.i ], [ %p.3.2.fr.prol.i, %B130.prol.i ]
  %.405645647.unr.i = phi i64 [ %.286.i, %B130.lr.ph.i ], [ %.412.prol.i, %B130.prol.i ]
  %17 = icmp eq i64 %.279686707.i, 4
  br i1 %17, label %B234.i, label %B130.i

B308.endif.endif.i:                               ; preds = %B296.i
  %18 = icmp slt i64 %p.2.1.lcssa4.i, 0
  %.715.i = select i1 %18, i64 %arg.room.5.2, i64 0
  %19 = getelementptr double, ptr %.546, i64 %p.2.1.lcssa4.i
  %.729.i = getelementptr double, ptr %19, i64 %.715.i
  %.730.i = load double, ptr %.729.i, align 8, !noalias !59
  %20 = getelementptr double, ptr %.546, i64 %.279686707.i
  %.761.i = load double, ptr %20, align 8, !noalias !59
  store double %.730.i, ptr %20, align 8, !noalias !59
  store double %.761.i, ptr %.729.i, align 8, !noalias !59
  %.1043.i = mul i64 %.279686707.i, %arg.room.5.2
  %21 = getelementptr double, ptr %.444, i64 %.1043.i
  %.993.i = load double, ptr %12, align 8, !noalias !59
  %.1048.i = load double, ptr %21, align 8, !noalias !59
  store double %.993.i, ptr %21, align 8, !noalias !59
  store double %.1048.i, ptr %12, align 8, !noalias !59
  %.992.1.i = getelementptr i8, ptr %12, i64 8
  %.993.1.i = load double, ptr %.992.1.i, align 8, !noalias !59
  %.1047.1.i = getelementptr i8, ptr %21, i64 8
  %.1048.1.i = load double, ptr %.1047.1.i, align 8, !noalias !59
  store double %.993.1.i, ptr %.1047.1.i, align 8, !noalias !59
  store double %.1048.1.i, ptr %.992.1.i, align 8, !noalias !59
  %.992.2.i = getelementptr i8, ptr %12, i64 16
  %.993.2.i = load double, ptr %.992.2.i, align 8, !noalias !59
  %.1047.2.i = getelementptr i8, ptr %21, i64 16
  %.1048.2.i = load double, ptr %.1047.2.i, align 8, !noalias !59
  store double %.993.2.i, ptr %.1047.2.i, align 8, !noalias !59
  store double %.1048.2.i, ptr %.992.2.i, align 8, !noalias !59
  %.992.3.i = getelementptr i8, ptr %12, i64 24
  %.993.3.i = load double, ptr %.992.3.i, align 8, !noalias !59
  %.1047.3.i = getelementptr i8, ptr %21, i64 24
  %.1048.3.i = load double, ptr %.1047.3.i, align 8, !noalias !59
  store double %.993.3.i, ptr %.1047.3.i, align 8, !noalias !59
  store double %.1048.3.i, ptr %.992.3.i, align 8, !noalias !59
  %.992.4.i = getelementptr i8, ptr %12, i64 32
  %.993.4.i = load double, ptr %.992.4.i, align 8, !noalias !59
  %.1047.4.i = getelementptr i8, ptr %21, i64 32
  %.1048.4.i = load double, ptr %.1047.4.i, align 8, !noalias !59
  store double %.993.4.i, ptr %.1047.4.i, align 8, !noalias !59
  store double %.1048.4.i, ptr %.992.4.i, align 8, !noalias !59
  %.992.5.i = getelementptr i8, ptr %12, i64 40
  %.993.5.i = load double, ptr %.992.5.i, align 8, !noalias !59
  %.1047.5.i = getelementptr i8, ptr %21, i64 40
  %.1048.5.i = load double, ptr %.1047.5.i, align 8, !noalias !59
  store double %.993.5.i, ptr %.1047.5.i, align 8, !noalias !59
  store double %.1048.5.i, ptr %.992.5.i, align 8, !noalias !59
  br label %B452.endif.i

B452.endif.i:                                     ; preds = %B308.endif.endif.i, %B296.i
  %invariant.gep665.i = getelementptr double, ptr %.444, i64 %.279686707.i
  br i1 %.357.not.i, label %part.5, label %B492.us.preheader.i

B492.us.preheader.i:                              ; preds = %B452.endif.i
  %.1392.i = mul i64 %.279686707.i, %arg.room.5.2
  %22 = getelementptr double, ptr %.444, i64 %.1392.i
  %.1548.us.prol.i = add nuw nsw i64 %.279686707.i, 2
  %invariant.gep5.i = getelementptr double, ptr %.444, i64 %.286.i
  %23 = icmp eq i64 %.279686707.i, 4
  br i1 %23, label %B492.us.us.us.i, label %B492.us.preheader77.i

B492.us.preheader77.i:                            ; preds = %B492.us.preheader.i
  %24 = getelementptr i8, ptr %scevgep41.i, i64 %13
  %25 = getelementptr i8, ptr %123, i64 %13
  %26 = and i64 %.279686707.i, 1
  %27 = icmp eq i64 %26, 0
  %sunkaddr102.i12 = shl i64 %.1392.i, 3
  %sunkaddr103.i = getelementptr i8, ptr %invariant.gep665.i, i64 %sunkaddr102.i12
  %sunkaddr104.i = shl i64 %.286.i, 3
  %sunkaddr105.i = getelementptr i8, ptr %22, i64 %sunkaddr104.i
  br label %B492.us.i

B492.us.us.us.i:                                  ; preds = %B492.us.preheader.i
  %gep666.us.us.us.i = getelementptr double, ptr %invariant.gep665.i, i64 %.1496.2.i
  %.1343.us.us.us.i = load double, ptr %gep666.us.us.us.i, align 8, !noalias !59
  %sunkaddr98.i = shl i64 %.1392.i, 3
  %sunkaddr99.i = getelementptr i8, ptr %invariant.gep665.i, i64 %sunkaddr98.i
  %.1397.us.us.us.i = load double, ptr %sunkaddr99.i, align 8, !noalias !59
  %.1403.us.us.us.i = fdiv double %.1343.us.us.us.i, %.1397.us.us.us.i
  store double %.1403.us.us.us.i, ptr %gep666.us.us.us.i, align 8, !noalias !59
  %gep.us.us.i = getelementptr double, ptr %invariant.gep5.i, i64 %.1496.2.i
  %.1625.us.prol.us.us.i = load double, ptr %gep.us.us.i, align 8, !noalias !59
  %sunkaddr101.i37 = getelementptr i8, ptr %22, i64 40
  %.1734.us.prol.us.us.i = load double, ptr %sunkaddr101.i37, align 8, !noalias !59
  %.1737.us.prol.us.us.i = fmul double %.1403.us.us.us.i, %.1734.us.prol.us.us.i
  %.1738.us.prol.us.us.i = fsub double %.1625.us.prol.us.us.i, %.1737.us.prol.us.us.i
  store double %.1738.us.prol.us.us.i, ptr %gep.us.us.i, align 8, !noalias !59
  br label %B84.endif.loopexit.i

B492.us.i:                                        ; preds = %B584.B490.loopexit_crit_edge.us.loopexit.i, %B492.us.preheader77.i
  %lsr.iv80.i = phi ptr [ %lsr.iv78.i, %B492.us.preheader77.i ], [ %scevgep81.i, %B584.B490.loopexit_crit_edge.us.loopexit.i ]
  %indvar.i = phi i64 [ 0, %B492.us.preheader77.i ], [ %indvar.next.i, %B584.B490.loopexit_crit_edge.us.loopexit.i ]
  %lsr.iv17.i = phi ptr [ %lsr.iv15.i, %B492.us.preheader77.i ], [ %scevgep18.i, %B584.B490.loopexit_crit_edge.us.loopexit.i ]
  %.1255670676.us.i = phi i64 [ %.286.i, %B492.us.preheader77.i ], [ %.1262.us.i, %B584.B490.loopexit_crit_edge.us.loopexit.i ]
  %28 = mul i64 %indvar.i, %97
  %scevgep33.i13 = getelementptr i8, ptr %24, i64 %28
  %scevgep37.i14 = getelementptr i8, ptr %25, i64 %28
  %.1338.us.i = mul i64 %.1255670676.us.i, %arg.room.5.2
  %gep666.us.i = getelementptr double, ptr %invariant.gep665.i, i64 %.1338.us.i
  %.1343.us.i = load double, ptr %gep666.us.i, align 8, !noalias !59
  %.1397.us.i = load double, ptr %sunkaddr103.i, align 8, !noalias !59
  %.1403.us.i = fdiv double %.1343.us.i, %.1397.us.i
  store double %.1403.us.i, ptr %gep666.us.i, align 8, !noalias !59
  br i1 %27, label %B586.us.prol.i, label %B492.us.B586.us.prol.loopexit_crit_edge.i

B492.us.B586.us.prol.loopexit_crit_edge.i:        ; preds = %B492.us.i
  %.pre.i15 = shl i64 %.1338.us.i, 3
  br label %B586.us.prol.loopexit.i

B586.us.prol.i:                                   ; preds = %B492.us.i
  %gep.i = getelementptr double, ptr %invariant.gep5.i, i64 %.1338.us.i
  %.1625.us.prol.i = load double, ptr %gep.i, align 8, !noalias !59
  %sunkaddr31.i = shl i64 %.1338.us.i, 3
  %sunkaddr32.i = getelementptr i8, ptr %invariant.gep665.i, i64 %sunkaddr31.i
  %.1679.us.prol.i = load double, ptr %sunkaddr32.i, align 8, !noalias !59
  %.1734.us.prol.i = load double, ptr %sunkaddr105.i, align 8, !noalias !59
  %.1737.us.prol.i = fmul double %.1679.us.prol.i, %.1734.us.prol.i
  %.1738.us.prol.i = fsub double %.1625.us.prol.i, %.1737.us.prol.i
  store double %.1738.us.prol.i, ptr %gep.i, align 8, !noalias !59
  br label %B586.us.prol.loopexit.i

B586.us.prol.loopexit.i:                          ; preds = %B586.us.prol.i, %B492.us.B586.us.prol.loopexit_crit_edge.i
  %sunkaddr35.pre-phi.i = phi i64 [ %.pre.i15, %B492.us.B586.us.prol.loopexit_crit_edge.i ], [ %sunkaddr31.i, %B586.us.prol.i ]
  %.1541659661.us.unr.i = phi i64 [ %.286.i, %B492.us.B586.us.prol.loopexit_crit_edge.i ], [ %.1548.us.prol.i, %B586.us.prol.i ]
  %29 = sub i64 4, %.1541659661.us.unr.i
  %30 = lshr i64 %29, 1
  %31 = add nuw i64 %30, 1
  %min.iters.check.i = icmp ult i64 %29, 66
  br i1 %min.iters.check.i, label %B586.us.preheader.i, label %vector.scevcheck.i

vector.scevcheck.i:                               ; preds = %B586.us.prol.loopexit.i
  %32 = shl nuw nsw i64 %.1541659661.us.unr.i, 3
  %scevgep15.i16 = getelementptr i8, ptr %scevgep33.i13, i64 %32
  %mul.result.i = shl i64 %30, 4
  %33 = getelementptr i8, ptr %scevgep15.i16, i64 %mul.result.i
  %34 = icmp ult ptr %33, %scevgep15.i16
  %scevgep17.i = getelementptr i8, ptr %lsr.iv17.i, i64 %32
  %mul.overflow20.i = icmp ugt i64 %29, 2305843009213693951
  %35 = getelementptr i8, ptr %scevgep17.i, i64 %mul.result.i
  %36 = icmp ult ptr %35, %scevgep17.i
  %37 = or i1 %mul.overflow20.i, %36
  %scevgep25.i17 = getelementptr i8, ptr %scevgep41.i10, i64 %32
  %38 = getelementptr i8, ptr %scevgep25.i17, i64 %mul.result.i
  %39 = icmp ult ptr %38, %scevgep25.i17
  %scevgep29.i18 = getelementptr i8, ptr %lsr.iv23.i, i64 %32
  %40 = getelementptr i8, ptr %scevgep29.i18, i64 %mul.result.i
  %41 = icmp ult ptr %40, %scevgep29.i18
  %42 = or i1 %34, %37
  %43 = or i1 %39, %42
  %44 = or i1 %41, %43
  br i1 %44, label %B586.us.preheader.i, label %vector.memcheck.i

vector.memcheck.i:                                ; preds = %vector.scevcheck.i
  %45 = sub nsw i64 32, %32
  %46 = and i64 %45, -16
  %47 = add i64 %46, %32
  %scevgep35.i19 = getelementptr i8, ptr %lsr.iv17.i, i64 %47
  %scevgep38.i20 = getelementptr i8, ptr %scevgep37.i14, i64 %47
  %scevgep43.i21 = getelementptr i8, ptr %lsr.iv23.i, i64 %47
  %scevgep46.i = getelementptr i8, ptr %scevgep45.i11, i64 %47
  %bound0.i = icmp ult ptr %scevgep15.i16, %scevgep38.i20
  %bound1.i = icmp ult ptr %scevgep17.i, %scevgep35.i19
  %found.conflict.i = and i1 %bound0.i, %bound1.i
  %bound047.i = icmp ult ptr %scevgep15.i16, %scevgep40.i9
  %bound148.i = icmp ult ptr %scevgep39.i8, %scevgep35.i19
  %found.conflict49.i = and i1 %bound047.i, %bound148.i
  %48 = or i1 %124, %found.conflict49.i
  %conflict.rdx.i = or i1 %found.conflict.i, %48
  %bound050.i = icmp ult ptr %scevgep15.i16, %scevgep43.i21
  %bound151.i = icmp ult ptr %scevgep25.i17, %scevgep35.i19
  %found.conflict52.i = and i1 %bound050.i, %bound151.i
  %conflict.rdx53.i = or i1 %found.conflict52.i, %conflict.rdx.i
  %bound054.i = icmp ult ptr %scevgep15.i16, %scevgep46.i
  %bound155.i = icmp ult ptr %scevgep29.i18, %scevgep35.i19
  %found.conflict56.i = and i1 %bound054.i, %bound155.i
  %conflict.rdx57.i = or i1 %found.conflict56.i, %conflict.rdx53.i
  %bound058.i = icmp ult ptr %scevgep17.i, %scevgep40.i9
  %bound159.i = icmp ult ptr %scevgep39.i8, %scevgep38.i20
  %found.conflict60.i = and i1 %bound058.i, %bound159.i
  %conflict.rdx62.i = or i1 %found.conflict60.i, %conflict.rdx57.i
  %bound063.i = icmp ult ptr %scevgep17.i, %scevgep43.i21
  %bound164.i = icmp ult ptr %scevgep25.i17, %scevgep38.i20
  %found.conflict65.i = and i1 %bound063.i, %bound164.i
  %conflict.rdx66.i = or i1 %found.conflict65.i, %conflict.rdx62.i
  %bound067.i = icmp ult ptr %scevgep17.i, %scevgep46.i
  %bound168.i = icmp ult ptr %scevgep29.i18, %scevgep38.i20
  %found.conflict69.i = and i1 %bound067.i, %bound168.i
  %conflict.rdx70.i = or i1 %found.conflict69.i, %conflict.rdx66.i
  br i1 %conflict.rdx70.i, label %B586.us.preheader.i, label %vector.ph.i

vector.ph.i:                                      ; preds = %vector.memcheck.i
  %n.vec.i = and i64 %31, -2
  %sunkaddr106.i = getelementptr i8, ptr %invariant.gep665.i, i64 %sunkaddr35.pre-phi.i
  br label %vector.body.i

vector.body.i:                                    ; preds = %vector.body.i, %vector.ph.i
  %lsr.iv87.i = phi i64 [ %lsr.iv.next88.i, %vector.body.i ], [ %n.vec.i, %vector.ph.i ]
  %lsr.iv82.i = phi i64 [ %lsr.iv.next.i24, %vector.body.i ], [ %32, %vector.ph.i ]
  %scevgep83.i22 = getelementptr i8, ptr %lsr.iv80.i, i64 %lsr.iv82.i
  %wide.vec.i = load <4 x double>, ptr %scevgep83.i22, align 8, !noalias !59
  %49 = load double, ptr %sunkaddr106.i, align 8, !alias.scope !62, !noalias !59
  %broadcast.splatinsert.i = insertelement <2 x double> poison, double %49, i64 0
  %scevgep86.i23 = getelementptr i8, ptr %lsr.iv84.i, i64 %lsr.iv82.i
  %wide.vec72.i = load <4 x double>, ptr %scevgep86.i23, align 8, !noalias !59
  %50 = shufflevector <2 x double> %broadcast.splatinsert.i, <2 x double> poison, <4 x i32> zeroinitializer
  %51 = fmul <4 x double> %50, %wide.vec72.i
  %interleaved.vec.i = fsub <4 x double> %wide.vec.i, %51
  store <4 x double> %interleaved.vec.i, ptr %scevgep83.i22, align 8, !noalias !59
  %lsr.iv.next.i24 = add i64 %lsr.iv82.i, 32
  %lsr.iv.next88.i = add i64 %lsr.iv87.i, -2
  %52 = icmp eq i64 %lsr.iv.next88.i, 0
  br i1 %52, label %middle.block.i, label %vector.body.i, !llvm.loop !65

middle.block.i:                                   ; preds = %vector.body.i
  %53 = shl i64 %n.vec.i, 1
  %54 = add i64 %53, %.1541659661.us.unr.i
  %cmp.n.i = icmp eq i64 %31, %n.vec.i
  br i1 %cmp.n.i, label %B584.B490.loopexit_crit_edge.us.loopexit.i, label %B586.us.preheader.i

B586.us.preheader.i:                              ; preds = %middle.block.i, %vector.memcheck.i, %vector.scevcheck.i, %B586.us.prol.loopexit.i
  %.1541659661.us.ph.i = phi i64 [ %.1541659661.us.unr.i, %vector.memcheck.i ], [ %.1541659661.us.unr.i, %vector.scevcheck.i ], [ %.1541659661.us.unr.i, %B586.us.prol.loopexit.i ], [ %54, %middle.block.i ]
  %55 = add i64 %.1541659661.us.ph.i, 1
  %sunkaddr107.i25 = getelementptr i8, ptr %invariant.gep665.i, i64 %sunkaddr35.pre-phi.i
  br label %B586.us.i

B586.us.i:                                        ; preds = %B586.us.i, %B586.us.preheader.i
  %lsr.iv89.i26 = phi i64 [ %55, %B586.us.preheader.i ], [ %lsr.iv.next90.i31, %B586.us.i ]
  %56 = shl i64 %lsr.iv89.i26, 3
  %scevgep91.i27 = getelementptr i8, ptr %lsr.iv80.i, i64 %56
  %scevgep92.i28 = getelementptr i8, ptr %scevgep91.i27, i64 -8
  %.1625.us.i = load double, ptr %scevgep92.i28, align 8, !noalias !59
  %.1679.us.i = load double, ptr %sunkaddr107.i25, align 8, !noalias !59
  %scevgep95.i29 = getelementptr i8, ptr %lsr.iv84.i, i64 %56
  %scevgep94.i30 = getelementptr i8, ptr %scevgep95.i29, i64 -8
  %.1734.us.i = load double, ptr %scevgep94.i30, align 8, !noalias !59
  %.1737.us.i = fmul double %.1679.us.i, %.1734.us.i
  %.1738.us.i = fsub double %.1625.us.i, %.1737.us.i
  store double %.1738.us.i, ptr %scevgep92.i28, align 8, !noalias !59
  %.1625.us.1.i = load double, ptr %scevgep91.i27, align 8, !noalias !59
  %.1679.us.1.i = load double, ptr %sunkaddr107.i25, align 8, !noalias !59
  %.1734.us.1.i = load double, ptr %scevgep95.i29, align 8, !noalias !59
  %.1737.us.1.i = fmul double %.1679.us.1.i, %.1734.us.1.i
  %.1738.us.1.i = fsub double %.1625.us.1.i, %.1737.us.1.i
  store double %.1738.us.1.i, ptr %scevgep91.i27, align 8, !noalias !59
  %lsr.iv.next90.i31 = add i64 %lsr.iv89.i26, 2
  %exitcond721.not.1.i = icmp eq i64 %lsr.iv.next90.i31, 7
  br i1 %exitcond721.not.1.i, label %B584.B490.loopexit_crit_edge.us.loopexit.i, label %B586.us.i, !llvm.loop !66

B584.B490.loopexit_crit_edge.us.loopexit.i:       ; preds = %B586.us.i, %middle.block.i
  %.1262.us.i = add nuw nsw i64 %.1255670676.us.i, 1
  %scevgep18.i = getelementptr i8, ptr %lsr.iv17.i, i64 %97
  %indvar.next.i = add i64 %indvar.i, 1
  %scevgep81.i = getelementptr i8, ptr %lsr.iv80.i, i64 %97
  %exitcond722.not.i = icmp eq i64 %.1262.us.i, 6
  br i1 %exitcond722.not.i, label %B84.endif.loopexit.i, label %B492.us.i

part.5: ; preds = %B452.endif.i
  br i1 %.7631173.i, label %B336.lr.ph, label %B434.lr.ph

B336:                                             ; preds = %B336.preheader125, %B336
  %lsr.iv165 = phi ptr [ %lsr.iv163, %B336.preheader125 ], [ %scevgep166, %B336 ]
  %lsr.iv160 = phi ptr [ %lsr.iv158, %B336.preheader125 ], [ %scevgep161, %B336 ]
  %lsr.iv157 = phi i64 [ 0, %B336.preheader125 ], [ %lsr.iv.next, %B336 ]
  %scevgep167 = getelementptr i8, ptr %lsr.iv165, i64 %177
  %.1561 = load double, ptr %scevgep167, align 8
  %scevgep162 = getelementptr i8, ptr %lsr.iv160, i64 %176
  %.1616 = load double, ptr %scevgep162, align 8
  %57 = shl i64 %lsr.iv157, 3
  %scevgep182 = getelementptr i8, ptr %scevgep180, i64 %57
  %scevgep183 = getelementptr i8, ptr %scevgep182, i64 -8
  store double %.1561, ptr %scevgep183, align 8
  %scevgep175 = getelementptr i8, ptr %scevgep173, i64 %57
  %scevgep176 = getelementptr i8, ptr %scevgep175, i64 -8
  store double %.1616, ptr %scevgep176, align 8
  %scevgep168 = getelementptr i8, ptr %lsr.iv165, i64 %179
  %.1561.1 = load double, ptr %scevgep168, align 8
  %scevgep169 = getelementptr i8, ptr %lsr.iv160, i64 %180
  %.1616.1 = load double, ptr %scevgep169, align 8
  store double %.1561.1, ptr %scevgep182, align 8
  store double %.1616.1, ptr %scevgep175, align 8
  %lsr.iv.next = add i64 %lsr.iv157, 2
  %scevgep161 = getelementptr i8, ptr %lsr.iv160, i64 %91
  %scevgep166 = getelementptr i8, ptr %lsr.iv165, i64 %92
  %exitcond.not.1 = icmp eq i64 %175, %lsr.iv.next
  br i1 %exitcond.not.1, label %B434.lr.ph, label %B336, !llvm.loop !67

B510.lr.ph.1.unr-lcssa:                           ; preds = %B510
  br i1 %144, label %B510.lr.ph.1.thread, label %B510.lr.ph.1

B510.lr.ph.1.thread:                              ; preds = %B510.lr.ph.1.unr-lcssa
  %.1905.185 = getelementptr i8, ptr %182, i64 %arg.twist.6.1
  %.1907.186 = load double, ptr %.1905.185, align 8
  store double %.1907.186, ptr %sunkaddr223, align 8
  br label %B510.1.preheader

B510.lr.ph.1:                                     ; preds = %B510.lr.ph.1.unr-lcssa, %B510.preheader
  %.21071159.epil.init = phi double [ %.1907, %B510.preheader ], [ %.2219.1112, %B510.lr.ph.1.unr-lcssa ]
  %.2160.epil = load double, ptr %gep.epil, align 8
  %.2213.epil = getelementptr i8, ptr %scevgep, i64 %.2210.epil
  %.2215.epil = load double, ptr %.2213.epil, align 8
  %.2218.epil = fmul double %.2160.epil, %.2215.epil
  %.2219.epil = fsub double %.21071159.epil.init, %.2218.epil
  store double %.2219.epil, ptr %.855, align 8
  %.1905.1 = getelementptr i8, ptr %182, i64 %arg.twist.6.1
  %.1907.1 = load double, ptr %.1905.1, align 8
  store double %.1907.1, ptr %sunkaddr223, align 8
  br i1 %142, label %B510.lr.ph.2, label %B510.1.preheader

B510.1.preheader:                                 ; preds = %B510.lr.ph.1.thread, %B510.lr.ph.1
  %.21071159.1.ph = phi double [ %.1907.1, %B510.lr.ph.1 ], [ %.1907.186, %B510.lr.ph.1.thread ]
  br label %B510.1

B510.1:                                           ; preds = %B510.1.preheader, %B510.1
  %lsr.iv193 = phi ptr [ %scevgep194, %B510.1 ], [ %lsr.iv163, %B510.1.preheader ]
  %lsr.iv190 = phi ptr [ %scevgep191, %B510.1 ], [ %invariant.gep.1, %B510.1.preheader ]
  %.21071159.1 = phi double [ %.2219.1.1, %B510.1 ], [ %.21071159.1.ph, %B510.1.preheader ]
  %.204511531155.1 = phi i64 [ %.2052.1.1, %B510.1 ], [ 0, %B510.1.preheader ]
  %.2160.1 = load double, ptr %lsr.iv190, align 8
  %.2215.1 = load double, ptr %lsr.iv193, align 8
  %.2218.1 = fmul double %.2160.1, %.2215.1
  %.2219.1 = fsub double %.21071159.1, %.2218.1
  store double %.2219.1, ptr %sunkaddr223, align 8
  %.2052.1.1 = add nuw i64 %.204511531155.1, 2
  %scevgep192 = getelementptr i8, ptr %lsr.iv190, i64 %arg.ride.6.0
  %.2160.1.1 = load double, ptr %scevgep192, align 8
  %scevgep195 = getelementptr i8, ptr %lsr.iv193, i64 %arg.rail_rate.6.1
  %.2215.1.1 = load double, ptr %scevgep195, align 8
  %.2218.1.1 = fmul double %.2160.1.1, %.2215.1.1
  %.2219.1.1 = fsub double %.2219.1, %.2218.1.1
  store double %.2219.1.1, ptr %sunkaddr223, align 8
  %scevgep191 = getelementptr i8, ptr %lsr.iv190, i64 %93
  %scevgep194 = getelementptr i8, ptr %lsr.iv193, i64 %92
  %niter118.ncmp.1 = icmp eq i64 %unroll_iter, %.2052.1.1
  br i1 %niter118.ncmp.1, label %B510.lr.ph.2.unr-lcssa, label %B510.1

B510.lr.ph.2.unr-lcssa:                           ; preds = %B510.1
  br i1 %144, label %B510.lr.ph.2.thread, label %B510.lr.ph.2

B510.lr.ph.2.thread:                              ; preds = %B510.lr.ph.2.unr-lcssa
  %sunkaddr20588 = getelementptr i8, ptr %182, i64 %sunkaddr204
  %.1907.289 = load double, ptr %sunkaddr20588, align 8
  store double %.1907.289, ptr %sunkaddr229, align 8
  br label %B510.2.preheader

B510.lr.ph.2:                                     ; preds = %B510.lr.ph.1, %B510.lr.ph.2.unr-lcssa
  %.21071159.1.epil.init = phi double [ %.1907.1, %B510.lr.ph.1 ], [ %.2219.1.1, %B510.lr.ph.2.unr-lcssa ]
  %.2160.1.epil = load double, ptr %gep.1.epil, align 8
  %.2213.1.epil = getelementptr i8, ptr %scevgep, i64 %.2210.1.epil
  %.2215.1.epil = load double, ptr %.2213.1.epil, align 8
  %.2218.1.epil = fmul double %.2160.1.epil, %.2215.1.epil
  %.2219.1.epil = fsub double %.21071159.1.epil.init, %.2218.1.epil
  store double %.2219.1.epil, ptr %sunkaddr223, align 8
  %sunkaddr205 = getelementptr i8, ptr %182, i64 %sunkaddr204
  %.1907.2 = load double, ptr %sunkaddr205, align 8
  store double %.1907.2, ptr %sunkaddr229, align 8
  br i1 %142, label %B510.2.epil.preheader, label %B510.2.preheader

B510.2.preheader:                                 ; preds = %B510.lr.ph.2.thread, %B510.lr.ph.2
  %.21071159.2.ph = phi double [ %.1907.2, %B510.lr.ph.2 ], [ %.1907.289, %B510.lr.ph.2.thread ]
  br label %B510.2

B510.2:                                           ; preds = %B510.2.preheader, %B510.2
  %lsr.iv199 = phi ptr [ %scevgep200, %B510.2 ], [ %lsr.iv163, %B510.2.preheader ]
  %lsr.iv196 = phi ptr [ %scevgep197, %B510.2 ], [ %invariant.gep.2, %B510.2.preheader ]
  %.21071159.2 = phi double [ %.2219.2.1, %B510.2 ], [ %.21071159.2.ph, %B510.2.preheader ]
  %.204511531155.2 = phi i64 [ %.2052.2.1, %B510.2 ], [ 0, %B510.2.preheader ]
  %.2160.2 = load double, ptr %lsr.iv196, align 8
  %.2215.2 = load double, ptr %lsr.iv199, align 8
  %.2218.2 = fmul double %.2160.2, %.2215.2
  %.2219.2 = fsub double %.21071159.2, %.2218.2
  store double %.2219.2, ptr %sunkaddr229, align 8
  %.2052.2.1 = add nuw i64 %.204511531155.2, 2
  %scevgep198 = getelementptr i8, ptr %lsr.iv196, i64 %arg.ride.6.0
  %.2160.2.1 = load double, ptr %scevgep198, align 8
  %scevgep201 = getelementptr i8, ptr %lsr.iv199, i64 %arg.rail_rate.6.1
  %.2215.2.1 = load double, ptr %scevgep201, align 8
  %.2218.2.1 = fmul double %.2160.2.1, %.2215.2.1
  %.2219.2.1 = fsub double %.2219.2, %.2218.2.1
  store double %.2219.2.1, ptr %sunkaddr229, align 8
  %scevgep197 = getelementptr i8, ptr %lsr.iv196, i64 %93
  %scevgep200 = getelementptr i8, ptr %lsr.iv199, i64 %92
  %niter123.ncmp.1 = icmp eq i64 %unroll_iter, %.2052.2.1
  br i1 %niter123.ncmp.1, label %B586.else.loopexit.unr-lcssa, label %B510.2

B510:                                             ; preds = %B510.preheader, %B510
  %lsr.iv187 = phi ptr [ %scevgep188, %B510 ], [ %lsr.iv163, %B510.preheader ]
  %lsr.iv184 = phi ptr [ %scevgep185, %B510 ], [ %arg.ride.4, %B510.preheader ]
  %.21071159 = phi double [ %.2219.1112, %B510 ], [ %.1907, %B510.preheader ]
  %.204511531155 = phi i64 [ %.2052.1104, %B510 ], [ 0, %B510.preheader ]
  %.2160 = load double, ptr %lsr.iv184, align 8
  %.2215 = load double, ptr %lsr.iv187, align 8
  %.2218 = fmul double %.2160, %.2215
  %.2219 = fsub double %.21071159, %.2218
  store double %.2219, ptr %.855, align 8
  %.2052.1104 = add nuw i64 %.204511531155, 2
  %scevgep186 = getelementptr i8, ptr %lsr.iv184, i64 %arg.ride.6.0
  %.2160.1107 = load double, ptr %scevgep186, align 8
  %scevgep189 = getelementptr i8, ptr %lsr.iv187, i64 %arg.rail_rate.6.1
  %.2215.1110 = load double, ptr %scevgep189, align 8
  %.2218.1111 = fmul double %.2160.1107, %.2215.1110
  %.2219.1112 = fsub double %.2219, %.2218.1111
  store double %.2219.1112, ptr %.855, align 8
  %scevgep185 = getelementptr i8, ptr %lsr.iv184, i64 %93
  %scevgep188 = getelementptr i8, ptr %lsr.iv187, i64 %92
  %niter.ncmp.1 = icmp eq i64 %unroll_iter, %.2052.1104
  br i1 %niter.ncmp.1, label %B510.lr.ph.1.unr-lcssa, label %B510

B906:                                             ; preds = %B846.endif, %B0.endif.else.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B0.else.endif.endif.endif:                        ; preds = %B0.else.endif
  %.353 = icmp samesign ult i64 %arg.room.5.1, 7
  br i1 %.353, label %B0.else.endif.endif.endif.if, label %B0.endif.else.endif, !prof !68

B0.else.endif.endif.endif.if:                     ; preds = %B0.else.endif.endif.endif
  br label %B0.endif.else.endif

B0.endif.else.endif:                              ; preds = %B0.else.endif.endif.endif.if, %B0.else.endif.endif.endif, %B0.else.endif
  %.316.sroa.0.31401 = phi i64 [ 0, %B0.else.endif.endif.endif ], [ 0, %B0.else.endif.endif.endif.if ], [ %arg.room.5.1, %B0.else.endif ]
  %.316.sroa.13.0 = phi i64 [ 6, %B0.else.endif.endif.endif ], [ %arg.room.5.1, %B0.else.endif.endif.endif.if ], [ %arg.room.5.1, %B0.else.endif ]
  %.404 = sub i64 %.316.sroa.13.0, %.316.sroa.0.31401
  %.413 = tail call i64 @llvm.smax.i64(i64 %.404, i64 0)
  %.438 = mul i64 %arg.room.5.2, 3
  %.440 = mul i64 %.438, %arg.room.5.1
  %.442 = mul i64 %.316.sroa.0.31401, %arg.room.5.2
  %58 = getelementptr double, ptr %arg.room.4, i64 %.440
  %.444 = getelementptr double, ptr %58, i64 %.442
  %.546.idx = mul i64 %arg.room.5.2, 48
  %.546 = getelementptr i8, ptr %58, i64 %.546.idx
  %.625.sroa.0.31405 = tail call i64 @llvm.smin.i64(i64 %arg.room.5.1, i64 3)
  %.751 = mul i64 %.625.sroa.0.31405, %arg.room.5.2
  %.753 = getelementptr double, ptr %arg.room.4, i64 %.751
  %.855.idx = mul i64 %arg.room.5.2, 40
  %.855 = getelementptr i8, ptr %arg.room.4, i64 %.855.idx
  %.11461259.not = icmp slt i64 %arg.q.5.0, 1
  br i1 %.11461259.not, label %B906, label %B182.lr.ph

B182.lr.ph:                                       ; preds = %B0.endif.else.endif
  %.1429 = icmp slt i64 %arg.q.5.1, 7
  %..265 = select i1 %.1429, i64 0, i64 %.265
  %.2314 = icmp slt i64 %arg.q.5.1, 6
  %.2315 = select i1 %.2314, i64 %arg.qd.5.1, i64 0
  %.2316 = add i64 %.2315, %.265
  %.3193 = select i1 %.2314, i64 %arg.qdd.5.1, i64 0
  %.3194 = add i64 %.3193, %.265
  %invariant.gep.1 = getelementptr i8, ptr %arg.ride.4, i64 %arg.ride.6.1
  %.2155.2 = shl i64 %arg.ride.6.1, 1
  %invariant.gep.2 = getelementptr i8, ptr %arg.ride.4, i64 %.2155.2
  %.1902.3 = mul i64 %arg.twist.6.1, 3
  %.1902.5 = mul i64 %arg.twist.6.1, 5
  %.2644.1 = icmp slt i64 %arg.q.5.1, 5
  %.2645.1 = select i1 %.2644.1, i64 %arg.qdd.5.1, i64 0
  %.2644.2 = icmp slt i64 %arg.q.5.1, 4
  %.2645.2 = select i1 %.2644.2, i64 %arg.qdd.5.1, i64 0
  %.2644.3 = icmp slt i64 %arg.q.5.1, 3
  %.2645.3 = select i1 %.2644.3, i64 %arg.qdd.5.1, i64 0
  %.2644.4 = icmp slt i64 %arg.q.5.1, 2
  %.2645.4 = select i1 %.2644.4, i64 %arg.qdd.5.1, i64 0
  %.2644.5.inv = icmp sgt i64 %arg.q.5.1, 0
  %.2645.5 = select i1 %.2644.5.inv, i64 0, i64 %arg.qdd.5.1
  %.3041.3 = mul i64 %arg.bend.6.1, 3
  %.3041.5 = mul i64 %arg.bend.6.1, 5
  %59 = add i64 %..265, -1
  %60 = add nsw i64 %arg.q.5.0, -1
  %61 = mul i64 %arg.qd.5.1, %60
  %62 = add i64 %61, %..265
  %63 = shl i64 %62, 3
  %scevgep71 = getelementptr i8, ptr %arg.qd.4, i64 %63
  %64 = shl i64 %arg.qd.5.1, 3
  %65 = mul i64 %arg.qdd.5.1, %60
  %66 = add i64 %65, %..265
  %67 = shl i64 %66, 3
  %scevgep72 = getelementptr i8, ptr %arg.qdd.4, i64 %67
  %68 = shl i64 %arg.qdd.5.1, 3
  %69 = mul i64 %arg.rail_rate.6.0, %60
  %70 = getelementptr i8, ptr %arg.rail_rate.4, i64 %..265
  %71 = getelementptr i8, ptr %70, i64 %69
  %scevgep73 = getelementptr i8, ptr %71, i64 7
  %72 = mul i64 %arg.rail_bend.6.0, %60
  %73 = getelementptr i8, ptr %arg.rail_bend.4, i64 %..265
  %74 = getelementptr i8, ptr %73, i64 %72
  %scevgep74 = getelementptr i8, ptr %74, i64 7
  %ident.check = icmp ne i64 %arg.rail_rate.6.1, 1
  %ident.check68 = icmp ne i64 %arg.rail_bend.6.1, 1
  %75 = or i1 %ident.check, %ident.check68
  %bound0 = icmp ult ptr %arg.qd.4, %scevgep72
  %bound1 = icmp ult ptr %arg.qdd.4, %scevgep71
  %found.conflict = and i1 %bound1, %bound0
  %76 = or i64 %68, %64
  %77 = icmp slt i64 %76, 0
  %78 = or i1 %77, %found.conflict
  %bound076 = icmp ult ptr %arg.qd.4, %scevgep73
  %bound177 = icmp ult ptr %arg.rail_rate.4, %scevgep71
  %found.conflict78 = and i1 %bound076, %bound177
  %79 = or i64 %64, %arg.rail_rate.6.0
  %80 = icmp slt i64 %79, 0
  %81 = or i1 %80, %found.conflict78
  %conflict.rdx = or i1 %81, %78
  %bound081 = icmp ult ptr %arg.qd.4, %scevgep74
  %bound182 = icmp ult ptr %arg.rail_bend.4, %scevgep71
  %found.conflict83 = and i1 %bound081, %bound182
  %82 = or i64 %64, %arg.rail_bend.6.0
  %83 = icmp slt i64 %82, 0
  %84 = or i1 %83, %found.conflict83
  %conflict.rdx86 = or i1 %84, %conflict.rdx
  %bound087 = icmp ult ptr %arg.qdd.4, %scevgep73
  %bound188 = icmp ult ptr %arg.rail_rate.4, %scevgep72
  %found.conflict89 = and i1 %bound087, %bound188
  %85 = or i64 %68, %arg.rail_rate.6.0
  %86 = icmp slt i64 %85, 0
  %87 = or i1 %86, %found.conflict89
  %conflict.rdx92 = or i1 %87, %conflict.rdx86
  %bound093 = icmp ult ptr %arg.qdd.4, %scevgep74
  %bound194 = icmp ult ptr %arg.rail_bend.4, %scevgep72
  %found.conflict95 = and i1 %bound093, %bound194
  %88 = or i64 %68, %arg.rail_bend.6.0
  %89 = icmp slt i64 %88, 0
  %90 = or i1 %89, %found.conflict95
  %conflict.rdx98 = or i1 %90, %conflict.rdx92
  %n.vec = and i64 %..265, 9223372036854775804
  %unroll_iter = and i64 %.265, -2
  %scevgep126 = getelementptr i8, ptr %arg.rail_rate.4, i64 3
  %scevgep135 = getelementptr i8, ptr %arg.rail_bend.4, i64 3
  %scevgep145 = getelementptr i8, ptr %arg.qd.4, i64 16
  %scevgep151 = getelementptr i8, ptr %arg.qdd.4, i64 16
  %91 = shl i64 %arg.rail_bend.6.1, 1
  %92 = shl i64 %arg.rail_rate.6.1, 1
  %scevgep170 = getelementptr i8, ptr %arg.qdd.4, i64 8
  %scevgep177 = getelementptr i8, ptr %arg.qd.4, i64 8
  %93 = shl i64 %arg.ride.6.0, 1
  %.168.i = mul i64 %arg.room.5.2, %arg.room.5.1
  %.348.idx.i = shl i64 %.168.i, 4
  %.348.i = getelementptr i8, ptr %arg.room.4, i64 %.348.idx.i
  %.622.i = mul i64 %arg.X_WC.6.1, 3
  %invariant.gep1184.i = getelementptr i8, ptr %arg.X_WC.4, i64 %.622.i
  %.7631173.i = icmp sgt i64 %..265, 0
  %invariant.gep1178.2.i = getelementptr i8, ptr %arg.room.4, i64 16
  %gep1179.1.2.i = getelementptr double, ptr %invariant.gep1178.2.i, i64 %arg.room.5.2
  %94 = getelementptr double, ptr %arg.room.4, i64 %arg.room.5.2
  %.idx1169.i = shl i64 %arg.room.5.2, 4
  %95 = getelementptr i8, ptr %arg.room.4, i64 %.idx1169.i
  %.2054.1.i = getelementptr i8, ptr %arg.room.4, i64 8
  %.2165.1.i = getelementptr i8, ptr %94, i64 8
  %.2276.1.i = getelementptr i8, ptr %95, i64 8
  %.2165.2.i = getelementptr i8, ptr %94, i64 16
  %.2276.2.i = getelementptr i8, ptr %95, i64 16
  %.1431.peel.i = getelementptr i8, ptr %arg.chain.4, i64 8
  %.1450.peel.i = select i1 %.2314, i64 %arg.q.5.1, i64 0
  %.1451.peel.i = add i64 %.1450.peel.i, %.265
  %.1462.peel.i = mul i64 %.1451.peel.i, %arg.q.6.1
  %.1521.peel.i = getelementptr i8, ptr %arg.chain.4, i64 16
  %.1577.peel.i = getelementptr i8, ptr %arg.chain.4, i64 48
  %.2109.peel.i = getelementptr i8, ptr %arg.chain.4, i64 24
  %.2220.peel.i = getelementptr i8, ptr %arg.chain.4, i64 32
  %.2331.peel.i = getelementptr i8, ptr %arg.chain.4, i64 40
  %sunkaddr101.i = shl i64 %.168.i, 3
  %sunkaddr102.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr101.i
  %sunkaddr130.i = getelementptr i8, ptr %.348.i, i64 8
  %sunkaddr107.i = getelementptr i8, ptr %sunkaddr102.i, i64 8
  %sunkaddr132.i = getelementptr i8, ptr %.348.i, i64 16
  %sunkaddr112.i = getelementptr i8, ptr %sunkaddr102.i, i64 16
  %96 = add i64 %.348.idx.i, 16
  %97 = shl i64 %arg.room.5.2, 3
  %98 = shl i64 %arg.room.5.1, 4
  %99 = or disjoint i64 %98, 8
  %100 = mul i64 %99, %arg.room.5.2
  %101 = add i64 %100, 16
  %102 = shl i64 %arg.room.5.1, 3
  %103 = add i64 %102, 8
  %104 = mul i64 %103, %arg.room.5.2
  %105 = add i64 %104, 16
  %106 = shl i64 %arg.chain.5.1, 3
  %107 = getelementptr i8, ptr %arg.chain.4, i64 %106
  %scevgep49.i = getelementptr i8, ptr %107, i64 48
  %108 = add i64 %arg.q.5.1, -5
  %sunkaddr134.i = getelementptr i8, ptr %arg.room.4, i64 %97
  %sunkaddr139.i = getelementptr i8, ptr %sunkaddr134.i, i64 8
  %sunkaddr145.i = getelementptr i8, ptr %sunkaddr134.i, i64 16
  %109 = getelementptr i8, ptr %.348.i, i64 %.855.idx
  %.3175.i = mul i64 %arg.X_6T.6.1, 3
  %.3178.i = getelementptr i8, ptr %arg.X_6T.4, i64 %.3175.i
  %110 = getelementptr i8, ptr %arg.X_6T.4, i64 %arg.X_6T.6.0
  %.3288.i = getelementptr i8, ptr %110, i64 %.3175.i
  %.3394.i = shl i64 %arg.X_6T.6.0, 1
  %111 = getelementptr i8, ptr %arg.X_6T.4, i64 %.3394.i
  %.3398.i = getelementptr i8, ptr %111, i64 %.3175.i
  %112 = getelementptr i8, ptr %.348.i, i64 %.546.idx
  %.3071.1.i = getelementptr i8, ptr %109, i64 8
  %.3455.1.i = getelementptr i8, ptr %112, i64 8
  %.3071.2.i = getelementptr i8, ptr %109, i64 16
  %.3455.2.i = getelementptr i8, ptr %112, i64 16
  %.121.i = getelementptr double, ptr %arg.room.4, i64 %.168.i
  %.1496.1.i = shl i64 %arg.room.5.2, 2
  %.1437.2.i = shl i64 %arg.room.5.2, 1
  %.1496.2.i = mul i64 %arg.room.5.2, 5
  %.786.peel.i = getelementptr i8, ptr %.121.i, i64 8
  %.842.peel.i = getelementptr i8, ptr %.121.i, i64 16
  %113 = getelementptr i8, ptr %.444, i64 -8
  %invariant.gep710.peel.i = getelementptr double, ptr %113, i64 %arg.room.5.2
  %gep709.peel.i = getelementptr double, ptr %.444, i64 %.438
  %gep.1.peel.i = getelementptr double, ptr %.444, i64 %arg.room.5.2
  %gep709.1.peel.i = getelementptr double, ptr %.444, i64 %.1496.1.i
  %gep.2.peel.i = getelementptr double, ptr %.444, i64 %.1437.2.i
  %gep709.2.peel.i = getelementptr double, ptr %.444, i64 %.1496.2.i
  %114 = mul i64 %arg.room.5.2, 24
  %scevgep20.i = getelementptr i8, ptr %.444, i64 %114
  %115 = shl i64 %arg.room.5.2, 5
  %scevgep26.i = getelementptr i8, ptr %.444, i64 %115
  %scevgep30.i = getelementptr i8, ptr %.444, i64 %.855.idx
  %scevgep37.i1 = getelementptr i8, ptr %.444, i64 %.idx1169.i
  %scevgep41.i = getelementptr i8, ptr %.444, i64 %97
  %116 = getelementptr i8, ptr %.546, i64 8
  %117 = getelementptr i8, ptr %.546, i64 16
  %118 = getelementptr i8, ptr %.546, i64 24
  %119 = getelementptr i8, ptr %.546, i64 32
  %120 = getelementptr i8, ptr %.546, i64 40
  %121 = add i64 %97, 8
  %scevgep14.i = getelementptr i8, ptr %.444, i64 %121
  %scevgep22.i = getelementptr i8, ptr %.444, i64 8
  %122 = getelementptr i8, ptr %scevgep30.i, i64 8
  %123 = getelementptr i8, ptr %scevgep41.i, i64 16
  %124 = icmp slt i64 %97, 0
  %125 = icmp slt i64 %.2316, 0
  %sunkaddr213 = getelementptr i8, ptr %.855, i64 24
  %sunkaddr214 = shl i64 %arg.twist.6.1, 2
  %sunkaddr216 = getelementptr i8, ptr %.855, i64 32
  %sunkaddr217 = getelementptr i8, ptr %.855, i64 40
  %126 = icmp slt i64 %.2316, %arg.qd.5.1
  %.335.i = add i64 %arg.qd.5.1, -6
  %127 = getelementptr double, ptr %.753, i64 %arg.room.5.2
  %.721.i38 = icmp slt i64 %arg.qd.5.1, 7
  %..335.i = select i1 %.721.i38, i64 0, i64 %.335.i
  %.7631553.i = icmp sgt i64 %..335.i, 0
  %.625.us.i = getelementptr i8, ptr %.753, i64 24
  %.681.us.i = getelementptr i8, ptr %127, i64 24
  %arg.out.5.1..i = tail call i64 @llvm.smin.i64(i64 %arg.room.5.2, i64 3)
  %128 = add i64 %64, -48
  %sunkaddr34.i = shl i64 %arg.out.5.1..i, 3
  %sunkaddr35.i = getelementptr i8, ptr %127, i64 %sunkaddr34.i
  %sunkaddr37.i = getelementptr i8, ptr %.753, i64 %sunkaddr34.i
  %sunkaddr38.i = getelementptr i8, ptr %sunkaddr37.i, i64 8
  %sunkaddr41.i = getelementptr i8, ptr %sunkaddr37.i, i64 16
  %sunkaddr44.i = getelementptr i8, ptr %sunkaddr35.i, i64 8
  %sunkaddr49.i45 = getelementptr i8, ptr %sunkaddr35.i, i64 16
  %sunkaddr50.i46 = getelementptr i8, ptr %127, i64 8
  %sunkaddr53.i = getelementptr i8, ptr %127, i64 16
  %sunkaddr54.i = getelementptr i8, ptr %.753, i64 8
  %sunkaddr55.i = getelementptr i8, ptr %.753, i64 16
  %129 = icmp slt i64 %.3194, 0
  %sunkaddr219 = getelementptr i8, ptr %.753, i64 %97
  %sunkaddr222 = getelementptr i8, ptr %sunkaddr219, i64 8
  %sunkaddr223 = getelementptr i8, ptr %.855, i64 8
  %sunkaddr224 = shl i64 %arg.bend.6.1, 1
  %sunkaddr228 = getelementptr i8, ptr %sunkaddr219, i64 16
  %sunkaddr229 = getelementptr i8, ptr %.855, i64 16
  %sunkaddr232 = getelementptr i8, ptr %sunkaddr219, i64 24
  %sunkaddr234 = shl i64 %arg.bend.6.1, 2
  %sunkaddr238 = getelementptr i8, ptr %sunkaddr219, i64 32
  %sunkaddr242 = getelementptr i8, ptr %sunkaddr219, i64 40
  %130 = icmp slt i64 %.3194, %arg.qdd.5.1
  %.1168.1.i = getelementptr i8, ptr %arg.X_WC.4, i64 %arg.X_WC.6.1
  %.1165.2.i = shl i64 %arg.X_WC.6.1, 1
  %.1168.2.i = getelementptr i8, ptr %arg.X_WC.4, i64 %.1165.2.i
  %gep1179.2.i = getelementptr double, ptr %arg.room.4, i64 %.1437.2.i
  %gep1185.1.i = getelementptr i8, ptr %invariant.gep1184.i, i64 %arg.X_WC.6.0
  %131 = getelementptr i8, ptr %arg.X_WC.4, i64 %arg.X_WC.6.0
  %.1168.1.1.i = getelementptr i8, ptr %131, i64 %arg.X_WC.6.1
  %gep1179.1.1.i = getelementptr double, ptr %.2054.1.i, i64 %arg.room.5.2
  %.1168.2.1.i = getelementptr i8, ptr %131, i64 %.1165.2.i
  %gep1179.2.1.i = getelementptr double, ptr %.2054.1.i, i64 %.1437.2.i
  %.621.2.i = shl i64 %arg.X_WC.6.0, 1
  %gep1185.2.i = getelementptr i8, ptr %invariant.gep1184.i, i64 %.621.2.i
  %132 = icmp eq i64 %..265, 1
  %unroll_iter.i = and i64 %..265, 9223372036854775806
  %133 = shl i64 %arg.q.6.1, 1
  %134 = add nsw i64 %..265, -2
  %135 = lshr i64 %134, 1
  %136 = icmp eq i64 %135, 0
  %137 = add nuw nsw i64 %135, 1
  %unroll_iter12.i = and i64 %137, 9223372036854775806
  %138 = and i64 %134, 2
  %lcmp.mod.not55.not.i = icmp eq i64 %138, 0
  %139 = and i64 %..265, 1
  %lcmp.mod.not.i = icmp eq i64 %139, 0
  %gep713.peel.i = getelementptr double, ptr %invariant.gep710.peel.i, i64 %.438
  %gep711.1.peel.i = getelementptr double, ptr %invariant.gep710.peel.i, i64 %arg.room.5.2
  %gep713.1.peel.i = getelementptr double, ptr %invariant.gep710.peel.i, i64 %.1496.1.i
  %gep711.2.peel.i = getelementptr double, ptr %invariant.gep710.peel.i, i64 %.1437.2.i
  %gep713.2.peel.i = getelementptr double, ptr %invariant.gep710.peel.i, i64 %.1496.2.i
  %140 = icmp samesign ult i64 %..265, 44
  %141 = icmp eq i64 %..265, %n.vec
  %142 = icmp eq i64 %arg.q.5.1, 7
  %143 = and i64 %arg.q.5.1, 1
  %144 = icmp eq i64 %143, 0
  %sunkaddr204 = shl i64 %arg.twist.6.1, 1
  %.625.1.i = getelementptr i8, ptr %.753, i64 32
  %.681.1.i39 = getelementptr i8, ptr %127, i64 32
  %.625.2.i = getelementptr i8, ptr %.753, i64 40
  %.681.2.i40 = getelementptr i8, ptr %127, i64 40
  %.902.us.epil.i = mul i64 %unroll_iter.i, %arg.ride.6.0
  %gep.us.epil.i = getelementptr i8, ptr %arg.ride.4, i64 %.902.us.epil.i
  %.937.us.epil.i = mul i64 %unroll_iter.i, %arg.q.6.1
  %.902.us.1.epil.i = mul i64 %unroll_iter.i, %arg.ride.6.0
  %gep.us.1.epil.i = getelementptr i8, ptr %invariant.gep.1, i64 %.902.us.1.epil.i
  %.937.us.1.epil.i = mul i64 %unroll_iter.i, %arg.q.6.1
  %.902.us.2.epil.i = mul i64 %unroll_iter.i, %arg.ride.6.0
  %gep.us.2.epil.i = getelementptr i8, ptr %invariant.gep.2, i64 %.902.us.2.epil.i
  %.937.us.2.epil.i = mul i64 %unroll_iter.i, %arg.q.6.1
  %145 = getelementptr i8, ptr %arg.X_WC.4, i64 %.621.2.i
  %.1168.1.2.i = getelementptr i8, ptr %145, i64 %arg.X_WC.6.1
  %.1168.2.2.i = getelementptr i8, ptr %145, i64 %.1165.2.i
  %gep1179.2.2.i = getelementptr double, ptr %invariant.gep1178.2.i, i64 %.1437.2.i
  %.2154.epil = mul i64 %unroll_iter, %arg.ride.6.0
  %gep.epil = getelementptr i8, ptr %arg.ride.4, i64 %.2154.epil
  %.2210.epil = mul i64 %unroll_iter, %arg.rail_rate.6.1
  %.2154.1.epil = mul i64 %unroll_iter, %arg.ride.6.0
  %gep.1.epil = getelementptr i8, ptr %invariant.gep.1, i64 %.2154.1.epil
  %.2210.1.epil = mul i64 %unroll_iter, %arg.rail_rate.6.1
  %.2154.2.epil = mul i64 %unroll_iter, %arg.ride.6.0
  %gep.2.epil = getelementptr i8, ptr %invariant.gep.2, i64 %.2154.2.epil
  %.2210.2.epil = mul i64 %unroll_iter, %arg.rail_rate.6.1
  br label %B182

B336.lr.ph:                                       ; preds = %part.5
  %.1666 = mul i64 %.115211871270, %arg.qd.5.1
  %146 = getelementptr double, ptr %arg.qd.4, i64 %.1666
  %.1721 = mul i64 %.115211871270, %arg.qdd.5.1
  %147 = getelementptr double, ptr %arg.qdd.4, i64 %.1721
  br i1 %140, label %B336.preheader, label %vector.scevcheck

vector.scevcheck:                                 ; preds = %B336.lr.ph
  %148 = getelementptr i8, ptr %scevgep, i64 %59
  %149 = icmp ult ptr %148, %scevgep
  %150 = getelementptr i8, ptr %scevgep69, i64 %59
  %151 = icmp ult ptr %150, %scevgep69
  %152 = or i1 %75, %149
  %153 = or i1 %151, %152
  %brmerge = select i1 %153, i1 true, i1 %conflict.rdx98
  br i1 %brmerge, label %B336.preheader, label %vector.body

vector.body:                                      ; preds = %vector.scevcheck, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %vector.scevcheck ]
  %scevgep133 = getelementptr i8, ptr %lsr.iv, i64 %index
  %scevgep134 = getelementptr i8, ptr %scevgep133, i64 -3
  %scevgep132 = getelementptr i8, ptr %scevgep133, i64 -2
  %scevgep130 = getelementptr i8, ptr %scevgep133, i64 -1
  %154 = load double, ptr %scevgep134, align 8, !alias.scope !69
  %155 = load double, ptr %scevgep132, align 8, !alias.scope !69
  %156 = insertelement <2 x double> poison, double %154, i64 0
  %157 = insertelement <2 x double> %156, double %155, i64 1
  %158 = load double, ptr %scevgep130, align 8, !alias.scope !69
  %159 = load double, ptr %scevgep133, align 8, !alias.scope !69
  %160 = insertelement <2 x double> poison, double %158, i64 0
  %161 = insertelement <2 x double> %160, double %159, i64 1
  %scevgep143 = getelementptr i8, ptr %lsr.iv136, i64 %index
  %scevgep144 = getelementptr i8, ptr %scevgep143, i64 -3
  %scevgep142 = getelementptr i8, ptr %scevgep143, i64 -2
  %scevgep140 = getelementptr i8, ptr %scevgep143, i64 -1
  %162 = load double, ptr %scevgep144, align 8, !alias.scope !72
  %163 = load double, ptr %scevgep142, align 8, !alias.scope !72
  %164 = insertelement <2 x double> poison, double %162, i64 0
  %165 = insertelement <2 x double> %164, double %163, i64 1
  %166 = load double, ptr %scevgep140, align 8, !alias.scope !72
  %167 = load double, ptr %scevgep143, align 8, !alias.scope !72
  %168 = insertelement <2 x double> poison, double %166, i64 0
  %169 = insertelement <2 x double> %168, double %167, i64 1
  %170 = shl i64 %index, 3
  %scevgep149 = getelementptr i8, ptr %lsr.iv146, i64 %170
  %scevgep150 = getelementptr i8, ptr %scevgep149, i64 -16
  store <2 x double> %157, ptr %scevgep150, align 8, !alias.scope !74, !noalias !76
  store <2 x double> %161, ptr %scevgep149, align 8, !alias.scope !74, !noalias !76
  %scevgep155 = getelementptr i8, ptr %lsr.iv152, i64 %170
  %scevgep156 = getelementptr i8, ptr %scevgep155, i64 -16
  store <2 x double> %165, ptr %scevgep156, align 8, !alias.scope !78, !noalias !79
  store <2 x double> %169, ptr %scevgep155, align 8, !alias.scope !78, !noalias !79
  %index.next = add nuw nsw i64 %index, 4
  %171 = icmp eq i64 %n.vec, %index.next
  br i1 %171, label %middle.block, label %vector.body, !llvm.loop !80

middle.block:                                     ; preds = %vector.body
  br i1 %141, label %B434.lr.ph, label %B336.preheader

B336.preheader:                                   ; preds = %middle.block, %vector.scevcheck, %B336.lr.ph
  %.147711471149.ph = phi i64 [ %n.vec, %middle.block ], [ 0, %vector.scevcheck ], [ 0, %B336.lr.ph ]
  %.neg = or disjoint i64 %.147711471149.ph, 1
  br i1 %lcmp.mod.not.i, label %B336.prol.loopexit, label %B336.prol

B336.prol:                                        ; preds = %B336.preheader
  %.1556.prol = mul i64 %.147711471149.ph, %arg.rail_rate.6.1
  %.1559.prol = getelementptr i8, ptr %scevgep, i64 %.1556.prol
  %.1561.prol = load double, ptr %.1559.prol, align 8
  %.1611.prol = mul i64 %.147711471149.ph, %arg.rail_bend.6.1
  %.1614.prol = getelementptr i8, ptr %scevgep69, i64 %.1611.prol
  %.1616.prol = load double, ptr %.1614.prol, align 8
  %172 = getelementptr double, ptr %146, i64 %.147711471149.ph
  store double %.1561.prol, ptr %172, align 8
  %173 = getelementptr double, ptr %147, i64 %.147711471149.ph
  store double %.1616.prol, ptr %173, align 8
  br label %B336.prol.loopexit

B336.prol.loopexit:                               ; preds = %B336.prol, %B336.preheader
  %.147711471149.unr = phi i64 [ %.147711471149.ph, %B336.preheader ], [ %.neg, %B336.prol ]
  %174 = icmp eq i64 %..265, %.neg
  br i1 %174, label %B434.lr.ph, label %B336.preheader125

B336.preheader125:                                ; preds = %B336.prol.loopexit
  %175 = sub i64 %..265, %.147711471149.unr
  %176 = mul i64 %.147711471149.unr, %arg.rail_bend.6.1
  %177 = mul i64 %.147711471149.unr, %arg.rail_rate.6.1
  %178 = add nuw nsw i64 %.147711471149.unr, 1
  %179 = mul i64 %178, %arg.rail_rate.6.1
  %180 = mul i64 %178, %arg.rail_bend.6.1
  %181 = shl i64 %.147711471149.unr, 3
  %scevgep173 = getelementptr i8, ptr %lsr.iv171, i64 %181
  %scevgep180 = getelementptr i8, ptr %lsr.iv178, i64 %181
  br label %B336

B434.lr.ph:                                       ; preds = %B336, %B336.prol.loopexit, %middle.block, %part.5
  %.1901 = mul i64 %.115211871270, %arg.twist.6.0
  %182 = getelementptr i8, ptr %arg.twist.4, i64 %.1901
  %.1907 = load double, ptr %182, align 8
  store double %.1907, ptr %.855, align 8
  br i1 %.1429, label %B432.loopexit.1.thread, label %B510.preheader

B510.preheader:                                   ; preds = %B434.lr.ph
  br i1 %142, label %B510.lr.ph.1, label %B510

B432.loopexit.1.thread:                           ; preds = %B434.lr.ph
  %.1905.11394 = getelementptr i8, ptr %182, i64 %arg.twist.6.1
  %.1907.11395 = load double, ptr %.1905.11394, align 8
  store double %.1907.11395, ptr %sunkaddr223, align 8
  %sunkaddr210 = getelementptr i8, ptr %182, i64 %sunkaddr204
  %.1907.21398 = load double, ptr %sunkaddr210, align 8
  br label %B586.else.sink.split

B586.else.loopexit.unr-lcssa:                     ; preds = %B510.2
  br i1 %144, label %B586.else, label %B510.2.epil.preheader

B510.2.epil.preheader:                            ; preds = %B586.else.loopexit.unr-lcssa, %B510.lr.ph.2
  %.21071159.2.epil.init = phi double [ %.1907.2, %B510.lr.ph.2 ], [ %.2219.2.1, %B586.else.loopexit.unr-lcssa ]
  %.2160.2.epil = load double, ptr %gep.2.epil, align 8
  %.2213.2.epil = getelementptr i8, ptr %scevgep, i64 %.2210.2.epil
  %.2215.2.epil = load double, ptr %.2213.2.epil, align 8
  %.2218.2.epil = fmul double %.2160.2.epil, %.2215.2.epil
  %.2219.2.epil = fsub double %.21071159.2.epil.init, %.2218.2.epil
  br label %B586.else.sink.split

B586.else.sink.split:                             ; preds = %B432.loopexit.1.thread, %B510.2.epil.preheader
  %.2219.2.epil.sink = phi double [ %.2219.2.epil, %B510.2.epil.preheader ], [ %.1907.21398, %B432.loopexit.1.thread ]
  store double %.2219.2.epil.sink, ptr %sunkaddr229, align 8
  br label %B586.else

B586.else:                                        ; preds = %B586.else.sink.split, %B586.else.loopexit.unr-lcssa
  %.1905.3 = getelementptr i8, ptr %182, i64 %.1902.3
  %.1907.3 = load double, ptr %.1905.3, align 8
  store double %.1907.3, ptr %sunkaddr213, align 8
  %sunkaddr215 = getelementptr i8, ptr %182, i64 %sunkaddr214
  %.1907.4 = load double, ptr %sunkaddr215, align 8
  store double %.1907.4, ptr %sunkaddr216, align 8
  %.1905.5 = getelementptr i8, ptr %182, i64 %.1902.5
  %.1907.5 = load double, ptr %.1905.5, align 8
  store double %.1907.5, ptr %sunkaddr217, align 8
  br i1 %125, label %B586.else.if, label %B586.else.endif, !prof !50

B586.endif:                                       ; preds = %B586.else.endif.if, %B586.else.endif
  %.2304.sroa.0.3 = phi i64 [ %arg.qd.5.1, %B586.else.endif.if ], [ %.2304.sroa.0.1, %B586.else.endif ]
  %.2421 = mul i64 %.115211871270, %arg.qd.5.1
  %183 = getelementptr double, ptr %arg.qd.4, i64 %.2421
  %.2425 = getelementptr double, ptr %183, i64 %.2304.sroa.0.3
  call fastcc void @part.6(ptr nonnull %.2460, ptr %.444, i64 %arg.room.5.2, ptr nonnull %.546, ptr nonnull %.855, i64 %arg.room.5.2, ptr %.2425)
  %.2663 = mul i64 %.115211871270, %arg.qdd.5.1
  %184 = getelementptr double, ptr %arg.qdd.4, i64 %.2663
  %185 = getelementptr double, ptr %184, i64 %.265
  %.2667 = getelementptr double, ptr %185, i64 %.3193
  store double 0.000000e+00, ptr %.2667, align 8
  %186 = getelementptr double, ptr %184, i64 %arg.q.5.1
  %187 = getelementptr i8, ptr %186, i64 -40
  %.2667.1 = getelementptr double, ptr %187, i64 %.2645.1
  store double 0.000000e+00, ptr %.2667.1, align 8
  %188 = getelementptr i8, ptr %186, i64 -32
  %.2667.2 = getelementptr double, ptr %188, i64 %.2645.2
  store double 0.000000e+00, ptr %.2667.2, align 8
  %189 = getelementptr i8, ptr %186, i64 -24
  %.2667.3 = getelementptr double, ptr %189, i64 %.2645.3
  store double 0.000000e+00, ptr %.2667.3, align 8
  %190 = getelementptr i8, ptr %186, i64 -16
  %.2667.4 = getelementptr double, ptr %190, i64 %.2645.4
  store double 0.000000e+00, ptr %.2667.4, align 8
  %191 = getelementptr i8, ptr %186, i64 -8
  %.2667.5 = getelementptr double, ptr %191, i64 %.2645.5
  store double 0.000000e+00, ptr %.2667.5, align 8
  store double 0.000000e+00, ptr %.753, align 8, !noalias !81
  store double 0.000000e+00, ptr %127, align 8, !noalias !81
  store double 0.000000e+00, ptr %.625.us.i, align 8, !noalias !81
  store double 0.000000e+00, ptr %.681.us.i, align 8, !noalias !81
  br i1 %.7631553.i, label %B206.us.i, label %B104.endif.preheader.i

B104.endif.preheader.i:                           ; preds = %B586.endif
  store double 0.000000e+00, ptr %sunkaddr54.i, align 8, !noalias !81
  store double 0.000000e+00, ptr %sunkaddr50.i46, align 8, !noalias !81
  store double 0.000000e+00, ptr %.625.1.i, align 8, !noalias !81
  store double 0.000000e+00, ptr %.681.1.i39, align 8, !noalias !81
  store double 0.000000e+00, ptr %sunkaddr55.i, align 8, !noalias !81
  store double 0.000000e+00, ptr %sunkaddr53.i, align 8, !noalias !81
  store double 0.000000e+00, ptr %.625.2.i, align 8, !noalias !81
  store double 0.000000e+00, ptr %.681.2.i40, align 8, !noalias !81
  br label %B352.else.endif.i

B206.us.i:                                        ; preds = %B586.endif, %B206.us.i
  %lsr.iv36.i = phi ptr [ %scevgep37.i66, %B206.us.i ], [ %arg.ride.4, %B586.endif ]
  %.76915521554.us.i = phi i64 [ %.776.us.i, %B206.us.i ], [ 0, %B586.endif ]
  %.776.us.i = add nuw nsw i64 %.76915521554.us.i, 1
  %.855.us.i = load double, ptr %.753, align 8, !noalias !81
  %.908.us.i61 = load double, ptr %lsr.iv36.i, align 8, !noalias !81
  %192 = shl i64 %.76915521554.us.i, 3
  %scevgep39.i62 = getelementptr i8, ptr %183, i64 %192
  %.940.us.i = load double, ptr %scevgep39.i62, align 8, !noalias !81
  %.941.us.i63 = fmul double %.908.us.i61, %.940.us.i
  %.942.us.i64 = fadd double %.855.us.i, %.941.us.i63
  store double %.942.us.i64, ptr %.753, align 8, !noalias !81
  %.1049.us.i = load double, ptr %127, align 8, !noalias !81
  %.1102.us.i = load double, ptr %lsr.iv36.i, align 8, !noalias !81
  %scevgep22.i65 = getelementptr i8, ptr %184, i64 %192
  %.1134.us.i = load double, ptr %scevgep22.i65, align 8, !noalias !81
  %.1135.us.i = fmul double %.1102.us.i, %.1134.us.i
  %.1136.us.i = fadd double %.1049.us.i, %.1135.us.i
  store double %.1136.us.i, ptr %127, align 8, !noalias !81
  %scevgep37.i66 = getelementptr i8, ptr %lsr.iv36.i, i64 %arg.ride.6.0
  %exitcond.not.i67 = icmp eq i64 %..335.i, %.776.us.i
  br i1 %exitcond.not.i67, label %B204.B350_crit_edge.us.i, label %B206.us.i

B204.B350_crit_edge.us.i:                         ; preds = %B206.us.i
  store double 0.000000e+00, ptr %sunkaddr54.i, align 8, !noalias !81
  store double 0.000000e+00, ptr %sunkaddr50.i46, align 8, !noalias !81
  store double 0.000000e+00, ptr %.625.1.i, align 8, !noalias !81
  store double 0.000000e+00, ptr %.681.1.i39, align 8, !noalias !81
  br label %B206.us.1.i

B206.us.1.i:                                      ; preds = %B206.us.1.i, %B204.B350_crit_edge.us.i
  %lsr.iv34.i = phi ptr [ %scevgep35.i74, %B206.us.1.i ], [ %invariant.gep.1, %B204.B350_crit_edge.us.i ]
  %.76915521554.us.1.i = phi i64 [ %.776.us.1.i, %B206.us.1.i ], [ 0, %B204.B350_crit_edge.us.i ]
  %.776.us.1.i = add nuw nsw i64 %.76915521554.us.1.i, 1
  %.855.us.1.i = load double, ptr %sunkaddr54.i, align 8, !noalias !81
  %.908.us.1.i70 = load double, ptr %lsr.iv34.i, align 8, !noalias !81
  %193 = shl i64 %.76915521554.us.1.i, 3
  %scevgep33.i71 = getelementptr i8, ptr %183, i64 %193
  %.940.us.1.i = load double, ptr %scevgep33.i71, align 8, !noalias !81
  %.941.us.1.i72 = fmul double %.908.us.1.i70, %.940.us.1.i
  %.942.us.1.i73 = fadd double %.855.us.1.i, %.941.us.1.i72
  store double %.942.us.1.i73, ptr %sunkaddr54.i, align 8, !noalias !81
  %.1049.us.1.i = load double, ptr %sunkaddr50.i46, align 8, !noalias !81
  %.1102.us.1.i = load double, ptr %lsr.iv34.i, align 8, !noalias !81
  %scevgep19.i = getelementptr i8, ptr %184, i64 %193
  %.1134.us.1.i = load double, ptr %scevgep19.i, align 8, !noalias !81
  %.1135.us.1.i = fmul double %.1102.us.1.i, %.1134.us.1.i
  %.1136.us.1.i = fadd double %.1049.us.1.i, %.1135.us.1.i
  store double %.1136.us.1.i, ptr %sunkaddr50.i46, align 8, !noalias !81
  %scevgep35.i74 = getelementptr i8, ptr %lsr.iv34.i, i64 %arg.ride.6.0
  %exitcond.1.not.i = icmp eq i64 %..335.i, %.776.us.1.i
  br i1 %exitcond.1.not.i, label %B204.B350_crit_edge.us.1.i, label %B206.us.1.i

B204.B350_crit_edge.us.1.i:                       ; preds = %B206.us.1.i
  store double 0.000000e+00, ptr %sunkaddr55.i, align 8, !noalias !81
  store double 0.000000e+00, ptr %sunkaddr53.i, align 8, !noalias !81
  store double 0.000000e+00, ptr %.625.2.i, align 8, !noalias !81
  store double 0.000000e+00, ptr %.681.2.i40, align 8, !noalias !81
  br label %B206.us.2.i

B206.us.2.i:                                      ; preds = %B206.us.2.i, %B204.B350_crit_edge.us.1.i
  %lsr.iv30.i = phi ptr [ %scevgep31.i, %B206.us.2.i ], [ %invariant.gep.2, %B204.B350_crit_edge.us.1.i ]
  %.76915521554.us.2.i = phi i64 [ %.776.us.2.i, %B206.us.2.i ], [ 0, %B204.B350_crit_edge.us.1.i ]
  %.776.us.2.i = add nuw nsw i64 %.76915521554.us.2.i, 1
  %.855.us.2.i = load double, ptr %sunkaddr55.i, align 8, !noalias !81
  %.908.us.2.i78 = load double, ptr %lsr.iv30.i, align 8, !noalias !81
  %194 = shl i64 %.76915521554.us.2.i, 3
  %scevgep29.i79 = getelementptr i8, ptr %183, i64 %194
  %.940.us.2.i = load double, ptr %scevgep29.i79, align 8, !noalias !81
  %.941.us.2.i80 = fmul double %.908.us.2.i78, %.940.us.2.i
  %.942.us.2.i81 = fadd double %.855.us.2.i, %.941.us.2.i80
  store double %.942.us.2.i81, ptr %sunkaddr55.i, align 8, !noalias !81
  %.1049.us.2.i = load double, ptr %sunkaddr53.i, align 8, !noalias !81
  %.1102.us.2.i = load double, ptr %lsr.iv30.i, align 8, !noalias !81
  %scevgep14.i82 = getelementptr i8, ptr %184, i64 %194
  %.1134.us.2.i = load double, ptr %scevgep14.i82, align 8, !noalias !81
  %.1135.us.2.i = fmul double %.1102.us.2.i, %.1134.us.2.i
  %.1136.us.2.i = fadd double %.1049.us.2.i, %.1135.us.2.i
  store double %.1136.us.2.i, ptr %sunkaddr53.i, align 8, !noalias !81
  %scevgep31.i = getelementptr i8, ptr %lsr.iv30.i, i64 %arg.ride.6.0
  %exitcond.2.not.i = icmp eq i64 %..335.i, %.776.us.2.i
  br i1 %exitcond.2.not.i, label %B352.else.endif.i, label %B206.us.2.i

B352.else.endif.i:                                ; preds = %B206.us.2.i, %B104.endif.preheader.i
  %scevgep17.i43 = getelementptr i8, ptr %184, i64 %128
  %scevgep20.i44 = getelementptr i8, ptr %183, i64 %128
  br label %switch.end.2.i47

switch.end.2.i47:                                 ; preds = %switch.end.2.i47, %B352.else.endif.i
  %lsr.iv14.i = phi ptr [ %scevgep15.i60, %switch.end.2.i47 ], [ %.1577.peel.i, %B352.else.endif.i ]
  %lsr.iv.i48 = phi ptr [ %scevgep2.i59, %switch.end.2.i47 ], [ %invariant.gep1178.2.i, %B352.else.endif.i ]
  %before_2.2.01580.i = phi double [ %.1983.i, %switch.end.2.i47 ], [ 0.000000e+00, %B352.else.endif.i ]
  %before.2.01579.i = phi double [ %.1837.i, %switch.end.2.i47 ], [ 0.000000e+00, %B352.else.endif.i ]
  %.172015721577.i = phi i64 [ %.1727.i, %switch.end.2.i47 ], [ 0, %B352.else.endif.i ]
  %.1727.i = add nuw nsw i64 %.172015721577.i, 1
  %scevgep16.i49 = getelementptr i8, ptr %lsr.iv14.i, i64 -40
  %.1805.i = load double, ptr %scevgep16.i49, align 8, !noalias !81
  %195 = add i64 %.172015721577.i, %.335.i
  %.1821.i = icmp slt i64 %195, 0
  %196 = select i1 %.1821.i, i64 %64, i64 0
  %scevgep21.i = getelementptr i8, ptr %scevgep20.i44, i64 %196
  %197 = shl nuw nsw i64 %.172015721577.i, 3
  %scevgep12.i = getelementptr i8, ptr %scevgep21.i, i64 %197
  %.1837.i = load double, ptr %scevgep12.i, align 8, !noalias !81
  %.1838.i = fmul double %.1805.i, %.1837.i
  %.1892.i = load double, ptr %lsr.iv14.i, align 8, !noalias !81
  %.1894.i = fmul double %before.2.01579.i, %.1892.i
  %.1897.i = fsub double %.1838.i, %.1894.i
  %198 = select i1 %.1821.i, i64 %68, i64 0
  %scevgep18.i50 = getelementptr i8, ptr %scevgep17.i43, i64 %198
  %scevgep11.i51 = getelementptr i8, ptr %scevgep18.i50, i64 %197
  %.1983.i = load double, ptr %scevgep11.i51, align 8, !noalias !81
  %.1984.i = fmul double %.1805.i, %.1983.i
  %.2040.i = fmul double %before_2.2.01580.i, %.1892.i
  %.2043.i = fsub double %.1984.i, %.2040.i
  %sunkaddr27.i = getelementptr i8, ptr %lsr.iv.i48, i64 %sunkaddr101.i
  %sunkaddr28.i52 = getelementptr i8, ptr %sunkaddr27.i, i64 -16
  %.2167.i = load double, ptr %sunkaddr28.i52, align 8, !noalias !81
  %sunkaddr31.i53 = getelementptr i8, ptr %sunkaddr27.i, i64 -8
  %.2221.i54 = load double, ptr %sunkaddr31.i53, align 8, !noalias !81
  %.2275.i = load double, ptr %sunkaddr27.i, align 8, !noalias !81
  %.2305.i = load double, ptr %sunkaddr35.i, align 8, !noalias !81
  %.2306.i = fmul double %.2167.i, %.2043.i
  %.2336.i = load double, ptr %sunkaddr38.i, align 8, !noalias !81
  %.2337.i = fmul double %.2275.i, %.2336.i
  %.2367.i = load double, ptr %sunkaddr41.i, align 8, !noalias !81
  %.2368.i = fmul double %.2221.i54, %.2367.i
  %.2369.i = fsub double %.2337.i, %.2368.i
  %.2370.i = fmul double %.1897.i, %.2369.i
  %.2371.i = fadd double %.2306.i, %.2370.i
  %.2372.i = fadd double %.2305.i, %.2371.i
  store double %.2372.i, ptr %sunkaddr35.i, align 8, !noalias !81
  %.2432.i = load double, ptr %sunkaddr44.i, align 8, !noalias !81
  %.2433.i = fmul double %.2043.i, %.2221.i54
  %.2463.i = load double, ptr %sunkaddr41.i, align 8, !noalias !81
  %.2464.i = fmul double %.2167.i, %.2463.i
  %.2494.i = load double, ptr %sunkaddr37.i, align 8, !noalias !81
  %.2495.i = fmul double %.2275.i, %.2494.i
  %.2496.i = fsub double %.2464.i, %.2495.i
  %.2497.i = fmul double %.1897.i, %.2496.i
  %.2498.i = fadd double %.2433.i, %.2497.i
  %.2499.i = fadd double %.2432.i, %.2498.i
  store double %.2499.i, ptr %sunkaddr44.i, align 8, !noalias !81
  %.2559.i = load double, ptr %sunkaddr49.i45, align 8, !noalias !81
  %.2560.i = fmul double %.2043.i, %.2275.i
  %.2590.i = load double, ptr %sunkaddr37.i, align 8, !noalias !81
  %.2591.i = fmul double %.2221.i54, %.2590.i
  %.2621.i = load double, ptr %sunkaddr38.i, align 8, !noalias !81
  %.2622.i = fmul double %.2167.i, %.2621.i
  %.2623.i = fsub double %.2591.i, %.2622.i
  %.2624.i = fmul double %.1897.i, %.2623.i
  %.2625.i = fadd double %.2560.i, %.2624.i
  %.2626.i = fadd double %.2559.i, %.2625.i
  store double %.2626.i, ptr %sunkaddr49.i45, align 8, !noalias !81
  %.2686.i = load double, ptr %sunkaddr37.i, align 8, !noalias !81
  %.2687.i = fmul double %.1897.i, %.2167.i
  %.2688.i = fadd double %.2687.i, %.2686.i
  store double %.2688.i, ptr %sunkaddr37.i, align 8, !noalias !81
  %.2748.i = load double, ptr %sunkaddr38.i, align 8, !noalias !81
  %.2749.i = fmul double %.1897.i, %.2221.i54
  %.2750.i = fadd double %.2749.i, %.2748.i
  store double %.2750.i, ptr %sunkaddr38.i, align 8, !noalias !81
  %.2810.i = load double, ptr %sunkaddr41.i, align 8, !noalias !81
  %.2811.i = fmul double %.1897.i, %.2275.i
  %.2812.i = fadd double %.2811.i, %.2810.i
  store double %.2812.i, ptr %sunkaddr41.i, align 8, !noalias !81
  %scevgep6.i55 = getelementptr i8, ptr %lsr.iv.i48, i64 %100
  %scevgep10.i = getelementptr i8, ptr %scevgep6.i55, i64 -16
  %.2897.i = load double, ptr %scevgep10.i, align 8, !noalias !81
  %scevgep3.i56 = getelementptr i8, ptr %lsr.iv.i48, i64 %.348.idx.i
  %scevgep4.i = getelementptr i8, ptr %scevgep3.i56, i64 -16
  %.2951.i = load double, ptr %scevgep4.i, align 8, !noalias !81
  %.2952.i = fsub double %.2897.i, %.2951.i
  %scevgep9.i57 = getelementptr i8, ptr %scevgep6.i55, i64 -8
  %.3007.i = load double, ptr %scevgep9.i57, align 8, !noalias !81
  %scevgep5.i58 = getelementptr i8, ptr %scevgep3.i56, i64 -8
  %.3061.i = load double, ptr %scevgep5.i58, align 8, !noalias !81
  %.3062.i = fsub double %.3007.i, %.3061.i
  %.3117.i = load double, ptr %scevgep6.i55, align 8, !noalias !81
  %.3171.i = load double, ptr %scevgep3.i56, align 8, !noalias !81
  %.3172.i = fsub double %.3117.i, %.3171.i
  %.3203.i = fmul double %.2750.i, %.3172.i
  %.3234.i = fmul double %.2812.i, %.3062.i
  %.3235.i = fsub double %.3203.i, %.3234.i
  %.3266.i = fmul double %.2812.i, %.2952.i
  %.3297.i = fmul double %.2688.i, %.3172.i
  %.3298.i = fsub double %.3266.i, %.3297.i
  %.3329.i = fmul double %.2688.i, %.3062.i
  %.3360.i = fmul double %.2750.i, %.2952.i
  %.3361.i = fsub double %.3329.i, %.3360.i
  %.3427.i = load double, ptr %127, align 8, !noalias !81
  %.3457.i = load double, ptr %sunkaddr44.i, align 8, !noalias !81
  %.3458.i = fmul double %.3172.i, %.3457.i
  %.3488.i = load double, ptr %sunkaddr49.i45, align 8, !noalias !81
  %.3489.i = fmul double %.3062.i, %.3488.i
  %.3490.i = fsub double %.3458.i, %.3489.i
  %.3523.i = fmul double %.2750.i, %.3361.i
  %.3524.i = fadd double %.3523.i, %.3490.i
  %.3557.i = fmul double %.2812.i, %.3298.i
  %.3558.i = fsub double %.3524.i, %.3557.i
  %.3559.i = fadd double %.3427.i, %.3558.i
  store double %.3559.i, ptr %127, align 8, !noalias !81
  %.3667.i = load double, ptr %sunkaddr50.i46, align 8, !noalias !81
  %.3697.i = load double, ptr %sunkaddr49.i45, align 8, !noalias !81
  %.3698.i = fmul double %.2952.i, %.3697.i
  %.3728.i = load double, ptr %sunkaddr35.i, align 8, !noalias !81
  %.3729.i = fmul double %.3172.i, %.3728.i
  %.3730.i = fsub double %.3698.i, %.3729.i
  %.3760.i = load double, ptr %sunkaddr41.i, align 8, !noalias !81
  %.3763.i = fmul double %.3235.i, %.3760.i
  %.3764.i = fadd double %.3730.i, %.3763.i
  %.3794.i = load double, ptr %sunkaddr37.i, align 8, !noalias !81
  %.3797.i = fmul double %.3361.i, %.3794.i
  %.3798.i = fsub double %.3764.i, %.3797.i
  %.3799.i = fadd double %.3667.i, %.3798.i
  store double %.3799.i, ptr %sunkaddr50.i46, align 8, !noalias !81
  %.3907.i = load double, ptr %sunkaddr53.i, align 8, !noalias !81
  %.3937.i = load double, ptr %sunkaddr35.i, align 8, !noalias !81
  %.3938.i = fmul double %.3062.i, %.3937.i
  %.3968.i = load double, ptr %sunkaddr44.i, align 8, !noalias !81
  %.3969.i = fmul double %.2952.i, %.3968.i
  %.3970.i = fsub double %.3938.i, %.3969.i
  %.4000.i = load double, ptr %sunkaddr37.i, align 8, !noalias !81
  %.4003.i = fmul double %.3298.i, %.4000.i
  %.4004.i = fadd double %.3970.i, %.4003.i
  %.4034.i = load double, ptr %sunkaddr38.i, align 8, !noalias !81
  %.4037.i = fmul double %.3235.i, %.4034.i
  %.4038.i = fsub double %.4004.i, %.4037.i
  %.4039.i = fadd double %.3907.i, %.4038.i
  store double %.4039.i, ptr %sunkaddr53.i, align 8, !noalias !81
  %.4262.i = load double, ptr %.753, align 8, !noalias !81
  %.4277.i = fadd double %.3235.i, %.4262.i
  store double %.4277.i, ptr %.753, align 8, !noalias !81
  %.4262.1.i = load double, ptr %sunkaddr54.i, align 8, !noalias !81
  %.4277.1.i = fadd double %.3298.i, %.4262.1.i
  store double %.4277.1.i, ptr %sunkaddr54.i, align 8, !noalias !81
  %.4262.2.i = load double, ptr %sunkaddr55.i, align 8, !noalias !81
  %.4277.2.i = fadd double %.3361.i, %.4262.2.i
  store double %.4277.2.i, ptr %sunkaddr55.i, align 8, !noalias !81
  %scevgep2.i59 = getelementptr i8, ptr %lsr.iv.i48, i64 %97
  %scevgep15.i60 = getelementptr i8, ptr %lsr.iv14.i, i64 %106
  %exitcond.not1.i = icmp eq i64 %.1727.i, 6
  br i1 %exitcond.not1.i, label %part.7, label %switch.end.2.i47

part.7: ; preds = %switch.end.2.i47
  %.3040 = mul i64 %.115211871270, %arg.bend.6.0
  %199 = getelementptr i8, ptr %arg.bend.4, i64 %.3040
  %.3046 = load double, ptr %199, align 8
  %.3102 = load double, ptr %sunkaddr219, align 8
  %.3103 = fsub double %.3046, %.3102
  store double %.3103, ptr %.855, align 8
  %.3044.1 = getelementptr i8, ptr %199, i64 %arg.bend.6.1
  %.3046.1 = load double, ptr %.3044.1, align 8
  %.3102.1 = load double, ptr %sunkaddr222, align 8
  %.3103.1 = fsub double %.3046.1, %.3102.1
  store double %.3103.1, ptr %sunkaddr223, align 8
  %sunkaddr225 = getelementptr i8, ptr %199, i64 %sunkaddr224
  %.3046.2 = load double, ptr %sunkaddr225, align 8
  %.3102.2 = load double, ptr %sunkaddr228, align 8
  %.3103.2 = fsub double %.3046.2, %.3102.2
  store double %.3103.2, ptr %sunkaddr229, align 8
  %.3044.3 = getelementptr i8, ptr %199, i64 %.3041.3
  %.3046.3 = load double, ptr %.3044.3, align 8
  %.3102.3 = load double, ptr %sunkaddr232, align 8
  %.3103.3 = fsub double %.3046.3, %.3102.3
  store double %.3103.3, ptr %sunkaddr213, align 8
  %sunkaddr235 = getelementptr i8, ptr %199, i64 %sunkaddr234
  %.3046.4 = load double, ptr %sunkaddr235, align 8
  %.3102.4 = load double, ptr %sunkaddr238, align 8
  %.3103.4 = fsub double %.3046.4, %.3102.4
  store double %.3103.4, ptr %sunkaddr216, align 8
  %.3044.5 = getelementptr i8, ptr %199, i64 %.3041.5
  %.3046.5 = load double, ptr %.3044.5, align 8
  %.3102.5 = load double, ptr %sunkaddr242, align 8
  %.3103.5 = fsub double %.3046.5, %.3102.5
  store double %.3103.5, ptr %sunkaddr217, align 8
  br i1 %129, label %B846.else.if, label %B846.else.endif, !prof !50

B586.else.if:                                     ; preds = %B586.else
  br label %B586.else.endif

B586.else.endif:                                  ; preds = %B586.else.if, %B586.else
  %.2304.sroa.0.1 = phi i64 [ 0, %B586.else.if ], [ %.2316, %B586.else ]
  br i1 %126, label %B586.endif, label %B586.else.endif.if, !prof !84

B586.else.endif.if:                               ; preds = %B586.else.endif
  br label %B586.endif

B846.endif:                                       ; preds = %B846.else.endif.if, %B846.else.endif
  %.3182.sroa.0.3 = phi i64 [ %arg.qdd.5.1, %B846.else.endif.if ], [ %.3182.sroa.0.1, %B846.else.endif ]
  %.3303 = getelementptr double, ptr %184, i64 %.3182.sroa.0.3
  call fastcc void @part.6(ptr nonnull %.3338, ptr %.444, i64 %arg.room.5.2, ptr nonnull %.546, ptr nonnull %.855, i64 %arg.room.5.2, ptr %.3303)
  %scevgep127 = getelementptr i8, ptr %lsr.iv, i64 %arg.rail_rate.6.0
  %scevgep137 = getelementptr i8, ptr %lsr.iv136, i64 %arg.rail_bend.6.0
  %scevgep147 = getelementptr i8, ptr %lsr.iv146, i64 %64
  %scevgep153 = getelementptr i8, ptr %lsr.iv152, i64 %68
  %scevgep159 = getelementptr i8, ptr %lsr.iv158, i64 %arg.rail_bend.6.0
  %scevgep164 = getelementptr i8, ptr %lsr.iv163, i64 %arg.rail_rate.6.0
  %scevgep172 = getelementptr i8, ptr %lsr.iv171, i64 %68
  %scevgep179 = getelementptr i8, ptr %lsr.iv178, i64 %64
  %exitcond1393.not = icmp eq i64 %.1159, %arg.q.5.0
  br i1 %exitcond1393.not, label %B906, label %B182

B846.else.if:                                     ; preds = %part.7
  br label %B846.else.endif

B846.else.endif:                                  ; preds = %B846.else.if, %part.7
  %.3182.sroa.0.1 = phi i64 [ 0, %B846.else.if ], [ %.3194, %part.7 ]
  br i1 %130, label %B846.endif, label %B846.else.endif.if, !prof !84

B846.else.endif.if:                               ; preds = %B846.else.endif
  br label %B846.endif
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #1

; Function Attrs: mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite)
define internal fastcc void @part.6(ptr noalias nonnull writeonly captures(none) initializes((0, 8)) %retptr, ptr readonly captures(none) %arg.A.4, i64 %arg.A.5.1, ptr readonly captures(none) %arg.order.4, ptr readonly captures(none) %arg.b.4, i64 %arg.b.5.0, ptr writeonly captures(none) initializes((0, 48)) %arg.x.4) unnamed_addr #2 {
common.ret:
  %.218 = load double, ptr %arg.order.4, align 8
  %.5.i = fptosi double %.218 to i64
  %.256 = icmp slt i64 %.5.i, 0
  %.257 = select i1 %.256, i64 %arg.b.5.0, i64 0
  %0 = getelementptr double, ptr %arg.b.4, i64 %.5.i
  %.271 = getelementptr double, ptr %0, i64 %.257
  %.272 = load double, ptr %.271, align 8
  store double %.272, ptr %arg.x.4, align 8
  %1 = getelementptr i8, ptr %arg.order.4, i64 8
  %.218.1 = load double, ptr %1, align 8
  %.5.i4 = fptosi double %.218.1 to i64
  %.256.1 = icmp slt i64 %.5.i4, 0
  %.257.1 = select i1 %.256.1, i64 %arg.b.5.0, i64 0
  %2 = getelementptr double, ptr %arg.b.4, i64 %.5.i4
  %.271.1 = getelementptr double, ptr %2, i64 %.257.1
  %.272.1 = load double, ptr %.271.1, align 8
  %3 = getelementptr i8, ptr %arg.x.4, i64 8
  store double %.272.1, ptr %3, align 8
  %4 = getelementptr double, ptr %arg.A.4, i64 %arg.A.5.1
  %.505.1 = load double, ptr %4, align 8
  %.538.1 = fmul double %.272, %.505.1
  %.539.1 = fsub double %.272.1, %.538.1
  store double %.539.1, ptr %3, align 8
  %5 = getelementptr i8, ptr %arg.order.4, i64 16
  %.218.2 = load double, ptr %5, align 8
  %.5.i5 = fptosi double %.218.2 to i64
  %.256.2 = icmp slt i64 %.5.i5, 0
  %.257.2 = select i1 %.256.2, i64 %arg.b.5.0, i64 0
  %6 = getelementptr double, ptr %arg.b.4, i64 %.5.i5
  %.271.2 = getelementptr double, ptr %6, i64 %.257.2
  %.272.2 = load double, ptr %.271.2, align 8
  %7 = getelementptr i8, ptr %arg.x.4, i64 16
  store double %.272.2, ptr %7, align 8
  %.idx = shl i64 %arg.A.5.1, 4
  %8 = getelementptr i8, ptr %arg.A.4, i64 %.idx
  %.505.2 = load double, ptr %8, align 8
  %.538.2 = fmul double %.272, %.505.2
  %.539.2 = fsub double %.272.2, %.538.2
  store double %.539.2, ptr %7, align 8
  %9 = getelementptr i8, ptr %8, i64 8
  %.505.2.1 = load double, ptr %9, align 8
  %.538.2.1 = fmul double %.539.1, %.505.2.1
  %.539.2.1 = fsub double %.539.2, %.538.2.1
  store double %.539.2.1, ptr %7, align 8
  %10 = getelementptr i8, ptr %arg.order.4, i64 24
  %.218.3 = load double, ptr %10, align 8
  %.5.i6 = fptosi double %.218.3 to i64
  %.256.3 = icmp slt i64 %.5.i6, 0
  %.257.3 = select i1 %.256.3, i64 %arg.b.5.0, i64 0
  %11 = getelementptr double, ptr %arg.b.4, i64 %.5.i6
  %.271.3 = getelementptr double, ptr %11, i64 %.257.3
  %.272.3 = load double, ptr %.271.3, align 8
  %12 = getelementptr i8, ptr %arg.x.4, i64 24
  store double %.272.3, ptr %12, align 8
  %.idx448 = mul i64 %arg.A.5.1, 24
  %13 = getelementptr i8, ptr %arg.A.4, i64 %.idx448
  %.505.3 = load double, ptr %13, align 8
  %.538.3 = fmul double %.272, %.505.3
  %.539.3 = fsub double %.272.3, %.538.3
  store double %.539.3, ptr %12, align 8
  %14 = getelementptr i8, ptr %13, i64 8
  %.505.3.1 = load double, ptr %14, align 8
  %.538.3.1 = fmul double %.539.1, %.505.3.1
  %.539.3.1 = fsub double %.539.3, %.538.3.1
  store double %.539.3.1, ptr %12, align 8
  %15 = getelementptr i8, ptr %13, i64 16
  %.505.3.2 = load double, ptr %15, align 8
  %.538.3.2 = fmul double %.539.2.1, %.505.3.2
  %.539.3.2 = fsub double %.539.3.1, %.538.3.2
  store double %.539.3.2, ptr %12, align 8
  %16 = getelementptr i8, ptr %arg.order.4, i64 32
  %.218.4 = load double, ptr %16, align 8
  %.5.i7 = fptosi double %.218.4 to i64
  %.256.4 = icmp slt i64 %.5.i7, 0
  %.257.4 = select i1 %.256.4, i64 %arg.b.5.0, i64 0
  %17 = getelementptr double, ptr %arg.b.4, i64 %.5.i7
  %.271.4 = getelementptr double, ptr %17, i64 %.257.4
  %.272.4 = load double, ptr %.271.4, align 8
  %18 = getelementptr i8, ptr %arg.x.4, i64 32
  store double %.272.4, ptr %18, align 8
  %.idx449 = shl i64 %arg.A.5.1, 5
  %19 = getelementptr i8, ptr %arg.A.4, i64 %.idx449
  %.505.4 = load double, ptr %19, align 8
  %.538.4 = fmul double %.272, %.505.4
  %.539.4 = fsub double %.272.4, %.538.4
  store double %.539.4, ptr %18, align 8
  %20 = getelementptr i8, ptr %19, i64 8
  %.505.4.1 = load double, ptr %20, align 8
  %.538.4.1 = fmul double %.539.1, %.505.4.1
  %.539.4.1 = fsub double %.539.4, %.538.4.1
  store double %.539.4.1, ptr %18, align 8
  %21 = getelementptr i8, ptr %19, i64 16
  %.505.4.2 = load double, ptr %21, align 8
  %.538.4.2 = fmul double %.539.2.1, %.505.4.2
  %.539.4.2 = fsub double %.539.4.1, %.538.4.2
  store double %.539.4.2, ptr %18, align 8
  %22 = getelementptr i8, ptr %19, i64 24
  %.505.4.3 = load double, ptr %22, align 8
  %.538.4.3 = fmul double %.539.3.2, %.505.4.3
  %.539.4.3 = fsub double %.539.4.2, %.538.4.3
  store double %.539.4.3, ptr %18, align 8
  %23 = getelementptr i8, ptr %arg.order.4, i64 40
  %.218.5 = load double, ptr %23, align 8
  %.5.i8 = fptosi double %.218.5 to i64
  %.256.5 = icmp slt i64 %.5.i8, 0
  %.257.5 = select i1 %.256.5, i64 %arg.b.5.0, i64 0
  %24 = getelementptr double, ptr %arg.b.4, i64 %.5.i8
  %.271.5 = getelementptr double, ptr %24, i64 %.257.5
  %.272.5 = load double, ptr %.271.5, align 8
  %25 = getelementptr i8, ptr %arg.x.4, i64 40
  store double %.272.5, ptr %25, align 8
  %.idx450 = mul i64 %arg.A.5.1, 40
  %26 = getelementptr i8, ptr %arg.A.4, i64 %.idx450
  %.505.5 = load double, ptr %26, align 8
  %.538.5 = fmul double %.272, %.505.5
  %.539.5 = fsub double %.272.5, %.538.5
  store double %.539.5, ptr %25, align 8
  %27 = getelementptr i8, ptr %26, i64 8
  %.505.5.1 = load double, ptr %27, align 8
  %.538.5.1 = fmul double %.539.1, %.505.5.1
  %.539.5.1 = fsub double %.539.5, %.538.5.1
  store double %.539.5.1, ptr %25, align 8
  %28 = getelementptr i8, ptr %26, i64 16
  %.505.5.2 = load double, ptr %28, align 8
  %.538.5.2 = fmul double %.539.2.1, %.505.5.2
  %.539.5.2 = fsub double %.539.5.1, %.538.5.2
  store double %.539.5.2, ptr %25, align 8
  %29 = getelementptr i8, ptr %26, i64 24
  %.505.5.3 = load double, ptr %29, align 8
  %.538.5.3 = fmul double %.539.3.2, %.505.5.3
  %.539.5.3 = fsub double %.539.5.2, %.538.5.3
  store double %.539.5.3, ptr %25, align 8
  %30 = getelementptr i8, ptr %26, i64 32
  %.505.5.4 = load double, ptr %30, align 8
  %.538.5.4 = fmul double %.539.4.3, %.505.5.4
  %.539.5.4 = fsub double %.539.5.3, %.538.5.4
  store double %.539.5.4, ptr %25, align 8
  %31 = getelementptr i8, ptr %26, i64 40
  %.1070 = load double, ptr %31, align 8
  %.1076 = fdiv double %.539.5.4, %.1070
  store double %.1076, ptr %25, align 8
  %32 = getelementptr i8, ptr %19, i64 40
  %.915.1 = load double, ptr %32, align 8
  %.948.1 = fmul double %.1076, %.915.1
  %.949.1 = fsub double %.539.4.3, %.948.1
  store double %.949.1, ptr %18, align 8
  %33 = getelementptr i8, ptr %19, i64 32
  %.1070.1 = load double, ptr %33, align 8
  %.1076.1 = fdiv double %.949.1, %.1070.1
  store double %.1076.1, ptr %18, align 8
  %34 = getelementptr i8, ptr %13, i64 32
  %.915.2 = load double, ptr %34, align 8
  %.948.2 = fmul double %.1076.1, %.915.2
  %.949.2 = fsub double %.539.3.2, %.948.2
  store double %.949.2, ptr %12, align 8
  %35 = getelementptr i8, ptr %13, i64 40
  %.915.2.1 = load double, ptr %35, align 8
  %.948.2.1 = fmul double %.1076, %.915.2.1
  %.949.2.1 = fsub double %.949.2, %.948.2.1
  store double %.949.2.1, ptr %12, align 8
  %36 = getelementptr i8, ptr %13, i64 24
  %.1070.2 = load double, ptr %36, align 8
  %.1076.2 = fdiv double %.949.2.1, %.1070.2
  store double %.1076.2, ptr %12, align 8
  %37 = getelementptr i8, ptr %8, i64 24
  %.915.3 = load double, ptr %37, align 8
  %.948.3 = fmul double %.1076.2, %.915.3
  %.949.3 = fsub double %.539.2.1, %.948.3
  store double %.949.3, ptr %7, align 8
  %38 = getelementptr i8, ptr %8, i64 32
  %.915.3.1 = load double, ptr %38, align 8
  %.948.3.1 = fmul double %.1076.1, %.915.3.1
  %.949.3.1 = fsub double %.949.3, %.948.3.1
  store double %.949.3.1, ptr %7, align 8
  %39 = getelementptr i8, ptr %8, i64 40
  %.915.3.2 = load double, ptr %39, align 8
  %.948.3.2 = fmul double %.1076, %.915.3.2
  %.949.3.2 = fsub double %.949.3.1, %.948.3.2
  store double %.949.3.2, ptr %7, align 8
  %40 = getelementptr i8, ptr %8, i64 16
  %.1070.3 = load double, ptr %40, align 8
  %.1076.3 = fdiv double %.949.3.2, %.1070.3
  store double %.1076.3, ptr %7, align 8
  %41 = getelementptr i8, ptr %4, i64 16
  %.915.4 = load double, ptr %41, align 8
  %.948.4 = fmul double %.1076.3, %.915.4
  %.949.4 = fsub double %.539.1, %.948.4
  store double %.949.4, ptr %3, align 8
  %42 = getelementptr i8, ptr %4, i64 24
  %.915.4.1 = load double, ptr %42, align 8
  %.948.4.1 = fmul double %.1076.2, %.915.4.1
  %.949.4.1 = fsub double %.949.4, %.948.4.1
  store double %.949.4.1, ptr %3, align 8
  %43 = getelementptr i8, ptr %4, i64 32
  %.915.4.2 = load double, ptr %43, align 8
  %.948.4.2 = fmul double %.1076.1, %.915.4.2
  %.949.4.2 = fsub double %.949.4.1, %.948.4.2
  store double %.949.4.2, ptr %3, align 8
  %44 = getelementptr i8, ptr %4, i64 40
  %.915.4.3 = load double, ptr %44, align 8
  %.948.4.3 = fmul double %.1076, %.915.4.3
  %.949.4.3 = fsub double %.949.4.2, %.948.4.3
  store double %.949.4.3, ptr %3, align 8
  %45 = getelementptr i8, ptr %4, i64 8
  %.1070.4 = load double, ptr %45, align 8
  %.1076.4 = fdiv double %.949.4.3, %.1070.4
  store double %.1076.4, ptr %3, align 8
  %46 = getelementptr i8, ptr %arg.A.4, i64 8
  %.915.5 = load double, ptr %46, align 8
  %.948.5 = fmul double %.1076.4, %.915.5
  %.949.5 = fsub double %.272, %.948.5
  store double %.949.5, ptr %arg.x.4, align 8
  %47 = getelementptr i8, ptr %arg.A.4, i64 16
  %.915.5.1 = load double, ptr %47, align 8
  %.948.5.1 = fmul double %.1076.3, %.915.5.1
  %.949.5.1 = fsub double %.949.5, %.948.5.1
  store double %.949.5.1, ptr %arg.x.4, align 8
  %48 = getelementptr i8, ptr %arg.A.4, i64 24
  %.915.5.2 = load double, ptr %48, align 8
  %.948.5.2 = fmul double %.1076.2, %.915.5.2
  %.949.5.2 = fsub double %.949.5.1, %.948.5.2
  store double %.949.5.2, ptr %arg.x.4, align 8
  %49 = getelementptr i8, ptr %arg.A.4, i64 32
  %.915.5.3 = load double, ptr %49, align 8
  %.948.5.3 = fmul double %.1076.1, %.915.5.3
  %.949.5.3 = fsub double %.949.5.2, %.948.5.3
  store double %.949.5.3, ptr %arg.x.4, align 8
  %50 = getelementptr i8, ptr %arg.A.4, i64 40
  %.915.5.4 = load double, ptr %50, align 8
  %.948.5.4 = fmul double %.1076, %.915.5.4
  %.949.5.4 = fsub double %.949.5.3, %.948.5.4
  store double %.949.5.4, ptr %arg.x.4, align 8
  %.1070.5 = load double, ptr %arg.A.4, align 8
  %.1076.5 = fdiv double %.949.5.4, %.1070.5
  store double %.1076.5, ptr %arg.x.4, align 8
  store ptr null, ptr %retptr, align 8
  ret void
}

attributes #0 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #1 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #2 = { mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite) }

!0 = !{!1}
!1 = distinct !{!1, !2, !"part.1: %retptr"}
!2 = distinct !{!2, !"part.1"}
!3 = distinct !{!3, !4}
!4 = !{!"llvm.loop.peeled.count", i32 1}
!5 = distinct !{!5, !4}
!6 = distinct !{!6, !4}
!7 = !{!8}
!8 = distinct !{!8, !9, !"part.1: %retptr"}
!9 = distinct !{!9, !"part.1"}
!10 = distinct !{!10, !4}
!11 = !{!12}
!12 = distinct !{!12, !13, !"part.8: %retptr"}
!13 = distinct !{!13, !"part.8"}
!14 = !{!15}
!15 = distinct !{!15, !16}
!16 = distinct !{!16, !"LVerDomain"}
!17 = !{!18}
!18 = distinct !{!18, !16}
!19 = !{!20, !21, !22, !23, !24, !15, !25, !26}
!20 = distinct !{!20, !16}
!21 = distinct !{!21, !16}
!22 = distinct !{!22, !16}
!23 = distinct !{!23, !16}
!24 = distinct !{!24, !16}
!25 = distinct !{!25, !16}
!26 = distinct !{!26, !16}
!27 = !{!20}
!28 = !{!21, !22, !23, !24, !15, !25, !26}
!29 = !{!25}
!30 = !{!21}
!31 = !{!22, !23, !24, !15, !25, !26}
!32 = !{!22}
!33 = !{!23, !24, !15, !25, !26}
!34 = !{!26}
!35 = !{!23}
!36 = !{!24, !15, !25, !26}
!37 = !{!24}
!38 = !{!15, !25, !26}
!39 = distinct !{!39, !40, !41}
!40 = !{!"llvm.loop.isvectorized", i32 1}
!41 = !{!"llvm.loop.unroll.runtime.disable"}
!42 = distinct !{!42, !40}
!43 = !{!44}
!44 = distinct !{!44, !45, !"part.1: %retptr"}
!45 = distinct !{!45, !"part.1"}
!46 = distinct !{!46, !4}
!47 = !{!48}
!48 = distinct !{!48, !49, !"part.9: %retptr"}
!49 = distinct !{!49, !"part.9"}
!50 = !{!"branch_weights", i32 1, i32 99}
!51 = !{!52}
!52 = distinct !{!52, !53, !"part.1: %retptr"}
!53 = distinct !{!53, !"part.1"}
!54 = distinct !{!54, !4}
!55 = !{!56}
!56 = distinct !{!56, !57, !"part.10: %retptr"}
!57 = distinct !{!57, !"part.10"}
!58 = distinct !{!58, !4}
!59 = !{!60}
!60 = distinct !{!60, !61, !"part.11: %retptr"}
!61 = distinct !{!61, !"part.11"}
!62 = !{!63}
!63 = distinct !{!63, !64}
!64 = distinct !{!64, !"LVerDomain"}
!65 = distinct !{!65, !40, !41}
!66 = distinct !{!66, !40}
!67 = distinct !{!67, !40}
!68 = !{!"branch_weights", i32 0, i32 -2147483648}
!69 = !{!70}
!70 = distinct !{!70, !71}
!71 = distinct !{!71, !"LVerDomain"}
!72 = !{!73}
!73 = distinct !{!73, !71}
!74 = !{!75}
!75 = distinct !{!75, !71}
!76 = !{!77, !70, !73}
!77 = distinct !{!77, !71}
!78 = !{!77}
!79 = !{!70, !73}
!80 = distinct !{!80, !40, !41}
!81 = !{!82}
!82 = distinct !{!82, !83, !"part.12: %retptr"}
!83 = distinct !{!83, !"part.12"}
!84 = !{!"branch_weights", i32 99, i32 1}
