; sha256 2d5b35217de8d743c56fd233cc4b288ae6c852e5a34480fae3280348894950b7 of hermite_loops.py and of this
; made by numba 0.68.1, llvmlite 0.50.0, Python 3.11.7
; loops.fill: array(float64, 1d, A); array(float64, 2d, A); array(float64, 2d, A); array(float64, 1d, A); float64; array(float64, 3d, C)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef i32 @loops.fill(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readnone captures(none) %arg.grid.0, ptr readnone captures(none) %arg.grid.1, i64 %arg.grid.2, i64 %arg.grid.3, ptr readonly captures(none) %arg.grid.4, i64 %arg.grid.5.0, i64 %arg.grid.6.0, ptr readnone captures(none) %arg.x.0, ptr readnone captures(none) %arg.x.1, i64 %arg.x.2, i64 %arg.x.3, ptr readonly captures(none) %arg.x.4, i64 %arg.x.5.0, i64 %arg.x.5.1, i64 %arg.x.6.0, i64 %arg.x.6.1, ptr readnone captures(none) %arg.v.0, ptr readnone captures(none) %arg.v.1, i64 %arg.v.2, i64 %arg.v.3, ptr readonly captures(none) %arg.v.4, i64 %arg.v.5.0, i64 %arg.v.5.1, i64 %arg.v.6.0, i64 %arg.v.6.1, ptr readnone captures(none) %arg.tau.0, ptr readnone captures(none) %arg.tau.1, i64 %arg.tau.2, i64 %arg.tau.3, ptr readonly captures(none) %arg.tau.4, i64 %arg.tau.5.0, i64 %arg.tau.6.0, double %arg.aside, ptr readnone captures(none) %arg.out.0, ptr readnone captures(none) %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr writeonly captures(none) %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.5.1, i64 %arg.out.5.2, i64 %arg.out.6.0, i64 %arg.out.6.1, i64 %arg.out.6.2) local_unnamed_addr #0 {
B0.endif:
  %.193463.not = icmp slt i64 %arg.tau.5.0, 1
  br i1 %.193463.not, label %B686, label %B64.lr.ph

B64.lr.ph:                                        ; preds = %B0.endif
  %.244 = add nsw i64 %arg.grid.5.0, -1
  %.667453.not = icmp slt i64 %arg.x.5.1, 1
  %.1072 = mul i64 %arg.out.5.2, %arg.out.5.1
  %0 = getelementptr double, ptr %arg.out.4, i64 %.1072
  %.idx = shl i64 %.1072, 4
  %1 = getelementptr i8, ptr %arg.out.4, i64 %.idx
  br i1 %.667453.not, label %B64.lr.ph.split.us, label %B64.preheader

