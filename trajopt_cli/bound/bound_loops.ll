; sha256 963b000cdb3fc1277a0d03d964b372624329a9be899550820c18e94debe4e962 of bound_loops.py and of this
; made by numba 0.68.1, llvmlite 0.50.0, Python 3.11.7
; loops.raise_times: array(float64, 1d, A); array(float64, 1d, A); array(float64, 1d, A); array(float64, 1d, A); array(float64, 1d, A); array(float64, 1d, A); array(float64, 1d, A); float64; float64
; loops.fill_times: array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(int64, 1d, A); array(int64, 1d, A); array(float64, 1d, A); array(float64, 1d, A); array(int64, 1d, A); array(float64, 1d, A); array(float64, 1d, A); int64; float64; int64; int64; int64; int64; int64; float64
; loops.fill_reached: array(float64, 2d, A); array(float64, 1d, A); array(float64, 1d, A)
; loops.fill_left: array(float64, 2d, A); array(float64, 1d, A); array(float64, 1d, A)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.raise_times(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.T.0, ptr readnone captures(none) %arg.T.1, i64 %arg.T.2, i64 %arg.T.3, ptr captures(none) %arg.T.4, i64 %arg.T.5.0, i64 %arg.T.6.0, ptr readnone captures(none) %arg.low.0, ptr readnone captures(none) %arg.low.1, i64 %arg.low.2, i64 %arg.low.3, ptr readonly captures(none) %arg.low.4, i64 %arg.low.5.0, i64 %arg.low.6.0, ptr readnone captures(none) %arg.high.0, ptr readnone captures(none) %arg.high.1, i64 %arg.high.2, i64 %arg.high.3, ptr readonly captures(none) %arg.high.4, i64 %arg.high.5.0, i64 %arg.high.6.0, ptr readnone captures(none) %arg.a_slow.0, ptr readnone captures(none) %arg.a_slow.1, i64 %arg.a_slow.2, i64 %arg.a_slow.3, ptr readonly captures(none) %arg.a_slow.4, i64 %arg.a_slow.5.0, i64 %arg.a_slow.6.0, ptr readnone captures(none) %arg.a_fast.0, ptr readnone captures(none) %arg.a_fast.1, i64 %arg.a_fast.2, i64 %arg.a_fast.3, ptr readonly captures(none) %arg.a_fast.4, i64 %arg.a_fast.5.0, i64 %arg.a_fast.6.0, ptr readnone captures(none) %arg.b_slow.0, ptr readnone captures(none) %arg.b_slow.1, i64 %arg.b_slow.2, i64 %arg.b_slow.3, ptr readonly captures(none) %arg.b_slow.4, i64 %arg.b_slow.5.0, i64 %arg.b_slow.6.0, ptr readnone captures(none) %arg.b_fast.0, ptr readnone captures(none) %arg.b_fast.1, i64 %arg.b_fast.2, i64 %arg.b_fast.3, ptr readonly captures(none) %arg.b_fast.4, i64 %arg.b_fast.5.0, i64 %arg.b_fast.6.0, double %arg.V, double %arg.A) local_unnamed_addr #0 {
B0.endif:
  %.56.i = alloca double, align 8
  %.84.i = alloca double, align 8
  %.199205.not = icmp slt i64 %arg.T.5.0, 1
  br i1 %.199205.not, label %B202, label %B62

B62:                                              ; preds = %B0.endif, %B62
  %lsr.iv19 = phi i64 [ %lsr.iv.next, %B62 ], [ %arg.T.5.0, %B0.endif ]
  %lsr.iv17 = phi ptr [ %scevgep18, %B62 ], [ %arg.T.4, %B0.endif ]
  %lsr.iv15 = phi ptr [ %scevgep16, %B62 ], [ %arg.low.4, %B0.endif ]
  %lsr.iv13 = phi ptr [ %scevgep14, %B62 ], [ %arg.high.4, %B0.endif ]
  %lsr.iv11 = phi ptr [ %scevgep12, %B62 ], [ %arg.a_slow.4, %B0.endif ]
  %lsr.iv9 = phi ptr [ %scevgep10, %B62 ], [ %arg.a_fast.4, %B0.endif ]
  %lsr.iv7 = phi ptr [ %scevgep8, %B62 ], [ %arg.b_slow.4, %B0.endif ]
  %lsr.iv = phi ptr [ %scevgep, %B62 ], [ %arg.b_fast.4, %B0.endif ]
  %.268 = load double, ptr %lsr.iv17, align 8
  %.299 = load double, ptr %lsr.iv15, align 8
  %.330 = load double, ptr %lsr.iv13, align 8
  %.361 = load double, ptr %lsr.iv11, align 8
  %.392 = load double, ptr %lsr.iv9, align 8
  %.423 = load double, ptr %lsr.iv7, align 8
  %.454 = load double, ptr %lsr.iv, align 8
  call void @llvm.lifetime.start.p0(ptr nonnull %.56.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.84.i)
  %.14.i = fsub double %.423, %.392
  %.18.i = fdiv double %.14.i, %arg.A
  %.19.i = fsub double %.361, %.454
  %.23.i = fdiv double %.19.i, %arg.A
  %.16.i.i = fcmp ogt double %.18.i, %.268
  %.17.i.i = select i1 %.16.i.i, double %.18.i, double %.268
  %.18.i.i = fcmp ogt double %.23.i, %.17.i.i
  %.19.i.i = select i1 %.18.i.i, double %.23.i, double %.17.i.i
  call fastcc void @part.0(ptr nonnull %.56.i, double %.19.i.i, double %.299, double %.392, double %.454, double %arg.V, double %arg.A)
  %.70.i = load double, ptr %.56.i, align 8, !noalias !0
  %.81.i = fneg double %.330
  %.82.i = fneg double %.361
  %.83.i = fneg double %.423
  call fastcc void @part.0(ptr nonnull %.84.i, double %.70.i, double %.81.i, double %.82.i, double %.83.i, double %arg.V, double %arg.A)
  %.98.i = load double, ptr %.84.i, align 8, !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.56.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.84.i)
  store double %.98.i, ptr %lsr.iv17, align 8
  %scevgep = getelementptr i8, ptr %lsr.iv, i64 %arg.b_fast.6.0
  %scevgep8 = getelementptr i8, ptr %lsr.iv7, i64 %arg.b_slow.6.0
  %scevgep10 = getelementptr i8, ptr %lsr.iv9, i64 %arg.a_fast.6.0
  %scevgep12 = getelementptr i8, ptr %lsr.iv11, i64 %arg.a_slow.6.0
  %scevgep14 = getelementptr i8, ptr %lsr.iv13, i64 %arg.high.6.0
  %scevgep16 = getelementptr i8, ptr %lsr.iv15, i64 %arg.low.6.0
  %scevgep18 = getelementptr i8, ptr %lsr.iv17, i64 %arg.T.6.0
  %lsr.iv.next = add nsw i64 %lsr.iv19, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond.not, label %B202, label %B62

B202:                                             ; preds = %B62, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.start.p0(ptr captures(none)) #1

; Function Attrs: mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: write)
define internal fastcc void @part.0(ptr noalias nonnull writeonly captures(none) initializes((0, 8)) %retptr, double %arg.T, double %arg.D, double %arg.a, double %arg.c, double %arg.V, double %arg.A) unnamed_addr #2 {
B0.endif.endif.endif:
  %.24 = fadd double %arg.a, %arg.c
  %.27 = fmul double %arg.T, %arg.A
  %.28 = fadd double %.24, %.27
  %.33 = fmul double %.28, 5.000000e-01
  %.53 = fsub double %.33, %arg.V
  %.12.i = fcmp olt double %.53, 0.000000e+00
  %.13.i = select i1 %.12.i, double 0.000000e+00, double %.53
  %.147.i = fmul double %.13.i, %.13.i
  %.35 = fmul double %.33, 2.000000e+00
  %.36 = fmul double %.33, %.35
  %.39 = fmul double %arg.a, %arg.a
  %.40 = fsub double %.36, %.39
  %.43 = fmul double %arg.c, %arg.c
  %.44 = fsub double %.40, %.43
  %.47 = fmul double %arg.A, 2.000000e+00
  %.51 = fdiv double %.44, %.47
  %.112 = fdiv double %.147.i, %arg.A
  %.113 = fsub double %.51, %.112
  %.12.i5 = fcmp olt double %arg.c, %arg.a
  %.13.i6 = select i1 %.12.i5, double %arg.c, double %arg.a
  %.12.i7 = fcmp ogt double %arg.c, %arg.a
  %.13.i8 = select i1 %.12.i7, double %arg.c, double %arg.a
  %.185 = fsub double %.13.i8, %.13.i6
  %.189 = fcmp ogt double %.185, %.27
  %.193 = fmul double %arg.T, %.13.i6
  %.198 = fmul double %arg.T, %.27
  %.203 = fmul double %.198, 5.000000e-01
  %.204 = fadd double %.193, %.203
  %most.2.0 = select i1 %.189, double %.204, double %.113
  %.209 = fadd double %arg.D, -1.000000e-09
  %.211 = fcmp ult double %most.2.0, %.209
  br i1 %.211, label %B280, label %common.ret

