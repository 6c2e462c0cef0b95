; sha256 34d76a22da4724c19b71881dcf904e08da750601454a86b98c80828f3b9b741d of law_loops.py and of this
; made by numba 0.68.1, llvmlite 0.50.0, Python 3.11.7
; loops.touched: float64; array(float64, 2d, A); float64; array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 1d, A)
; loops.at_rest: array(float64, 2d, A); float64; array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A)
; loops.replay: float64; int64; int64; array(float64, 2d, A); array(float64, 2d, A); array(int64, 1d, A); array(float64, 3d, A); array(float64, 3d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); float64; array(float64, 1d, A); array(float64, 1d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 1d, A); array(float64, 2d, A)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.touched(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, double %arg.h, ptr readnone captures(none) %arg.shapes.0, ptr readnone captures(none) %arg.shapes.1, i64 %arg.shapes.2, i64 %arg.shapes.3, ptr readonly captures(none) %arg.shapes.4, i64 %arg.shapes.5.0, i64 %arg.shapes.5.1, i64 %arg.shapes.6.0, i64 %arg.shapes.6.1, double %arg.tip, ptr readnone captures(none) %arg.p.0, ptr readnone captures(none) %arg.p.1, i64 %arg.p.2, i64 %arg.p.3, ptr readonly captures(none) %arg.p.4, i64 %arg.p.5.0, i64 %arg.p.5.1, i64 %arg.p.6.0, i64 %arg.p.6.1, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr readonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.5.1, i64 %arg.q.6.0, i64 %arg.q.6.1, ptr readnone captures(none) %arg.force.0, ptr readnone captures(none) %arg.force.1, i64 %arg.force.2, i64 %arg.force.3, ptr captures(none) %arg.force.4, i64 %arg.force.5.0, i64 %arg.force.5.1, i64 %arg.force.6.0, i64 %arg.force.6.1, ptr readnone captures(none) %arg.depth.0, ptr readnone captures(none) %arg.depth.1, i64 %arg.depth.2, i64 %arg.depth.3, ptr writeonly captures(none) %arg.depth.4, i64 %arg.depth.5.0, i64 %arg.depth.6.0) local_unnamed_addr #0 {
B0.endif:
  %.1280 = alloca double, align 8
  %invariant.gep = getelementptr i8, ptr %arg.p.4, i64 %arg.p.6.1
  %invariant.gep525 = getelementptr i8, ptr %arg.q.4, i64 %arg.q.6.1
  %.198535.not = icmp slt i64 %arg.p.5.0, 1
  br i1 %.198535.not, label %B524, label %B150.i.peel

B150.i.peel:                                      ; preds = %B0.endif
  %.541 = shl i64 %arg.p.6.1, 1
  %invariant.gep539 = getelementptr i8, ptr %arg.p.4, i64 %.541
  %.770 = shl i64 %arg.q.6.1, 1
  %invariant.gep543 = getelementptr i8, ptr %arg.q.4, i64 %.770
  %.824 = mul i64 %arg.q.6.1, 3
  %invariant.gep545 = getelementptr i8, ptr %arg.q.4, i64 %.824
  %.318.peel = load double, ptr %arg.p.4, align 8
  %.432.peel = load double, ptr %invariant.gep, align 8
  %.546.peel = load double, ptr %invariant.gep539, align 8
  %.667.peel = load double, ptr %arg.q.4, align 8
  %.721.peel = load double, ptr %invariant.gep525, align 8
  %.775.peel = load double, ptr %invariant.gep543, align 8
  %.829.peel = load double, ptr %invariant.gep545, align 8
  %.68.i.i.peel = fmul double %.667.peel, %.721.peel
  %.69.i.i.peel = fsub double %.68.i.i.peel, %.68.i.i.peel
  %0 = fmul double %.775.peel, %.829.peel
  %.71.i.i.peel = fsub double %.69.i.i.peel, %0
  %.73.i.i.peel = fadd double %0, %.71.i.i.peel
  %.75.i.i.peel = fmul double %.667.peel, %.775.peel
  %.76.i.i.peel = fsub double %.75.i.i.peel, %.75.i.i.peel
  %1 = fmul double %.721.peel, %.829.peel
  %.78.i.i.peel = fsub double %.76.i.i.peel, %1
  %.80.i.i.peel = fadd double %1, %.78.i.i.peel
  %.82.i.i.peel = fmul double %.667.peel, %.829.peel
  %.83.i.i.peel = fsub double %.82.i.i.peel, %.82.i.i.peel
  %2 = fmul double %.721.peel, %.775.peel
  %.85.i.i.peel = fsub double %.83.i.i.peel, %2
  %.87.i.i.peel = fadd double %2, %.85.i.i.peel
  %.197.i.peel = fmul double %.73.i.i.peel, %.73.i.i.peel
  %.200.i.peel = fmul double %.80.i.i.peel, %.80.i.i.peel
  %.201.i.peel = fadd double %.197.i.peel, %.200.i.peel
  %.204.i.peel = fmul double %.87.i.i.peel, %.87.i.i.peel
  %.205.i.peel = fadd double %.201.i.peel, %.204.i.peel
  %.212.i.peel = fcmp ogt double %.205.i.peel, 0.000000e+00
  br i1 %.212.i.peel, label %B222.endif.i.peel, label %B62.endif.endif.endif.endif.endif.peel

B222.endif.i.peel:                                ; preds = %B150.i.peel
  %.60.i.i.peel = fmul double %.667.peel, %.667.peel
  %3 = fmul double %.721.peel, %.721.peel
  %.62.i.i.peel = fadd double %.60.i.i.peel, %3
  %4 = fmul double %.775.peel, %.775.peel
  %.64.i.i.peel = fadd double %.62.i.i.peel, %4
  %5 = fmul double %.829.peel, %.829.peel
  %.66.i.i.peel = fadd double %.64.i.i.peel, %5
  %sqrt.i.peel = tail call double @llvm.sqrt.f64(double %.205.i.peel)
  %.216.i.peel = tail call double @atan2(double %sqrt.i.peel, double %.66.i.i.peel)
  %.220.i.peel = fmul double %.216.i.peel, 2.000000e+00
  %.225.i.peel = fdiv double %.220.i.peel, %sqrt.i.peel
  br label %B62.endif.endif.endif.endif.endif.peel

B62.endif.endif.endif.endif.endif.peel:           ; preds = %B222.endif.i.peel, %B150.i.peel
  %"$phi268.0.2.0.i.peel" = phi double [ %.225.i.peel, %B222.endif.i.peel ], [ 0.000000e+00, %B150.i.peel ]
  %.243.i.peel = fmul double %.73.i.i.peel, %"$phi268.0.2.0.i.peel"
  %.247.i.peel = fmul double %.80.i.i.peel, %"$phi268.0.2.0.i.peel"
  %.251.i.peel = fmul double %.87.i.i.peel, %"$phi268.0.2.0.i.peel"
  %.601.peel = fsub double %.546.peel, %.546.peel
  %.606.peel = fdiv double %.601.peel, %arg.h
  %.487.peel = fsub double %.432.peel, %.432.peel
  %.492.peel = fdiv double %.487.peel, %arg.h
  %.373.peel = fsub double %.318.peel, %.318.peel
  %.378.peel = fdiv double %.373.peel, %arg.h
  %.1190.peel = fdiv double %.243.i.peel, %arg.h
  %.1195.peel = fdiv double %.247.i.peel, %arg.h
  %.1200.peel = fdiv double %.251.i.peel, %arg.h
  store double 0.000000e+00, ptr %.1280, align 8
  call fastcc void @part.0(ptr nonnull %.1280, ptr %arg.shapes.4, i64 %arg.shapes.5.0, i64 %arg.shapes.6.0, i64 %arg.shapes.6.1, double %arg.tip, ptr nonnull %arg.p.4, i64 %arg.p.6.1, double %.378.peel, double %.492.peel, double %.606.peel, double %.1190.peel, double %.1195.peel, double %.1200.peel, ptr %arg.force.4, i64 %arg.force.6.1)
  %.1308.peel = load double, ptr %.1280, align 8
  store double %.1308.peel, ptr %arg.depth.4, align 8
  %exitcond.not.peel = icmp eq i64 %arg.p.5.0, 1
  br i1 %exitcond.not.peel, label %B524, label %B62.endif

B524:                                             ; preds = %B62.endif.endif.endif.endif.endif, %B62.endif.endif.endif.endif.endif.peel, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B62.endif:                                        ; preds = %B62.endif.endif.endif.endif.endif.peel, %B62.endif.endif.endif.endif.endif
  %.204532536 = phi i64 [ %.211, %B62.endif.endif.endif.endif.endif ], [ 1, %B62.endif.endif.endif.endif.endif.peel ]
  %.211 = add nuw nsw i64 %.204532536, 1
  %.13.i = add nsw i64 %.204532536, -1
  %.312 = mul i64 %.204532536, %arg.p.6.0
  %.316 = getelementptr i8, ptr %arg.p.4, i64 %.312
  %.318 = load double, ptr %.316, align 8
  %.366 = mul i64 %.13.i, %arg.p.6.0
  %.370 = getelementptr i8, ptr %arg.p.4, i64 %.366
  %.372 = load double, ptr %.370, align 8
  %gep = getelementptr i8, ptr %invariant.gep, i64 %.312
  %.432 = load double, ptr %gep, align 8
  %gep524 = getelementptr i8, ptr %invariant.gep, i64 %.366
  %.486 = load double, ptr %gep524, align 8
  %gep540 = getelementptr i8, ptr %invariant.gep539, i64 %.312
  %.546 = load double, ptr %gep540, align 8
  %gep542 = getelementptr i8, ptr %invariant.gep539, i64 %.366
  %.600 = load double, ptr %gep542, align 8
  %.661 = mul i64 %.204532536, %arg.q.6.0
  %.665 = getelementptr i8, ptr %arg.q.4, i64 %.661
  %.667 = load double, ptr %.665, align 8
  %gep526 = getelementptr i8, ptr %invariant.gep525, i64 %.661
  %.721 = load double, ptr %gep526, align 8
  %gep544 = getelementptr i8, ptr %invariant.gep543, i64 %.661
  %.775 = load double, ptr %gep544, align 8
  %gep546 = getelementptr i8, ptr %invariant.gep545, i64 %.661
  %.829 = load double, ptr %gep546, align 8
  %.885 = mul i64 %.13.i, %arg.q.6.0
  %.889 = getelementptr i8, ptr %arg.q.4, i64 %.885
  %.891 = load double, ptr %.889, align 8
  %gep528 = getelementptr i8, ptr %invariant.gep525, i64 %.885
  %.945 = load double, ptr %gep528, align 8
  %gep548 = getelementptr i8, ptr %invariant.gep543, i64 %.885
  %.999 = load double, ptr %gep548, align 8
  %gep550 = getelementptr i8, ptr %invariant.gep545, i64 %.885
  %.1053 = load double, ptr %gep550, align 8
  %.60.i.i = fmul double %.667, %.891
  %6 = fmul double %.721, %.945
  %.62.i.i = fadd double %.60.i.i, %6
  %7 = fmul double %.775, %.999
  %.64.i.i = fadd double %.62.i.i, %7
  %8 = fmul double %.829, %.1053
  %.66.i.i = fadd double %.64.i.i, %8
  %.68.i.i = fmul double %.721, %.891
  %9 = fmul double %.667, %.945
  %.69.i.i = fsub double %.68.i.i, %9
  %10 = fmul double %.775, %.1053
  %.71.i.i = fsub double %.69.i.i, %10
  %11 = fmul double %.829, %.999
  %.73.i.i = fadd double %11, %.71.i.i
  %.75.i.i = fmul double %.775, %.891
  %12 = fmul double %.667, %.999
  %.76.i.i = fsub double %.75.i.i, %12
  %13 = fmul double %.829, %.945
  %.78.i.i = fsub double %.76.i.i, %13
  %14 = fmul double %.721, %.1053
  %.80.i.i = fadd double %14, %.78.i.i
  %.82.i.i = fmul double %.829, %.891
  %15 = fmul double %.667, %.1053
  %.83.i.i = fsub double %.82.i.i, %15
  %16 = fmul double %.721, %.999
  %.85.i.i = fsub double %.83.i.i, %16
  %17 = fmul double %.775, %.945
  %.87.i.i = fadd double %17, %.85.i.i
  %.136.i = fcmp olt double %.66.i.i, 0.000000e+00
  br i1 %.136.i, label %B120.i, label %B150.i

B120.i:                                           ; preds = %B62.endif
  %.139.i = fneg double %.66.i.i
  %.143.i = fneg double %.73.i.i
  %.147.i = fneg double %.80.i.i
  %.151.i = fneg double %.87.i.i
  br label %B150.i

B150.i:                                           ; preds = %B120.i, %B62.endif
  %w.2.0.i = phi double [ %.139.i, %B120.i ], [ %.66.i.i, %B62.endif ]
  %x.2.0.i = phi double [ %.143.i, %B120.i ], [ %.73.i.i, %B62.endif ]
  %y.2.0.i = phi double [ %.147.i, %B120.i ], [ %.80.i.i, %B62.endif ]
  %z.2.0.i = phi double [ %.151.i, %B120.i ], [ %.87.i.i, %B62.endif ]
  %.197.i = fmul double %x.2.0.i, %x.2.0.i
  %.200.i = fmul double %y.2.0.i, %y.2.0.i
  %.201.i = fadd double %.197.i, %.200.i
  %.204.i = fmul double %z.2.0.i, %z.2.0.i
  %.205.i = fadd double %.201.i, %.204.i
  %.212.i = fcmp ogt double %.205.i, 0.000000e+00
  br i1 %.212.i, label %B222.endif.i, label %B62.endif.endif.endif.endif.endif

B222.endif.i:                                     ; preds = %B150.i
  %sqrt.i = tail call double @llvm.sqrt.f64(double %.205.i)
  %.216.i = tail call double @atan2(double %sqrt.i, double %w.2.0.i)
  %.220.i = fmul double %.216.i, 2.000000e+00
  %.225.i = fdiv double %.220.i, %sqrt.i
  br label %B62.endif.endif.endif.endif.endif

B62.endif.endif.endif.endif.endif:                ; preds = %B222.endif.i, %B150.i
  %"$phi268.0.2.0.i" = phi double [ %.225.i, %B222.endif.i ], [ 0.000000e+00, %B150.i ]
  %.243.i = fmul double %x.2.0.i, %"$phi268.0.2.0.i"
  %.247.i = fmul double %y.2.0.i, %"$phi268.0.2.0.i"
  %.251.i = fmul double %z.2.0.i, %"$phi268.0.2.0.i"
  %.601 = fsub double %.546, %.600
  %.606 = fdiv double %.601, %arg.h
  %.487 = fsub double %.432, %.486
  %.492 = fdiv double %.487, %arg.h
  %.373 = fsub double %.318, %.372
  %.378 = fdiv double %.373, %arg.h
  %.1190 = fdiv double %.243.i, %arg.h
  %.1195 = fdiv double %.247.i, %arg.h
  %.1200 = fdiv double %.251.i, %arg.h
  %.1243 = mul i64 %.204532536, %arg.force.6.0
  %.1245 = getelementptr i8, ptr %arg.force.4, i64 %.1243
  store double 0.000000e+00, ptr %.1280, align 8
  call fastcc void @part.0(ptr nonnull %.1280, ptr %arg.shapes.4, i64 %arg.shapes.5.0, i64 %arg.shapes.6.0, i64 %arg.shapes.6.1, double %arg.tip, ptr nonnull %.316, i64 %arg.p.6.1, double %.378, double %.492, double %.606, double %.1190, double %.1195, double %.1200, ptr %.1245, i64 %arg.force.6.1)
  %.1308 = load double, ptr %.1280, align 8
  %.1356 = mul i64 %.204532536, %arg.depth.6.0
  %.1358 = getelementptr i8, ptr %arg.depth.4, i64 %.1356
  store double %.1308, ptr %.1358, align 8
  %exitcond.not = icmp eq i64 %.211, %arg.p.5.0
  br i1 %exitcond.not, label %B524, label %B62.endif, !llvm.loop !0
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sqrt.f64(double) #1

; Function Attrs: mustprogress nofree nosync nounwind willreturn memory(none)
declare double @atan2(double, double) local_unnamed_addr #2

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @part.0(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.shapes.4, i64 %arg.shapes.5.0, i64 %arg.shapes.6.0, i64 %arg.shapes.6.1, double %arg.tip, ptr readonly captures(none) %arg.p.4, i64 %arg.p.6.0, double %arg.v.0, double %arg.v.1, double %arg.v.2, double %arg.w.0, double %arg.w.1, double %arg.w.2, ptr captures(none) initializes((0, 8)) %arg.out.4, i64 %arg.out.6.0) unnamed_addr #0 {
B0.endif.endif:
  store double 0.000000e+00, ptr %arg.out.4, align 8
  %.227.1 = getelementptr i8, ptr %arg.out.4, i64 %arg.out.6.0
  store double 0.000000e+00, ptr %.227.1, align 8
  %.225.2 = shl i64 %arg.out.6.0, 1
  %.227.2 = getelementptr i8, ptr %arg.out.4, i64 %.225.2
  store double 0.000000e+00, ptr %.227.2, align 8
  %.225.3 = mul i64 %arg.out.6.0, 3
  %.227.3 = getelementptr i8, ptr %arg.out.4, i64 %.225.3
  store double 0.000000e+00, ptr %.227.3, align 8
  %.225.4 = shl i64 %arg.out.6.0, 2
  %.227.4 = getelementptr i8, ptr %arg.out.4, i64 %.225.4
  store double 0.000000e+00, ptr %.227.4, align 8
  %.225.5 = mul i64 %arg.out.6.0, 5
  %.227.5 = getelementptr i8, ptr %arg.out.4, i64 %.225.5
  store double 0.000000e+00, ptr %.227.5, align 8
  %.334517.not = icmp slt i64 %arg.shapes.5.0, 1
  br i1 %.334517.not, label %B1068, label %B114.lr.ph

B114:                                             ; preds = %B114.lr.ph, %B1069
  %lsr.iv16 = phi i64 [ %arg.shapes.5.0, %B114.lr.ph ], [ %lsr.iv.next, %B1069 ]
  %lsr.iv = phi ptr [ %arg.shapes.4, %B114.lr.ph ], [ %scevgep, %B1069 ]
  %deepest.2.0520 = phi double [ 0.000000e+00, %B114.lr.ph ], [ %deepest.3.1, %B1069 ]
  %.62.i = load double, ptr %lsr.iv, align 8, !noalias !2
  %.64.i = fcmp oeq double %.62.i, 1.000000e+00
  %.319.i = getelementptr i8, ptr %lsr.iv, i64 %.1074.i
  %.321.i = load double, ptr %.319.i, align 8, !noalias !2
  br i1 %.64.i, label %B30.i, label %B610.endif.i

B30.i:                                            ; preds = %B114
  %.94.i = getelementptr i8, ptr %lsr.iv, i64 %.1106.i
  %.96.i = load double, ptr %.94.i, align 8, !noalias !2
  %.128.i = fmul double %.96.i, %.96.i
  %.157.i = getelementptr i8, ptr %lsr.iv, i64 %.1204.i
  %.159.i = load double, ptr %.157.i, align 8, !noalias !2
  %.191.i = fmul double %.159.i, %.159.i
  %.192.i = fadd double %.128.i, %.191.i
  %.221.i = getelementptr i8, ptr %lsr.iv, i64 %.1302.i
  %.223.i = load double, ptr %.221.i, align 8, !noalias !2
  %.255.i = fmul double %.223.i, %.223.i
  %.256.i = fadd double %.192.i, %.255.i
  %.290.i = load double, ptr %arg.p.4, align 8, !noalias !2
  %.322.i = fsub double %.290.i, %.321.i
  %.353.i = load double, ptr %.945.i, align 8, !noalias !2
  %.382.i = getelementptr i8, ptr %lsr.iv, i64 %.1172.i
  %.384.i = load double, ptr %.382.i, align 8, !noalias !2
  %.385.i = fsub double %.353.i, %.384.i
  %.416.i = load double, ptr %.1008.i, align 8, !noalias !2
  %.450.i = getelementptr i8, ptr %lsr.iv, i64 %.1270.i
  %.452.i = load double, ptr %.450.i, align 8, !noalias !2
  %.453.i = fsub double %.416.i, %.452.i
  %.465.i = fcmp ogt double %.256.i, 0.000000e+00
  br i1 %.465.i, label %B250.endif.i, label %B328.endif.endif.endif.i

B1112.i:                                          ; preds = %B610.endif.i
  %.1506.i = fcmp oeq double %.1384.i, %.19.i.i
  br i1 %.1506.i, label %B1344.i, label %B1128.i

B1128.i:                                          ; preds = %B1112.i
  %.1539.i = fcmp oeq double %.1418.i, %.19.i.i
  br i1 %.1539.i, label %B1344.i, label %B1144.i

B1144.i:                                          ; preds = %B1128.i
  br label %B1344.i