B64.preheader:                                    ; preds = %B64.lr.ph
  %2 = add nsw i64 %arg.x.5.1, -1
  %3 = add nuw i64 %arg.tau.5.0, 2305843009213693951
  %4 = mul i64 %arg.out.5.2, %3
  %5 = shl i64 %arg.x.5.1, 3
  %6 = add i64 %4, %arg.x.5.1
  %7 = shl i64 %6, 3
  %scevgep = getelementptr i8, ptr %arg.out.4, i64 %7
  %8 = shl i64 %arg.out.5.2, 3
  %9 = shl i64 %arg.tau.5.0, 3
  %10 = add i64 %arg.out.5.1, %arg.tau.5.0
  %11 = shl i64 %10, 3
  %12 = add i64 %11, -8
  %13 = mul i64 %12, %arg.out.5.2
  %14 = getelementptr i8, ptr %arg.out.4, i64 %13
  %scevgep10 = getelementptr i8, ptr %14, i64 %5
  %15 = shl i64 %arg.out.5.1, 4
  %16 = add i64 %9, -8
  %17 = add i64 %16, %15
  %18 = mul i64 %17, %arg.out.5.2
  %19 = getelementptr i8, ptr %arg.out.4, i64 %18
  %scevgep11 = getelementptr i8, ptr %19, i64 %5
  %20 = add nuw i64 %arg.x.5.1, 7
  %scevgep12 = getelementptr i8, ptr %arg.v.4, i64 %20
  %scevgep16 = getelementptr i8, ptr %arg.x.4, i64 %20
  %ident.check = icmp ne i64 %arg.v.6.1, 1
  %ident.check6 = icmp ne i64 %arg.x.6.1, 1
  %21 = or i1 %ident.check6, %ident.check
  %bound0 = icmp ult ptr %arg.out.4, %scevgep10
  %bound1 = icmp ult ptr %0, %scevgep
  %found.conflict = and i1 %bound1, %bound0
  %bound021 = icmp ult ptr %arg.out.4, %scevgep11
  %bound122 = icmp ult ptr %1, %scevgep
  %found.conflict23 = and i1 %bound021, %bound122
  %stride.check24 = icmp slt i64 %8, 0
  %22 = or i1 %found.conflict23, %found.conflict
  %bound046 = icmp ult ptr %0, %scevgep11
  %bound147 = icmp ult ptr %1, %scevgep10
  %found.conflict48 = and i1 %bound046, %bound147
  %n.vec = and i64 %arg.x.5.1, 9223372036854775806
  %scevgep102 = getelementptr i8, ptr %arg.v.4, i64 1
  %scevgep112 = getelementptr i8, ptr %arg.x.4, i64 1
  %23 = icmp sgt i64 %arg.grid.5.0, 2
  %24 = icmp samesign ult i64 %arg.x.5.1, 6
  %25 = icmp eq i64 %arg.x.5.1, %n.vec
  br label %B64

B64.lr.ph.split.us:                               ; preds = %B64.lr.ph
  %26 = icmp sgt i64 %arg.grid.5.0, 2
  br i1 %26, label %B64.us.us.preheader, label %B686

B64.us.us.preheader:                              ; preds = %B64.lr.ph.split.us
  %.371.us.us = load double, ptr %arg.tau.4, align 8
  %.373.us.us = fadd double %arg.aside, %.371.us.us
  br label %B124.else.if.us.us

B124.else.if.us.us:                               ; preds = %B124.else.if.us.us, %B64.us.us.preheader
  %end.2.1.us.us = phi i64 [ %end.3.3.us.us, %B124.else.if.us.us ], [ %.244, %B64.us.us.preheader ]
  %i.2.1.us.us = phi i64 [ %i.3.3.us.us, %B124.else.if.us.us ], [ 0, %B64.us.us.preheader ]
  %.264.us.us = add nsw i64 %i.2.1.us.us, %end.2.1.us.us
  %.272.1.us.us = ashr i64 %.264.us.us, 1
  %.322.us.us = icmp slt i64 %.272.1.us.us, 0
  %.323.us.us = select i1 %.322.us.us, i64 %arg.grid.5.0, i64 0
  %.324.us.us = add i64 %.323.us.us, %.272.1.us.us
  %.335.us.us = mul i64 %.324.us.us, %arg.grid.6.0
  %.337.us.us = getelementptr i8, ptr %arg.grid.4, i64 %.335.us.us
  %.339.us.us = load double, ptr %.337.us.us, align 8
  %.374.us.us = fcmp ole double %.339.us.us, %.373.us.us
  %end.3.3.us.us = select i1 %.374.us.us, i64 %end.2.1.us.us, i64 %.272.1.us.us
  %i.3.3.us.us = select i1 %.374.us.us, i64 %.272.1.us.us, i64 %i.2.1.us.us
  %.415.us.us = sub nsw i64 %end.3.3.us.us, %i.3.3.us.us
  %.420.us.us = icmp sgt i64 %.415.us.us, 1
  br i1 %.420.us.us, label %B124.else.if.us.us, label %B686

B62.loopexit.loopexit:                            ; preds = %B344, %middle.block
  %scevgep122 = getelementptr i8, ptr %lsr.iv, i64 %8
  %scevgep125 = getelementptr i8, ptr %lsr.iv124, i64 %8
  %scevgep128 = getelementptr i8, ptr %lsr.iv127, i64 %8
  %exitcond470.not = icmp eq i64 %.206, %arg.tau.5.0
  br i1 %exitcond470.not, label %B686, label %B64