common.ret:                                       ; preds = %B618.endif, %B0.endif.endif.endif
  %storemerge = phi double [ %.13.i4, %B618.endif ], [ %arg.T, %B0.endif.endif.endif ]
  store double %storemerge, ptr %retptr, align 8
  ret void

B280:                                             ; preds = %B0.endif.endif.endif
  %.236 = fcmp ult double %.13.i8, 0.000000e+00
  br i1 %.236, label %B430.endif.endif.endif.endif.endif, label %B292

B292:                                             ; preds = %B280
  %.240 = fmul double %.13.i8, %.13.i8
  %.245 = fmul double %.13.i6, %.13.i6
  %.246 = fsub double %.240, %.245
  %.253 = fdiv double %.246, %.47
  %.255 = fcmp ogt double %.253, %arg.D
  br i1 %.255, label %B334.endif, label %B430.endif.endif.endif.endif.endif

B334.endif:                                       ; preds = %B292
  %.270 = fmul double %arg.D, %.47
  %.273 = fadd double %.245, %.270
  %.12.i1 = fcmp olt double %.273, 0.000000e+00
  %.13.i2 = select i1 %.12.i1, double 0.000000e+00, double %.273
  %sqrt = tail call double @llvm.sqrt.f64(double %.13.i2)
  %.304 = fsub double %sqrt, %.13.i6
  br label %B618.endif

B430.endif.endif.endif.endif.endif:               ; preds = %B292, %B280
  %.324 = fmul double %arg.D, %arg.A
  %.333 = fadd double %.39, %.43
  %.338 = fmul double %.333, 5.000000e-01
  %.339 = fadd double %.324, %.338
  %.12.i9 = fcmp olt double %.339, 0.000000e+00
  %.13.i10 = select i1 %.12.i9, double 0.000000e+00, double %.339
  %sqrt15 = tail call double @llvm.sqrt.f64(double %.13.i10)
  %.12.i11 = fcmp olt double %arg.V, %sqrt15
  %.13.i12 = select i1 %.12.i11, double %arg.V, double %sqrt15
  %.12.i13 = fcmp olt double %.13.i12, 1.000000e-300
  %.13.i14 = select i1 %.12.i13, double 1.000000e-300, double %.13.i12
  %.431 = fdiv double %.339, %.13.i14
  %.432 = fadd double %.13.i12, %.431
  %.440 = fsub double %.432, %.24
  br label %B618.endif

B618.endif:                                       ; preds = %B430.endif.endif.endif.endif.endif, %B334.endif
  %.304.pn = phi double [ %.304, %B334.endif ], [ %.440, %B430.endif.endif.endif.endif.endif ]
  %end.2.0 = fdiv double %.304.pn, %arg.A
  %.452 = fadd double %end.2.0, -1.000000e-09
  %.12.i3 = fcmp ogt double %.452, %arg.T
  %.13.i4 = select i1 %.12.i3, double %.452, double %arg.T
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.end.p0(ptr captures(none)) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sqrt.f64(double) #3

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.fill_times(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr writeonly captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.5.1, i64 %arg.out.6.0, i64 %arg.out.6.1, ptr readnone captures(none) %arg.a_low.0, ptr readnone captures(none) %arg.a_low.1, i64 %arg.a_low.2, i64 %arg.a_low.3, ptr readonly captures(none) %arg.a_low.4, i64 %arg.a_low.5.0, i64 %arg.a_low.5.1, i64 %arg.a_low.6.0, i64 %arg.a_low.6.1, ptr readnone captures(none) %arg.a_high.0, ptr readnone captures(none) %arg.a_high.1, i64 %arg.a_high.2, i64 %arg.a_high.3, ptr readonly captures(none) %arg.a_high.4, i64 %arg.a_high.5.0, i64 %arg.a_high.5.1, i64 %arg.a_high.6.0, i64 %arg.a_high.6.1, ptr readnone captures(none) %arg.a_slow.0, ptr readnone captures(none) %arg.a_slow.1, i64 %arg.a_slow.2, i64 %arg.a_slow.3, ptr readonly captures(none) %arg.a_slow.4, i64 %arg.a_slow.5.0, i64 %arg.a_slow.5.1, i64 %arg.a_slow.6.0, i64 %arg.a_slow.6.1, ptr readnone captures(none) %arg.a_fast.0, ptr readnone captures(none) %arg.a_fast.1, i64 %arg.a_fast.2, i64 %arg.a_fast.3, ptr readonly captures(none) %arg.a_fast.4, i64 %arg.a_fast.5.0, i64 %arg.a_fast.5.1, i64 %arg.a_fast.6.0, i64 %arg.a_fast.6.1, ptr readnone captures(none) %arg.b_low.0, ptr readnone captures(none) %arg.b_low.1, i64 %arg.b_low.2, i64 %arg.b_low.3, ptr readonly captures(none) %arg.b_low.4, i64 %arg.b_low.5.0, i64 %arg.b_low.5.1, i64 %arg.b_low.6.0, i64 %arg.b_low.6.1, ptr readnone captures(none) %arg.b_high.0, ptr readnone captures(none) %arg.b_high.1, i64 %arg.b_high.2, i64 %arg.b_high.3, ptr readonly captures(none) %arg.b_high.4, i64 %arg.b_high.5.0, i64 %arg.b_high.5.1, i64 %arg.b_high.6.0, i64 %arg.b_high.6.1, ptr readnone captures(none) %arg.b_slow.0, ptr readnone captures(none) %arg.b_slow.1, i64 %arg.b_slow.2, i64 %arg.b_slow.3, ptr readonly captures(none) %arg.b_slow.4, i64 %arg.b_slow.5.0, i64 %arg.b_slow.5.1, i64 %arg.b_slow.6.0, i64 %arg.b_slow.6.1, ptr readnone captures(none) %arg.b_fast.0, ptr readnone captures(none) %arg.b_fast.1, i64 %arg.b_fast.2, i64 %arg.b_fast.3, ptr readonly captures(none) %arg.b_fast.4, i64 %arg.b_fast.5.0, i64 %arg.b_fast.5.1, i64 %arg.b_fast.6.0, i64 %arg.b_fast.6.1, ptr readnone captures(none) %arg.a_signs.0, ptr readnone captures(none) %arg.a_signs.1, i64 %arg.a_signs.2, i64 %arg.a_signs.3, ptr readonly captures(none) %arg.a_signs.4, i64 %arg.a_signs.5.0, i64 %arg.a_signs.6.0, ptr readnone captures(none) %arg.b_signs.0, ptr readnone captures(none) %arg.b_signs.1, i64 %arg.b_signs.2, i64 %arg.b_signs.3, ptr readonly captures(none) %arg.b_signs.4, i64 %arg.b_signs.5.0, i64 %arg.b_signs.6.0, ptr readnone captures(none) %arg.so_far.0, ptr readnone captures(none) %arg.so_far.1, i64 %arg.so_far.2, i64 %arg.so_far.3, ptr readonly captures(none) %arg.so_far.4, i64 %arg.so_far.5.0, i64 %arg.so_far.6.0, ptr readnone captures(none) %arg.ahead.0, ptr readnone captures(none) %arg.ahead.1, i64 %arg.ahead.2, i64 %arg.ahead.3, ptr readonly captures(none) %arg.ahead.4, i64 %arg.ahead.5.0, i64 %arg.ahead.6.0, ptr readnone captures(none) %arg.order.0, ptr readnone captures(none) %arg.order.1, i64 %arg.order.2, i64 %arg.order.3, ptr readonly captures(none) %arg.order.4, i64 %arg.order.5.0, i64 %arg.order.6.0, ptr readnone captures(none) %arg.V.0, ptr readnone captures(none) %arg.V.1, i64 %arg.V.2, i64 %arg.V.3, ptr readonly captures(none) %arg.V.4, i64 %arg.V.5.0, i64 %arg.V.6.0, ptr readnone captures(none) %arg.A.0, ptr readnone captures(none) %arg.A.1, i64 %arg.A.2, i64 %arg.A.3, ptr readonly captures(none) %arg.A.4, i64 %arg.A.5.0, i64 %arg.A.6.0, i64 %arg.r, double %arg.floor, i64 %arg.fixed, i64 %arg.still, i64 %arg.straight, i64 %arg.branch, i64 %arg.least, double %arg.incumbent) local_unnamed_addr #0 {
B0.endif:
  %.56.i37 = alloca double, align 8
  %.84.i = alloca double, align 8
  %.3991081.not = icmp slt i64 %arg.so_far.5.0, 1
  br i1 %.3991081.not, label %B1218, label %B64.endif.lr.ph