B1344.i:                                          ; preds = %B1158.endif.endif.endif.i, %B1144.i, %B1128.i, %B1112.i
  %far.3.0.i = phi double [ %sqrt669.i, %B1158.endif.endif.endif.i ], [ %.19.i.i, %B1128.i ], [ %.19.i.i, %B1112.i ], [ %.19.i.i, %B1144.i ]
  %a.4.0.i = phi double [ %.1728.i, %B1158.endif.endif.endif.i ], [ 0.000000e+00, %B1128.i ], [ 1.000000e+00, %B1112.i ], [ 0.000000e+00, %B1144.i ]
  %b.4.0.i = phi double [ %.1732.i, %B1158.endif.endif.endif.i ], [ 1.000000e+00, %B1128.i ], [ 0.000000e+00, %B1112.i ], [ 0.000000e+00, %B1144.i ]
  %c.4.0.i = phi double [ %.1736.i, %B1158.endif.endif.endif.i ], [ 0.000000e+00, %B1128.i ], [ 0.000000e+00, %B1112.i ], [ 1.000000e+00, %B1144.i ]
  %.1746.i = tail call double @llvm.copysign.f64(double %a.4.0.i, double %.1145.i)
  %.1753.i = tail call double @llvm.copysign.f64(double %b.4.0.i, double %.1243.i)
  %.1760.i = tail call double @llvm.copysign.f64(double %c.4.0.i, double %.1341.i)
  %.1796.i = fmul double %.321.i, %.1746.i
  %.1828.i = fmul double %.1176.i, %.1753.i
  %.1829.i = fadd double %.1796.i, %.1828.i
  %.1861.i = fmul double %.1274.i, %.1760.i
  %.1862.i = fadd double %.1829.i, %.1861.i
  %.1894.i = fmul double %.1110.i, %.1746.i
  %.1926.i = fmul double %.1208.i, %.1753.i
  %.1927.i = fadd double %.1894.i, %.1926.i
  %.1959.i = fmul double %.1306.i, %.1760.i
  %.1960.i = fadd double %.1927.i, %.1959.i
  %.1992.i = fmul double %.1143.i, %.1746.i
  %.2024.i = fmul double %.1241.i, %.1753.i
  %.2025.i = fadd double %.1992.i, %.2024.i
  %.2062.i = fmul double %.1339.i, %.1760.i
  %.2063.i = fadd double %.2025.i, %.2062.i
  br label %part.1

B250.endif.i:                                     ; preds = %B30.i
  %.499.i = fmul double %.96.i, %.322.i
  %.532.i = fmul double %.159.i, %.385.i
  %.533.i = fadd double %.499.i, %.532.i
  %.566.i = fmul double %.223.i, %.453.i
  %.567.i = fadd double %.533.i, %.566.i
  %.572.i = fdiv double %.567.i, %.256.i
  br label %B328.endif.endif.endif.i

B328.endif.endif.endif.i:                         ; preds = %B250.endif.i, %B30.i
  %"$phi328.0.2.0.i" = phi double [ %.572.i, %B250.endif.i ], [ 0.000000e+00, %B30.i ]
  %.12.i.i = fcmp ogt double %"$phi328.0.2.0.i", 0.000000e+00
  %.13.i.i = select i1 %.12.i.i, double %"$phi328.0.2.0.i", double 0.000000e+00
  %.12.i3.i = fcmp olt double %.13.i.i, 1.000000e+00
  %.13.i4.i = select i1 %.12.i3.i, double %.13.i.i, double 1.000000e+00
  %.676.i = fmul double %.96.i, %.13.i4.i
  %.678.i = fsub double %.322.i, %.676.i
  %.712.i = fmul double %.159.i, %.13.i4.i
  %.714.i = fsub double %.385.i, %.712.i
  %.748.i = fmul double %.223.i, %.13.i4.i
  %.750.i = fsub double %.453.i, %.748.i
  %.753.i = fmul double %.678.i, %.678.i
  %.754.i = fmul double %.714.i, %.714.i
  %.755.i = fadd double %.753.i, %.754.i
  %.756.i = fmul double %.750.i, %.750.i
  %.757.i = fadd double %.756.i, %.755.i
  %sqrt.i = tail call double @llvm.sqrt.f64(double %.757.i)
  %.12.i5.i = fcmp olt double %sqrt.i, 1.000000e-300
  %.13.i6.i = select i1 %.12.i5.i, double 1.000000e-300, double %sqrt.i
  %.815.i = getelementptr i8, ptr %lsr.iv, i64 %.1139.i
  %.817.i = load double, ptr %.815.i, align 8, !noalias !2
  %.823.i = fsub double %.13.i6.i, %.817.i
  %.827.i = fdiv double %.678.i, %.13.i6.i
  %.831.i = fdiv double %.714.i, %.13.i6.i
  %.835.i = fdiv double %.750.i, %.13.i6.i
  br label %part.1

B610.endif.i:                                     ; preds = %B114
  %.884.i = load double, ptr %arg.p.4, align 8, !noalias !2
  %.913.i = getelementptr i8, ptr %lsr.iv, i64 %.911.i
  %.915.i = load double, ptr %.913.i, align 8, !noalias !2
  %.916.i = fsub double %.884.i, %.915.i
  %.947.i = load double, ptr %.945.i, align 8, !noalias !2
  %.976.i = getelementptr i8, ptr %lsr.iv, i64 %.974.i
  %.978.i = load double, ptr %.976.i, align 8, !noalias !2
  %.979.i = fsub double %.947.i, %.978.i
  %.1010.i = load double, ptr %.1008.i, align 8, !noalias !2
  %.1044.i = getelementptr i8, ptr %lsr.iv, i64 %.1042.i
  %.1046.i = load double, ptr %.1044.i, align 8, !noalias !2
  %.1047.i = fsub double %.1010.i, %.1046.i
  %.1079.i = fmul double %.916.i, %.321.i
  %.1108.i = getelementptr i8, ptr %lsr.iv, i64 %.1106.i
  %.1110.i = load double, ptr %.1108.i, align 8, !noalias !2
  %.1111.i = fmul double %.979.i, %.1110.i
  %.1112.i = fadd double %.1079.i, %.1111.i
  %.1141.i = getelementptr i8, ptr %lsr.iv, i64 %.1139.i
  %.1143.i = load double, ptr %.1141.i, align 8, !noalias !2
  %.1144.i = fmul double %.1047.i, %.1143.i
  %.1145.i = fadd double %.1112.i, %.1144.i
  %.1174.i = getelementptr i8, ptr %lsr.iv, i64 %.1172.i
  %.1176.i = load double, ptr %.1174.i, align 8, !noalias !2
  %.1177.i = fmul double %.916.i, %.1176.i
  %.1206.i = getelementptr i8, ptr %lsr.iv, i64 %.1204.i
  %.1208.i = load double, ptr %.1206.i, align 8, !noalias !2
  %.1209.i = fmul double %.979.i, %.1208.i
  %.1210.i = fadd double %.1177.i, %.1209.i
  %.1239.i = getelementptr i8, ptr %lsr.iv, i64 %.1237.i
  %.1241.i = load double, ptr %.1239.i, align 8, !noalias !2
  %.1242.i = fmul double %.1047.i, %.1241.i
  %.1243.i = fadd double %.1210.i, %.1242.i
  %.1272.i = getelementptr i8, ptr %lsr.iv, i64 %.1270.i
  %.1274.i = load double, ptr %.1272.i, align 8, !noalias !2
  %.1275.i = fmul double %.916.i, %.1274.i
  %.1304.i = getelementptr i8, ptr %lsr.iv, i64 %.1302.i
  %.1306.i = load double, ptr %.1304.i, align 8, !noalias !2
  %.1307.i = fmul double %.979.i, %.1306.i
  %.1308.i = fadd double %.1275.i, %.1307.i
  %.1337.i = getelementptr i8, ptr %lsr.iv, i64 %.1335.i
  %.1339.i = load double, ptr %.1337.i, align 8, !noalias !2
  %.1340.i = fmul double %.1047.i, %.1339.i
  %.1341.i = fadd double %.1308.i, %.1340.i
  %.1352.i = tail call double @llvm.fabs.f64(double %.1145.i)
  %.1381.i = getelementptr i8, ptr %lsr.iv, i64 %.1379.i
  %.1383.i = load double, ptr %.1381.i, align 8, !noalias !2
  %.1384.i = fsub double %.1352.i, %.1383.i
  %.1386.i = tail call double @llvm.fabs.f64(double %.1243.i)
  %.1415.i = getelementptr i8, ptr %lsr.iv, i64 %.1413.i
  %.1417.i = load double, ptr %.1415.i, align 8, !noalias !2
  %.1418.i = fsub double %.1386.i, %.1417.i
  %.1420.i = tail call double @llvm.fabs.f64(double %.1341.i)
  %.1449.i = getelementptr i8, ptr %lsr.iv, i64 %.1447.i
  %.1451.i = load double, ptr %.1449.i, align 8, !noalias !2
  %.1452.i = fsub double %.1420.i, %.1451.i
  %.16.i.i = fcmp ogt double %.1418.i, %.1384.i
  %.17.i.i = select i1 %.16.i.i, double %.1418.i, double %.1384.i
  %.18.i.i = fcmp ogt double %.1452.i, %.17.i.i
  %.19.i.i = select i1 %.18.i.i, double %.1452.i, double %.17.i.i
  %.1500.i = fcmp ugt double %.19.i.i, 0.000000e+00
  br i1 %.1500.i, label %B1158.endif.endif.endif.i, label %B1112.i

B1158.endif.endif.endif.i:                        ; preds = %B610.endif.i
  %.12.i1.i = fcmp olt double %.1384.i, 0.000000e+00
  %.13.i2.i = select i1 %.12.i1.i, double 0.000000e+00, double %.1384.i
  %.12.i7.i = fcmp olt double %.1418.i, 0.000000e+00
  %.13.i8.i = select i1 %.12.i7.i, double 0.000000e+00, double %.1418.i
  %.12.i9.i = fcmp olt double %.1452.i, 0.000000e+00
  %.13.i10.i = select i1 %.12.i9.i, double 0.000000e+00, double %.1452.i
  %.1717.i = fmul double %.13.i2.i, %.13.i2.i
  %.1718.i = fmul double %.13.i8.i, %.13.i8.i
  %.1719.i = fadd double %.1717.i, %.1718.i
  %.1720.i = fmul double %.13.i10.i, %.13.i10.i
  %.1721.i = fadd double %.1719.i, %.1720.i
  %sqrt669.i = tail call double @llvm.sqrt.f64(double %.1721.i)
  %.1728.i = fdiv double %.13.i2.i, %sqrt669.i
  %.1732.i = fdiv double %.13.i8.i, %sqrt669.i
  %.1736.i = fdiv double %.13.i10.i, %sqrt669.i
  br label %B1344.i

part.1: ; preds = %B1344.i, %B328.endif.endif.endif.i
  %.823.sink.i = phi double [ %.823.i, %B328.endif.endif.endif.i ], [ %far.3.0.i, %B1344.i ]
  %.827.sink.i = phi double [ %.827.i, %B328.endif.endif.endif.i ], [ %.1862.i, %B1344.i ]
  %.831.sink.i = phi double [ %.831.i, %B328.endif.endif.endif.i ], [ %.1960.i, %B1344.i ]
  %.835.sink.i = phi double [ %.835.i, %B328.endif.endif.endif.i ], [ %.2063.i, %B1344.i ]
  %.506 = fsub double %arg.tip, %.823.sink.i
  %.512 = fcmp ugt double %.506, 0.000000e+00
  br i1 %.512, label %B198.endif.endif.endif, label %B1069

B1068:                                            ; preds = %B1069, %B0.endif.endif
  %deepest.2.0.lcssa = phi double [ 0.000000e+00, %B0.endif.endif ], [ %deepest.3.1, %B1069 ]
  store double %deepest.2.0.lcssa, ptr %retptr, align 8
  ret void

B1069:                                            ; preds = %part.1, %B198.endif.endif.endif
  %deepest.3.1 = phi double [ %.13.i, %B198.endif.endif.endif ], [ %deepest.2.0520, %part.1 ]
  %scevgep = getelementptr i8, ptr %lsr.iv, i64 %arg.shapes.6.0
  %lsr.iv.next = add nsw i64 %lsr.iv16, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond.not, label %B1068, label %B114

B114.lr.ph:                                       ; preds = %B0.endif.endif
  %.796 = mul i64 %arg.shapes.6.1, 3
  %.911.i = mul i64 %arg.shapes.6.1, 13
  %.945.i = getelementptr i8, ptr %arg.p.4, i64 %arg.p.6.0
  %.974.i = mul i64 %arg.shapes.6.1, 14
  %.1006.i = shl i64 %arg.p.6.0, 1
  %.1008.i = getelementptr i8, ptr %arg.p.4, i64 %.1006.i
  %.1042.i = mul i64 %arg.shapes.6.1, 15
  %.1074.i = shl i64 %arg.shapes.6.1, 2
  %.1106.i = mul i64 %arg.shapes.6.1, 7
  %.1139.i = mul i64 %arg.shapes.6.1, 10
  %.1172.i = mul i64 %arg.shapes.6.1, 5
  %.1204.i = shl i64 %arg.shapes.6.1, 3
  %.1237.i = mul i64 %arg.shapes.6.1, 11
  %.1270.i = mul i64 %arg.shapes.6.1, 6
  %.1302.i = mul i64 %arg.shapes.6.1, 9
  %.1335.i = mul i64 %arg.shapes.6.1, 12
  %.1379.i = shl i64 %arg.shapes.6.1, 4
  %.1413.i = mul i64 %arg.shapes.6.1, 17
  %.1447.i = mul i64 %arg.shapes.6.1, 18
  %sunkaddr10 = shl i64 %arg.shapes.6.1, 1
  br label %B114

B198.endif.endif.endif:                           ; preds = %part.1
  %.12.i = fcmp ogt double %.506, %deepest.2.0520
  %.13.i = select i1 %.12.i, double %.506, double %deepest.2.0520
  %.574 = fmul double %.506, 5.000000e-01
  %.576 = fsub double %.574, %arg.tip
  %.578 = fmul double %.827.sink.i, %.576
  %.580 = fmul double %.831.sink.i, %.576
  %.582 = fmul double %.835.sink.i, %.576
  %.597 = fmul double %arg.w.1, %.582
  %.598 = fadd double %arg.v.0, %.597
  %.602 = fmul double %arg.w.2, %.580
  %.603 = fsub double %.598, %.602
  %.609 = fmul double %arg.w.2, %.578
  %.610 = fadd double %arg.v.1, %.609
  %.614 = fmul double %arg.w.0, %.582
  %.615 = fsub double %.610, %.614
  %.621 = fmul double %arg.w.0, %.580
  %.622 = fadd double %arg.v.2, %.621
  %.626 = fmul double %arg.w.1, %.578
  %.627 = fsub double %.622, %.626
  %.629 = fmul double %.827.sink.i, %.603
  %.631 = fmul double %.831.sink.i, %.615
  %.632 = fadd double %.629, %.631
  %.634 = fmul double %.835.sink.i, %.627
  %.635 = fadd double %.634, %.632
  %scevgep15 = getelementptr i8, ptr %lsr.iv, i64 %arg.shapes.6.1
  %.666 = load double, ptr %scevgep15, align 8
  %.668 = fmul double %.506, %.666
  %sunkaddr11 = getelementptr i8, ptr %lsr.iv, i64 %sunkaddr10
  %.701 = load double, ptr %sunkaddr11, align 8
  %.702 = fmul double %.635, %.701
  %.703 = fsub double %.668, %.702
  %.12.i5 = fcmp ogt double %.703, 0.000000e+00
  %.13.i6 = select i1 %.12.i5, double %.703, double 0.000000e+00
  %.736 = fmul double %.827.sink.i, %.635
  %.737 = fsub double %.603, %.736
  %.739 = fmul double %.831.sink.i, %.635
  %.740 = fsub double %.615, %.739
  %.742 = fmul double %.835.sink.i, %.635
  %.743 = fsub double %.627, %.742
  %.755 = fmul double %.737, %.737
  %.758 = fmul double %.740, %.740
  %.759 = fadd double %.755, %.758
  %.762 = fmul double %.743, %.743
  %.763 = fadd double %.762, %.759
  %sqrt = tail call double @llvm.sqrt.f64(double %.763)
  %.769 = fmul double %sqrt, 2.000000e+03
  %scevgep13 = getelementptr i8, ptr %lsr.iv, i64 %.796
  %.800 = load double, ptr %scevgep13, align 8
  %.802 = fmul double %.800, %.13.i6
  %.803 = fcmp ugt double %.769, %.802
  %"$phi770.1.2.2.frozen" = freeze i1 %.803
  %.858 = fdiv double %.802, %sqrt
  %"$phi770.1.2.2" = select i1 %"$phi770.1.2.2.frozen", double %.858, double 2.000000e+03
  %.874 = fmul double %.827.sink.i, %.13.i6
  %.878 = fmul double %.737, %"$phi770.1.2.2"
  %.881 = fsub double %.874, %.878
  %.884 = fmul double %.831.sink.i, %.13.i6
  %.888 = fmul double %.740, %"$phi770.1.2.2"
  %.891 = fsub double %.884, %.888
  %.894 = fmul double %.835.sink.i, %.13.i6
  %.900 = fmul double %.743, %"$phi770.1.2.2"
  %.903 = fsub double %.894, %.900
  %.934 = load double, ptr %arg.out.4, align 8
  %.935 = fadd double %.934, %.881
  %.966 = load double, ptr %.227.1, align 8
  %.967 = fadd double %.966, %.891
  %.998 = load double, ptr %.227.2, align 8
  %.999 = fadd double %.998, %.903
  store double %.935, ptr %arg.out.4, align 8
  store double %.967, ptr %.227.1, align 8
  store double %.999, ptr %.227.2, align 8
  %.1123 = load double, ptr %.227.3, align 8
  %.1125 = fmul double %.580, %.903
  %.1126 = fadd double %.1123, %.1125
  %.1128 = fmul double %.582, %.891
  %.1129 = fsub double %.1126, %.1128
  %.1160 = load double, ptr %.227.4, align 8
  %.1162 = fmul double %.582, %.881
  %.1165 = fadd double %.1160, %.1162
  %.1167 = fmul double %.578, %.903
  %.1168 = fsub double %.1165, %.1167
  %.1199 = load double, ptr %.227.5, align 8
  %.1201 = fmul double %.578, %.891
  %.1204 = fadd double %.1199, %.1201
  %.1206 = fmul double %.580, %.881
  %.1209 = fsub double %.1204, %.1206
  store double %.1129, ptr %.227.3, align 8
  store double %.1168, ptr %.227.4, align 8
  store double %.1209, ptr %.227.5, align 8
  br label %B1069
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.copysign.f64(double, double) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.at_rest(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.shapes.0, ptr readnone captures(none) %arg.shapes.1, i64 %arg.shapes.2, i64 %arg.shapes.3, ptr readonly captures(none) %arg.shapes.4, i64 %arg.shapes.5.0, i64 %arg.shapes.5.1, i64 %arg.shapes.6.0, i64 %arg.shapes.6.1, double %arg.tip, ptr readnone captures(none) %arg.p.0, ptr readnone captures(none) %arg.p.1, i64 %arg.p.2, i64 %arg.p.3, ptr readonly captures(none) %arg.p.4, i64 %arg.p.5.0, i64 %arg.p.5.1, i64 %arg.p.6.0, i64 %arg.p.6.1, ptr readnone captures(none) %arg.K.0, ptr readnone captures(none) %arg.K.1, i64 %arg.K.2, i64 %arg.K.3, ptr readonly captures(none) %arg.K.4, i64 %arg.K.5.0, i64 %arg.K.5.1, i64 %arg.K.6.0, i64 %arg.K.6.1, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.5.1, i64 %arg.out.6.0, i64 %arg.out.6.1) local_unnamed_addr #0 {
B0.endif:
  %invariant.gep547 = getelementptr i8, ptr %arg.out.4, i64 %arg.out.6.1
  %.181558.not = icmp slt i64 %arg.p.5.0, 1
  br i1 %.181558.not, label %B492, label %B62.endif.lr.ph

B62.endif.lr.ph:                                  ; preds = %B0.endif
  %invariant.gep = getelementptr i8, ptr %arg.K.4, i64 %arg.K.6.1
  %.369543.not = icmp slt i64 %arg.shapes.5.0, 1
  %.896 = shl i64 %arg.K.6.1, 1
  %invariant.gep565 = getelementptr i8, ptr %arg.K.4, i64 %.896
  %.1102 = shl i64 %arg.out.6.1, 1
  %invariant.gep567 = getelementptr i8, ptr %arg.out.4, i64 %.1102
  %.1157 = mul i64 %arg.out.6.1, 3
  %invariant.gep569 = getelementptr i8, ptr %arg.out.4, i64 %.1157
  %.1249 = shl i64 %arg.out.6.1, 2
  %invariant.gep571 = getelementptr i8, ptr %arg.out.4, i64 %.1249
  br i1 %.369543.not, label %B62.endif.preheader, label %B62.endif.us.preheader

B62.endif.us.preheader:                           ; preds = %B62.endif.lr.ph
  %.911.i = mul i64 %arg.shapes.6.1, 13
  %.974.i = mul i64 %arg.shapes.6.1, 14
  %.1006.i = shl i64 %arg.p.6.1, 1
  %.1042.i = mul i64 %arg.shapes.6.1, 15
  %.1074.i = shl i64 %arg.shapes.6.1, 2
  %.1106.i = mul i64 %arg.shapes.6.1, 7
  %.1139.i = mul i64 %arg.shapes.6.1, 10
  %.1172.i = mul i64 %arg.shapes.6.1, 5
  %.1204.i = shl i64 %arg.shapes.6.1, 3
  %.1237.i = mul i64 %arg.shapes.6.1, 11
  %.1270.i = mul i64 %arg.shapes.6.1, 6
  %.1302.i = mul i64 %arg.shapes.6.1, 9
  %.1335.i = mul i64 %arg.shapes.6.1, 12
  %.1379.i = shl i64 %arg.shapes.6.1, 4
  %.1413.i = mul i64 %arg.shapes.6.1, 17
  %.1447.i = mul i64 %arg.shapes.6.1, 18
  br label %B62.endif.us