B64:                                              ; preds = %B62.loopexit.loopexit, %B64.preheader
  %lsr.iv127 = phi ptr [ %1, %B64.preheader ], [ %scevgep128, %B62.loopexit.loopexit ]
  %lsr.iv124 = phi ptr [ %0, %B64.preheader ], [ %scevgep125, %B62.loopexit.loopexit ]
  %lsr.iv = phi ptr [ %arg.out.4, %B64.preheader ], [ %scevgep122, %B62.loopexit.loopexit ]
  %.199458464 = phi i64 [ 0, %B64.preheader ], [ %.206, %B62.loopexit.loopexit ]
  %.206 = add nuw nsw i64 %.199458464, 1
  %.367 = mul i64 %.199458464, %arg.tau.6.0
  %.369 = getelementptr i8, ptr %arg.tau.4, i64 %.367
  %.371 = load double, ptr %.369, align 8
  br i1 %23, label %B124.else.if.preheader, label %B210

B124.else.if.preheader:                           ; preds = %B64
  %.373 = fadd double %arg.aside, %.371
  br label %B124.else.if

B210:                                             ; preds = %B124.else.if, %B64
  %i.4.2 = phi i64 [ 0, %B64 ], [ %i.3.3, %B124.else.if ]
  %.432 = add nsw i64 %i.4.2, 1
  %.446 = icmp slt i64 %i.4.2, -1
  %.447 = select i1 %.446, i64 %arg.grid.5.0, i64 0
  %.448 = add i64 %.447, %.432
  %.459 = mul i64 %.448, %arg.grid.6.0
  %.461 = getelementptr i8, ptr %arg.grid.4, i64 %.459
  %.463 = load double, ptr %.461, align 8
  %.478 = icmp slt i64 %i.4.2, 0
  %.479 = select i1 %.478, i64 %arg.grid.5.0, i64 0
  %.480 = add i64 %.479, %i.4.2
  %.491 = mul i64 %.480, %arg.grid.6.0
  %.493 = getelementptr i8, ptr %arg.grid.4, i64 %.491
  %.495 = load double, ptr %.493, align 8
  %.496 = fsub double %.463, %.495
  %.564 = fsub double %.371, %.495
  %.569 = fdiv double %.564, %.496
  %.731 = select i1 %.478, i64 %arg.v.5.0, i64 0
  %.732 = add i64 %.731, %i.4.2
  %.751 = mul i64 %.732, %arg.v.6.0
  %27 = getelementptr i8, ptr %arg.v.4, i64 %.751
  %.789 = select i1 %.446, i64 %arg.v.5.0, i64 0
  %.790 = add i64 %.789, %.432
  %.809 = mul i64 %.790, %arg.v.6.0
  %28 = getelementptr i8, ptr %arg.v.4, i64 %.809
  %.847 = select i1 %.446, i64 %arg.x.5.0, i64 0
  %.848 = add i64 %.847, %.432
  %.867 = mul i64 %.848, %arg.x.6.0
  %29 = getelementptr i8, ptr %arg.x.4, i64 %.867
  %.902 = select i1 %.478, i64 %arg.x.5.0, i64 0
  %.903 = add i64 %.902, %i.4.2
  %.922 = mul i64 %.903, %arg.x.6.0
  %30 = getelementptr i8, ptr %arg.x.4, i64 %.922
  %.1086 = fmul double %.569, 3.000000e+00
  %.1177 = fmul double %.569, 6.000000e+00
  %.1182 = fmul double %.496, %.496
  br i1 %24, label %B344.preheader, label %vector.scevcheck

vector.scevcheck:                                 ; preds = %B210
  %31 = getelementptr i8, ptr %27, i64 %2
  %32 = icmp ult ptr %31, %27
  %33 = getelementptr i8, ptr %28, i64 %2
  %34 = icmp ult ptr %33, %28
  %35 = getelementptr i8, ptr %29, i64 %2
  %36 = icmp ult ptr %35, %29
  %37 = getelementptr i8, ptr %30, i64 %2
  %38 = icmp ult ptr %37, %30
  %39 = or i1 %21, %32
  %40 = or i1 %34, %39
  %41 = or i1 %36, %40
  %42 = or i1 %38, %41
  br i1 %42, label %B344.preheader, label %vector.memcheck