B64.endif.lr.ph:                                  ; preds = %B0.endif
  %.5361004.not = icmp slt i64 %arg.ahead.5.0, 1
  %.2399 = fadd double %arg.floor, 1.000000e-09
  br i1 %.5361004.not, label %B1218, label %B64.endif.us.preheader

B64.endif.us.preheader:                           ; preds = %B64.endif.lr.ph
  %arg.least.fr = freeze i64 %arg.least
  %0 = icmp eq i64 %arg.least.fr, 0
  %1 = icmp slt i64 %arg.r, 1
  %2 = icmp eq i64 %arg.branch, 0
  %3 = icmp sgt i64 %arg.order.5.0, 0
  %4 = icmp eq i64 %arg.still, 0
  %5 = icmp eq i64 %arg.fixed, 0
  %6 = icmp eq i64 %arg.straight, 0
  br label %B64.endif.us

B64.endif.us:                                     ; preds = %B64.endif.us.preheader, %B124.B1186_crit_edge.us
  %lsr.iv57 = phi ptr [ %scevgep58, %B124.B1186_crit_edge.us ], [ %arg.a_high.4, %B64.endif.us.preheader ]
  %lsr.iv51 = phi ptr [ %scevgep52, %B124.B1186_crit_edge.us ], [ %arg.a_low.4, %B64.endif.us.preheader ]
  %incumbent.4.01087.us = phi double [ %incumbent.5.1.us, %B124.B1186_crit_edge.us ], [ %arg.incumbent, %B64.endif.us.preheader ]
  %.40510251085.us = phi i64 [ %.412.us, %B124.B1186_crit_edge.us ], [ 0, %B64.endif.us.preheader ]
  %.624.us = mul i64 %.40510251085.us, %arg.out.6.0
  %7 = getelementptr i8, ptr %arg.out.4, i64 %.624.us
  %.857.us = mul i64 %.40510251085.us, %arg.a_high.6.1
  %invariant.gep921.us = getelementptr i8, ptr %arg.a_high.4, i64 %.857.us
  %.948.us = mul i64 %.40510251085.us, %arg.a_low.6.1
  %invariant.gep923.us = getelementptr i8, ptr %arg.a_low.4, i64 %.948.us
  %.1112.us = mul i64 %.40510251085.us, %arg.so_far.6.0
  %.1187.us = mul i64 %.40510251085.us, %arg.a_signs.6.0
  %.1678.us = mul i64 %.40510251085.us, %arg.a_slow.6.1
  %invariant.gep952.us = getelementptr i8, ptr %arg.a_slow.4, i64 %.1678.us
  %.1734.us = mul i64 %.40510251085.us, %arg.a_fast.6.1
  %invariant.gep954.us = getelementptr i8, ptr %arg.a_fast.4, i64 %.1734.us
  %sunkaddr = getelementptr i8, ptr %arg.so_far.4, i64 %.1112.us
  %sunkaddr70 = getelementptr i8, ptr %arg.a_signs.4, i64 %.1187.us
  br label %B126.endif.us

B126.endif.us:                                    ; preds = %B1219.us, %B64.endif.us
  %lsr.iv61 = phi ptr [ %arg.b_low.4, %B64.endif.us ], [ %scevgep62, %B1219.us ]
  %lsr.iv = phi ptr [ %arg.b_high.4, %B64.endif.us ], [ %scevgep, %B1219.us ]
  %incumbent.3.11008.us = phi double [ %incumbent.4.01087.us, %B64.endif.us ], [ %incumbent.6.2.us, %B1219.us ]
  %.5429701006.us = phi i64 [ 0, %B64.endif.us ], [ %.549.us, %B1219.us ]
  %.549.us = add nuw nsw i64 %.5429701006.us, 1
  %.625.us = mul i64 %.5429701006.us, %arg.out.6.1
  %.628.us = getelementptr i8, ptr %7, i64 %.625.us
  store double 0x7FF0000000000000, ptr %.628.us, align 8
  br i1 %1, label %B350.us, label %B198.backedge.us

B350.us:                                          ; preds = %B198.backedge.us, %B126.endif.us
  %T.4.2.lcssa.us = phi double [ %arg.floor, %B126.endif.us ], [ %.19.i45, %B198.backedge.us ]
  %.1116.us = load double, ptr %sunkaddr, align 8
  %.1118.us = fadd double %T.4.2.lcssa.us, %.1116.us
  %.1148.us = mul i64 %.5429701006.us, %arg.ahead.6.0
  %.1150.us = getelementptr i8, ptr %arg.ahead.4, i64 %.1148.us
  %.1152.us = load double, ptr %.1150.us, align 8
  %.1153.us = fadd double %.1118.us, %.1152.us
  %.1155.us = fcmp ogt double %.1153.us, %incumbent.3.11008.us
  br i1 %.1155.us, label %B1219.us, label %B398.us

B398.us:                                          ; preds = %B350.us
  br i1 %2, label %B440.us, label %B402.us

B402.us:                                          ; preds = %B398.us
  %.1191.us = load i64, ptr %sunkaddr70, align 8
  %.1219.us = mul i64 %.5429701006.us, %arg.b_signs.6.0
  %.1221.us = getelementptr i8, ptr %arg.b_signs.4, i64 %.1219.us
  %.1223.us = load i64, ptr %.1221.us, align 8
  %.1224.not.us = icmp eq i64 %.1191.us, %.1223.us
  br i1 %.1224.not.us, label %B440.us, label %B1219.us

B440.us:                                          ; preds = %B402.us, %B398.us
  br i1 %3, label %B500.lr.ph.us, label %B1114.us

B1114.us:                                         ; preds = %B1110.us, %B440.us
  %T.5.3.lcssa.us = phi double [ %arg.floor, %B440.us ], [ %T.6.5.us, %B1110.us ]
  store double %T.5.3.lcssa.us, ptr %.628.us, align 8
  br i1 %0, label %B1219.us, label %B1132.us

B1132.us:                                         ; preds = %B1114.us
  %.2679.us = load double, ptr %.1150.us, align 8
  %.2683.us = fadd double %T.5.3.lcssa.us, %.2679.us
  %.12.i = fcmp olt double %.2683.us, %incumbent.3.11008.us
  %.13.i = select i1 %.12.i, double %.2683.us, double %incumbent.3.11008.us
  br label %B1219.us

B500.endif.us:                                    ; preds = %B500.lr.ph.us, %B1110.us
  %lsr.iv68 = phi ptr [ %scevgep69, %B1110.us ], [ %arg.order.4, %B500.lr.ph.us ]
  %lsr.iv66 = phi i64 [ %lsr.iv.next67, %B1110.us ], [ %arg.order.5.0, %B500.lr.ph.us ]
  %T.5.3941.us = phi double [ %T.6.5.us, %B1110.us ], [ %arg.floor, %B500.lr.ph.us ]
  %top_v.2.3940.us = phi double [ %top_v.3.4.us, %B1110.us ], [ 0x7FF0000000000000, %B500.lr.ph.us ]
  %top_a.2.3939.us = phi double [ %top_a.3.4.us, %B1110.us ], [ 0x7FF0000000000000, %B500.lr.ph.us ]
  %.1314.us = load i64, ptr %lsr.iv68, align 8
  %.1371.us = icmp slt i64 %.1314.us, 0
  %.1372.us = select i1 %.1371.us, i64 %arg.b_low.5.0, i64 0
  %.1373.us = add i64 %.1372.us, %.1314.us
  %.1392.us = mul i64 %.1373.us, %arg.b_low.6.0
  %gep945.us = getelementptr i8, ptr %invariant.gep944.us, i64 %.1392.us
  %.1398.us = load double, ptr %gep945.us, align 8
  %.1428.us = select i1 %.1371.us, i64 %arg.a_high.5.0, i64 0
  %.1429.us = add i64 %.1428.us, %.1314.us
  %.1448.us = mul i64 %.1429.us, %arg.a_high.6.0
  %gep947.us = getelementptr i8, ptr %invariant.gep921.us, i64 %.1448.us
  %.1454.us = load double, ptr %gep947.us, align 8
  %.1457.us = fsub double %.1398.us, %.1454.us
  %.1485.us = select i1 %.1371.us, i64 %arg.b_high.5.0, i64 0
  %.1486.us = add i64 %.1485.us, %.1314.us
  %.1505.us = mul i64 %.1486.us, %arg.b_high.6.0
  %gep949.us = getelementptr i8, ptr %invariant.gep948.us, i64 %.1505.us
  %.1511.us = load double, ptr %gep949.us, align 8
  %.1541.us = select i1 %.1371.us, i64 %arg.a_low.5.0, i64 0
  %.1542.us = add i64 %.1541.us, %.1314.us
  %.1561.us = mul i64 %.1542.us, %arg.a_low.6.0
  %gep951.us = getelementptr i8, ptr %invariant.gep923.us, i64 %.1561.us
  %.1567.us = load double, ptr %gep951.us, align 8
  %.1570.us = fsub double %.1511.us, %.1567.us
  %.1578.us = fneg double %.1570.us
  %.16.i = fcmp olt double %.1457.us, %.1578.us
  %.17.i = select i1 %.16.i, double %.1578.us, double %.1457.us
  %.18.i = fcmp olt double %.17.i, 0.000000e+00
  %.19.i = select i1 %.18.i, double 0.000000e+00, double %.17.i
  br i1 %4, label %B626.us, label %B766.us