B62.endif.preheader:                              ; preds = %B62.endif.lr.ph
  %xtraiter = and i64 %arg.p.5.0, 3
  %0 = icmp samesign ult i64 %arg.p.5.0, 4
  br i1 %0, label %B62.endif.epil.preheader, label %B62.endif.preheader.new

B62.endif.preheader.new:                          ; preds = %B62.endif.preheader
  %unroll_iter = and i64 %arg.p.5.0, 9223372036854775804
  %1 = mul i64 %arg.out.6.0, 3
  %2 = shl i64 %arg.out.6.0, 2
  %sunkaddr40 = shl i64 %arg.out.6.0, 1
  br label %B62.endif

B62.endif.us:                                     ; preds = %B62.endif.us.preheader, %B134.B60.loopexit_crit_edge.us
  %.187551559.us = phi i64 [ %.194.us, %B134.B60.loopexit_crit_edge.us ], [ 0, %B62.endif.us.preheader ]
  %.270.us = mul i64 %.187551559.us, %arg.out.6.0
  %.274.us = getelementptr i8, ptr %arg.out.4, i64 %.270.us
  store double -1.000000e+300, ptr %.274.us, align 8
  %.522.us = mul i64 %.187551559.us, %arg.p.6.0
  %.524.us = getelementptr i8, ptr %arg.p.4, i64 %.522.us
  %.769.us = mul i64 %.187551559.us, %arg.K.6.0
  %.945.i = getelementptr i8, ptr %.524.us, i64 %arg.p.6.1
  %.1008.i = getelementptr i8, ptr %.524.us, i64 %.1006.i
  %sunkaddr32 = getelementptr i8, ptr %arg.K.4, i64 %.769.us
  %sunkaddr33 = getelementptr i8, ptr %invariant.gep, i64 %.769.us
  %sunkaddr34 = getelementptr i8, ptr %invariant.gep565, i64 %.769.us
  %sunkaddr36 = getelementptr i8, ptr %invariant.gep547, i64 %.270.us
  %sunkaddr37 = getelementptr i8, ptr %invariant.gep567, i64 %.270.us
  %sunkaddr38 = getelementptr i8, ptr %invariant.gep569, i64 %.270.us
  %sunkaddr39 = getelementptr i8, ptr %invariant.gep571, i64 %.270.us
  br label %B136.us

B136.us:                                          ; preds = %B488.us, %B62.endif.us
  %lsr.iv27 = phi i64 [ %arg.shapes.5.0, %B62.endif.us ], [ %lsr.iv.next28, %B488.us ]
  %lsr.iv24 = phi ptr [ %arg.shapes.4, %B62.endif.us ], [ %scevgep25, %B488.us ]
  %.62.i = load double, ptr %lsr.iv24, align 8, !noalias !5
  %.64.i = fcmp oeq double %.62.i, 1.000000e+00
  %.319.i = getelementptr i8, ptr %lsr.iv24, i64 %.1074.i
  %.321.i = load double, ptr %.319.i, align 8, !noalias !5
  br i1 %.64.i, label %B30.i, label %B610.endif.i

B30.i:                                            ; preds = %B136.us
  %.94.i = getelementptr i8, ptr %lsr.iv24, i64 %.1106.i
  %.96.i = load double, ptr %.94.i, align 8, !noalias !5
  %.128.i = fmul double %.96.i, %.96.i
  %.157.i = getelementptr i8, ptr %lsr.iv24, i64 %.1204.i
  %.159.i = load double, ptr %.157.i, align 8, !noalias !5
  %.191.i = fmul double %.159.i, %.159.i
  %.192.i = fadd double %.128.i, %.191.i
  %.221.i = getelementptr i8, ptr %lsr.iv24, i64 %.1302.i
  %.223.i = load double, ptr %.221.i, align 8, !noalias !5
  %.255.i = fmul double %.223.i, %.223.i
  %.256.i = fadd double %.192.i, %.255.i
  %.290.i = load double, ptr %.524.us, align 8, !noalias !5
  %.322.i = fsub double %.290.i, %.321.i
  %.353.i = load double, ptr %.945.i, align 8, !noalias !5
  %.382.i = getelementptr i8, ptr %lsr.iv24, i64 %.1172.i
  %.384.i = load double, ptr %.382.i, align 8, !noalias !5
  %.385.i = fsub double %.353.i, %.384.i
  %.416.i = load double, ptr %.1008.i, align 8, !noalias !5
  %.450.i = getelementptr i8, ptr %lsr.iv24, i64 %.1270.i
  %.452.i = load double, ptr %.450.i, align 8, !noalias !5
  %.453.i = fsub double %.416.i, %.452.i
  %.465.i = fcmp ogt double %.256.i, 0.000000e+00
  br i1 %.465.i, label %B250.endif.i, label %B328.endif.endif.endif.i

B1112.i:                                          ; preds = %B610.endif.i
  %.1506.i = fcmp oeq double %.1384.i, %.19.i.i
  br i1 %.1506.i, label %B1344.i, label %B1128.i

B1128.i:                                          ; preds = %B1112.i
  %.1539.i = fcmp oeq double %.1418.i, %.19.i.i
  br i1 %.1539.i, label %B1344.i, label %B1144.i

B1144.i:                                          ; preds = %B1128.i
  br label %B1344.i

B1344.i:                                          ; preds = %B1158.endif.endif.endif.i, %B1144.i, %B1128.i, %B1112.i
  %far.3.0.i = phi double [ %sqrt669.i, %B1158.endif.endif.endif.i ], [ %.19.i.i, %B1128.i ], [ %.19.i.i, %B1112.i ], [ %.19.i.i, %B1144.i ]
  %a.4.0.i = phi double [ %.1728.i, %B1158.endif.endif.endif.i ], [ 0.000000e+00, %B1128.i ], [ 1.000000e+00, %B1112.i ], [ 0.000000e+00, %B1144.i ]
  %b.4.0.i = phi double [ %.1732.i, %B1158.endif.endif.endif.i ], [ 1.000000e+00, %B1128.i ], [ 0.000000e+00, %B1112.i ], [ 0.000000e+00, %B1144.i ]
  %c.4.0.i = phi double [ %.1736.i, %B1158.endif.endif.endif.i ], [ 0.000000e+00, %B1128.i ], [ 0.000000e+00, %B1112.i ], [ 1.000000e+00, %B1144.i ]
  %.1746.i = tail call double @llvm.copysign.f64(double %a.4.0.i, double %.1145.i)
  %.1753.i = tail call double @llvm.copysign.f64(double %b.4.0.i, double %.1243.i)
  %.1760.i = tail call double @llvm.copysign.f64(double %c.4.0.i, double %.1341.i)
  %.1796.i = fmul double %.321.i, %.1746.i
  %.1828.i = fmul double %.1176.i, %.1753.i
  %.1829.i = fadd double %.1796.i, %.1828.i
  %.1861.i = fmul double %.1274.i, %.1760.i
  %.1862.i = fadd double %.1829.i, %.1861.i
  %.1894.i = fmul double %.1110.i, %.1746.i
  %.1926.i = fmul double %.1208.i, %.1753.i
  %.1927.i = fadd double %.1894.i, %.1926.i
  %.1959.i = fmul double %.1306.i, %.1760.i
  %.1960.i = fadd double %.1927.i, %.1959.i
  %.1992.i = fmul double %.1143.i, %.1746.i
  %.2024.i = fmul double %.1241.i, %.1753.i
  %.2025.i = fadd double %.1992.i, %.2024.i
  %.2062.i = fmul double %.1339.i, %.1760.i
  %.2063.i = fadd double %.2025.i, %.2062.i
  br label %part.1

B250.endif.i:                                     ; preds = %B30.i
  %.499.i = fmul double %.96.i, %.322.i
  %.532.i = fmul double %.159.i, %.385.i
  %.533.i = fadd double %.499.i, %.532.i
  %.566.i = fmul double %.223.i, %.453.i
  %.567.i = fadd double %.533.i, %.566.i
  %.572.i = fdiv double %.567.i, %.256.i
  br label %B328.endif.endif.endif.i

B328.endif.endif.endif.i:                         ; preds = %B250.endif.i, %B30.i
  %"$phi328.0.2.0.i" = phi double [ %.572.i, %B250.endif.i ], [ 0.000000e+00, %B30.i ]
  %.12.i.i = fcmp ogt double %"$phi328.0.2.0.i", 0.000000e+00
  %.13.i.i = select i1 %.12.i.i, double %"$phi328.0.2.0.i", double 0.000000e+00
  %.12.i3.i = fcmp olt double %.13.i.i, 1.000000e+00
  %.13.i4.i = select i1 %.12.i3.i, double %.13.i.i, double 1.000000e+00
  %.676.i = fmul double %.96.i, %.13.i4.i
  %.678.i = fsub double %.322.i, %.676.i
  %.712.i = fmul double %.159.i, %.13.i4.i
  %.714.i = fsub double %.385.i, %.712.i
  %.748.i = fmul double %.223.i, %.13.i4.i
  %.750.i = fsub double %.453.i, %.748.i
  %.753.i = fmul double %.678.i, %.678.i
  %.754.i = fmul double %.714.i, %.714.i
  %.755.i = fadd double %.753.i, %.754.i
  %.756.i = fmul double %.750.i, %.750.i
  %.757.i = fadd double %.756.i, %.755.i
  %sqrt.i = tail call double @llvm.sqrt.f64(double %.757.i)
  %.12.i5.i = fcmp olt double %sqrt.i, 1.000000e-300
  %.13.i6.i = select i1 %.12.i5.i, double 1.000000e-300, double %sqrt.i
  %.815.i = getelementptr i8, ptr %lsr.iv24, i64 %.1139.i
  %.817.i = load double, ptr %.815.i, align 8, !noalias !5
  %.823.i = fsub double %.13.i6.i, %.817.i
  %.827.i = fdiv double %.678.i, %.13.i6.i
  %.831.i = fdiv double %.714.i, %.13.i6.i
  %.835.i = fdiv double %.750.i, %.13.i6.i
  br label %part.1

B610.endif.i:                                     ; preds = %B136.us
  %.884.i = load double, ptr %.524.us, align 8, !noalias !5
  %.913.i = getelementptr i8, ptr %lsr.iv24, i64 %.911.i
  %.915.i = load double, ptr %.913.i, align 8, !noalias !5
  %.916.i = fsub double %.884.i, %.915.i
  %.947.i = load double, ptr %.945.i, align 8, !noalias !5
  %.976.i = getelementptr i8, ptr %lsr.iv24, i64 %.974.i
  %.978.i = load double, ptr %.976.i, align 8, !noalias !5
  %.979.i = fsub double %.947.i, %.978.i
  %.1010.i = load double, ptr %.1008.i, align 8, !noalias !5
  %.1044.i = getelementptr i8, ptr %lsr.iv24, i64 %.1042.i
  %.1046.i = load double, ptr %.1044.i, align 8, !noalias !5
  %.1047.i = fsub double %.1010.i, %.1046.i
  %.1079.i = fmul double %.916.i, %.321.i
  %.1108.i = getelementptr i8, ptr %lsr.iv24, i64 %.1106.i
  %.1110.i = load double, ptr %.1108.i, align 8, !noalias !5
  %.1111.i = fmul double %.979.i, %.1110.i
  %.1112.i = fadd double %.1079.i, %.1111.i
  %.1141.i = getelementptr i8, ptr %lsr.iv24, i64 %.1139.i
  %.1143.i = load double, ptr %.1141.i, align 8, !noalias !5
  %.1144.i = fmul double %.1047.i, %.1143.i
  %.1145.i = fadd double %.1112.i, %.1144.i
  %.1174.i = getelementptr i8, ptr %lsr.iv24, i64 %.1172.i
  %.1176.i = load double, ptr %.1174.i, align 8, !noalias !5
  %.1177.i = fmul double %.916.i, %.1176.i
  %.1206.i = getelementptr i8, ptr %lsr.iv24, i64 %.1204.i
  %.1208.i = load double, ptr %.1206.i, align 8, !noalias !5
  %.1209.i = fmul double %.979.i, %.1208.i
  %.1210.i = fadd double %.1177.i, %.1209.i
  %.1239.i = getelementptr i8, ptr %lsr.iv24, i64 %.1237.i
  %.1241.i = load double, ptr %.1239.i, align 8, !noalias !5
  %.1242.i = fmul double %.1047.i, %.1241.i
  %.1243.i = fadd double %.1210.i, %.1242.i
  %.1272.i = getelementptr i8, ptr %lsr.iv24, i64 %.1270.i
  %.1274.i = load double, ptr %.1272.i, align 8, !noalias !5
  %.1275.i = fmul double %.916.i, %.1274.i
  %.1304.i = getelementptr i8, ptr %lsr.iv24, i64 %.1302.i
  %.1306.i = load double, ptr %.1304.i, align 8, !noalias !5
  %.1307.i = fmul double %.979.i, %.1306.i
  %.1308.i = fadd double %.1275.i, %.1307.i
  %.1337.i = getelementptr i8, ptr %lsr.iv24, i64 %.1335.i
  %.1339.i = load double, ptr %.1337.i, align 8, !noalias !5
  %.1340.i = fmul double %.1047.i, %.1339.i
  %.1341.i = fadd double %.1308.i, %.1340.i
  %.1352.i = tail call double @llvm.fabs.f64(double %.1145.i)
  %.1381.i = getelementptr i8, ptr %lsr.iv24, i64 %.1379.i
  %.1383.i = load double, ptr %.1381.i, align 8, !noalias !5
  %.1384.i = fsub double %.1352.i, %.1383.i
  %.1386.i = tail call double @llvm.fabs.f64(double %.1243.i)
  %.1415.i = getelementptr i8, ptr %lsr.iv24, i64 %.1413.i
  %.1417.i = load double, ptr %.1415.i, align 8, !noalias !5
  %.1418.i = fsub double %.1386.i, %.1417.i
  %.1420.i = tail call double @llvm.fabs.f64(double %.1341.i)
  %.1449.i = getelementptr i8, ptr %lsr.iv24, i64 %.1447.i
  %.1451.i = load double, ptr %.1449.i, align 8, !noalias !5
  %.1452.i = fsub double %.1420.i, %.1451.i
  %.16.i.i = fcmp ogt double %.1418.i, %.1384.i
  %.17.i.i = select i1 %.16.i.i, double %.1418.i, double %.1384.i
  %.18.i.i = fcmp ogt double %.1452.i, %.17.i.i
  %.19.i.i = select i1 %.18.i.i, double %.1452.i, double %.17.i.i
  %.1500.i = fcmp ugt double %.19.i.i, 0.000000e+00
  br i1 %.1500.i, label %B1158.endif.endif.endif.i, label %B1112.i

B1158.endif.endif.endif.i:                        ; preds = %B610.endif.i
  %.12.i1.i = fcmp olt double %.1384.i, 0.000000e+00
  %.13.i2.i = select i1 %.12.i1.i, double 0.000000e+00, double %.1384.i
  %.12.i7.i = fcmp olt double %.1418.i, 0.000000e+00
  %.13.i8.i = select i1 %.12.i7.i, double 0.000000e+00, double %.1418.i
  %.12.i9.i = fcmp olt double %.1452.i, 0.000000e+00
  %.13.i10.i = select i1 %.12.i9.i, double 0.000000e+00, double %.1452.i
  %.1717.i = fmul double %.13.i2.i, %.13.i2.i
  %.1718.i = fmul double %.13.i8.i, %.13.i8.i
  %.1719.i = fadd double %.1717.i, %.1718.i
  %.1720.i = fmul double %.13.i10.i, %.13.i10.i
  %.1721.i = fadd double %.1719.i, %.1720.i
  %sqrt669.i = tail call double @llvm.sqrt.f64(double %.1721.i)
  %.1728.i = fdiv double %.13.i2.i, %sqrt669.i
  %.1732.i = fdiv double %.13.i8.i, %sqrt669.i
  %.1736.i = fdiv double %.13.i10.i, %sqrt669.i
  br label %B1344.i

part.1: ; preds = %B1344.i, %B328.endif.endif.endif.i
  %.823.sink.i = phi double [ %.823.i, %B328.endif.endif.endif.i ], [ %far.3.0.i, %B1344.i ]
  %.827.sink.i = phi double [ %.827.i, %B328.endif.endif.endif.i ], [ %.1862.i, %B1344.i ]
  %.831.sink.i = phi double [ %.831.i, %B328.endif.endif.endif.i ], [ %.1960.i, %B1344.i ]
  %.835.sink.i = phi double [ %.835.i, %B328.endif.endif.endif.i ], [ %.2063.i, %B1344.i ]
  %.619.us = fsub double %arg.tip, %.823.sink.i
  %.674.us = load double, ptr %.274.us, align 8
  %.675.us = fcmp ogt double %.619.us, %.674.us
  br i1 %.675.us, label %B242.endif.endif.endif.endif.endif.endif.us, label %B488.us

B242.endif.endif.endif.endif.endif.endif.us:      ; preds = %part.1
  %scevgep26 = getelementptr i8, ptr %lsr.iv24, i64 %arg.shapes.6.1
  %.707.us = load double, ptr %scevgep26, align 8
  %.775.us = load double, ptr %sunkaddr32, align 8
  %.838.us = load double, ptr %sunkaddr33, align 8
  %.901.us = load double, ptr %sunkaddr34, align 8
  store double %.619.us, ptr %.274.us, align 8
  store double %.827.sink.i, ptr %sunkaddr36, align 8
  store double %.831.sink.i, ptr %sunkaddr37, align 8
  store double %.835.sink.i, ptr %sunkaddr38, align 8
  %.12.i = fcmp ogt double %.619.us, 0.000000e+00
  %.13.i = select i1 %.12.i, double %.619.us, double 0.000000e+00
  %.717.us = fdiv double 1.000000e+00, %.707.us
  %.720.us = fmul double %.827.sink.i, %.827.sink.i
  %.779.us = fdiv double %.720.us, %.775.us
  %.780.us = fadd double %.717.us, %.779.us
  %.783.us = fmul double %.831.sink.i, %.831.sink.i
  %.842.us = fdiv double %.783.us, %.838.us
  %.843.us = fadd double %.780.us, %.842.us
  %.846.us = fmul double %.835.sink.i, %.835.sink.i
  %.905.us = fdiv double %.846.us, %.901.us
  %.906.us = fadd double %.843.us, %.905.us
  %.1199.us = fdiv double %.13.i, %.906.us
  store double %.1199.us, ptr %sunkaddr39, align 8
  br label %B488.us

B488.us:                                          ; preds = %B242.endif.endif.endif.endif.endif.endif.us, %part.1
  %scevgep25 = getelementptr i8, ptr %lsr.iv24, i64 %arg.shapes.6.0
  %lsr.iv.next28 = add nsw i64 %lsr.iv27, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next28, 0
  br i1 %exitcond.not, label %B134.B60.loopexit_crit_edge.us, label %B136.us

B134.B60.loopexit_crit_edge.us:                   ; preds = %B488.us
  %.194.us = add nuw nsw i64 %.187551559.us, 1
  %exitcond595.not = icmp eq i64 %.194.us, %arg.p.5.0
  br i1 %exitcond595.not, label %B492, label %B62.endif.us

B492.loopexit.unr-lcssa:                          ; preds = %B62.endif
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B492, label %B62.endif.epil.preheader

B62.endif.epil.preheader:                         ; preds = %B492.loopexit.unr-lcssa, %B62.endif.preheader
  %.187551559.epil.init = phi i64 [ 0, %B62.endif.preheader ], [ %unroll_iter, %B492.loopexit.unr-lcssa ]
  %3 = mul i64 %.187551559.epil.init, %arg.out.6.0
  %scevgep = getelementptr i8, ptr %arg.out.4, i64 %3
  br label %B62.endif.epil

B62.endif.epil:                                   ; preds = %B62.endif.epil, %B62.endif.epil.preheader
  %lsr.iv18 = phi i64 [ %lsr.iv.next, %B62.endif.epil ], [ %xtraiter, %B62.endif.epil.preheader ]
  %lsr.iv = phi ptr [ %scevgep17, %B62.endif.epil ], [ %scevgep, %B62.endif.epil.preheader ]
  store double -1.000000e+300, ptr %lsr.iv, align 8
  %scevgep17 = getelementptr i8, ptr %lsr.iv, i64 %arg.out.6.0
  %lsr.iv.next = add nsw i64 %lsr.iv18, -1
  %epil.iter.cmp.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %epil.iter.cmp.not, label %B492, label %B62.endif.epil, !llvm.loop !8