vector.memcheck:                                  ; preds = %vector.scevcheck
  %scevgep13 = getelementptr i8, ptr %scevgep12, i64 %.751
  %scevgep15 = getelementptr i8, ptr %scevgep12, i64 %.809
  %scevgep17 = getelementptr i8, ptr %scevgep16, i64 %.867
  %scevgep19 = getelementptr i8, ptr %scevgep16, i64 %.922
  %bound026 = icmp ult ptr %arg.out.4, %scevgep13
  %bound127 = icmp ult ptr %27, %scevgep
  %found.conflict28 = and i1 %bound026, %bound127
  %43 = or i1 %22, %found.conflict28
  %bound031 = icmp ult ptr %arg.out.4, %scevgep15
  %bound132 = icmp ult ptr %28, %scevgep
  %found.conflict33 = and i1 %bound031, %bound132
  %44 = or i1 %found.conflict33, %43
  %bound036 = icmp ult ptr %arg.out.4, %scevgep17
  %bound137 = icmp ult ptr %29, %scevgep
  %found.conflict38 = and i1 %bound036, %bound137
  %45 = or i1 %found.conflict38, %44
  %bound041 = icmp ult ptr %arg.out.4, %scevgep19
  %bound142 = icmp ult ptr %30, %scevgep
  %found.conflict43 = and i1 %bound041, %bound142
  %46 = or i1 %found.conflict43, %45
  %47 = or i1 %found.conflict48, %46
  %bound052 = icmp ult ptr %0, %scevgep13
  %bound153 = icmp ult ptr %27, %scevgep10
  %found.conflict54 = and i1 %bound052, %bound153
  %48 = or i1 %found.conflict54, %47
  %bound057 = icmp ult ptr %0, %scevgep15
  %bound158 = icmp ult ptr %28, %scevgep10
  %found.conflict59 = and i1 %bound057, %bound158
  %49 = or i1 %found.conflict59, %48
  %bound062 = icmp ult ptr %0, %scevgep17
  %bound163 = icmp ult ptr %29, %scevgep10
  %found.conflict64 = and i1 %bound062, %bound163
  %50 = or i1 %stride.check24, %found.conflict64
  %conflict.rdx66 = or i1 %50, %49
  %bound067 = icmp ult ptr %0, %scevgep19
  %bound168 = icmp ult ptr %30, %scevgep10
  %found.conflict69 = and i1 %bound067, %bound168
  %conflict.rdx71 = or i1 %found.conflict69, %conflict.rdx66
  %bound072 = icmp ult ptr %1, %scevgep13
  %bound173 = icmp ult ptr %27, %scevgep11
  %found.conflict74 = and i1 %bound072, %bound173
  %conflict.rdx76 = or i1 %found.conflict74, %conflict.rdx71
  %bound077 = icmp ult ptr %1, %scevgep15
  %bound178 = icmp ult ptr %28, %scevgep11
  %found.conflict79 = and i1 %bound077, %bound178
  %conflict.rdx81 = or i1 %found.conflict79, %conflict.rdx76
  %bound082 = icmp ult ptr %1, %scevgep17
  %bound183 = icmp ult ptr %29, %scevgep11
  %found.conflict84 = and i1 %bound082, %bound183
  %conflict.rdx86 = or i1 %found.conflict84, %conflict.rdx81
  %bound087 = icmp ult ptr %1, %scevgep19
  %bound188 = icmp ult ptr %30, %scevgep11
  %found.conflict89 = and i1 %bound087, %bound188
  %conflict.rdx91 = or i1 %found.conflict89, %conflict.rdx86
  br i1 %conflict.rdx91, label %B344.preheader, label %vector.ph