B766.us:                                          ; preds = %B500.endif.us
  br i1 %6, label %B938.us, label %B770.endif.endif.endif.endif.endif.us

B770.endif.endif.endif.endif.endif.us:            ; preds = %B766.us
  %.12.i17 = fcmp olt double %.19.i, 0x3D719799812DEA11
  %.13.i18 = select i1 %.12.i17, double 0x3D719799812DEA11, double %.19.i
  %.2135.us = select i1 %.1371.us, i64 %arg.V.5.0, i64 0
  %.2136.us = add i64 %.2135.us, %.1314.us
  %.2147.us = mul i64 %.2136.us, %arg.V.6.0
  %.2149.us = getelementptr i8, ptr %arg.V.4, i64 %.2147.us
  %.2151.us = load double, ptr %.2149.us, align 8
  %.2155.us = fdiv double %.2151.us, %.13.i18
  %.12.i19 = fcmp olt double %.2155.us, %top_v.2.3940.us
  %.13.i20 = select i1 %.12.i19, double %.2155.us, double %top_v.2.3940.us
  %.2202.us = select i1 %.1371.us, i64 %arg.A.5.0, i64 0
  %.2203.us = add i64 %.2202.us, %.1314.us
  %.2214.us = mul i64 %.2203.us, %arg.A.6.0
  %.2216.us = getelementptr i8, ptr %arg.A.4, i64 %.2214.us
  %.2218.us = load double, ptr %.2216.us, align 8
  %.2224.us = fdiv double %.2218.us, %.13.i18
  %.12.i21 = fcmp olt double %.2224.us, %top_a.2.3939.us
  %.13.i22 = select i1 %.12.i21, double %.2224.us, double %top_a.2.3939.us
  %.18.i23 = fmul double %.13.i20, %.13.i20
  %.19.i24 = fcmp ogt double %.13.i22, %.18.i23
  br i1 %.19.i24, label %B28.endif.i, label %B50.endif.i

B28.endif.i:                                      ; preds = %B770.endif.endif.endif.endif.endif.us
  %.26.i = fdiv double 1.000000e+00, %.13.i20
  %.34.i = fdiv double %.13.i20, %.13.i22
  %.39.i = fadd double %.26.i, %.34.i
  br label %B996.us

B50.endif.i:                                      ; preds = %B770.endif.endif.endif.endif.endif.us
  %.51.i = fdiv double 1.000000e+00, %.13.i22
  %.56.i = tail call double @sqrt(double %.51.i)
  %.58.i = fmul double %.56.i, 2.000000e+00
  br label %B996.us

B938.us:                                          ; preds = %B766.us
  %.2314.us = select i1 %.1371.us, i64 %arg.V.5.0, i64 0
  %.2315.us = add i64 %.2314.us, %.1314.us
  %.2326.us = mul i64 %.2315.us, %arg.V.6.0
  %.2328.us = getelementptr i8, ptr %arg.V.4, i64 %.2326.us
  %.2330.us = load double, ptr %.2328.us, align 8
  %.2346.us = select i1 %.1371.us, i64 %arg.A.5.0, i64 0
  %.2347.us = add i64 %.2346.us, %.1314.us
  %.2358.us = mul i64 %.2347.us, %arg.A.6.0
  %.2360.us = getelementptr i8, ptr %arg.A.4, i64 %.2358.us
  %.2362.us = load double, ptr %.2360.us, align 8
  %.15.i = fmul double %.19.i, %.2362.us
  %.18.i25 = fmul double %.2330.us, %.2330.us
  %.19.i26 = fcmp ogt double %.15.i, %.18.i25
  br i1 %.19.i26, label %B28.endif.i32, label %B50.endif.i27

B28.endif.i32:                                    ; preds = %B938.us
  %.26.i33 = fdiv double %.19.i, %.2330.us
  %.34.i34 = fdiv double %.2330.us, %.2362.us
  %.39.i35 = fadd double %.26.i33, %.34.i34
  br label %B996.us

B50.endif.i27:                                    ; preds = %B938.us
  %.51.i28 = fdiv double %.19.i, %.2362.us
  %.56.i29 = tail call double @sqrt(double %.51.i28)
  %.58.i30 = fmul double %.56.i29, 2.000000e+00
  br label %B996.us

B626.us:                                          ; preds = %B500.endif.us
  %.1657.us = select i1 %.1371.us, i64 %arg.a_slow.5.0, i64 0
  %.1658.us = add i64 %.1657.us, %.1314.us
  %.1677.us = mul i64 %.1658.us, %arg.a_slow.6.0
  %gep953.us = getelementptr i8, ptr %invariant.gep952.us, i64 %.1677.us
  %.1683.us = load double, ptr %gep953.us, align 8
  %.1713.us = select i1 %.1371.us, i64 %arg.a_fast.5.0, i64 0
  %.1714.us = add i64 %.1713.us, %.1314.us
  %.1733.us = mul i64 %.1714.us, %arg.a_fast.6.0
  %gep955.us = getelementptr i8, ptr %invariant.gep954.us, i64 %.1733.us
  %.1739.us = load double, ptr %gep955.us, align 8
  %.1769.us = select i1 %.1371.us, i64 %arg.b_slow.5.0, i64 0
  %.1770.us = add i64 %.1769.us, %.1314.us
  %.1789.us = mul i64 %.1770.us, %arg.b_slow.6.0
  %gep957.us = getelementptr i8, ptr %invariant.gep956.us, i64 %.1789.us
  %.1795.us = load double, ptr %gep957.us, align 8
  %.1825.us = select i1 %.1371.us, i64 %arg.b_fast.5.0, i64 0
  %.1826.us = add i64 %.1825.us, %.1314.us
  %.1845.us = mul i64 %.1826.us, %arg.b_fast.6.0
  %gep959.us = getelementptr i8, ptr %invariant.gep958.us, i64 %.1845.us
  %.1851.us = load double, ptr %gep959.us, align 8
  %.1927.us = select i1 %.1371.us, i64 %arg.V.5.0, i64 0
  %.1928.us = add i64 %.1927.us, %.1314.us
  %.1939.us = mul i64 %.1928.us, %arg.V.6.0
  %.1941.us = getelementptr i8, ptr %arg.V.4, i64 %.1939.us
  %.1943.us = load double, ptr %.1941.us, align 8
  %.1959.us = select i1 %.1371.us, i64 %arg.A.5.0, i64 0
  %.1960.us = add i64 %.1959.us, %.1314.us
  %.1971.us = mul i64 %.1960.us, %arg.A.6.0
  %.1973.us = getelementptr i8, ptr %arg.A.4, i64 %.1971.us
  %.1975.us = load double, ptr %.1973.us, align 8
  call void @llvm.lifetime.start.p0(ptr nonnull %.56.i37)
  call void @llvm.lifetime.start.p0(ptr nonnull %.84.i)
  %.14.i = fsub double %.1795.us, %.1739.us
  %.18.i38 = fdiv double %.14.i, %.1975.us
  %.19.i39 = fsub double %.1683.us, %.1851.us
  %.23.i = fdiv double %.19.i39, %.1975.us
  %.16.i.i = fcmp ogt double %.18.i38, %T.5.3941.us
  %.17.i.i = select i1 %.16.i.i, double %.18.i38, double %T.5.3941.us
  %.18.i.i = fcmp ogt double %.23.i, %.17.i.i
  %.19.i.i = select i1 %.18.i.i, double %.23.i, double %.17.i.i
  call fastcc void @part.1(ptr nonnull %.56.i37, double %.19.i.i, double %.1457.us, double %.1739.us, double %.1851.us, double %.1943.us, double %.1975.us)
  %.70.i = load double, ptr %.56.i37, align 8, !noalias !4
  %.82.i = fneg double %.1683.us
  %.83.i = fneg double %.1795.us
  call fastcc void @part.1(ptr nonnull %.84.i, double %.70.i, double %.1578.us, double %.82.i, double %.83.i, double %.1943.us, double %.1975.us)
  %.98.i = load double, ptr %.84.i, align 8, !noalias !4
  call void @llvm.lifetime.end.p0(ptr nonnull %.56.i37)
  call void @llvm.lifetime.end.p0(ptr nonnull %.84.i)
  br label %B996.us