B492:                                             ; preds = %B134.B60.loopexit_crit_edge.us, %B62.endif.epil, %B492.loopexit.unr-lcssa, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B62.endif:                                        ; preds = %B62.endif, %B62.endif.preheader.new
  %lsr.iv19 = phi ptr [ %scevgep20, %B62.endif ], [ %arg.out.4, %B62.endif.preheader.new ]
  %.187551559 = phi i64 [ %.194.3, %B62.endif ], [ 0, %B62.endif.preheader.new ]
  store double -1.000000e+300, ptr %lsr.iv19, align 8
  %scevgep23 = getelementptr i8, ptr %lsr.iv19, i64 %arg.out.6.0
  store double -1.000000e+300, ptr %scevgep23, align 8
  %sunkaddr41 = getelementptr i8, ptr %lsr.iv19, i64 %sunkaddr40
  store double -1.000000e+300, ptr %sunkaddr41, align 8
  %.194.3 = add nuw nsw i64 %.187551559, 4
  %scevgep21 = getelementptr i8, ptr %lsr.iv19, i64 %1
  store double -1.000000e+300, ptr %scevgep21, align 8
  %scevgep20 = getelementptr i8, ptr %lsr.iv19, i64 %2
  %niter.ncmp.3 = icmp eq i64 %unroll_iter, %.194.3
  br i1 %niter.ncmp.3, label %B492.loopexit.unr-lcssa, label %B62.endif
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef range(i32 -1, -2) i32 @loops.replay(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, double %arg.h, i64 %arg.slerp, i64 %arg.speed, ptr readnone captures(none) %arg.u.0, ptr readnone captures(none) %arg.u.1, i64 %arg.u.2, i64 %arg.u.3, ptr readonly captures(none) %arg.u.4, i64 %arg.u.5.0, i64 %arg.u.5.1, i64 %arg.u.6.0, i64 %arg.u.6.1, ptr readnone captures(none) %arg.q_e.0, ptr readnone captures(none) %arg.q_e.1, i64 %arg.q_e.2, i64 %arg.q_e.3, ptr readonly captures(none) %arg.q_e.4, i64 %arg.q_e.5.0, i64 %arg.q_e.5.1, i64 %arg.q_e.6.0, i64 %arg.q_e.6.1, ptr readnone captures(none) %arg.starts.0, ptr readnone captures(none) %arg.starts.1, i64 %arg.starts.2, i64 %arg.starts.3, ptr readonly captures(none) %arg.starts.4, i64 %arg.starts.5.0, i64 %arg.starts.6.0, ptr readnone captures(none) %arg.laws.0, ptr readnone captures(none) %arg.laws.1, i64 %arg.laws.2, i64 %arg.laws.3, ptr readonly captures(none) %arg.laws.4, i64 %arg.laws.5.0, i64 %arg.laws.5.1, i64 %arg.laws.5.2, i64 %arg.laws.6.0, i64 %arg.laws.6.1, i64 %arg.laws.6.2, ptr readnone captures(none) %arg.kept.0, ptr readnone captures(none) %arg.kept.1, i64 %arg.kept.2, i64 %arg.kept.3, ptr readonly captures(none) %arg.kept.4, i64 %arg.kept.5.0, i64 %arg.kept.5.1, i64 %arg.kept.5.2, i64 %arg.kept.6.0, i64 %arg.kept.6.1, i64 %arg.kept.6.2, ptr readnone captures(none) %arg.bounds.0, ptr readnone captures(none) %arg.bounds.1, i64 %arg.bounds.2, i64 %arg.bounds.3, ptr readonly captures(none) %arg.bounds.4, i64 %arg.bounds.5.0, i64 %arg.bounds.5.1, i64 %arg.bounds.6.0, i64 %arg.bounds.6.1, ptr readnone captures(none) %arg.told.0, ptr readnone captures(none) %arg.told.1, i64 %arg.told.2, i64 %arg.told.3, ptr readonly captures(none) %arg.told.4, i64 %arg.told.5.0, i64 %arg.told.5.1, i64 %arg.told.6.0, i64 %arg.told.6.1, ptr readnone captures(none) %arg.shapes.0, ptr readnone captures(none) %arg.shapes.1, i64 %arg.shapes.2, i64 %arg.shapes.3, ptr readonly captures(none) %arg.shapes.4, i64 %arg.shapes.5.0, i64 %arg.shapes.5.1, i64 %arg.shapes.6.0, i64 %arg.shapes.6.1, double %arg.tip, ptr readnone captures(none) %arg.p_0.0, ptr readnone captures(none) %arg.p_0.1, i64 %arg.p_0.2, i64 %arg.p_0.3, ptr readonly captures(none) %arg.p_0.4, i64 %arg.p_0.5.0, i64 %arg.p_0.6.0, ptr readnone captures(none) %arg.q_0.0, ptr readnone captures(none) %arg.q_0.1, i64 %arg.q_0.2, i64 %arg.q_0.3, ptr readonly captures(none) %arg.q_0.4, i64 %arg.q_0.5.0, i64 %arg.q_0.6.0, ptr readnone captures(none) %arg.x.0, ptr readnone captures(none) %arg.x.1, i64 %arg.x.2, i64 %arg.x.3, ptr captures(none) initializes((0, 8)) %arg.x.4, i64 %arg.x.5.0, i64 %arg.x.5.1, i64 %arg.x.6.0, i64 %arg.x.6.1, ptr readnone captures(none) %arg.q.0, ptr readnone captures(none) %arg.q.1, i64 %arg.q.2, i64 %arg.q.3, ptr writeonly captures(none) %arg.q.4, i64 %arg.q.5.0, i64 %arg.q.5.1, i64 %arg.q.6.0, i64 %arg.q.6.1, ptr readnone captures(none) %arg.force.0, ptr readnone captures(none) %arg.force.1, i64 %arg.force.2, i64 %arg.force.3, ptr captures(none) %arg.force.4, i64 %arg.force.5.0, i64 %arg.force.5.1, i64 %arg.force.6.0, i64 %arg.force.6.1, ptr readnone captures(none) %arg.depth.0, ptr readnone captures(none) %arg.depth.1, i64 %arg.depth.2, i64 %arg.depth.3, ptr writeonly captures(none) %arg.depth.4, i64 %arg.depth.5.0, i64 %arg.depth.6.0, ptr readnone captures(none) %arg.room.0, ptr readnone captures(none) %arg.room.1, i64 %arg.room.2, i64 %arg.room.3, ptr captures(none) initializes((0, 8)) %arg.room.4, i64 %arg.room.5.0, i64 %arg.room.5.1, i64 %arg.room.6.0, i64 %arg.room.6.1) local_unnamed_addr #0 {
B178.5:
  %.332 = load double, ptr %arg.q_0.4, align 8
  %.361 = getelementptr i8, ptr %arg.q_0.4, i64 %arg.q_0.6.0
  %.363 = load double, ptr %.361, align 8
  %.390 = shl i64 %arg.q_0.6.0, 1
  %.392 = getelementptr i8, ptr %arg.q_0.4, i64 %.390
  %.394 = load double, ptr %.392, align 8
  %.421 = mul i64 %arg.q_0.6.0, 3
  %.423 = getelementptr i8, ptr %arg.q_0.4, i64 %.421
  %.425 = load double, ptr %.423, align 8
  store double 0.000000e+00, ptr %arg.room.4, align 8
  %.807 = load double, ptr %arg.p_0.4, align 8
  store double %.807, ptr %arg.x.4, align 8
  %.770.1 = getelementptr i8, ptr %arg.room.4, i64 %arg.room.6.1
  store double 0.000000e+00, ptr %.770.1, align 8
  %.805.1 = getelementptr i8, ptr %arg.p_0.4, i64 %arg.p_0.6.0
  %.807.1 = load double, ptr %.805.1, align 8
  %.870.1 = getelementptr i8, ptr %arg.x.4, i64 %arg.x.6.1
  store double %.807.1, ptr %.870.1, align 8
  %.768.2 = shl i64 %arg.room.6.1, 1
  %.770.2 = getelementptr i8, ptr %arg.room.4, i64 %.768.2
  store double 0.000000e+00, ptr %.770.2, align 8
  %.803.2 = shl i64 %arg.p_0.6.0, 1
  %.805.2 = getelementptr i8, ptr %arg.p_0.4, i64 %.803.2
  %.807.2 = load double, ptr %.805.2, align 8
  %.867.2 = shl i64 %arg.x.6.1, 1
  %.870.2 = getelementptr i8, ptr %arg.x.4, i64 %.867.2
  store double %.807.2, ptr %.870.2, align 8
  %.768.3 = mul i64 %arg.room.6.1, 3
  %.770.3 = getelementptr i8, ptr %arg.room.4, i64 %.768.3
  store double 0.000000e+00, ptr %.770.3, align 8
  %.867.3 = mul i64 %arg.x.6.1, 3
  %.870.3 = getelementptr i8, ptr %arg.x.4, i64 %.867.3
  store double 0.000000e+00, ptr %.870.3, align 8
  %.768.4 = shl i64 %arg.room.6.1, 2
  %.770.4 = getelementptr i8, ptr %arg.room.4, i64 %.768.4
  store double 0.000000e+00, ptr %.770.4, align 8
  %.867.4 = shl i64 %arg.x.6.1, 2
  %.870.4 = getelementptr i8, ptr %arg.x.4, i64 %.867.4
  store double 0.000000e+00, ptr %.870.4, align 8
  %.768.5 = mul i64 %arg.room.6.1, 5
  %.770.5 = getelementptr i8, ptr %arg.room.4, i64 %.768.5
  store double 0.000000e+00, ptr %.770.5, align 8
  %.867.5 = mul i64 %arg.x.6.1, 5
  %.870.5 = getelementptr i8, ptr %arg.x.4, i64 %.867.5
  store double 0.000000e+00, ptr %.870.5, align 8
  %.563 = getelementptr i8, ptr %arg.room.4, i64 %arg.room.6.0
  %invariant.gep = getelementptr i8, ptr %arg.q.4, i64 %arg.q.6.1
  %invariant.gep2617 = getelementptr i8, ptr %arg.q_e.4, i64 %arg.q_e.6.1
  %.10202720.not = icmp slt i64 %arg.u.5.0, 1
  br i1 %.10202720.not, label %common.ret, label %B252.lr.ph

B252:                                             ; preds = %B252.backedge, %B252.lr.ph
  %law.2.02737 = phi i64 [ 0, %B252.lr.ph ], [ %law.3.1, %B252.backedge ]
  %last.2.sroa.0.02736 = phi double [ %.332, %B252.lr.ph ], [ %at.3.sroa.0.1, %B252.backedge ]
  %last.2.sroa.12.02735 = phi double [ %.363, %B252.lr.ph ], [ %at.3.sroa.17.1, %B252.backedge ]
  %last.2.sroa.24.02734 = phi double [ %.394, %B252.lr.ph ], [ %at.3.sroa.34.1, %B252.backedge ]
  %last.2.sroa.36.02733 = phi double [ %.425, %B252.lr.ph ], [ %at.3.sroa.51.1, %B252.backedge ]
  %at.4.sroa.0.02732 = phi double [ %.332, %B252.lr.ph ], [ %at.4.sroa.0.02732.be, %B252.backedge ]
  %at.4.sroa.10.02731 = phi double [ %.363, %B252.lr.ph ], [ %at.4.sroa.10.02731.be, %B252.backedge ]
  %at.4.sroa.20.02730 = phi double [ %.394, %B252.lr.ph ], [ %at.4.sroa.20.02730.be, %B252.backedge ]
  %at.4.sroa.30.02729 = phi double [ %.425, %B252.lr.ph ], [ %at.4.sroa.30.02729.be, %B252.backedge ]
  %.102626342727 = phi i64 [ 0, %B252.lr.ph ], [ %.1033, %B252.backedge ]
  %.1033 = add nuw nsw i64 %.102626342727, 1
  %.1066 = add nsw i64 %law.2.02737, 1
  %.1077 = icmp slt i64 %.1066, %arg.starts.5.0
  br i1 %.1077, label %B298, label %B412

B298:                                             ; preds = %B252
  %.1103 = icmp slt i64 %law.2.02737, -1
  %.1104 = select i1 %.1103, i64 %arg.starts.5.0, i64 0
  %.1105 = add i64 %.1104, %.1066
  %.1116 = mul i64 %.1105, %arg.starts.6.0
  %.1118 = getelementptr i8, ptr %arg.starts.4, i64 %.1116
  %.1120 = load i64, ptr %.1118, align 8
  %.1122.not = icmp sgt i64 %.1120, %.102626342727
  br i1 %.1122.not, label %B412, label %B328.preheader

B328.preheader:                                   ; preds = %B298
  %0 = add i64 %law.2.02737, 2
  br label %B328

B328:                                             ; preds = %B382, %B328.preheader
  %lsr.iv = phi i64 [ %0, %B328.preheader ], [ %lsr.iv.next, %B382 ]
  %exitcond.not6 = icmp eq i64 %lsr.iv, %arg.starts.5.0
  br i1 %exitcond.not6, label %B412, label %B382

B382:                                             ; preds = %B328
  %.1174 = icmp ugt i64 %lsr.iv, -9223372036854775807
  %.1175 = select i1 %.1174, i64 %arg.starts.5.0, i64 0
  %1 = add i64 %.1175, %lsr.iv
  %.1187 = mul i64 %1, %arg.starts.6.0
  %.1189 = getelementptr i8, ptr %arg.starts.4, i64 %.1187
  %.1191 = load i64, ptr %.1189, align 8
  %.1193.not = icmp sgt i64 %.1191, %.102626342727
  %lsr.iv.next = add i64 %lsr.iv, 1
  br i1 %.1193.not, label %B382.B412.loopexit_crit_edge, label %B328

B382.B412.loopexit_crit_edge:                     ; preds = %B382
  %2 = add nsw i64 %lsr.iv, -1
  br label %B412

B412:                                             ; preds = %B328, %B382.B412.loopexit_crit_edge, %B298, %B252
  %law.3.1 = phi i64 [ %law.2.02737, %B298 ], [ %law.2.02737, %B252 ], [ %2, %B382.B412.loopexit_crit_edge ], [ %20, %B328 ]
  br i1 %22, label %B424.endif, label %B590

B590:                                             ; preds = %B424.endif, %B412
  %at.3.sroa.51.1 = phi double [ %at.4.sroa.30.02729, %B412 ], [ %.87.i58, %B424.endif ]
  %at.3.sroa.34.1 = phi double [ %at.4.sroa.20.02730, %B412 ], [ %.80.i, %B424.endif ]
  %at.3.sroa.17.1 = phi double [ %at.4.sroa.10.02731, %B412 ], [ %.73.i, %B424.endif ]
  %at.3.sroa.0.1 = phi double [ %at.4.sroa.0.02732, %B412 ], [ %.66.i, %B424.endif ]
  %.1666 = mul i64 %.102626342727, %arg.q.6.0
  %.1670 = getelementptr i8, ptr %arg.q.4, i64 %.1666
  store double %at.3.sroa.0.1, ptr %.1670, align 8
  %gep = getelementptr i8, ptr %invariant.gep, i64 %.1666
  store double %at.3.sroa.17.1, ptr %gep, align 8
  %gep2753 = getelementptr i8, ptr %invariant.gep2752, i64 %.1666
  store double %at.3.sroa.34.1, ptr %gep2753, align 8
  %gep2755 = getelementptr i8, ptr %invariant.gep2754, i64 %.1666
  store double %at.3.sroa.51.1, ptr %gep2755, align 8
  br i1 %23, label %B590.B996.endif.endif_crit_edge, label %B674.endif

B590.B996.endif.endif_crit_edge:                  ; preds = %B590
  %.pre2921 = mul i64 %.102626342727, %arg.force.6.0
  br label %B996.endif.endif

common.ret:                                       ; preds = %B1270.split.us, %B178.5
  store ptr null, ptr %retptr, align 8
  ret i32 0

B1320:                                            ; preds = %B1270.split.us
  %.3568 = mul i64 %.102626342727, %arg.q_e.6.0
  %.3572 = getelementptr i8, ptr %arg.q_e.4, i64 %.3568
  %.3574 = load double, ptr %.3572, align 8
  %gep2618 = getelementptr i8, ptr %invariant.gep2617, i64 %.3568
  %.3629 = load double, ptr %gep2618, align 8
  %gep2761 = getelementptr i8, ptr %invariant.gep2760, i64 %.3568
  %.3684 = load double, ptr %gep2761, align 8
  %gep2763 = getelementptr i8, ptr %invariant.gep2762, i64 %.3568
  %.3739 = load double, ptr %gep2763, align 8
  %.60.i.i14 = fmul double %at.3.sroa.0.1, %.3574
  %3 = fmul double %at.3.sroa.17.1, %.3629
  %.62.i.i15 = fadd double %.60.i.i14, %3
  %4 = fmul double %at.3.sroa.34.1, %.3684
  %.64.i.i16 = fadd double %.62.i.i15, %4
  %5 = fmul double %at.3.sroa.51.1, %.3739
  %.66.i.i17 = fadd double %.64.i.i16, %5
  %.68.i.i18 = fmul double %at.3.sroa.17.1, %.3574
  %6 = fmul double %at.3.sroa.0.1, %.3629
  %.69.i.i19 = fsub double %.68.i.i18, %6
  %7 = fmul double %at.3.sroa.34.1, %.3739
  %.71.i.i20 = fsub double %.69.i.i19, %7
  %8 = fmul double %at.3.sroa.51.1, %.3684
  %.73.i.i21 = fadd double %8, %.71.i.i20
  %.75.i.i22 = fmul double %at.3.sroa.34.1, %.3574
  %9 = fmul double %at.3.sroa.0.1, %.3684
  %.76.i.i23 = fsub double %.75.i.i22, %9
  %10 = fmul double %at.3.sroa.51.1, %.3629
  %.78.i.i24 = fsub double %.76.i.i23, %10
  %11 = fmul double %at.3.sroa.17.1, %.3739
  %.80.i.i25 = fadd double %11, %.78.i.i24
  %.82.i.i = fmul double %at.3.sroa.51.1, %.3574
  %12 = fmul double %at.3.sroa.0.1, %.3739
  %.83.i.i26 = fsub double %.82.i.i, %12
  %13 = fmul double %at.3.sroa.17.1, %.3684
  %.85.i.i27 = fsub double %.83.i.i26, %13
  %14 = fmul double %at.3.sroa.34.1, %.3629
  %.87.i.i28 = fadd double %14, %.85.i.i27
  %.136.i = fcmp olt double %.66.i.i17, 0.000000e+00
  br i1 %.136.i, label %B120.i, label %B150.i

B120.i:                                           ; preds = %B1320
  %.139.i = fneg double %.66.i.i17
  %.143.i = fneg double %.73.i.i21
  %.147.i = fneg double %.80.i.i25
  %.151.i = fneg double %.87.i.i28
  br label %B150.i

B150.i:                                           ; preds = %B120.i, %B1320
  %w.2.0.i = phi double [ %.139.i, %B120.i ], [ %.66.i.i17, %B1320 ]
  %x.2.0.i = phi double [ %.143.i, %B120.i ], [ %.73.i.i21, %B1320 ]
  %y.2.0.i = phi double [ %.147.i, %B120.i ], [ %.80.i.i25, %B1320 ]
  %z.2.0.i = phi double [ %.151.i, %B120.i ], [ %.87.i.i28, %B1320 ]
  %.197.i = fmul double %x.2.0.i, %x.2.0.i
  %.200.i = fmul double %y.2.0.i, %y.2.0.i
  %.201.i = fadd double %.197.i, %.200.i
  %.204.i = fmul double %z.2.0.i, %z.2.0.i
  %.205.i = fadd double %.201.i, %.204.i
  %.212.i = fcmp ogt double %.205.i, 0.000000e+00
  br i1 %.212.i, label %B222.endif.i, label %B1320.endif

B222.endif.i:                                     ; preds = %B150.i
  %sqrt.i = tail call double @llvm.sqrt.f64(double %.205.i)
  %.216.i = tail call double @atan2(double %sqrt.i, double %w.2.0.i)
  %.220.i = fmul double %.216.i, 2.000000e+00
  %.225.i = fdiv double %.220.i, %sqrt.i
  br label %B1320.endif

B1802.thread:                                     ; preds = %B222.endif.i163, %B150.i146
  %"$phi268.0.2.0.i157" = phi double [ %.225.i167, %B222.endif.i163 ], [ 0.000000e+00, %B150.i146 ]
  %.243.i158 = fmul double %x.2.0.i148, %"$phi268.0.2.0.i157"
  %.247.i159 = fmul double %y.2.0.i149, %"$phi268.0.2.0.i157"
  %.251.i160 = fmul double %z.2.0.i150, %"$phi268.0.2.0.i157"
  %.4219 = select i1 %.3025, i64 %arg.laws.5.0, i64 0
  %.4220 = add i64 %.4219, %law.3.1
  %.4244 = mul i64 %.4220, %arg.laws.6.0
  %15 = getelementptr i8, ptr %arg.laws.4, i64 %.4244
  %.4606 = mul i64 %.102626342727, %arg.x.6.0
  %16 = getelementptr i8, ptr %arg.x.4, i64 %.4606
  %.4662 = mul i64 %.102626342727, %arg.u.6.0
  %17 = getelementptr i8, ptr %arg.u.4, i64 %.4662
  %.4759 = mul i64 %.1033, %arg.u.6.0
  %18 = getelementptr i8, ptr %arg.u.4, i64 %.4759
  %.5137 = mul i64 %.1033, %arg.x.6.0
  %19 = getelementptr i8, ptr %arg.x.4, i64 %.5137
  %.4312 = load double, ptr %15, align 8
  %.4340 = getelementptr i8, ptr %15, i64 %arg.laws.6.2
  %.4342 = load double, ptr %.4340, align 8
  %sunkaddr210 = getelementptr i8, ptr %15, i64 %sunkaddr
  %.4372 = load double, ptr %sunkaddr210, align 8
  %.4400 = getelementptr i8, ptr %15, i64 %.4398
  %.4402 = load double, ptr %.4400, align 8
  %sunkaddr212 = getelementptr i8, ptr %15, i64 %sunkaddr211
  %.4432 = load double, ptr %sunkaddr212, align 8
  %.4460 = getelementptr i8, ptr %15, i64 %.4458
  %.4462 = load double, ptr %.4460, align 8
  %.4612 = load double, ptr %16, align 8
  %.4668 = load double, ptr %17, align 8
  %.4671 = fsub double %.4612, %.4668
  br i1 %25, label %B1892.endif, label %B1802.thread.1