vector.ph:                                        ; preds = %vector.memcheck
  %broadcast.splatinsert = insertelement <2 x double> poison, double %.496, i64 0
  %broadcast.splat = shufflevector <2 x double> %broadcast.splatinsert, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert92 = insertelement <2 x double> poison, double %.569, i64 0
  %broadcast.splat93 = shufflevector <2 x double> %broadcast.splatinsert92, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert94 = insertelement <2 x double> poison, double %.1086, i64 0
  %broadcast.splat95 = shufflevector <2 x double> %broadcast.splatinsert94, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert96 = insertelement <2 x double> poison, double %.1177, i64 0
  %broadcast.splat97 = shufflevector <2 x double> %broadcast.splatinsert96, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert98 = insertelement <2 x double> poison, double %.1182, i64 0
  %broadcast.splat99 = shufflevector <2 x double> %broadcast.splatinsert98, <2 x double> poison, <2 x i32> zeroinitializer
  %scevgep103 = getelementptr i8, ptr %scevgep102, i64 %.751
  %scevgep108 = getelementptr i8, ptr %scevgep102, i64 %.809
  %scevgep113 = getelementptr i8, ptr %scevgep112, i64 %.867
  %scevgep118 = getelementptr i8, ptr %scevgep112, i64 %.922
  br label %vector.body

vector.body:                                      ; preds = %vector.body, %vector.ph
  %index = phi i64 [ 0, %vector.ph ], [ %index.next, %vector.body ]
  %scevgep105 = getelementptr i8, ptr %scevgep103, i64 %index
  %scevgep106 = getelementptr i8, ptr %scevgep105, i64 -1
  %51 = load double, ptr %scevgep106, align 8, !alias.scope !0
  %52 = load double, ptr %scevgep105, align 8, !alias.scope !0
  %53 = insertelement <2 x double> poison, double %51, i64 0
  %54 = insertelement <2 x double> %53, double %52, i64 1
  %55 = fmul <2 x double> %broadcast.splat, %54
  %scevgep110 = getelementptr i8, ptr %scevgep108, i64 %index
  %scevgep111 = getelementptr i8, ptr %scevgep110, i64 -1
  %56 = load double, ptr %scevgep111, align 8, !alias.scope !3
  %57 = load double, ptr %scevgep110, align 8, !alias.scope !3
  %58 = insertelement <2 x double> poison, double %56, i64 0
  %59 = insertelement <2 x double> %58, double %57, i64 1
  %60 = fmul <2 x double> %broadcast.splat, %59
  %scevgep115 = getelementptr i8, ptr %scevgep113, i64 %index
  %scevgep116 = getelementptr i8, ptr %scevgep115, i64 -1
  %61 = load double, ptr %scevgep116, align 8, !alias.scope !5
  %62 = load double, ptr %scevgep115, align 8, !alias.scope !5
  %63 = insertelement <2 x double> poison, double %61, i64 0
  %64 = insertelement <2 x double> %63, double %62, i64 1
  %scevgep120 = getelementptr i8, ptr %scevgep118, i64 %index
  %scevgep121 = getelementptr i8, ptr %scevgep120, i64 -1
  %65 = load double, ptr %scevgep121, align 8, !alias.scope !7
  %66 = load double, ptr %scevgep120, align 8, !alias.scope !7
  %67 = insertelement <2 x double> poison, double %65, i64 0
  %68 = insertelement <2 x double> %67, double %66, i64 1
  %69 = fsub <2 x double> %64, %68
  %70 = fmul <2 x double> %69, splat (double 3.000000e+00)
  %71 = fmul <2 x double> %55, splat (double 2.000000e+00)
  %72 = fsub <2 x double> %70, %71
  %73 = fsub <2 x double> %72, %60
  %74 = fadd <2 x double> %55, %60
  %75 = fmul <2 x double> %69, splat (double 2.000000e+00)
  %76 = fsub <2 x double> %74, %75
  %77 = fmul <2 x double> %broadcast.splat93, %76
  %78 = fadd <2 x double> %73, %77
  %79 = fmul <2 x double> %broadcast.splat93, %78
  %80 = fadd <2 x double> %55, %79
  %81 = fmul <2 x double> %broadcast.splat93, %80
  %82 = fadd <2 x double> %68, %81
  %83 = shl i64 %index, 3
  %scevgep123 = getelementptr i8, ptr %lsr.iv, i64 %83
  store <2 x double> %82, ptr %scevgep123, align 8, !alias.scope !9, !noalias !11
  %84 = fmul <2 x double> %73, splat (double 2.000000e+00)
  %85 = fmul <2 x double> %broadcast.splat95, %76
  %86 = fadd <2 x double> %85, %84
  %87 = fmul <2 x double> %broadcast.splat93, %86
  %88 = fadd <2 x double> %55, %87
  %89 = fdiv <2 x double> %88, %broadcast.splat
  %scevgep126 = getelementptr i8, ptr %lsr.iv124, i64 %83
  store <2 x double> %89, ptr %scevgep126, align 8, !alias.scope !14, !noalias !15
  %90 = fmul <2 x double> %broadcast.splat97, %76
  %91 = fadd <2 x double> %90, %84
  %92 = fdiv <2 x double> %91, %broadcast.splat99
  %scevgep129 = getelementptr i8, ptr %lsr.iv127, i64 %83
  store <2 x double> %92, ptr %scevgep129, align 8, !alias.scope !16, !noalias !17
  %index.next = add nuw nsw i64 %index, 2
  %93 = icmp eq i64 %n.vec, %index.next
  br i1 %93, label %middle.block, label %vector.body, !llvm.loop !18