B996.us:                                          ; preds = %B626.us, %B50.endif.i27, %B28.endif.i32, %B50.endif.i, %B28.endif.i
  %top_a.3.4.us = phi double [ %top_a.2.3939.us, %B626.us ], [ %.13.i22, %B50.endif.i ], [ %.13.i22, %B28.endif.i ], [ %top_a.2.3939.us, %B50.endif.i27 ], [ %top_a.2.3939.us, %B28.endif.i32 ]
  %top_v.3.4.us = phi double [ %top_v.2.3940.us, %B626.us ], [ %.13.i20, %B50.endif.i ], [ %.13.i20, %B28.endif.i ], [ %top_v.2.3940.us, %B50.endif.i27 ], [ %top_v.2.3940.us, %B28.endif.i32 ]
  %time.3.4.in.us.sroa.speculated = phi double [ %.98.i, %B626.us ], [ %.58.i, %B50.endif.i ], [ %.39.i, %B28.endif.i ], [ %.58.i30, %B50.endif.i27 ], [ %.39.i35, %B28.endif.i32 ]
  br i1 %5, label %B1026.endif.us, label %B1000.us

B1000.us:                                         ; preds = %B996.us
  %.2401.us = fcmp ogt double %time.3.4.in.us.sroa.speculated, %.2399
  br i1 %.2401.us, label %B1219.us, label %B1110.us

B1026.endif.us:                                   ; preds = %B996.us
  %.12.i40 = fcmp ogt double %time.3.4.in.us.sroa.speculated, %T.5.3941.us
  %.13.i41 = select i1 %.12.i40, double %time.3.4.in.us.sroa.speculated, double %T.5.3941.us
  %.2500.us = fadd double %.1116.us, %.13.i41
  %.2533.us = fadd double %.1152.us, %.2500.us
  %.2535.us = fcmp ogt double %.2533.us, %incumbent.3.11008.us
  br i1 %.2535.us, label %B1219.us, label %B1110.us

B1110.us:                                         ; preds = %B1026.endif.us, %B1000.us
  %T.6.5.us = phi double [ %.13.i41, %B1026.endif.us ], [ %T.5.3941.us, %B1000.us ]
  %lsr.iv.next67 = add nsw i64 %lsr.iv66, -1
  %scevgep69 = getelementptr i8, ptr %lsr.iv68, i64 %arg.order.6.0
  %exitcond1353.not = icmp eq i64 %lsr.iv.next67, 0
  br i1 %exitcond1353.not, label %B1114.us, label %B500.endif.us

B1219.us:                                         ; preds = %B1000.us, %B1026.endif.us, %B1132.us, %B1114.us, %B402.us, %B350.us
  %incumbent.6.2.us = phi double [ %incumbent.3.11008.us, %B350.us ], [ %incumbent.3.11008.us, %B402.us ], [ %incumbent.3.11008.us, %B1114.us ], [ %.13.i, %B1132.us ], [ %incumbent.3.11008.us, %B1026.endif.us ], [ %incumbent.3.11008.us, %B1000.us ]
  %scevgep = getelementptr i8, ptr %lsr.iv, i64 %arg.b_high.6.1
  %scevgep62 = getelementptr i8, ptr %lsr.iv61, i64 %arg.b_low.6.1
  %exitcond1354.not = icmp eq i64 %arg.ahead.5.0, %.549.us
  br i1 %exitcond1354.not, label %B124.B1186_crit_edge.us, label %B126.endif.us

B198.backedge.us:                                 ; preds = %B126.endif.us, %B198.backedge.us
  %lsr.iv65 = phi i64 [ %lsr.iv.next, %B198.backedge.us ], [ %arg.r, %B126.endif.us ]
  %lsr.iv63 = phi ptr [ %scevgep64, %B198.backedge.us ], [ %lsr.iv61, %B126.endif.us ]
  %lsr.iv59 = phi ptr [ %scevgep60, %B198.backedge.us ], [ %lsr.iv57, %B126.endif.us ]
  %lsr.iv55 = phi ptr [ %scevgep56, %B198.backedge.us ], [ %arg.V.4, %B126.endif.us ]
  %lsr.iv53 = phi ptr [ %scevgep54, %B198.backedge.us ], [ %lsr.iv51, %B126.endif.us ]
  %lsr.iv49 = phi ptr [ %scevgep50, %B198.backedge.us ], [ %lsr.iv, %B126.endif.us ]
  %T.4.2918.us = phi double [ %.19.i45, %B198.backedge.us ], [ %arg.floor, %B126.endif.us ]
  %.807.us = load double, ptr %lsr.iv63, align 8
  %.862.us = load double, ptr %lsr.iv59, align 8
  %.865.us = fsub double %.807.us, %.862.us
  %.896.us = load double, ptr %lsr.iv55, align 8
  %.900.us = fdiv double %.865.us, %.896.us
  %.953.us = load double, ptr %lsr.iv53, align 8
  %.1008.us = load double, ptr %lsr.iv49, align 8
  %.1011.us = fsub double %.953.us, %.1008.us
  %.1046.us = fdiv double %.1011.us, %.896.us
  %.16.i42 = fcmp ogt double %.900.us, %T.4.2918.us
  %.17.i43 = select i1 %.16.i42, double %.900.us, double %T.4.2918.us
  %.18.i44 = fcmp ogt double %.1046.us, %.17.i43
  %.19.i45 = select i1 %.18.i44, double %.1046.us, double %.17.i43
  %scevgep50 = getelementptr i8, ptr %lsr.iv49, i64 %arg.b_high.6.0
  %scevgep54 = getelementptr i8, ptr %lsr.iv53, i64 %arg.a_low.6.0
  %scevgep56 = getelementptr i8, ptr %lsr.iv55, i64 %arg.V.6.0
  %scevgep60 = getelementptr i8, ptr %lsr.iv59, i64 %arg.a_high.6.0
  %scevgep64 = getelementptr i8, ptr %lsr.iv63, i64 %arg.b_low.6.0
  %lsr.iv.next = add i64 %lsr.iv65, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond.not, label %B350.us, label %B198.backedge.us

B500.lr.ph.us:                                    ; preds = %B440.us
  %.1393.us = mul i64 %.5429701006.us, %arg.b_low.6.1
  %invariant.gep944.us = getelementptr i8, ptr %arg.b_low.4, i64 %.1393.us
  %.1506.us = mul i64 %.5429701006.us, %arg.b_high.6.1
  %invariant.gep948.us = getelementptr i8, ptr %arg.b_high.4, i64 %.1506.us
  %.1790.us = mul i64 %.5429701006.us, %arg.b_slow.6.1
  %invariant.gep956.us = getelementptr i8, ptr %arg.b_slow.4, i64 %.1790.us
  %.1846.us = mul i64 %.5429701006.us, %arg.b_fast.6.1
  %invariant.gep958.us = getelementptr i8, ptr %arg.b_fast.4, i64 %.1846.us
  br label %B500.endif.us

B124.B1186_crit_edge.us:                          ; preds = %B1219.us
  %.412.us = add nuw nsw i64 %.40510251085.us, 1
  %incumbent.5.1.us = select i1 %0, double %incumbent.6.2.us, double 0x7FF0000000000000
  %scevgep52 = getelementptr i8, ptr %lsr.iv51, i64 %arg.a_low.6.1
  %scevgep58 = getelementptr i8, ptr %lsr.iv57, i64 %arg.a_high.6.1
  %exitcond1355.not = icmp eq i64 %arg.so_far.5.0, %.412.us
  br i1 %exitcond1355.not, label %B1218, label %B64.endif.us

B1218:                                            ; preds = %B124.B1186_crit_edge.us, %B64.endif.lr.ph, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #4