B1802.thread.1:                                   ; preds = %B1892.endif, %B1802.thread
  %v_e.2.2 = phi double [ %.4833, %B1892.endif ], [ 0.000000e+00, %B1802.thread ]
  %.4870 = load double, ptr %arg.room.4, align 8
  %.4872 = fsub double %.4870, %v_e.2.2
  %.4918 = load double, ptr %.563, align 8
  %.4928 = fmul double %.4312, %.4872
  %.4932 = fadd double %v_e.2.2, %.4928
  %.4937 = fmul double %.4342, %.4671
  %.4942 = fadd double %.4937, %.4932
  %.4976 = fmul double %.4372, %.4918
  %.4979 = fadd double %.4976, %.4942
  store double %.4979, ptr %arg.room.4, align 8
  %.4920 = fmul double %.4462, %.4918
  %.4883 = fmul double %.4432, %.4671
  %.4875 = fmul double %arg.h, %v_e.2.2
  %.4877 = fmul double %.4402, %.4872
  %.4880 = fadd double %.4875, %.4877
  %.4886 = fadd double %.4883, %.4880
  %.4923 = fadd double %.4920, %.4886
  %.5076 = load double, ptr %16, align 8
  %.5080 = fadd double %.5076, %.4923
  store double %.5080, ptr %19, align 8
  %.4248.1 = getelementptr i8, ptr %15, i64 %arg.laws.6.1
  %.4312.1 = load double, ptr %.4248.1, align 8
  %.4340.1 = getelementptr i8, ptr %.4248.1, i64 %arg.laws.6.2
  %.4342.1 = load double, ptr %.4340.1, align 8
  %sunkaddr214 = getelementptr i8, ptr %.4248.1, i64 %sunkaddr
  %.4372.1 = load double, ptr %sunkaddr214, align 8
  %.4400.1 = getelementptr i8, ptr %.4248.1, i64 %.4398
  %.4402.1 = load double, ptr %.4400.1, align 8
  %sunkaddr216 = getelementptr i8, ptr %.4248.1, i64 %sunkaddr211
  %.4432.1 = load double, ptr %sunkaddr216, align 8
  %.4460.1 = getelementptr i8, ptr %.4248.1, i64 %.4458
  %.4462.1 = load double, ptr %.4460.1, align 8
  %.4610.1 = getelementptr i8, ptr %16, i64 %arg.x.6.1
  %.4612.1 = load double, ptr %.4610.1, align 8
  %.4666.1 = getelementptr i8, ptr %17, i64 %arg.u.6.1
  %.4668.1 = load double, ptr %.4666.1, align 8
  %.4671.1 = fsub double %.4612.1, %.4668.1
  br i1 %25, label %B1892.endif.1, label %B1802.thread.2

B1892.endif.1:                                    ; preds = %B1802.thread.1
  %.4763.1 = getelementptr i8, ptr %18, i64 %arg.u.6.1
  %.4765.1 = load double, ptr %.4763.1, align 8
  %.4824.1 = fsub double %.4765.1, %.4668.1
  %.4833.1 = fdiv double %.4824.1, %arg.h
  br label %B1802.thread.2

B1802.thread.2:                                   ; preds = %B1892.endif.1, %B1802.thread.1
  %v_e.2.2.1 = phi double [ %.4833.1, %B1892.endif.1 ], [ 0.000000e+00, %B1802.thread.1 ]
  %.4870.1 = load double, ptr %.770.1, align 8
  %.4872.1 = fsub double %.4870.1, %v_e.2.2.1
  %.4918.1 = load double, ptr %sunkaddr218, align 8
  %.4928.1 = fmul double %.4312.1, %.4872.1
  %.4932.1 = fadd double %v_e.2.2.1, %.4928.1
  %.4937.1 = fmul double %.4342.1, %.4671.1
  %.4942.1 = fadd double %.4937.1, %.4932.1
  %.4976.1 = fmul double %.4372.1, %.4918.1
  %.4979.1 = fadd double %.4976.1, %.4942.1
  store double %.4979.1, ptr %.770.1, align 8
  %.4920.1 = fmul double %.4462.1, %.4918.1
  %.4883.1 = fmul double %.4432.1, %.4671.1
  %.4875.1 = fmul double %arg.h, %v_e.2.2.1
  %.4877.1 = fmul double %.4402.1, %.4872.1
  %.4880.1 = fadd double %.4875.1, %.4877.1
  %.4886.1 = fadd double %.4883.1, %.4880.1
  %.4923.1 = fadd double %.4920.1, %.4886.1
  %.5076.1 = load double, ptr %.4610.1, align 8
  %.5080.1 = fadd double %.5076.1, %.4923.1
  %.5141.1 = getelementptr i8, ptr %19, i64 %arg.x.6.1
  store double %.5080.1, ptr %.5141.1, align 8
  %.4248.2 = getelementptr i8, ptr %15, i64 %.4245.2
  %.4312.2 = load double, ptr %.4248.2, align 8
  %.4340.2 = getelementptr i8, ptr %.4248.2, i64 %arg.laws.6.2
  %.4342.2 = load double, ptr %.4340.2, align 8
  %sunkaddr220 = getelementptr i8, ptr %.4248.2, i64 %sunkaddr
  %.4372.2 = load double, ptr %sunkaddr220, align 8
  %.4400.2 = getelementptr i8, ptr %.4248.2, i64 %.4398
  %.4402.2 = load double, ptr %.4400.2, align 8
  %sunkaddr222 = getelementptr i8, ptr %.4248.2, i64 %sunkaddr211
  %.4432.2 = load double, ptr %sunkaddr222, align 8
  %.4460.2 = getelementptr i8, ptr %.4248.2, i64 %.4458
  %.4462.2 = load double, ptr %.4460.2, align 8
  %sunkaddr224 = getelementptr i8, ptr %16, i64 %.867.2
  %.4612.2 = load double, ptr %sunkaddr224, align 8
  %sunkaddr226 = getelementptr i8, ptr %17, i64 %sunkaddr225
  %.4668.2 = load double, ptr %sunkaddr226, align 8
  %.4671.2 = fsub double %.4612.2, %.4668.2
  br i1 %25, label %B1892.endif.2, label %B2070.2

B1892.endif.2:                                    ; preds = %B1802.thread.2
  %sunkaddr228 = getelementptr i8, ptr %18, i64 %sunkaddr225
  %.4765.2 = load double, ptr %sunkaddr228, align 8
  %.4824.2 = fsub double %.4765.2, %.4668.2
  %.4833.2 = fdiv double %.4824.2, %arg.h
  br label %B2070.2

B2070.2:                                          ; preds = %B1892.endif.2, %B1802.thread.2
  %v_e.2.2.2 = phi double [ %.4833.2, %B1892.endif.2 ], [ 0.000000e+00, %B1802.thread.2 ]
  %.4870.2 = load double, ptr %.770.2, align 8
  %.4872.2 = fsub double %.4870.2, %v_e.2.2.2
  %.4918.2 = load double, ptr %sunkaddr232, align 8
  %.4928.2 = fmul double %.4312.2, %.4872.2
  %.4932.2 = fadd double %v_e.2.2.2, %.4928.2
  %.4937.2 = fmul double %.4342.2, %.4671.2
  %.4942.2 = fadd double %.4937.2, %.4932.2
  %.4976.2 = fmul double %.4372.2, %.4918.2
  %.4979.2 = fadd double %.4976.2, %.4942.2
  store double %.4979.2, ptr %.770.2, align 8
  %.4920.2 = fmul double %.4462.2, %.4918.2
  %.4883.2 = fmul double %.4432.2, %.4671.2
  %.4875.2 = fmul double %arg.h, %v_e.2.2.2
  %.4877.2 = fmul double %.4402.2, %.4872.2
  %.4880.2 = fadd double %.4875.2, %.4877.2
  %.4886.2 = fadd double %.4883.2, %.4880.2
  %.4923.2 = fadd double %.4920.2, %.4886.2
  %.5076.2 = load double, ptr %sunkaddr224, align 8
  %.5080.2 = fadd double %.5076.2, %.4923.2
  %sunkaddr236 = getelementptr i8, ptr %19, i64 %.867.2
  store double %.5080.2, ptr %sunkaddr236, align 8
  %.4248.3 = getelementptr i8, ptr %15, i64 %.4245.3
  %.4312.3 = load double, ptr %.4248.3, align 8
  %.4340.3 = getelementptr i8, ptr %.4248.3, i64 %arg.laws.6.2
  %.4342.3 = load double, ptr %.4340.3, align 8
  %sunkaddr238 = getelementptr i8, ptr %.4248.3, i64 %sunkaddr
  %.4372.3 = load double, ptr %sunkaddr238, align 8
  %.4400.3 = getelementptr i8, ptr %.4248.3, i64 %.4398
  %.4402.3 = load double, ptr %.4400.3, align 8
  %sunkaddr240 = getelementptr i8, ptr %.4248.3, i64 %sunkaddr211
  %.4432.3 = load double, ptr %sunkaddr240, align 8
  %.4460.3 = getelementptr i8, ptr %.4248.3, i64 %.4458
  %.4462.3 = load double, ptr %.4460.3, align 8
  br i1 %26, label %B1802.3, label %B1802.thread.3

B1802.thread.3:                                   ; preds = %B2070.2
  %.4610.3 = getelementptr i8, ptr %16, i64 %.867.3
  %.4612.3 = load double, ptr %.4610.3, align 8
  %.4666.3 = getelementptr i8, ptr %17, i64 %.4663.3
  %.4668.3 = load double, ptr %.4666.3, align 8
  %.4671.3 = fsub double %.4612.3, %.4668.3
  br i1 %25, label %B1846.3, label %B1900.3

B1846.3:                                          ; preds = %B1802.thread.3
  %.4763.3 = getelementptr i8, ptr %18, i64 %.4663.3
  %.4765.3 = load double, ptr %.4763.3, align 8
  %.4824.3 = fsub double %.4765.3, %.4668.3
  br label %B1892.endif.3

B1802.3:                                          ; preds = %B2070.2
  %"$phi1802.2.2.2.3" = fmul double %x.2.0.i, %"$phi268.0.2.0.i"
  br i1 %25, label %B1892.endif.3, label %B1900.3

B1892.endif.3:                                    ; preds = %B1802.3, %B1846.3
  %"$phi1802.2.2.229252927.3" = phi double [ %.4671.3, %B1846.3 ], [ %"$phi1802.2.2.2.3", %B1802.3 ]
  %"$phi1892.2.2.3.3" = phi double [ %.4824.3, %B1846.3 ], [ %.243.i158, %B1802.3 ]
  %.4833.3 = fdiv double %"$phi1892.2.2.3.3", %arg.h
  br label %B1900.3

B1900.3:                                          ; preds = %B1892.endif.3, %B1802.3, %B1802.thread.3
  %"$phi1802.2.2.22924.3" = phi double [ %"$phi1802.2.2.229252927.3", %B1892.endif.3 ], [ %"$phi1802.2.2.2.3", %B1802.3 ], [ %.4671.3, %B1802.thread.3 ]
  %v_e.2.2.3 = phi double [ %.4833.3, %B1892.endif.3 ], [ 0.000000e+00, %B1802.3 ], [ 0.000000e+00, %B1802.thread.3 ]
  %.4870.3 = load double, ptr %.770.3, align 8
  %.4872.3 = fsub double %.4870.3, %v_e.2.2.3
  %.4875.3 = fmul double %arg.h, %v_e.2.2.3
  %.4877.3 = fmul double %.4402.3, %.4872.3
  %.4880.3 = fadd double %.4875.3, %.4877.3
  %.4883.3 = fmul double %.4432.3, %"$phi1802.2.2.22924.3"
  %.4886.3 = fadd double %.4883.3, %.4880.3
  %.4918.3 = load double, ptr %sunkaddr242, align 8
  %.4920.3 = fmul double %.4462.3, %.4918.3
  %.4923.3 = fadd double %.4920.3, %.4886.3
  %.4928.3 = fmul double %.4312.3, %.4872.3
  %.4932.3 = fadd double %v_e.2.2.3, %.4928.3
  %.4937.3 = fmul double %.4342.3, %"$phi1802.2.2.22924.3"
  %.4942.3 = fadd double %.4937.3, %.4932.3
  %.4976.3 = fmul double %.4372.3, %.4918.3
  %.4979.3 = fadd double %.4976.3, %.4942.3
  store double %.4979.3, ptr %.770.3, align 8
  br i1 %26, label %B2070.3, label %B2046.3

B2046.3:                                          ; preds = %B1900.3
  %.5074.3 = getelementptr i8, ptr %16, i64 %.867.3
  %.5076.3 = load double, ptr %.5074.3, align 8
  %.5080.3 = fadd double %.4923.3, %.5076.3
  br label %B2070.3

B2070.3:                                          ; preds = %B2046.3, %B1900.3
  %"$phi2070.2.2.2.3" = phi double [ %.5080.3, %B2046.3 ], [ %.4923.3, %B1900.3 ]
  %.5141.3 = getelementptr i8, ptr %19, i64 %.867.3
  store double %"$phi2070.2.2.2.3", ptr %.5141.3, align 8
  %.4248.4 = getelementptr i8, ptr %15, i64 %.4245.4
  %.4312.4 = load double, ptr %.4248.4, align 8
  %.4340.4 = getelementptr i8, ptr %.4248.4, i64 %arg.laws.6.2
  %.4342.4 = load double, ptr %.4340.4, align 8
  %sunkaddr244 = getelementptr i8, ptr %.4248.4, i64 %sunkaddr
  %.4372.4 = load double, ptr %sunkaddr244, align 8
  %.4400.4 = getelementptr i8, ptr %.4248.4, i64 %.4398
  %.4402.4 = load double, ptr %.4400.4, align 8
  %sunkaddr246 = getelementptr i8, ptr %.4248.4, i64 %sunkaddr211
  %.4432.4 = load double, ptr %sunkaddr246, align 8
  %.4460.4 = getelementptr i8, ptr %.4248.4, i64 %.4458
  %.4462.4 = load double, ptr %.4460.4, align 8
  br i1 %26, label %B1802.4, label %B1802.thread.4

B1802.thread.4:                                   ; preds = %B2070.3
  %sunkaddr248 = getelementptr i8, ptr %16, i64 %.867.4
  %.4612.4 = load double, ptr %sunkaddr248, align 8
  %sunkaddr250 = getelementptr i8, ptr %17, i64 %sunkaddr249
  %.4668.4 = load double, ptr %sunkaddr250, align 8
  %.4671.4 = fsub double %.4612.4, %.4668.4
  br i1 %25, label %B1846.4, label %B1900.4

B1846.4:                                          ; preds = %B1802.thread.4
  %sunkaddr252 = getelementptr i8, ptr %18, i64 %sunkaddr249
  %.4765.4 = load double, ptr %sunkaddr252, align 8
  %.4824.4 = fsub double %.4765.4, %.4668.4
  br label %B1892.endif.4

B1802.4:                                          ; preds = %B2070.3
  %"$phi1802.2.2.2.4" = fmul double %y.2.0.i, %"$phi268.0.2.0.i"
  br i1 %25, label %B1892.endif.4, label %B1900.4

B1892.endif.4:                                    ; preds = %B1802.4, %B1846.4
  %"$phi1802.2.2.229252927.4" = phi double [ %.4671.4, %B1846.4 ], [ %"$phi1802.2.2.2.4", %B1802.4 ]
  %"$phi1892.2.2.3.4" = phi double [ %.4824.4, %B1846.4 ], [ %.247.i159, %B1802.4 ]
  %.4833.4 = fdiv double %"$phi1892.2.2.3.4", %arg.h
  br label %B1900.4

B1900.4:                                          ; preds = %B1892.endif.4, %B1802.4, %B1802.thread.4
  %"$phi1802.2.2.22924.4" = phi double [ %"$phi1802.2.2.229252927.4", %B1892.endif.4 ], [ %"$phi1802.2.2.2.4", %B1802.4 ], [ %.4671.4, %B1802.thread.4 ]
  %v_e.2.2.4 = phi double [ %.4833.4, %B1892.endif.4 ], [ 0.000000e+00, %B1802.4 ], [ 0.000000e+00, %B1802.thread.4 ]
  %.4870.4 = load double, ptr %.770.4, align 8
  %.4872.4 = fsub double %.4870.4, %v_e.2.2.4
  %.4875.4 = fmul double %arg.h, %v_e.2.2.4
  %.4877.4 = fmul double %.4402.4, %.4872.4
  %.4880.4 = fadd double %.4875.4, %.4877.4
  %.4883.4 = fmul double %.4432.4, %"$phi1802.2.2.22924.4"
  %.4886.4 = fadd double %.4883.4, %.4880.4
  %.4918.4 = load double, ptr %sunkaddr256, align 8
  %.4920.4 = fmul double %.4462.4, %.4918.4
  %.4923.4 = fadd double %.4920.4, %.4886.4
  %.4928.4 = fmul double %.4312.4, %.4872.4
  %.4932.4 = fadd double %v_e.2.2.4, %.4928.4
  %.4937.4 = fmul double %.4342.4, %"$phi1802.2.2.22924.4"
  %.4942.4 = fadd double %.4937.4, %.4932.4
  %.4976.4 = fmul double %.4372.4, %.4918.4
  %.4979.4 = fadd double %.4976.4, %.4942.4
  store double %.4979.4, ptr %.770.4, align 8
  br i1 %26, label %B2070.4, label %B2046.4

B2046.4:                                          ; preds = %B1900.4
  %sunkaddr258 = getelementptr i8, ptr %16, i64 %.867.4
  %.5076.4 = load double, ptr %sunkaddr258, align 8
  %.5080.4 = fadd double %.4923.4, %.5076.4
  br label %B2070.4

B2070.4:                                          ; preds = %B2046.4, %B1900.4
  %"$phi2070.2.2.2.4" = phi double [ %.5080.4, %B2046.4 ], [ %.4923.4, %B1900.4 ]
  %sunkaddr260 = getelementptr i8, ptr %19, i64 %.867.4
  store double %"$phi2070.2.2.2.4", ptr %sunkaddr260, align 8
  %.4248.5 = getelementptr i8, ptr %15, i64 %.4245.5
  %.4312.5 = load double, ptr %.4248.5, align 8
  %.4340.5 = getelementptr i8, ptr %.4248.5, i64 %arg.laws.6.2
  %.4342.5 = load double, ptr %.4340.5, align 8
  %sunkaddr262 = getelementptr i8, ptr %.4248.5, i64 %sunkaddr
  %.4372.5 = load double, ptr %sunkaddr262, align 8
  %.4400.5 = getelementptr i8, ptr %.4248.5, i64 %.4398
  %.4402.5 = load double, ptr %.4400.5, align 8
  %sunkaddr264 = getelementptr i8, ptr %.4248.5, i64 %sunkaddr211
  %.4432.5 = load double, ptr %sunkaddr264, align 8
  %.4460.5 = getelementptr i8, ptr %.4248.5, i64 %.4458
  %.4462.5 = load double, ptr %.4460.5, align 8
  br i1 %26, label %B1802.5, label %B1802.thread.5

B1802.thread.5:                                   ; preds = %B2070.4
  %.4610.5 = getelementptr i8, ptr %16, i64 %.867.5
  %.4612.5 = load double, ptr %.4610.5, align 8
  %.4666.5 = getelementptr i8, ptr %17, i64 %.4663.5
  %.4668.5 = load double, ptr %.4666.5, align 8
  %.4671.5 = fsub double %.4612.5, %.4668.5
  br i1 %25, label %B1846.5, label %B1900.5

B1846.5:                                          ; preds = %B1802.thread.5
  %.4763.5 = getelementptr i8, ptr %18, i64 %.4663.5
  %.4765.5 = load double, ptr %.4763.5, align 8
  %.4824.5 = fsub double %.4765.5, %.4668.5
  br label %B1892.endif.5

B1802.5:                                          ; preds = %B2070.4
  %"$phi1802.2.2.2.5" = fmul double %z.2.0.i, %"$phi268.0.2.0.i"
  br i1 %25, label %B1892.endif.5, label %B1900.5

B1892.endif.5:                                    ; preds = %B1802.5, %B1846.5
  %"$phi1802.2.2.229252927.5" = phi double [ %.4671.5, %B1846.5 ], [ %"$phi1802.2.2.2.5", %B1802.5 ]
  %"$phi1892.2.2.3.5" = phi double [ %.4824.5, %B1846.5 ], [ %.251.i160, %B1802.5 ]
  %.4833.5 = fdiv double %"$phi1892.2.2.3.5", %arg.h
  br label %B1900.5