middle.block:                                     ; preds = %vector.body
  br i1 %25, label %B62.loopexit.loopexit, label %B344.preheader

B344.preheader:                                   ; preds = %middle.block, %vector.memcheck, %vector.scevcheck, %B210
  %.673452454.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %vector.scevcheck ], [ 0, %B210 ], [ %n.vec, %middle.block ]
  %94 = shl i64 %.673452454.ph, 3
  %scevgep130 = getelementptr i8, ptr %lsr.iv, i64 %94
  %scevgep133 = getelementptr i8, ptr %lsr.iv124, i64 %94
  %scevgep135 = getelementptr i8, ptr %lsr.iv127, i64 %94
  %95 = mul i64 %.673452454.ph, %arg.x.6.1
  %scevgep137 = getelementptr i8, ptr %arg.x.4, i64 %95
  %96 = mul i64 %.673452454.ph, %arg.v.6.1
  %scevgep142 = getelementptr i8, ptr %arg.v.4, i64 %96
  %97 = sub nsw i64 %arg.x.5.1, %.673452454.ph
  br label %B344

B344:                                             ; preds = %B344, %B344.preheader
  %lsr.iv143 = phi ptr [ %scevgep142, %B344.preheader ], [ %scevgep144, %B344 ]
  %lsr.iv138 = phi ptr [ %scevgep137, %B344.preheader ], [ %scevgep139, %B344 ]
  %lsr.iv131 = phi i64 [ 0, %B344.preheader ], [ %lsr.iv.next, %B344 ]
  %scevgep146 = getelementptr i8, ptr %lsr.iv143, i64 %.751
  %.757 = load double, ptr %scevgep146, align 8
  %.761 = fmul double %.496, %.757
  %scevgep145 = getelementptr i8, ptr %lsr.iv143, i64 %.809
  %.815 = load double, ptr %scevgep145, align 8
  %.819 = fmul double %.496, %.815
  %scevgep141 = getelementptr i8, ptr %lsr.iv138, i64 %.867
  %.873 = load double, ptr %scevgep141, align 8
  %scevgep140 = getelementptr i8, ptr %lsr.iv138, i64 %.922
  %.928 = load double, ptr %scevgep140, align 8
  %.931 = fsub double %.873, %.928
  %.933 = fmul double %.931, 3.000000e+00
  %.935 = fmul double %.761, 2.000000e+00
  %.936 = fsub double %.933, %.935
  %.937 = fsub double %.936, %.819
  %.938 = fadd double %.761, %.819
  %.940 = fmul double %.931, 2.000000e+00
  %.941 = fsub double %.938, %.940
  %.998 = fmul double %.569, %.941
  %.999 = fadd double %.937, %.998
  %.1001 = fmul double %.569, %.999
  %.1002 = fadd double %.761, %.1001
  %.1004 = fmul double %.569, %.1002
  %.1005 = fadd double %.928, %.1004
  %98 = shl i64 %lsr.iv131, 3
  %scevgep132 = getelementptr i8, ptr %scevgep130, i64 %98
  store double %.1005, ptr %scevgep132, align 8
  %.1083 = fmul double %.937, 2.000000e+00
  %.1087 = fmul double %.1086, %.941
  %.1088 = fadd double %.1087, %.1083
  %.1090 = fmul double %.569, %.1088
  %.1091 = fadd double %.761, %.1090
  %.1096 = fdiv double %.1091, %.496
  %scevgep134 = getelementptr i8, ptr %scevgep133, i64 %98
  store double %.1096, ptr %scevgep134, align 8
  %.1178 = fmul double %.1177, %.941
  %.1179 = fadd double %.1178, %.1083
  %.1186 = fdiv double %.1179, %.1182
  %scevgep136 = getelementptr i8, ptr %scevgep135, i64 %98
  store double %.1186, ptr %scevgep136, align 8
  %lsr.iv.next = add i64 %lsr.iv131, 1
  %scevgep139 = getelementptr i8, ptr %lsr.iv138, i64 %arg.x.6.1
  %scevgep144 = getelementptr i8, ptr %lsr.iv143, i64 %arg.v.6.1
  %exitcond.not = icmp eq i64 %97, %lsr.iv.next
  br i1 %exitcond.not, label %B62.loopexit.loopexit, label %B344, !llvm.loop !21