; Function Attrs: mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: write)
define internal fastcc void @part.1(ptr noalias nonnull writeonly captures(none) initializes((0, 8)) %retptr, double %arg.T, double %arg.D, double %arg.a, double %arg.c, double %arg.V, double %arg.A) unnamed_addr #2 {
B0.endif.endif.endif:
  %.24 = fadd double %arg.a, %arg.c
  %.27 = fmul double %arg.T, %arg.A
  %.28 = fadd double %.24, %.27
  %.33 = fmul double %.28, 5.000000e-01
  %.53 = fsub double %.33, %arg.V
  %.12.i = fcmp olt double %.53, 0.000000e+00
  %.13.i = select i1 %.12.i, double 0.000000e+00, double %.53
  %.147.i = fmul double %.13.i, %.13.i
  %.35 = fmul double %.33, 2.000000e+00
  %.36 = fmul double %.33, %.35
  %.39 = fmul double %arg.a, %arg.a
  %.40 = fsub double %.36, %.39
  %.43 = fmul double %arg.c, %arg.c
  %.44 = fsub double %.40, %.43
  %.47 = fmul double %arg.A, 2.000000e+00
  %.51 = fdiv double %.44, %.47
  %.112 = fdiv double %.147.i, %arg.A
  %.113 = fsub double %.51, %.112
  %.12.i5 = fcmp olt double %arg.c, %arg.a
  %.13.i6 = select i1 %.12.i5, double %arg.c, double %arg.a
  %.12.i7 = fcmp ogt double %arg.c, %arg.a
  %.13.i8 = select i1 %.12.i7, double %arg.c, double %arg.a
  %.185 = fsub double %.13.i8, %.13.i6
  %.189 = fcmp ogt double %.185, %.27
  %.193 = fmul double %arg.T, %.13.i6
  %.198 = fmul double %arg.T, %.27
  %.203 = fmul double %.198, 5.000000e-01
  %.204 = fadd double %.193, %.203
  %most.2.0 = select i1 %.189, double %.204, double %.113
  %.209 = fadd double %arg.D, -1.000000e-09
  %.211 = fcmp ult double %most.2.0, %.209
  br i1 %.211, label %B280, label %common.ret

common.ret:                                       ; preds = %B618.endif, %B0.endif.endif.endif
  %storemerge = phi double [ %.13.i4, %B618.endif ], [ %arg.T, %B0.endif.endif.endif ]
  store double %storemerge, ptr %retptr, align 8
  ret void

B280:                                             ; preds = %B0.endif.endif.endif
  %.236 = fcmp ult double %.13.i8, 0.000000e+00
  br i1 %.236, label %B430.endif.endif.endif.endif.endif, label %B292

B292:                                             ; preds = %B280
  %.240 = fmul double %.13.i8, %.13.i8
  %.245 = fmul double %.13.i6, %.13.i6
  %.246 = fsub double %.240, %.245
  %.253 = fdiv double %.246, %.47
  %.255 = fcmp ogt double %.253, %arg.D
  br i1 %.255, label %B334.endif, label %B430.endif.endif.endif.endif.endif

B334.endif:                                       ; preds = %B292
  %.270 = fmul double %arg.D, %.47
  %.273 = fadd double %.245, %.270
  %.12.i1 = fcmp olt double %.273, 0.000000e+00
  %.13.i2 = select i1 %.12.i1, double 0.000000e+00, double %.273
  %sqrt = tail call double @llvm.sqrt.f64(double %.13.i2)
  %.304 = fsub double %sqrt, %.13.i6
  br label %B618.endif

B430.endif.endif.endif.endif.endif:               ; preds = %B292, %B280
  %.324 = fmul double %arg.D, %arg.A
  %.333 = fadd double %.39, %.43
  %.338 = fmul double %.333, 5.000000e-01
  %.339 = fadd double %.324, %.338
  %.12.i9 = fcmp olt double %.339, 0.000000e+00
  %.13.i10 = select i1 %.12.i9, double 0.000000e+00, double %.339
  %sqrt15 = tail call double @llvm.sqrt.f64(double %.13.i10)
  %.12.i11 = fcmp olt double %arg.V, %sqrt15
  %.13.i12 = select i1 %.12.i11, double %arg.V, double %sqrt15
  %.12.i13 = fcmp olt double %.13.i12, 1.000000e-300
  %.13.i14 = select i1 %.12.i13, double 1.000000e-300, double %.13.i12
  %.431 = fdiv double %.339, %.13.i14
  %.432 = fadd double %.13.i12, %.431
  %.440 = fsub double %.432, %.24
  br label %B618.endif

B618.endif:                                       ; preds = %B430.endif.endif.endif.endif.endif, %B334.endif
  %.304.pn = phi double [ %.304, %B334.endif ], [ %.440, %B430.endif.endif.endif.endif.endif ]
  %end.2.0 = fdiv double %.304.pn, %arg.A
  %.452 = fadd double %end.2.0, -1.000000e-09
  %.12.i3 = fcmp ogt double %.452, %arg.T
  %.13.i4 = select i1 %.12.i3, double %.452, double %arg.T
  br label %common.ret
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.fill_reached(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.T.0, ptr readnone captures(none) %arg.T.1, i64 %arg.T.2, i64 %arg.T.3, ptr readonly captures(none) %arg.T.4, i64 %arg.T.5.0, i64 %arg.T.5.1, i64 %arg.T.6.0, i64 %arg.T.6.1, ptr readnone captures(none) %arg.so_far.0, ptr readnone captures(none) %arg.so_far.1, i64 %arg.so_far.2, i64 %arg.so_far.3, ptr readonly captures(none) %arg.so_far.4, i64 %arg.so_far.5.0, i64 %arg.so_far.6.0, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.6.0) local_unnamed_addr #0 {
B0.else.endif:
  %.240 = icmp slt i64 %arg.out.5.0, 1
  br i1 %.240, label %common.ret, label %.306.endif.preheader, !prof !8

.306.endif.preheader:                             ; preds = %B0.else.endif
  %xtraiter = and i64 %arg.out.5.0, 3
  %0 = icmp samesign ult i64 %arg.out.5.0, 4
  br i1 %0, label %.306.endif.epil.preheader, label %.306.endif.preheader.new, !prof !9

.306.endif.preheader.new:                         ; preds = %.306.endif.preheader
  %unroll_iter = and i64 %arg.out.5.0, 9223372036854775804
  %1 = mul i64 %arg.out.6.0, 3
  %2 = shl i64 %arg.out.6.0, 2
  %sunkaddr = shl i64 %arg.out.6.0, 1
  br label %.306.endif

common.ret:                                       ; preds = %B154.B94.loopexit_crit_edge.us, %.307.endif, %B0.else.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

.306.endif:                                       ; preds = %.306.endif, %.306.endif.preheader.new
  %lsr.iv19 = phi ptr [ %scevgep20, %.306.endif ], [ %arg.out.4, %.306.endif.preheader.new ]
  %.302.0245 = phi i64 [ %.348.3, %.306.endif ], [ 0, %.306.endif.preheader.new ]
  store double 0x7FF0000000000000, ptr %lsr.iv19, align 8
  %scevgep23 = getelementptr i8, ptr %lsr.iv19, i64 %arg.out.6.0
  store double 0x7FF0000000000000, ptr %scevgep23, align 8
  %sunkaddr24 = getelementptr i8, ptr %lsr.iv19, i64 %sunkaddr
  store double 0x7FF0000000000000, ptr %sunkaddr24, align 8
  %scevgep21 = getelementptr i8, ptr %lsr.iv19, i64 %1
  store double 0x7FF0000000000000, ptr %scevgep21, align 8
  %.348.3 = add nuw nsw i64 %.302.0245, 4
  %scevgep20 = getelementptr i8, ptr %lsr.iv19, i64 %2
  %niter.ncmp.3 = icmp eq i64 %unroll_iter, %.348.3
  br i1 %niter.ncmp.3, label %.307.endif.unr-lcssa, label %.306.endif, !prof !10, !llvm.loop !11

.307.endif.unr-lcssa:                             ; preds = %.306.endif
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %.307.endif, label %.306.endif.epil.preheader, !prof !13

.306.endif.epil.preheader:                        ; preds = %.307.endif.unr-lcssa, %.306.endif.preheader
  %.302.0245.epil.init = phi i64 [ 0, %.306.endif.preheader ], [ %unroll_iter, %.307.endif.unr-lcssa ]
  %3 = mul i64 %.302.0245.epil.init, %arg.out.6.0
  %scevgep15 = getelementptr i8, ptr %arg.out.4, i64 %3
  br label %.306.endif.epil

.306.endif.epil:                                  ; preds = %.306.endif.epil, %.306.endif.epil.preheader
  %lsr.iv18 = phi i64 [ %lsr.iv.next, %.306.endif.epil ], [ %xtraiter, %.306.endif.epil.preheader ]
  %lsr.iv16 = phi ptr [ %scevgep17, %.306.endif.epil ], [ %scevgep15, %.306.endif.epil.preheader ]
  store double 0x7FF0000000000000, ptr %lsr.iv16, align 8
  %scevgep17 = getelementptr i8, ptr %lsr.iv16, i64 %arg.out.6.0
  %lsr.iv.next = add nsw i64 %lsr.iv18, -1
  %epil.iter.cmp.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %epil.iter.cmp.not, label %.307.endif, label %.306.endif.epil, !prof !14, !llvm.loop !15