B1900.5:                                          ; preds = %B1892.endif.5, %B1802.5, %B1802.thread.5
  %"$phi1802.2.2.22924.5" = phi double [ %"$phi1802.2.2.229252927.5", %B1892.endif.5 ], [ %"$phi1802.2.2.2.5", %B1802.5 ], [ %.4671.5, %B1802.thread.5 ]
  %v_e.2.2.5 = phi double [ %.4833.5, %B1892.endif.5 ], [ 0.000000e+00, %B1802.5 ], [ 0.000000e+00, %B1802.thread.5 ]
  %.4870.5 = load double, ptr %.770.5, align 8
  %.4872.5 = fsub double %.4870.5, %v_e.2.2.5
  %.4875.5 = fmul double %arg.h, %v_e.2.2.5
  %.4877.5 = fmul double %.4402.5, %.4872.5
  %.4880.5 = fadd double %.4875.5, %.4877.5
  %.4883.5 = fmul double %.4432.5, %"$phi1802.2.2.22924.5"
  %.4886.5 = fadd double %.4883.5, %.4880.5
  %.4918.5 = load double, ptr %sunkaddr266, align 8
  %.4920.5 = fmul double %.4462.5, %.4918.5
  %.4923.5 = fadd double %.4920.5, %.4886.5
  %.4928.5 = fmul double %.4312.5, %.4872.5
  %.4932.5 = fadd double %v_e.2.2.5, %.4928.5
  %.4937.5 = fmul double %.4342.5, %"$phi1802.2.2.22924.5"
  %.4942.5 = fadd double %.4937.5, %.4932.5
  %.4976.5 = fmul double %.4372.5, %.4918.5
  %.4979.5 = fadd double %.4976.5, %.4942.5
  store double %.4979.5, ptr %.770.5, align 8
  br i1 %26, label %B2102, label %B2070.5

B2070.5:                                          ; preds = %B1900.5
  %.5074.5 = getelementptr i8, ptr %16, i64 %.867.5
  %.5076.5 = load double, ptr %.5074.5, align 8
  %.5080.5 = fadd double %.4923.5, %.5076.5
  %.5141.5 = getelementptr i8, ptr %19, i64 %.867.5
  store double %.5080.5, ptr %.5141.5, align 8
  br label %B252.backedge

B252.backedge:                                    ; preds = %B2070.5, %part.2
  %at.4.sroa.0.02732.be = phi double [ %at.3.sroa.0.1, %B2070.5 ], [ %.66.i.i37, %part.2 ]
  %at.4.sroa.10.02731.be = phi double [ %at.3.sroa.17.1, %B2070.5 ], [ %.73.i.i43, %part.2 ]
  %at.4.sroa.20.02730.be = phi double [ %at.3.sroa.34.1, %B2070.5 ], [ %.80.i.i48, %part.2 ]
  %at.4.sroa.30.02729.be = phi double [ %at.3.sroa.51.1, %B2070.5 ], [ %.87.i.i53, %part.2 ]
  br label %B252

B2102:                                            ; preds = %B1900.5
  %.5141.5198 = getelementptr i8, ptr %19, i64 %.867.5
  store double %.4923.5, ptr %.5141.5198, align 8
  %gep2769 = getelementptr i8, ptr %.870.3, i64 %.5137
  %.5234 = load double, ptr %gep2769, align 8
  %gep2771 = getelementptr i8, ptr %.870.4, i64 %.5137
  %.5290 = load double, ptr %gep2771, align 8
  %.29.i = fmul double %.5234, %.5234
  %.32.i29 = fmul double %.5290, %.5290
  %.33.i = fadd double %.29.i, %.32.i29
  %.36.i = fmul double %.4923.5, %.4923.5
  %.37.i = fadd double %.36.i, %.33.i
  %sqrt.i30 = tail call double @llvm.sqrt.f64(double %.37.i)
  %.44.i = fcmp ogt double %.37.i, 0.000000e+00
  %.51.i = fmul double %sqrt.i30, 5.000000e-01
  br i1 %.44.i, label %B76.endif.endif.i, label %part.2

B76.endif.endif.i:                                ; preds = %B2102
  %.52.i54 = tail call double @llvm.sin.f64(double %.51.i)
  %.57.i = fdiv double %.52.i54, %sqrt.i30
  br label %part.2

part.2: ; preds = %B76.endif.endif.i, %B2102
  %"$phi120.0.2.0.i" = phi double [ %.57.i, %B76.endif.endif.i ], [ 5.000000e-01, %B2102 ]
  %.77.i = tail call double @llvm.cos.f64(double %.51.i)
  %.79.i = fmul double %.5234, %"$phi120.0.2.0.i"
  %.83.i = fmul double %.5290, %"$phi120.0.2.0.i"
  %.87.i = fmul double %.4923.5, %"$phi120.0.2.0.i"
  %.60.i.i31 = fmul double %at.3.sroa.0.1, %.77.i
  %.61.i.i32 = fmul double %at.3.sroa.17.1, %.79.i
  %.62.i.i33 = fsub double %.60.i.i31, %.61.i.i32
  %.63.i.i34 = fmul double %at.3.sroa.34.1, %.83.i
  %.64.i.i35 = fsub double %.62.i.i33, %.63.i.i34
  %.65.i.i36 = fmul double %at.3.sroa.51.1, %.87.i
  %.66.i.i37 = fsub double %.64.i.i35, %.65.i.i36
  %.67.i.i38 = fmul double %at.3.sroa.17.1, %.77.i
  %.68.i.i39 = fmul double %at.3.sroa.0.1, %.79.i
  %.69.i.i40 = fadd double %.67.i.i38, %.68.i.i39
  %.70.i.i = fmul double %at.3.sroa.51.1, %.83.i
  %.71.i.i41 = fadd double %.70.i.i, %.69.i.i40
  %.72.i.i42 = fmul double %at.3.sroa.34.1, %.87.i
  %.73.i.i43 = fsub double %.71.i.i41, %.72.i.i42
  %.74.i.i44 = fmul double %at.3.sroa.34.1, %.77.i
  %.75.i.i45 = fmul double %at.3.sroa.0.1, %.83.i
  %.76.i.i46 = fadd double %.74.i.i44, %.75.i.i45
  %.77.i.i = fmul double %at.3.sroa.17.1, %.87.i
  %.78.i.i47 = fadd double %.77.i.i, %.76.i.i46
  %.79.i.i = fmul double %at.3.sroa.51.1, %.79.i
  %.80.i.i48 = fsub double %.78.i.i47, %.79.i.i
  %.81.i.i = fmul double %at.3.sroa.51.1, %.77.i
  %.82.i.i49 = fmul double %at.3.sroa.0.1, %.87.i
  %.83.i.i50 = fadd double %.81.i.i, %.82.i.i49
  %.84.i.i = fmul double %at.3.sroa.34.1, %.79.i
  %.85.i.i51 = fadd double %.84.i.i, %.83.i.i50
  %.86.i.i52 = fmul double %at.3.sroa.17.1, %.83.i
  %.87.i.i53 = fsub double %.85.i.i51, %.86.i.i52
  br label %B252.backedge

B252.lr.ph:                                       ; preds = %B178.5
  %.1777 = shl i64 %arg.q.6.1, 1
  %invariant.gep2752 = getelementptr i8, ptr %arg.q.4, i64 %.1777
  %.1832 = mul i64 %arg.q.6.1, 3
  %invariant.gep2754 = getelementptr i8, ptr %arg.q.4, i64 %.1832
  %.3679 = shl i64 %arg.q_e.6.1, 1
  %invariant.gep2760 = getelementptr i8, ptr %arg.q_e.4, i64 %.3679
  %.3734 = mul i64 %arg.q_e.6.1, 3
  %invariant.gep2762 = getelementptr i8, ptr %arg.q_e.4, i64 %.3734
  %.4398 = mul i64 %arg.laws.6.2, 3
  %.4458 = mul i64 %arg.laws.6.2, 5
  %20 = add i64 %arg.starts.5.0, -1
  %.2992.us.3 = mul i64 %arg.force.6.1, 3
  %.3047.us.3 = mul i64 %arg.bounds.6.1, 3
  %.3214.us.3 = mul i64 %arg.told.6.1, 3
  %.2992.us.5 = mul i64 %arg.force.6.1, 5
  %.3047.us.5 = mul i64 %arg.bounds.6.1, 5
  %.3214.us.5 = mul i64 %arg.told.6.1, 5
  %21 = add i64 %arg.x.5.1, -4
  %arg.x.5.1.mux = tail call i64 @llvm.smin.i64(i64 %arg.x.5.1, i64 0)
  %.4245.2 = shl i64 %arg.laws.6.1, 1
  %.4245.3 = mul i64 %arg.laws.6.1, 3
  %.4663.3 = mul i64 %arg.u.6.1, 3
  %.4245.4 = shl i64 %arg.laws.6.1, 2
  %.4245.5 = mul i64 %arg.laws.6.1, 5
  %.4663.5 = mul i64 %arg.u.6.1, 5
  %22 = icmp eq i64 %arg.slerp, 0
  %23 = icmp eq i64 %arg.shapes.5.0, 0
  %sunkaddr274 = shl i64 %arg.force.6.1, 1
  %sunkaddr276 = shl i64 %arg.bounds.6.1, 1
  %sunkaddr278 = shl i64 %arg.told.6.1, 1
  %sunkaddr283 = shl i64 %arg.force.6.1, 2
  %sunkaddr285 = shl i64 %arg.bounds.6.1, 2
  %sunkaddr287 = shl i64 %arg.told.6.1, 2
  %24 = icmp ult i64 %21, -3
  %.334517.not.i = icmp slt i64 %arg.shapes.5.0, 1
  %.796.i = mul i64 %arg.shapes.6.1, 3
  %.911.i.i = mul i64 %arg.shapes.6.1, 13
  %.974.i.i = mul i64 %arg.shapes.6.1, 14
  %.1042.i.i = mul i64 %arg.shapes.6.1, 15
  %.1074.i.i = shl i64 %arg.shapes.6.1, 2
  %.1106.i.i = mul i64 %arg.shapes.6.1, 7
  %.1139.i.i = mul i64 %arg.shapes.6.1, 10
  %.1172.i.i = mul i64 %arg.shapes.6.1, 5
  %.1204.i.i = shl i64 %arg.shapes.6.1, 3
  %.1237.i.i = mul i64 %arg.shapes.6.1, 11
  %.1270.i.i = mul i64 %arg.shapes.6.1, 6
  %.1302.i.i = mul i64 %arg.shapes.6.1, 9
  %.1335.i.i = mul i64 %arg.shapes.6.1, 12
  %.1379.i.i = shl i64 %arg.shapes.6.1, 4
  %.1413.i.i = mul i64 %arg.shapes.6.1, 17
  %.1447.i.i = mul i64 %arg.shapes.6.1, 18
  %sunkaddr10.i = shl i64 %arg.shapes.6.1, 1
  %25 = icmp eq i64 %arg.speed, 1
  %sunkaddr = shl i64 %arg.laws.6.2, 1
  %sunkaddr211 = shl i64 %arg.laws.6.2, 2
  %sunkaddr218 = getelementptr i8, ptr %.563, i64 %arg.room.6.1
  %sunkaddr225 = shl i64 %arg.u.6.1, 1
  %26 = icmp eq i64 %arg.slerp, 1
  %sunkaddr232 = getelementptr i8, ptr %.563, i64 %.768.2
  %sunkaddr242 = getelementptr i8, ptr %.563, i64 %.768.3
  %sunkaddr249 = shl i64 %arg.u.6.1, 2
  %sunkaddr256 = getelementptr i8, ptr %.563, i64 %.768.4
  %sunkaddr266 = getelementptr i8, ptr %.563, i64 %.768.5
  br label %B252

B424.endif:                                       ; preds = %B412
  %.1277 = mul i64 %.102626342727, %arg.x.6.0
  %gep2747 = getelementptr i8, ptr %.870.3, i64 %.1277
  %.1283 = load double, ptr %gep2747, align 8
  %gep2749 = getelementptr i8, ptr %.870.4, i64 %.1277
  %.1338 = load double, ptr %gep2749, align 8
  %gep2751 = getelementptr i8, ptr %.870.5, i64 %.1277
  %.1393 = load double, ptr %gep2751, align 8
  %.11.i = fmul double %.1338, 5.000000e-01
  %.12.i = tail call double @llvm.cos.f64(double %.11.i)
  %.18.i = tail call double @llvm.sin.f64(double %.11.i)
  %.31.i = fmul double %.1283, 5.000000e-01
  %.32.i = tail call double @llvm.cos.f64(double %.31.i)
  %.38.i = tail call double @llvm.sin.f64(double %.31.i)
  %.60.i.i = fmul double %.32.i, %.12.i
  %.61.i.i = fmul double %.38.i, 0.000000e+00
  %.62.i.i = fsub double %.60.i.i, %.61.i.i
  %.63.i.i = fmul double %.18.i, 0.000000e+00
  %.64.i.i = fsub double %.62.i.i, %.63.i.i
  %.67.i.i = fmul double %.38.i, %.12.i
  %.68.i.i = fmul double %.32.i, 0.000000e+00
  %.69.i.i = fadd double %.68.i.i, %.67.i.i
  %.71.i.i = fadd double %.63.i.i, %.69.i.i
  %.74.i.i = fmul double %.12.i, 0.000000e+00
  %.75.i.i = fmul double %.32.i, %.18.i
  %.76.i.i = fadd double %.75.i.i, %.74.i.i
  %.78.i.i = fadd double %.61.i.i, %.76.i.i
  %.83.i.i = fadd double %.68.i.i, %.74.i.i
  %.85.i.i = fadd double %.83.i.i, 0.000000e+00
  %.86.i.i = fmul double %.38.i, %.18.i
  %.87.i.i = fsub double %.85.i.i, %.86.i.i
  %.52.i = fmul double %.1393, 5.000000e-01
  %.59.i = tail call double @llvm.sin.f64(double %.52.i)
  %.53.i = tail call double @llvm.cos.f64(double %.52.i)
  %.60.i1.i = fmul double %.53.i, %.64.i.i
  %.61.i2.i = fmul double %.71.i.i, 0.000000e+00
  %.62.i3.i = fsub double %.60.i1.i, %.61.i2.i
  %.63.i4.i = fmul double %.78.i.i, 0.000000e+00
  %.64.i5.i = fsub double %.62.i3.i, %.63.i4.i
  %.65.i.i = fmul double %.59.i, %.87.i.i
  %.66.i.i = fsub double %.64.i5.i, %.65.i.i
  %.67.i6.i = fmul double %.53.i, %.71.i.i
  %.68.i7.i = fmul double %.64.i.i, 0.000000e+00
  %.69.i8.i = fadd double %.68.i7.i, %.67.i6.i
  %.70.i9.i = fmul double %.87.i.i, 0.000000e+00
  %.71.i10.i = fadd double %.69.i8.i, %.70.i9.i
  %.72.i.i = fmul double %.59.i, %.78.i.i
  %.73.i.i = fsub double %.71.i10.i, %.72.i.i
  %.74.i11.i = fmul double %.53.i, %.78.i.i
  %.76.i13.i = fadd double %.68.i7.i, %.74.i11.i
  %.77.i14.i = fmul double %.59.i, %.71.i.i
  %.78.i15.i = fadd double %.77.i14.i, %.76.i13.i
  %.80.i.i = fsub double %.78.i15.i, %.70.i9.i
  %.81.i16.i = fmul double %.53.i, %.87.i.i
  %.82.i17.i = fmul double %.59.i, %.64.i.i
  %.83.i18.i = fadd double %.82.i17.i, %.81.i16.i
  %.85.i19.i = fadd double %.63.i4.i, %.83.i18.i
  %.87.i21.i = fsub double %.85.i19.i, %.61.i2.i
  %.1448 = load double, ptr %arg.q_0.4, align 8
  %.1479 = load double, ptr %.361, align 8
  %.1510 = load double, ptr %.392, align 8
  %.1541 = load double, ptr %.423, align 8
  %.60.i = fmul double %.1448, %.66.i.i
  %.61.i = fmul double %.1479, %.73.i.i
  %.62.i = fsub double %.60.i, %.61.i
  %.63.i = fmul double %.1510, %.80.i.i
  %.64.i = fsub double %.62.i, %.63.i
  %.65.i = fmul double %.1541, %.87.i21.i
  %.66.i = fsub double %.64.i, %.65.i
  %.67.i = fmul double %.1479, %.66.i.i
  %.68.i = fmul double %.1448, %.73.i.i
  %.69.i = fadd double %.68.i, %.67.i
  %.70.i = fmul double %.1541, %.80.i.i
  %.71.i = fadd double %.70.i, %.69.i
  %.72.i = fmul double %.1510, %.87.i21.i
  %.73.i = fsub double %.71.i, %.72.i
  %.74.i = fmul double %.1510, %.66.i.i
  %.75.i = fmul double %.1448, %.80.i.i
  %.76.i = fadd double %.75.i, %.74.i
  %.77.i55 = fmul double %.1479, %.87.i21.i
  %.78.i = fadd double %.77.i55, %.76.i
  %.79.i56 = fmul double %.1541, %.73.i.i
  %.80.i = fsub double %.78.i, %.79.i56
  %.81.i = fmul double %.1541, %.66.i.i
  %.82.i = fmul double %.1448, %.87.i21.i
  %.83.i57 = fadd double %.81.i, %.82.i
  %.84.i = fmul double %.1510, %.73.i.i
  %.85.i = fadd double %.84.i, %.83.i57
  %.86.i = fmul double %.1479, %.80.i.i
  %.87.i58 = fsub double %.85.i, %.86.i
  br label %B590

B674.endif:                                       ; preds = %B590
  %27 = tail call i64 @llvm.smax.i64(i64 %.102626342727, i64 1)
  %.13.i = add nsw i64 %27, -1
  %.1931 = mul i64 %.102626342727, %arg.x.6.0
  %.1935 = getelementptr i8, ptr %arg.x.4, i64 %.1931
  %.1937 = load double, ptr %.1935, align 8
  %.1985 = mul i64 %.13.i, %arg.x.6.0
  %.1989 = getelementptr i8, ptr %arg.x.4, i64 %.1985
  %.1991 = load double, ptr %.1989, align 8
  %.1992 = fsub double %.1937, %.1991
  %.1997 = fdiv double %.1992, %arg.h
  %gep2614 = getelementptr i8, ptr %.870.1, i64 %.1931
  %.2052 = load double, ptr %gep2614, align 8
  %gep2616 = getelementptr i8, ptr %.870.1, i64 %.1985
  %.2106 = load double, ptr %gep2616, align 8
  %.2107 = fsub double %.2052, %.2106
  %.2112 = fdiv double %.2107, %arg.h
  %gep2757 = getelementptr i8, ptr %.870.2, i64 %.1931
  %.2167 = load double, ptr %gep2757, align 8
  %gep2759 = getelementptr i8, ptr %.870.2, i64 %.1985
  %.2221 = load double, ptr %gep2759, align 8
  %.2222 = fsub double %.2167, %.2221
  %.2227 = fdiv double %.2222, %arg.h
  %.60.i.i60 = fmul double %last.2.sroa.0.02736, %at.3.sroa.0.1
  %28 = fmul double %last.2.sroa.12.02735, %at.3.sroa.17.1
  %.62.i.i61 = fadd double %28, %.60.i.i60
  %29 = fmul double %last.2.sroa.24.02734, %at.3.sroa.34.1
  %.64.i.i62 = fadd double %29, %.62.i.i61
  %30 = fmul double %last.2.sroa.36.02733, %at.3.sroa.51.1
  %.66.i.i63 = fadd double %30, %.64.i.i62
  %.68.i.i64 = fmul double %last.2.sroa.0.02736, %at.3.sroa.17.1
  %31 = fmul double %last.2.sroa.12.02735, %at.3.sroa.0.1
  %.69.i.i65 = fsub double %.68.i.i64, %31
  %32 = fmul double %last.2.sroa.36.02733, %at.3.sroa.34.1
  %.71.i.i66 = fsub double %.69.i.i65, %32
  %33 = fmul double %last.2.sroa.24.02734, %at.3.sroa.51.1
  %.73.i.i67 = fadd double %33, %.71.i.i66
  %.75.i.i68 = fmul double %last.2.sroa.0.02736, %at.3.sroa.34.1
  %34 = fmul double %last.2.sroa.24.02734, %at.3.sroa.0.1
  %.76.i.i69 = fsub double %.75.i.i68, %34
  %35 = fmul double %last.2.sroa.12.02735, %at.3.sroa.51.1
  %.78.i.i70 = fsub double %.76.i.i69, %35
  %36 = fmul double %last.2.sroa.36.02733, %at.3.sroa.17.1
  %.80.i.i71 = fadd double %36, %.78.i.i70
  %.82.i.i72 = fmul double %last.2.sroa.0.02736, %at.3.sroa.51.1
  %37 = fmul double %last.2.sroa.36.02733, %at.3.sroa.0.1
  %.83.i.i73 = fsub double %.82.i.i72, %37
  %38 = fmul double %last.2.sroa.24.02734, %at.3.sroa.17.1
  %.85.i.i74 = fsub double %.83.i.i73, %38
  %39 = fmul double %last.2.sroa.12.02735, %at.3.sroa.34.1
  %.87.i.i75 = fadd double %39, %.85.i.i74
  %.136.i76 = fcmp olt double %.66.i.i63, 0.000000e+00
  br i1 %.136.i76, label %B120.i99, label %B150.i77

B120.i99:                                         ; preds = %B674.endif
  %.139.i100 = fneg double %.66.i.i63
  %.143.i101 = fneg double %.73.i.i67
  %.147.i102 = fneg double %.80.i.i71
  %.151.i103 = fneg double %.87.i.i75
  br label %B150.i77