B686:                                             ; preds = %B62.loopexit.loopexit, %B124.else.if.us.us, %B64.lr.ph.split.us, %B0.endif
  store ptr null, ptr %retptr, align 8
  ret i32 0

B124.else.if:                                     ; preds = %B124.else.if, %B124.else.if.preheader
  %end.2.1 = phi i64 [ %end.3.3, %B124.else.if ], [ %.244, %B124.else.if.preheader ]
  %i.2.1 = phi i64 [ %i.3.3, %B124.else.if ], [ 0, %B124.else.if.preheader ]
  %.264 = add nsw i64 %i.2.1, %end.2.1
  %.272.1 = ashr i64 %.264, 1
  %.322 = icmp slt i64 %.272.1, 0
  %.323 = select i1 %.322, i64 %arg.grid.5.0, i64 0
  %.324 = add i64 %.323, %.272.1
  %.335 = mul i64 %.324, %arg.grid.6.0
  %.337 = getelementptr i8, ptr %arg.grid.4, i64 %.335
  %.339 = load double, ptr %.337, align 8
  %.374 = fcmp ole double %.339, %.373
  %end.3.3 = select i1 %.374, i64 %end.2.1, i64 %.272.1
  %i.3.3 = select i1 %.374, i64 %.272.1, i64 %i.2.1
  %.415 = sub nsw i64 %end.3.3, %i.3.3
  %.420 = icmp sgt i64 %.415, 1
  br i1 %.420, label %B124.else.if, label %B210
}

attributes #0 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }

!0 = !{!1}
!1 = distinct !{!1, !2}
!2 = distinct !{!2, !"LVerDomain"}
!3 = !{!4}
!4 = distinct !{!4, !2}
!5 = !{!6}
!6 = distinct !{!6, !2}
!7 = !{!8}
!8 = distinct !{!8, !2}
!9 = !{!10}
!10 = distinct !{!10, !2}
!11 = !{!12, !13, !1, !4, !6, !8}
!12 = distinct !{!12, !2}
!13 = distinct !{!13, !2}
!14 = !{!12}
!15 = !{!13, !1, !4, !6, !8}
!16 = !{!13}
!17 = !{!1, !4, !6, !8}
!18 = distinct !{!18, !19, !20}
!19 = !{!"llvm.loop.isvectorized", i32 1}
!20 = !{!"llvm.loop.unroll.runtime.disable"}
!21 = distinct !{!21, !19}