.307.endif:                                       ; preds = %.306.endif.epil, %.307.endif.unr-lcssa
  %.445258.not = icmp slt i64 %arg.so_far.5.0, 1
  br i1 %.445258.not, label %common.ret, label %B96.endif.us.preheader

B96.endif.us.preheader:                           ; preds = %.307.endif
  %unroll_iter7 = and i64 %arg.out.5.0, 9223372036854775806
  %4 = shl i64 %arg.out.6.0, 1
  %5 = shl i64 %arg.T.6.1, 1
  %6 = icmp eq i64 %arg.out.5.0, 1
  %7 = and i64 %arg.out.5.0, 1
  %8 = icmp eq i64 %7, 0
  %.639.us.epil = mul i64 %unroll_iter7, %arg.out.6.0
  %.641.us.epil = getelementptr i8, ptr %arg.out.4, i64 %.639.us.epil
  %.723.us.epil = mul i64 %unroll_iter7, %arg.T.6.1
  %invariant.gep = getelementptr i8, ptr %arg.T.4, i64 %.723.us.epil
  br label %B96.endif.us

B96.endif.us:                                     ; preds = %B154.B94.loopexit_crit_edge.us, %B96.endif.us.preheader
  %lsr.iv10 = phi ptr [ %arg.T.4, %B96.endif.us.preheader ], [ %scevgep11, %B154.B94.loopexit_crit_edge.us ]
  %.451253259.us = phi i64 [ 0, %B96.endif.us.preheader ], [ %.458.us, %B154.B94.loopexit_crit_edge.us ]
  %.671.us = mul i64 %.451253259.us, %arg.so_far.6.0
  %.722.us = mul i64 %.451253259.us, %arg.T.6.0
  br i1 %6, label %B156.endif.us.epil.preheader, label %B156.endif.us.preheader

B156.endif.us.preheader:                          ; preds = %B96.endif.us
  %sunkaddr25 = getelementptr i8, ptr %arg.so_far.4, i64 %.671.us
  br label %B156.endif.us

B156.endif.us:                                    ; preds = %B156.endif.us.preheader, %B156.endif.us
  %lsr.iv12 = phi ptr [ %scevgep13, %B156.endif.us ], [ %lsr.iv10, %B156.endif.us.preheader ]
  %lsr.iv = phi ptr [ %scevgep, %B156.endif.us ], [ %arg.out.4, %B156.endif.us.preheader ]
  %.581247249.us = phi i64 [ %.588.us.1, %B156.endif.us ], [ 0, %B156.endif.us.preheader ]
  %.643.us = load double, ptr %lsr.iv, align 8
  %.675.us = load double, ptr %sunkaddr25, align 8
  %.728.us = load double, ptr %lsr.iv12, align 8
  %.731.us = fadd double %.675.us, %.728.us
  %.12.i = fcmp olt double %.731.us, %.643.us
  %.13.i = select i1 %.12.i, double %.731.us, double %.643.us
  store double %.13.i, ptr %lsr.iv, align 8
  %scevgep9 = getelementptr i8, ptr %lsr.iv, i64 %arg.out.6.0
  %.643.us.1 = load double, ptr %scevgep9, align 8
  %.675.us.1 = load double, ptr %sunkaddr25, align 8
  %scevgep14 = getelementptr i8, ptr %lsr.iv12, i64 %arg.T.6.1
  %.728.us.1 = load double, ptr %scevgep14, align 8
  %.731.us.1 = fadd double %.675.us.1, %.728.us.1
  %.12.i.1 = fcmp olt double %.731.us.1, %.643.us.1
  %.13.i.1 = select i1 %.12.i.1, double %.731.us.1, double %.643.us.1
  %.588.us.1 = add nuw i64 %.581247249.us, 2
  store double %.13.i.1, ptr %scevgep9, align 8
  %scevgep = getelementptr i8, ptr %lsr.iv, i64 %4
  %scevgep13 = getelementptr i8, ptr %lsr.iv12, i64 %5
  %niter8.ncmp.1 = icmp eq i64 %unroll_iter7, %.588.us.1
  br i1 %niter8.ncmp.1, label %B154.B94.loopexit_crit_edge.us.unr-lcssa, label %B156.endif.us

B154.B94.loopexit_crit_edge.us.unr-lcssa:         ; preds = %B156.endif.us
  br i1 %8, label %B154.B94.loopexit_crit_edge.us, label %B156.endif.us.epil.preheader

B156.endif.us.epil.preheader:                     ; preds = %B154.B94.loopexit_crit_edge.us.unr-lcssa, %B96.endif.us
  %.643.us.epil = load double, ptr %.641.us.epil, align 8
  %sunkaddr26 = getelementptr i8, ptr %arg.so_far.4, i64 %.671.us
  %.675.us.epil = load double, ptr %sunkaddr26, align 8
  %gep = getelementptr i8, ptr %invariant.gep, i64 %.722.us
  %.728.us.epil = load double, ptr %gep, align 8
  %.731.us.epil = fadd double %.675.us.epil, %.728.us.epil
  %.12.i.epil = fcmp olt double %.731.us.epil, %.643.us.epil
  %.13.i.epil = select i1 %.12.i.epil, double %.731.us.epil, double %.643.us.epil
  store double %.13.i.epil, ptr %.641.us.epil, align 8
  br label %B154.B94.loopexit_crit_edge.us

B154.B94.loopexit_crit_edge.us:                   ; preds = %B156.endif.us.epil.preheader, %B154.B94.loopexit_crit_edge.us.unr-lcssa
  %.458.us = add nuw nsw i64 %.451253259.us, 1
  %scevgep11 = getelementptr i8, ptr %lsr.iv10, i64 %arg.T.6.0
  %exitcond279.not = icmp eq i64 %.458.us, %arg.so_far.5.0
  br i1 %exitcond279.not, label %common.ret, label %B96.endif.us
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.fill_left(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.T.0, ptr readnone captures(none) %arg.T.1, i64 %arg.T.2, i64 %arg.T.3, ptr readonly captures(none) %arg.T.4, i64 %arg.T.5.0, i64 %arg.T.5.1, i64 %arg.T.6.0, i64 %arg.T.6.1, ptr readnone captures(none) %arg.ahead.0, ptr readnone captures(none) %arg.ahead.1, i64 %arg.ahead.2, i64 %arg.ahead.3, ptr readonly captures(none) %arg.ahead.4, i64 %arg.ahead.5.0, i64 %arg.ahead.6.0, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.6.0) local_unnamed_addr #0 {
B0.else.endif:
  %.240 = icmp slt i64 %arg.out.5.0, 1
  br i1 %.240, label %common.ret, label %.306.endif.preheader, !prof !8

.306.endif.preheader:                             ; preds = %B0.else.endif
  %xtraiter = and i64 %arg.out.5.0, 3
  %0 = icmp samesign ult i64 %arg.out.5.0, 4
  br i1 %0, label %.306.endif.epil.preheader, label %.306.endif.preheader.new, !prof !9

.306.endif.preheader.new:                         ; preds = %.306.endif.preheader
  %unroll_iter = and i64 %arg.out.5.0, 9223372036854775804
  %1 = mul i64 %arg.out.6.0, 3
  %2 = shl i64 %arg.out.6.0, 2
  %sunkaddr = shl i64 %arg.out.6.0, 1
  br label %.306.endif

common.ret:                                       ; preds = %B154.B94.loopexit_crit_edge.us, %B96.endif.lr.ph, %B0.else.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

.306.endif:                                       ; preds = %.306.endif, %.306.endif.preheader.new
  %lsr.iv19 = phi ptr [ %scevgep20, %.306.endif ], [ %arg.out.4, %.306.endif.preheader.new ]
  %.302.0246 = phi i64 [ %.348.3, %.306.endif ], [ 0, %.306.endif.preheader.new ]
  store double 0x7FF0000000000000, ptr %lsr.iv19, align 8
  %scevgep23 = getelementptr i8, ptr %lsr.iv19, i64 %arg.out.6.0
  store double 0x7FF0000000000000, ptr %scevgep23, align 8
  %sunkaddr24 = getelementptr i8, ptr %lsr.iv19, i64 %sunkaddr
  store double 0x7FF0000000000000, ptr %sunkaddr24, align 8
  %scevgep21 = getelementptr i8, ptr %lsr.iv19, i64 %1
  store double 0x7FF0000000000000, ptr %scevgep21, align 8
  %.348.3 = add nuw nsw i64 %.302.0246, 4
  %scevgep20 = getelementptr i8, ptr %lsr.iv19, i64 %2
  %niter.ncmp.3 = icmp eq i64 %unroll_iter, %.348.3
  br i1 %niter.ncmp.3, label %B96.endif.lr.ph.unr-lcssa, label %.306.endif, !prof !10, !llvm.loop !18