B150.i77:                                         ; preds = %B120.i99, %B674.endif
  %w.2.0.i78 = phi double [ %.139.i100, %B120.i99 ], [ %.66.i.i63, %B674.endif ]
  %x.2.0.i79 = phi double [ %.143.i101, %B120.i99 ], [ %.73.i.i67, %B674.endif ]
  %y.2.0.i80 = phi double [ %.147.i102, %B120.i99 ], [ %.80.i.i71, %B674.endif ]
  %z.2.0.i81 = phi double [ %.151.i103, %B120.i99 ], [ %.87.i.i75, %B674.endif ]
  %.197.i82 = fmul double %x.2.0.i79, %x.2.0.i79
  %.200.i83 = fmul double %y.2.0.i80, %y.2.0.i80
  %.201.i84 = fadd double %.197.i82, %.200.i83
  %.204.i85 = fmul double %z.2.0.i81, %z.2.0.i81
  %.205.i86 = fadd double %.201.i84, %.204.i85
  %.212.i87 = fcmp ogt double %.205.i86, 0.000000e+00
  br i1 %.212.i87, label %B222.endif.i94, label %B674.endif.endif.endif.endif.endif.else.endif

B222.endif.i94:                                   ; preds = %B150.i77
  %sqrt.i95 = tail call double @llvm.sqrt.f64(double %.205.i86)
  %.216.i96 = tail call double @atan2(double %sqrt.i95, double %w.2.0.i78)
  %.220.i97 = fmul double %.216.i96, 2.000000e+00
  %.225.i98 = fdiv double %.220.i97, %sqrt.i95
  br label %B674.endif.endif.endif.endif.endif.else.endif

B674.endif.endif.endif.endif.endif.endif:         ; preds = %B674.endif.endif.endif.en...endif.if, %B674.endif.endif.endif.endif.endif.else.endif
  %.2327.sroa.0.32930 = phi i64 [ %arg.x.5.1.mux, %B674.endif.endif.endif.endif.endif.else.endif ], [ 0, %B674.endif.endif.endif.en...endif.if ]
  %.2444 = mul i64 %.2327.sroa.0.32930, %arg.x.6.1
  %.2447 = getelementptr i8, ptr %.1935, i64 %.2444
  %.2484 = fdiv double %.243.i89, %arg.h
  %.2489 = fdiv double %.247.i90, %arg.h
  %.2494 = fdiv double %.251.i91, %arg.h
  %.2538 = mul i64 %.102626342727, %arg.force.6.0
  %.2540 = getelementptr i8, ptr %arg.force.4, i64 %.2538
  store double 0.000000e+00, ptr %.2540, align 8, !noalias !10
  %.227.1.i = getelementptr i8, ptr %.2540, i64 %arg.force.6.1
  store double 0.000000e+00, ptr %.227.1.i, align 8, !noalias !10
  %.227.2.i = getelementptr i8, ptr %.2540, i64 %sunkaddr274
  store double 0.000000e+00, ptr %.227.2.i, align 8, !noalias !10
  %.227.3.i = getelementptr i8, ptr %.2540, i64 %.2992.us.3
  store double 0.000000e+00, ptr %.227.3.i, align 8, !noalias !10
  %.227.4.i = getelementptr i8, ptr %.2540, i64 %sunkaddr283
  store double 0.000000e+00, ptr %.227.4.i, align 8, !noalias !10
  %.227.5.i = getelementptr i8, ptr %.2540, i64 %.2992.us.5
  store double 0.000000e+00, ptr %.227.5.i, align 8, !noalias !10
  br i1 %.334517.not.i, label %part.3, label %B114.lr.ph.i

B114.i:                                           ; preds = %B114.lr.ph.i, %B1069.i
  %lsr.iv16.i = phi i64 [ %arg.shapes.5.0, %B114.lr.ph.i ], [ %lsr.iv.next.i, %B1069.i ]
  %lsr.iv.i = phi ptr [ %arg.shapes.4, %B114.lr.ph.i ], [ %scevgep.i, %B1069.i ]
  %deepest.2.0520.i = phi double [ 0.000000e+00, %B114.lr.ph.i ], [ %deepest.3.1.i, %B1069.i ]
  %.62.i.i1 = load double, ptr %lsr.iv.i, align 8, !noalias !13
  %.64.i.i2 = fcmp oeq double %.62.i.i1, 1.000000e+00
  %.319.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1074.i.i
  %.321.i.i = load double, ptr %.319.i.i, align 8, !noalias !13
  br i1 %.64.i.i2, label %B30.i.i, label %B610.endif.i.i

B30.i.i:                                          ; preds = %B114.i
  %.94.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1106.i.i
  %.96.i.i = load double, ptr %.94.i.i, align 8, !noalias !13
  %.128.i.i = fmul double %.96.i.i, %.96.i.i
  %.157.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1204.i.i
  %.159.i.i = load double, ptr %.157.i.i, align 8, !noalias !13
  %.191.i.i = fmul double %.159.i.i, %.159.i.i
  %.192.i.i = fadd double %.128.i.i, %.191.i.i
  %.221.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1302.i.i
  %.223.i.i = load double, ptr %.221.i.i, align 8, !noalias !13
  %.255.i.i = fmul double %.223.i.i, %.223.i.i
  %.256.i.i = fadd double %.192.i.i, %.255.i.i
  %.290.i.i = load double, ptr %.2447, align 8, !noalias !13
  %.322.i.i = fsub double %.290.i.i, %.321.i.i
  %.353.i.i = load double, ptr %.945.i.i, align 8, !noalias !13
  %.382.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1172.i.i
  %.384.i.i = load double, ptr %.382.i.i, align 8, !noalias !13
  %.385.i.i = fsub double %.353.i.i, %.384.i.i
  %.416.i.i = load double, ptr %.1008.i.i, align 8, !noalias !13
  %.450.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1270.i.i
  %.452.i.i = load double, ptr %.450.i.i, align 8, !noalias !13
  %.453.i.i = fsub double %.416.i.i, %.452.i.i
  %.465.i.i = fcmp ogt double %.256.i.i, 0.000000e+00
  br i1 %.465.i.i, label %B250.endif.i.i, label %B328.endif.endif.endif.i.i

B1112.i.i:                                        ; preds = %B610.endif.i.i
  %.1506.i.i = fcmp oeq double %.1384.i.i, %.19.i.i.i
  br i1 %.1506.i.i, label %B1344.i.i, label %B1128.i.i

B1128.i.i:                                        ; preds = %B1112.i.i
  %.1539.i.i = fcmp oeq double %.1418.i.i, %.19.i.i.i
  br i1 %.1539.i.i, label %B1344.i.i, label %B1144.i.i

B1144.i.i:                                        ; preds = %B1128.i.i
  br label %B1344.i.i

B1344.i.i:                                        ; preds = %B1158.endif.endif.endif.i.i, %B1144.i.i, %B1128.i.i, %B1112.i.i
  %far.3.0.i.i = phi double [ %sqrt669.i.i, %B1158.endif.endif.endif.i.i ], [ %.19.i.i.i, %B1128.i.i ], [ %.19.i.i.i, %B1112.i.i ], [ %.19.i.i.i, %B1144.i.i ]
  %a.4.0.i.i = phi double [ %.1728.i.i, %B1158.endif.endif.endif.i.i ], [ 0.000000e+00, %B1128.i.i ], [ 1.000000e+00, %B1112.i.i ], [ 0.000000e+00, %B1144.i.i ]
  %b.4.0.i.i = phi double [ %.1732.i.i, %B1158.endif.endif.endif.i.i ], [ 1.000000e+00, %B1128.i.i ], [ 0.000000e+00, %B1112.i.i ], [ 0.000000e+00, %B1144.i.i ]
  %c.4.0.i.i = phi double [ %.1736.i.i, %B1158.endif.endif.endif.i.i ], [ 0.000000e+00, %B1128.i.i ], [ 0.000000e+00, %B1112.i.i ], [ 1.000000e+00, %B1144.i.i ]
  %.1746.i.i = tail call double @llvm.copysign.f64(double %a.4.0.i.i, double %.1145.i.i)
  %.1753.i.i = tail call double @llvm.copysign.f64(double %b.4.0.i.i, double %.1243.i.i)
  %.1760.i.i = tail call double @llvm.copysign.f64(double %c.4.0.i.i, double %.1341.i.i)
  %.1796.i.i = fmul double %.321.i.i, %.1746.i.i
  %.1828.i.i = fmul double %.1176.i.i, %.1753.i.i
  %.1829.i.i = fadd double %.1796.i.i, %.1828.i.i
  %.1861.i.i = fmul double %.1274.i.i, %.1760.i.i
  %.1862.i.i = fadd double %.1829.i.i, %.1861.i.i
  %.1894.i.i = fmul double %.1110.i.i, %.1746.i.i
  %.1926.i.i = fmul double %.1208.i.i, %.1753.i.i
  %.1927.i.i = fadd double %.1894.i.i, %.1926.i.i
  %.1959.i.i = fmul double %.1306.i.i, %.1760.i.i
  %.1960.i.i = fadd double %.1927.i.i, %.1959.i.i
  %.1992.i.i = fmul double %.1143.i.i, %.1746.i.i
  %.2024.i.i = fmul double %.1241.i.i, %.1753.i.i
  %.2025.i.i = fadd double %.1992.i.i, %.2024.i.i
  %.2062.i.i = fmul double %.1339.i.i, %.1760.i.i
  %.2063.i.i = fadd double %.2025.i.i, %.2062.i.i
  br label %part.4

B250.endif.i.i:                                   ; preds = %B30.i.i
  %.499.i.i = fmul double %.96.i.i, %.322.i.i
  %.532.i.i = fmul double %.159.i.i, %.385.i.i
  %.533.i.i = fadd double %.499.i.i, %.532.i.i
  %.566.i.i = fmul double %.223.i.i, %.453.i.i
  %.567.i.i = fadd double %.533.i.i, %.566.i.i
  %.572.i.i = fdiv double %.567.i.i, %.256.i.i
  br label %B328.endif.endif.endif.i.i

B328.endif.endif.endif.i.i:                       ; preds = %B250.endif.i.i, %B30.i.i
  %"$phi328.0.2.0.i.i" = phi double [ %.572.i.i, %B250.endif.i.i ], [ 0.000000e+00, %B30.i.i ]
  %.12.i.i.i = fcmp ogt double %"$phi328.0.2.0.i.i", 0.000000e+00
  %.13.i.i.i = select i1 %.12.i.i.i, double %"$phi328.0.2.0.i.i", double 0.000000e+00
  %.12.i3.i.i = fcmp olt double %.13.i.i.i, 1.000000e+00
  %.13.i4.i.i = select i1 %.12.i3.i.i, double %.13.i.i.i, double 1.000000e+00
  %.676.i.i = fmul double %.96.i.i, %.13.i4.i.i
  %.678.i.i = fsub double %.322.i.i, %.676.i.i
  %.712.i.i = fmul double %.159.i.i, %.13.i4.i.i
  %.714.i.i = fsub double %.385.i.i, %.712.i.i
  %.748.i.i = fmul double %.223.i.i, %.13.i4.i.i
  %.750.i.i = fsub double %.453.i.i, %.748.i.i
  %.753.i.i = fmul double %.678.i.i, %.678.i.i
  %.754.i.i = fmul double %.714.i.i, %.714.i.i
  %.755.i.i = fadd double %.753.i.i, %.754.i.i
  %.756.i.i = fmul double %.750.i.i, %.750.i.i
  %.757.i.i = fadd double %.756.i.i, %.755.i.i
  %sqrt.i.i = tail call double @llvm.sqrt.f64(double %.757.i.i)
  %.12.i5.i.i = fcmp olt double %sqrt.i.i, 1.000000e-300
  %.13.i6.i.i = select i1 %.12.i5.i.i, double 1.000000e-300, double %sqrt.i.i
  %.815.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1139.i.i
  %.817.i.i = load double, ptr %.815.i.i, align 8, !noalias !13
  %.823.i.i = fsub double %.13.i6.i.i, %.817.i.i
  %.827.i.i = fdiv double %.678.i.i, %.13.i6.i.i
  %.831.i.i = fdiv double %.714.i.i, %.13.i6.i.i
  %.835.i.i = fdiv double %.750.i.i, %.13.i6.i.i
  br label %part.4

B610.endif.i.i:                                   ; preds = %B114.i
  %.884.i.i = load double, ptr %.2447, align 8, !noalias !13
  %.913.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.911.i.i
  %.915.i.i = load double, ptr %.913.i.i, align 8, !noalias !13
  %.916.i.i = fsub double %.884.i.i, %.915.i.i
  %.947.i.i = load double, ptr %.945.i.i, align 8, !noalias !13
  %.976.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.974.i.i
  %.978.i.i = load double, ptr %.976.i.i, align 8, !noalias !13
  %.979.i.i = fsub double %.947.i.i, %.978.i.i
  %.1010.i.i = load double, ptr %.1008.i.i, align 8, !noalias !13
  %.1044.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1042.i.i
  %.1046.i.i = load double, ptr %.1044.i.i, align 8, !noalias !13
  %.1047.i.i = fsub double %.1010.i.i, %.1046.i.i
  %.1079.i.i = fmul double %.321.i.i, %.916.i.i
  %.1108.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1106.i.i
  %.1110.i.i = load double, ptr %.1108.i.i, align 8, !noalias !13
  %.1111.i.i = fmul double %.979.i.i, %.1110.i.i
  %.1112.i.i = fadd double %.1079.i.i, %.1111.i.i
  %.1141.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1139.i.i
  %.1143.i.i = load double, ptr %.1141.i.i, align 8, !noalias !13
  %.1144.i.i = fmul double %.1047.i.i, %.1143.i.i
  %.1145.i.i = fadd double %.1112.i.i, %.1144.i.i
  %.1174.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1172.i.i
  %.1176.i.i = load double, ptr %.1174.i.i, align 8, !noalias !13
  %.1177.i.i = fmul double %.916.i.i, %.1176.i.i
  %.1206.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1204.i.i
  %.1208.i.i = load double, ptr %.1206.i.i, align 8, !noalias !13
  %.1209.i.i = fmul double %.979.i.i, %.1208.i.i
  %.1210.i.i = fadd double %.1177.i.i, %.1209.i.i
  %.1239.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1237.i.i
  %.1241.i.i = load double, ptr %.1239.i.i, align 8, !noalias !13
  %.1242.i.i = fmul double %.1047.i.i, %.1241.i.i
  %.1243.i.i = fadd double %.1210.i.i, %.1242.i.i
  %.1272.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1270.i.i
  %.1274.i.i = load double, ptr %.1272.i.i, align 8, !noalias !13
  %.1275.i.i = fmul double %.916.i.i, %.1274.i.i
  %.1304.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1302.i.i
  %.1306.i.i = load double, ptr %.1304.i.i, align 8, !noalias !13
  %.1307.i.i = fmul double %.979.i.i, %.1306.i.i
  %.1308.i.i = fadd double %.1275.i.i, %.1307.i.i
  %.1337.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1335.i.i
  %.1339.i.i = load double, ptr %.1337.i.i, align 8, !noalias !13
  %.1340.i.i = fmul double %.1047.i.i, %.1339.i.i
  %.1341.i.i = fadd double %.1308.i.i, %.1340.i.i
  %.1352.i.i = tail call double @llvm.fabs.f64(double %.1145.i.i)
  %.1381.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1379.i.i
  %.1383.i.i = load double, ptr %.1381.i.i, align 8, !noalias !13
  %.1384.i.i = fsub double %.1352.i.i, %.1383.i.i
  %.1386.i.i = tail call double @llvm.fabs.f64(double %.1243.i.i)
  %.1415.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1413.i.i
  %.1417.i.i = load double, ptr %.1415.i.i, align 8, !noalias !13
  %.1418.i.i = fsub double %.1386.i.i, %.1417.i.i
  %.1420.i.i = tail call double @llvm.fabs.f64(double %.1341.i.i)
  %.1449.i.i = getelementptr i8, ptr %lsr.iv.i, i64 %.1447.i.i
  %.1451.i.i = load double, ptr %.1449.i.i, align 8, !noalias !13
  %.1452.i.i = fsub double %.1420.i.i, %.1451.i.i
  %.16.i.i.i = fcmp ogt double %.1418.i.i, %.1384.i.i
  %.17.i.i.i = select i1 %.16.i.i.i, double %.1418.i.i, double %.1384.i.i
  %.18.i.i.i = fcmp ogt double %.1452.i.i, %.17.i.i.i
  %.19.i.i.i = select i1 %.18.i.i.i, double %.1452.i.i, double %.17.i.i.i
  %.1500.i.i = fcmp ugt double %.19.i.i.i, 0.000000e+00
  br i1 %.1500.i.i, label %B1158.endif.endif.endif.i.i, label %B1112.i.i

B1158.endif.endif.endif.i.i:                      ; preds = %B610.endif.i.i
  %.12.i1.i.i = fcmp olt double %.1384.i.i, 0.000000e+00
  %.13.i2.i.i = select i1 %.12.i1.i.i, double 0.000000e+00, double %.1384.i.i
  %.12.i7.i.i = fcmp olt double %.1418.i.i, 0.000000e+00
  %.13.i8.i.i = select i1 %.12.i7.i.i, double 0.000000e+00, double %.1418.i.i
  %.12.i9.i.i = fcmp olt double %.1452.i.i, 0.000000e+00
  %.13.i10.i.i = select i1 %.12.i9.i.i, double 0.000000e+00, double %.1452.i.i
  %.1717.i.i = fmul double %.13.i2.i.i, %.13.i2.i.i
  %.1718.i.i = fmul double %.13.i8.i.i, %.13.i8.i.i
  %.1719.i.i = fadd double %.1717.i.i, %.1718.i.i
  %.1720.i.i = fmul double %.13.i10.i.i, %.13.i10.i.i
  %.1721.i.i = fadd double %.1719.i.i, %.1720.i.i
  %sqrt669.i.i = tail call double @llvm.sqrt.f64(double %.1721.i.i)
  %.1728.i.i = fdiv double %.13.i2.i.i, %sqrt669.i.i
  %.1732.i.i = fdiv double %.13.i8.i.i, %sqrt669.i.i
  %.1736.i.i = fdiv double %.13.i10.i.i, %sqrt669.i.i
  br label %B1344.i.i

part.4: ; preds = %B328.endif.endif.endif.i.i, %B1344.i.i
  %.823.sink.i.i = phi double [ %.823.i.i, %B328.endif.endif.endif.i.i ], [ %far.3.0.i.i, %B1344.i.i ]
  %.827.sink.i.i = phi double [ %.827.i.i, %B328.endif.endif.endif.i.i ], [ %.1862.i.i, %B1344.i.i ]
  %.831.sink.i.i = phi double [ %.831.i.i, %B328.endif.endif.endif.i.i ], [ %.1960.i.i, %B1344.i.i ]
  %.835.sink.i.i = phi double [ %.835.i.i, %B328.endif.endif.endif.i.i ], [ %.2063.i.i, %B1344.i.i ]
  %.506.i = fsub double %arg.tip, %.823.sink.i.i
  %.512.i = fcmp ugt double %.506.i, 0.000000e+00
  br i1 %.512.i, label %B198.endif.endif.endif.i, label %B1069.i

B1069.i:                                          ; preds = %B198.endif.endif.endif.i, %part.4
  %deepest.3.1.i = phi double [ %.13.i.i, %B198.endif.endif.endif.i ], [ %deepest.2.0520.i, %part.4 ]
  %scevgep.i = getelementptr i8, ptr %lsr.iv.i, i64 %arg.shapes.6.0
  %lsr.iv.next.i = add nsw i64 %lsr.iv16.i, -1
  %exitcond.not.i = icmp eq i64 %lsr.iv.next.i, 0
  br i1 %exitcond.not.i, label %part.3, label %B114.i

B114.lr.ph.i:                                     ; preds = %B674.endif.endif.endif.endif.endif.endif
  %.945.i.i = getelementptr i8, ptr %.2447, i64 %arg.x.6.1
  %.1008.i.i = getelementptr i8, ptr %.2447, i64 %.867.2
  br label %B114.i