B96.endif.lr.ph.unr-lcssa:                        ; preds = %.306.endif
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B96.endif.lr.ph, label %.306.endif.epil.preheader, !prof !13

.306.endif.epil.preheader:                        ; preds = %B96.endif.lr.ph.unr-lcssa, %.306.endif.preheader
  %.302.0246.epil.init = phi i64 [ 0, %.306.endif.preheader ], [ %unroll_iter, %B96.endif.lr.ph.unr-lcssa ]
  %3 = mul i64 %.302.0246.epil.init, %arg.out.6.0
  %scevgep15 = getelementptr i8, ptr %arg.out.4, i64 %3
  br label %.306.endif.epil

.306.endif.epil:                                  ; preds = %.306.endif.epil, %.306.endif.epil.preheader
  %lsr.iv18 = phi i64 [ %lsr.iv.next, %.306.endif.epil ], [ %xtraiter, %.306.endif.epil.preheader ]
  %lsr.iv16 = phi ptr [ %scevgep17, %.306.endif.epil ], [ %scevgep15, %.306.endif.epil.preheader ]
  store double 0x7FF0000000000000, ptr %lsr.iv16, align 8
  %scevgep17 = getelementptr i8, ptr %lsr.iv16, i64 %arg.out.6.0
  %lsr.iv.next = add nsw i64 %lsr.iv18, -1
  %epil.iter.cmp.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %epil.iter.cmp.not, label %B96.endif.lr.ph, label %.306.endif.epil, !prof !14, !llvm.loop !19

B96.endif.lr.ph:                                  ; preds = %.306.endif.epil, %B96.endif.lr.ph.unr-lcssa
  %.575249.not = icmp slt i64 %arg.ahead.5.0, 1
  br i1 %.575249.not, label %common.ret, label %B96.endif.us.preheader

B96.endif.us.preheader:                           ; preds = %B96.endif.lr.ph
  %unroll_iter7 = and i64 %arg.ahead.5.0, 9223372036854775806
  %4 = shl i64 %arg.T.6.1, 1
  %5 = shl i64 %arg.ahead.6.0, 1
  %6 = icmp eq i64 %arg.ahead.5.0, 1
  %7 = and i64 %arg.ahead.5.0, 1
  %8 = icmp eq i64 %7, 0
  %.692.us.epil = mul i64 %unroll_iter7, %arg.T.6.1
  %invariant.gep = getelementptr i8, ptr %arg.T.4, i64 %.692.us.epil
  %.726.us.epil = mul i64 %unroll_iter7, %arg.ahead.6.0
  %.728.us.epil = getelementptr i8, ptr %arg.ahead.4, i64 %.726.us.epil
  br label %B96.endif.us

B96.endif.us:                                     ; preds = %B154.B94.loopexit_crit_edge.us, %B96.endif.us.preheader
  %lsr.iv = phi ptr [ %arg.T.4, %B96.endif.us.preheader ], [ %scevgep, %B154.B94.loopexit_crit_edge.us ]
  %.451254260.us = phi i64 [ 0, %B96.endif.us.preheader ], [ %.458.us, %B154.B94.loopexit_crit_edge.us ]
  %.640.us = mul i64 %.451254260.us, %arg.out.6.0
  %.642.us = getelementptr i8, ptr %arg.out.4, i64 %.640.us
  %.691.us = mul i64 %.451254260.us, %arg.T.6.0
  %.644.us.pre = load double, ptr %.642.us, align 8
  br i1 %6, label %B156.endif.us.epil.preheader, label %B156.endif.us

B156.endif.us:                                    ; preds = %B96.endif.us, %B156.endif.us
  %lsr.iv12 = phi ptr [ %scevgep13, %B156.endif.us ], [ %arg.ahead.4, %B96.endif.us ]
  %lsr.iv9 = phi ptr [ %scevgep10, %B156.endif.us ], [ %lsr.iv, %B96.endif.us ]
  %.644.us = phi double [ %.13.i.1, %B156.endif.us ], [ %.644.us.pre, %B96.endif.us ]
  %.581248250.us = phi i64 [ %.588.us.1, %B156.endif.us ], [ 0, %B96.endif.us ]
  %.697.us = load double, ptr %lsr.iv9, align 8
  %.730.us = load double, ptr %lsr.iv12, align 8
  %.731.us = fadd double %.697.us, %.730.us
  %.12.i = fcmp olt double %.731.us, %.644.us
  %.13.i = select i1 %.12.i, double %.731.us, double %.644.us
  store double %.13.i, ptr %.642.us, align 8
  %scevgep11 = getelementptr i8, ptr %lsr.iv9, i64 %arg.T.6.1
  %.697.us.1 = load double, ptr %scevgep11, align 8
  %scevgep14 = getelementptr i8, ptr %lsr.iv12, i64 %arg.ahead.6.0
  %.730.us.1 = load double, ptr %scevgep14, align 8
  %.731.us.1 = fadd double %.697.us.1, %.730.us.1
  %.12.i.1 = fcmp olt double %.731.us.1, %.13.i
  %.13.i.1 = select i1 %.12.i.1, double %.731.us.1, double %.13.i
  %.588.us.1 = add nuw i64 %.581248250.us, 2
  store double %.13.i.1, ptr %.642.us, align 8
  %scevgep10 = getelementptr i8, ptr %lsr.iv9, i64 %4
  %scevgep13 = getelementptr i8, ptr %lsr.iv12, i64 %5
  %niter8.ncmp.1 = icmp eq i64 %unroll_iter7, %.588.us.1
  br i1 %niter8.ncmp.1, label %B154.B94.loopexit_crit_edge.us.unr-lcssa, label %B156.endif.us

B154.B94.loopexit_crit_edge.us.unr-lcssa:         ; preds = %B156.endif.us
  br i1 %8, label %B154.B94.loopexit_crit_edge.us, label %B156.endif.us.epil.preheader

B156.endif.us.epil.preheader:                     ; preds = %B154.B94.loopexit_crit_edge.us.unr-lcssa, %B96.endif.us
  %.644.us.epil.init = phi double [ %.644.us.pre, %B96.endif.us ], [ %.13.i.1, %B154.B94.loopexit_crit_edge.us.unr-lcssa ]
  %gep = getelementptr i8, ptr %invariant.gep, i64 %.691.us
  %.697.us.epil = load double, ptr %gep, align 8
  %.730.us.epil = load double, ptr %.728.us.epil, align 8
  %.731.us.epil = fadd double %.697.us.epil, %.730.us.epil
  %.12.i.epil = fcmp olt double %.731.us.epil, %.644.us.epil.init
  %.13.i.epil = select i1 %.12.i.epil, double %.731.us.epil, double %.644.us.epil.init
  store double %.13.i.epil, ptr %.642.us, align 8
  br label %B154.B94.loopexit_crit_edge.us

B154.B94.loopexit_crit_edge.us:                   ; preds = %B156.endif.us.epil.preheader, %B154.B94.loopexit_crit_edge.us.unr-lcssa
  %.458.us = add nuw nsw i64 %.451254260.us, 1
  %scevgep = getelementptr i8, ptr %lsr.iv, i64 %arg.T.6.0
  %exitcond280.not = icmp eq i64 %.458.us, %arg.out.5.0
  br i1 %exitcond280.not, label %common.ret, label %B96.endif.us
}

attributes #0 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: write) }
attributes #3 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #4 = { mustprogress nofree nosync nounwind willreturn memory(none) }

!0 = !{!1, !3}
!1 = distinct !{!1, !2, !"part.2: %retptr"}
!2 = distinct !{!2, !"part.2"}
!3 = distinct !{!3, !2, !"part.2: %excinfo"}
!4 = !{!5, !7}
!5 = distinct !{!5, !6, !"part.2: %retptr"}
!6 = distinct !{!6, !"part.2"}
!7 = distinct !{!7, !6, !"part.2: %excinfo"}
!8 = !{!"branch_weights", i32 1, i32 99}
!9 = !{!"branch_weights", i32 63921928, i32 2083561720}
!10 = !{!"branch_weights", i32 84803583, i32 2062680065}
!11 = distinct !{!11, !12}
!12 = !{!"llvm.loop.estimated_trip_count", i32 25}
!13 = !{!"branch_weights", i32 545009512, i32 1602474136}
!14 = !{!"branch_weights", i32 1077359047, i32 1070124601}
!15 = distinct !{!15, !16, !17}
!16 = !{!"llvm.loop.estimated_trip_count", i32 0}
!17 = !{!"llvm.loop.unroll.disable"}
!18 = distinct !{!18, !12}
!19 = distinct !{!19, !16, !17}