B198.endif.endif.endif.i:                         ; preds = %part.4
  %.12.i.i = fcmp ogt double %.506.i, %deepest.2.0520.i
  %.13.i.i = select i1 %.12.i.i, double %.506.i, double %deepest.2.0520.i
  %.574.i = fmul double %.506.i, 5.000000e-01
  %.576.i = fsub double %.574.i, %arg.tip
  %.578.i = fmul double %.827.sink.i.i, %.576.i
  %.580.i = fmul double %.831.sink.i.i, %.576.i
  %.582.i = fmul double %.835.sink.i.i, %.576.i
  %.597.i = fmul double %.2489, %.582.i
  %.598.i = fadd double %.1997, %.597.i
  %.602.i = fmul double %.2494, %.580.i
  %.603.i = fsub double %.598.i, %.602.i
  %.609.i = fmul double %.2494, %.578.i
  %.610.i = fadd double %.2112, %.609.i
  %.614.i = fmul double %.2484, %.582.i
  %.615.i = fsub double %.610.i, %.614.i
  %.621.i = fmul double %.2484, %.580.i
  %.622.i = fadd double %.2227, %.621.i
  %.626.i = fmul double %.2489, %.578.i
  %.627.i = fsub double %.622.i, %.626.i
  %.629.i = fmul double %.827.sink.i.i, %.603.i
  %.631.i = fmul double %.831.sink.i.i, %.615.i
  %.632.i = fadd double %.629.i, %.631.i
  %.634.i = fmul double %.835.sink.i.i, %.627.i
  %.635.i = fadd double %.634.i, %.632.i
  %scevgep15.i = getelementptr i8, ptr %lsr.iv.i, i64 %arg.shapes.6.1
  %.666.i = load double, ptr %scevgep15.i, align 8, !noalias !10
  %.668.i = fmul double %.506.i, %.666.i
  %sunkaddr11.i = getelementptr i8, ptr %lsr.iv.i, i64 %sunkaddr10.i
  %.701.i = load double, ptr %sunkaddr11.i, align 8, !noalias !10
  %.702.i = fmul double %.635.i, %.701.i
  %.703.i = fsub double %.668.i, %.702.i
  %.12.i5.i = fcmp ogt double %.703.i, 0.000000e+00
  %.13.i6.i = select i1 %.12.i5.i, double %.703.i, double 0.000000e+00
  %.736.i = fmul double %.827.sink.i.i, %.635.i
  %.737.i = fsub double %.603.i, %.736.i
  %.739.i = fmul double %.831.sink.i.i, %.635.i
  %.740.i = fsub double %.615.i, %.739.i
  %.742.i = fmul double %.835.sink.i.i, %.635.i
  %.743.i = fsub double %.627.i, %.742.i
  %.755.i = fmul double %.737.i, %.737.i
  %.758.i = fmul double %.740.i, %.740.i
  %.759.i = fadd double %.755.i, %.758.i
  %.762.i = fmul double %.743.i, %.743.i
  %.763.i = fadd double %.762.i, %.759.i
  %sqrt.i3 = tail call double @llvm.sqrt.f64(double %.763.i)
  %.769.i = fmul double %sqrt.i3, 2.000000e+03
  %scevgep13.i = getelementptr i8, ptr %lsr.iv.i, i64 %.796.i
  %.800.i = load double, ptr %scevgep13.i, align 8, !noalias !10
  %.802.i = fmul double %.800.i, %.13.i6.i
  %.803.i = fcmp ugt double %.769.i, %.802.i
  %"$phi770.1.2.2.frozen.i" = freeze i1 %.803.i
  %.858.i = fdiv double %.802.i, %sqrt.i3
  %"$phi770.1.2.2.i" = select i1 %"$phi770.1.2.2.frozen.i", double %.858.i, double 2.000000e+03
  %.874.i = fmul double %.827.sink.i.i, %.13.i6.i
  %.878.i = fmul double %.737.i, %"$phi770.1.2.2.i"
  %.881.i = fsub double %.874.i, %.878.i
  %.884.i = fmul double %.831.sink.i.i, %.13.i6.i
  %.888.i = fmul double %.740.i, %"$phi770.1.2.2.i"
  %.891.i = fsub double %.884.i, %.888.i
  %.894.i = fmul double %.835.sink.i.i, %.13.i6.i
  %.900.i = fmul double %.743.i, %"$phi770.1.2.2.i"
  %.903.i = fsub double %.894.i, %.900.i
  %.934.i = load double, ptr %.2540, align 8, !noalias !10
  %.935.i = fadd double %.934.i, %.881.i
  %.966.i = load double, ptr %.227.1.i, align 8, !noalias !10
  %.967.i = fadd double %.966.i, %.891.i
  %.998.i = load double, ptr %.227.2.i, align 8, !noalias !10
  %.999.i = fadd double %.998.i, %.903.i
  store double %.935.i, ptr %.2540, align 8, !noalias !10
  store double %.967.i, ptr %.227.1.i, align 8, !noalias !10
  store double %.999.i, ptr %.227.2.i, align 8, !noalias !10
  %.1123.i = load double, ptr %.227.3.i, align 8, !noalias !10
  %.1125.i = fmul double %.580.i, %.903.i
  %.1126.i = fadd double %.1123.i, %.1125.i
  %.1128.i = fmul double %.582.i, %.891.i
  %.1129.i = fsub double %.1126.i, %.1128.i
  %.1160.i = load double, ptr %.227.4.i, align 8, !noalias !10
  %.1162.i = fmul double %.582.i, %.881.i
  %.1165.i = fadd double %.1160.i, %.1162.i
  %.1167.i = fmul double %.578.i, %.903.i
  %.1168.i = fsub double %.1165.i, %.1167.i
  %.1199.i = load double, ptr %.227.5.i, align 8, !noalias !10
  %.1201.i = fmul double %.578.i, %.891.i
  %.1204.i = fadd double %.1199.i, %.1201.i
  %.1206.i = fmul double %.580.i, %.881.i
  %.1209.i = fsub double %.1204.i, %.1206.i
  store double %.1129.i, ptr %.227.3.i, align 8, !noalias !10
  store double %.1168.i, ptr %.227.4.i, align 8, !noalias !10
  store double %.1209.i, ptr %.227.5.i, align 8, !noalias !10
  br label %B1069.i

part.3: ; preds = %B1069.i, %B674.endif.endif.endif.endif.endif.endif
  %deepest.2.0.lcssa.i = phi double [ 0.000000e+00, %B674.endif.endif.endif.endif.endif.endif ], [ %deepest.3.1.i, %B1069.i ]
  %.2652 = mul i64 %.102626342727, %arg.depth.6.0
  %.2654 = getelementptr i8, ptr %arg.depth.4, i64 %.2652
  store double %deepest.2.0.lcssa.i, ptr %.2654, align 8
  br label %B996.endif.endif

B674.endif.endif.endif.endif.endif.else.endif:    ; preds = %B222.endif.i94, %B150.i77
  %"$phi268.0.2.0.i88" = phi double [ %.225.i98, %B222.endif.i94 ], [ 0.000000e+00, %B150.i77 ]
  %.243.i89 = fmul double %x.2.0.i79, %"$phi268.0.2.0.i88"
  %.247.i90 = fmul double %y.2.0.i80, %"$phi268.0.2.0.i88"
  %.251.i91 = fmul double %z.2.0.i81, %"$phi268.0.2.0.i88"
  br i1 %24, label %B674.endif.endif.endif.endif.endif.endif, label %B674.endif.endif.endif.en...endif.if, !prof !16

B674.endif.endif.endif.en...endif.if:             ; preds = %B674.endif.endif.endif.endif.endif.else.endif
  br label %B674.endif.endif.endif.endif.endif.endif

B996.endif.endif:                                 ; preds = %part.3, %B590.B996.endif.endif_crit_edge
  %.2991.pre-phi = phi i64 [ %.pre2921, %B590.B996.endif.endif_crit_edge ], [ %.2538, %part.3 ]
  %40 = getelementptr i8, ptr %arg.force.4, i64 %.2991.pre-phi
  %.3025 = icmp slt i64 %law.3.1, 0
  %.3026 = select i1 %.3025, i64 %arg.bounds.5.0, i64 0
  %.3027 = add i64 %.3026, %law.3.1
  %.3046 = mul i64 %.3027, %arg.bounds.6.0
  %41 = getelementptr i8, ptr %arg.bounds.4, i64 %.3046
  %.3213 = mul i64 %.102626342727, %arg.told.6.0
  %42 = getelementptr i8, ptr %arg.told.4, i64 %.3213
  %.3290 = select i1 %.3025, i64 %arg.kept.5.0, i64 0
  %.3291 = add i64 %.3290, %law.3.1
  %.3318 = mul i64 %.3291, %arg.kept.6.0
  %43 = getelementptr i8, ptr %arg.kept.4, i64 %.3318
  %sunkaddr271 = getelementptr i8, ptr %40, i64 %arg.force.6.1
  %sunkaddr272 = getelementptr i8, ptr %41, i64 %arg.bounds.6.1
  %sunkaddr273 = getelementptr i8, ptr %42, i64 %arg.told.6.1
  %sunkaddr275 = getelementptr i8, ptr %40, i64 %sunkaddr274
  %sunkaddr277 = getelementptr i8, ptr %41, i64 %sunkaddr276
  %sunkaddr279 = getelementptr i8, ptr %42, i64 %sunkaddr278
  %sunkaddr280 = getelementptr i8, ptr %40, i64 %.2992.us.3
  %sunkaddr281 = getelementptr i8, ptr %41, i64 %.3047.us.3
  %sunkaddr282 = getelementptr i8, ptr %42, i64 %.3214.us.3
  %sunkaddr284 = getelementptr i8, ptr %40, i64 %sunkaddr283
  %sunkaddr286 = getelementptr i8, ptr %41, i64 %sunkaddr285
  %sunkaddr288 = getelementptr i8, ptr %42, i64 %sunkaddr287
  %sunkaddr289 = getelementptr i8, ptr %40, i64 %.2992.us.5
  %sunkaddr290 = getelementptr i8, ptr %41, i64 %.3047.us.5
  %sunkaddr291 = getelementptr i8, ptr %42, i64 %.3214.us.5
  br label %B1076.endif.endif.us.5

B1076.endif.endif.us.5:                           ; preds = %B1076.endif.endif.us.5, %B996.endif.endif
  %lsr.iv203 = phi i64 [ %lsr.iv.next204, %B1076.endif.endif.us.5 ], [ 6, %B996.endif.endif ]
  %lsr.iv201 = phi ptr [ %scevgep202, %B1076.endif.endif.us.5 ], [ %.563, %B996.endif.endif ]
  %lsr.iv200 = phi ptr [ %scevgep, %B1076.endif.endif.us.5 ], [ %43, %B996.endif.endif ]
  store double 0.000000e+00, ptr %lsr.iv201, align 8
  %.2997.us = load double, ptr %40, align 8
  %.3052.us = load double, ptr %41, align 8
  %.3055.us = fneg double %.3052.us
  %.12.i105 = fcmp olt double %.2997.us, %.3055.us
  %.13.i106 = select i1 %.12.i105, double %.3055.us, double %.2997.us
  %.12.i107 = fcmp olt double %.3052.us, %.13.i106
  %.13.i108 = select i1 %.12.i107, double %.3052.us, double %.13.i106
  %.3219.us = load double, ptr %42, align 8
  %.3222.us = fadd double %.3219.us, %.13.i108
  %.3326.us = load double, ptr %lsr.iv200, align 8
  %.3330.us = fmul double %.3326.us, %.3222.us
  %.3331.us = fadd double %.3330.us, 0.000000e+00
  store double %.3331.us, ptr %lsr.iv201, align 8
  %.2997.us.1 = load double, ptr %sunkaddr271, align 8
  %.3052.us.1 = load double, ptr %sunkaddr272, align 8
  %.3055.us.1 = fneg double %.3052.us.1
  %.12.i109 = fcmp olt double %.2997.us.1, %.3055.us.1
  %.13.i110 = select i1 %.12.i109, double %.3055.us.1, double %.2997.us.1
  %.12.i111 = fcmp olt double %.3052.us.1, %.13.i110
  %.13.i112 = select i1 %.12.i111, double %.3052.us.1, double %.13.i110
  %.3219.us.1 = load double, ptr %sunkaddr273, align 8
  %.3222.us.1 = fadd double %.3219.us.1, %.13.i112
  %scevgep205 = getelementptr i8, ptr %lsr.iv200, i64 %arg.kept.6.2
  %.3326.us.1 = load double, ptr %scevgep205, align 8
  %.3330.us.1 = fmul double %.3326.us.1, %.3222.us.1
  %.3331.us.1 = fadd double %.3331.us, %.3330.us.1
  store double %.3331.us.1, ptr %lsr.iv201, align 8
  %.2997.us.2 = load double, ptr %sunkaddr275, align 8
  %.3052.us.2 = load double, ptr %sunkaddr277, align 8
  %.3055.us.2 = fneg double %.3052.us.2
  %.12.i113 = fcmp olt double %.2997.us.2, %.3055.us.2
  %.13.i114 = select i1 %.12.i113, double %.3055.us.2, double %.2997.us.2
  %.12.i115 = fcmp olt double %.3052.us.2, %.13.i114
  %.13.i116 = select i1 %.12.i115, double %.3052.us.2, double %.13.i114
  %.3219.us.2 = load double, ptr %sunkaddr279, align 8
  %.3222.us.2 = fadd double %.3219.us.2, %.13.i116
  %scevgep206 = getelementptr i8, ptr %scevgep205, i64 %arg.kept.6.2
  %.3326.us.2 = load double, ptr %scevgep206, align 8
  %.3330.us.2 = fmul double %.3326.us.2, %.3222.us.2
  %.3331.us.2 = fadd double %.3331.us.1, %.3330.us.2
  store double %.3331.us.2, ptr %lsr.iv201, align 8
  %.2997.us.3 = load double, ptr %sunkaddr280, align 8
  %.3052.us.3 = load double, ptr %sunkaddr281, align 8
  %.3055.us.3 = fneg double %.3052.us.3
  %.12.i117 = fcmp olt double %.2997.us.3, %.3055.us.3
  %.13.i118 = select i1 %.12.i117, double %.3055.us.3, double %.2997.us.3
  %.12.i119 = fcmp olt double %.3052.us.3, %.13.i118
  %.13.i120 = select i1 %.12.i119, double %.3052.us.3, double %.13.i118
  %.3219.us.3 = load double, ptr %sunkaddr282, align 8
  %.3222.us.3 = fadd double %.3219.us.3, %.13.i120
  %scevgep207 = getelementptr i8, ptr %scevgep206, i64 %arg.kept.6.2
  %.3326.us.3 = load double, ptr %scevgep207, align 8
  %.3330.us.3 = fmul double %.3326.us.3, %.3222.us.3
  %.3331.us.3 = fadd double %.3331.us.2, %.3330.us.3
  store double %.3331.us.3, ptr %lsr.iv201, align 8
  %.2997.us.4 = load double, ptr %sunkaddr284, align 8
  %.3052.us.4 = load double, ptr %sunkaddr286, align 8
  %.3055.us.4 = fneg double %.3052.us.4
  %.12.i121 = fcmp olt double %.2997.us.4, %.3055.us.4
  %.13.i122 = select i1 %.12.i121, double %.3055.us.4, double %.2997.us.4
  %.12.i123 = fcmp olt double %.3052.us.4, %.13.i122
  %.13.i124 = select i1 %.12.i123, double %.3052.us.4, double %.13.i122
  %.3219.us.4 = load double, ptr %sunkaddr288, align 8
  %.3222.us.4 = fadd double %.3219.us.4, %.13.i124
  %scevgep208 = getelementptr i8, ptr %scevgep207, i64 %arg.kept.6.2
  %.3326.us.4 = load double, ptr %scevgep208, align 8
  %.3330.us.4 = fmul double %.3326.us.4, %.3222.us.4
  %.3331.us.4 = fadd double %.3331.us.3, %.3330.us.4
  store double %.3331.us.4, ptr %lsr.iv201, align 8
  %.2997.us.5 = load double, ptr %sunkaddr289, align 8
  %.3052.us.5 = load double, ptr %sunkaddr290, align 8
  %.3055.us.5 = fneg double %.3052.us.5
  %.12.i125 = fcmp olt double %.2997.us.5, %.3055.us.5
  %.13.i126 = select i1 %.12.i125, double %.3055.us.5, double %.2997.us.5
  %.12.i127 = fcmp olt double %.3052.us.5, %.13.i126
  %.13.i128 = select i1 %.12.i127, double %.3052.us.5, double %.13.i126
  %.3219.us.5 = load double, ptr %sunkaddr291, align 8
  %.3222.us.5 = fadd double %.3219.us.5, %.13.i128
  %scevgep209 = getelementptr i8, ptr %scevgep208, i64 %arg.kept.6.2
  %.3326.us.5 = load double, ptr %scevgep209, align 8
  %.3330.us.5 = fmul double %.3326.us.5, %.3222.us.5
  %.3331.us.5 = fadd double %.3331.us.4, %.3330.us.5
  store double %.3331.us.5, ptr %lsr.iv201, align 8
  %scevgep = getelementptr i8, ptr %lsr.iv200, i64 %arg.kept.6.1
  %scevgep202 = getelementptr i8, ptr %lsr.iv201, i64 %arg.room.6.1
  %lsr.iv.next204 = add nsw i64 %lsr.iv203, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next204, 0
  br i1 %exitcond.not, label %B1270.split.us, label %B1076.endif.endif.us.5

B1270.split.us:                                   ; preds = %B1076.endif.endif.us.5
  %.3391 = icmp eq i64 %.1033, %arg.u.5.0
  br i1 %.3391, label %common.ret, label %B1320

B1320.endif:                                      ; preds = %B222.endif.i, %B150.i
  %"$phi268.0.2.0.i" = phi double [ %.225.i, %B222.endif.i ], [ 0.000000e+00, %B150.i ]
  %.3838 = mul i64 %.1033, %arg.q_e.6.0
  %.3842 = getelementptr i8, ptr %arg.q_e.4, i64 %.3838
  %.3844 = load double, ptr %.3842, align 8
  %gep2620 = getelementptr i8, ptr %invariant.gep2617, i64 %.3838
  %.3900 = load double, ptr %gep2620, align 8
  %gep2765 = getelementptr i8, ptr %invariant.gep2760, i64 %.3838
  %.3956 = load double, ptr %gep2765, align 8
  %gep2767 = getelementptr i8, ptr %invariant.gep2762, i64 %.3838
  %.4012 = load double, ptr %gep2767, align 8
  %.60.i.i129 = fmul double %.3574, %.3844
  %44 = fmul double %.3629, %.3900
  %.62.i.i130 = fadd double %.60.i.i129, %44
  %45 = fmul double %.3684, %.3956
  %.64.i.i131 = fadd double %.62.i.i130, %45
  %46 = fmul double %.3739, %.4012
  %.66.i.i132 = fadd double %.64.i.i131, %46
  %.68.i.i133 = fmul double %.3574, %.3900
  %47 = fmul double %.3629, %.3844
  %.69.i.i134 = fsub double %.68.i.i133, %47
  %48 = fmul double %.3739, %.3956
  %.71.i.i135 = fsub double %.69.i.i134, %48
  %49 = fmul double %.3684, %.4012
  %.73.i.i136 = fadd double %49, %.71.i.i135
  %.75.i.i137 = fmul double %.3574, %.3956
  %50 = fmul double %.3684, %.3844
  %.76.i.i138 = fsub double %.75.i.i137, %50
  %51 = fmul double %.3629, %.4012
  %.78.i.i139 = fsub double %.76.i.i138, %51
  %52 = fmul double %.3739, %.3900
  %.80.i.i140 = fadd double %52, %.78.i.i139
  %.82.i.i141 = fmul double %.3574, %.4012
  %53 = fmul double %.3739, %.3844
  %.83.i.i142 = fsub double %.82.i.i141, %53
  %54 = fmul double %.3684, %.3900
  %.85.i.i143 = fsub double %.83.i.i142, %54
  %55 = fmul double %.3629, %.3956
  %.87.i.i144 = fadd double %55, %.85.i.i143
  %.136.i145 = fcmp olt double %.66.i.i132, 0.000000e+00
  br i1 %.136.i145, label %B120.i168, label %B150.i146

B120.i168:                                        ; preds = %B1320.endif
  %.139.i169 = fneg double %.66.i.i132
  %.143.i170 = fneg double %.73.i.i136
  %.147.i171 = fneg double %.80.i.i140
  %.151.i172 = fneg double %.87.i.i144
  br label %B150.i146

B150.i146:                                        ; preds = %B120.i168, %B1320.endif
  %w.2.0.i147 = phi double [ %.139.i169, %B120.i168 ], [ %.66.i.i132, %B1320.endif ]
  %x.2.0.i148 = phi double [ %.143.i170, %B120.i168 ], [ %.73.i.i136, %B1320.endif ]
  %y.2.0.i149 = phi double [ %.147.i171, %B120.i168 ], [ %.80.i.i140, %B1320.endif ]
  %z.2.0.i150 = phi double [ %.151.i172, %B120.i168 ], [ %.87.i.i144, %B1320.endif ]
  %.197.i151 = fmul double %x.2.0.i148, %x.2.0.i148
  %.200.i152 = fmul double %y.2.0.i149, %y.2.0.i149
  %.201.i153 = fadd double %.197.i151, %.200.i152
  %.204.i154 = fmul double %z.2.0.i150, %z.2.0.i150
  %.205.i155 = fadd double %.201.i153, %.204.i154
  %.212.i156 = fcmp ogt double %.205.i155, 0.000000e+00
  br i1 %.212.i156, label %B222.endif.i163, label %B1802.thread

B222.endif.i163:                                  ; preds = %B150.i146
  %sqrt.i164 = tail call double @llvm.sqrt.f64(double %.205.i155)
  %.216.i165 = tail call double @atan2(double %sqrt.i164, double %w.2.0.i147)
  %.220.i166 = fmul double %.216.i165, 2.000000e+00
  %.225.i167 = fdiv double %.220.i166, %sqrt.i164
  br label %B1802.thread

B1892.endif:                                      ; preds = %B1802.thread
  %.4765 = load double, ptr %18, align 8
  %.4824 = fsub double %.4765, %.4668
  %.4833 = fdiv double %.4824, %arg.h
  br label %B1802.thread.1
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sin.f64(double) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.cos.f64(double) #1

; Function Attrs: nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #1

attributes #0 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #1 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #2 = { mustprogress nofree nosync nounwind willreturn memory(none) }
attributes #3 = { nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }

!0 = distinct !{!0, !1}
!1 = !{!"llvm.loop.peeled.count", i32 1}
!2 = !{!3}
!3 = distinct !{!3, !4, !"part.5: %retptr"}
!4 = distinct !{!4, !"part.5"}
!5 = !{!6}
!6 = distinct !{!6, !7, !"part.5: %retptr"}
!7 = distinct !{!7, !"part.5"}
!8 = distinct !{!8, !9}
!9 = !{!"llvm.loop.unroll.disable"}
!10 = !{!11}
!11 = distinct !{!11, !12, !"part.0: %retptr"}
!12 = distinct !{!12, !"part.0"}
!13 = !{!14, !11}
!14 = distinct !{!14, !15, !"part.5: %retptr"}
!15 = distinct !{!15, !"part.5"}
!16 = !{!"branch_weights", i32 -939524096, i32 0}
