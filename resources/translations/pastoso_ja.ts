<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>Painting with thick wet paint</source>
        <translation>厚くて乾いていない絵具で描く</translation>
    </message>
    <message>
        <source>The Pastoso authors</source>
        <translation>Pastoso の作者たち</translation>
    </message>
    <message>
        <source>Free software: you may use, study, share and change it under the GNU General Public License, version 3 or later. It comes without any warranty.</source>
        <translation>自由ソフトウェアです。GNU 一般公衆利用許諾書（バージョン 3 以降）のもとで、使用、研究、共有、変更ができます。いかなる保証もありません。</translation>
    </message>
</context>
<context>
    <name>CanvasChoices</name>
    <message>
        <source>Small study</source>
        <translation>小さな習作</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>正方形</translation>
    </message>
    <message>
        <source>Small canvas</source>
        <translation>小さなキャンバス</translation>
    </message>
    <message>
        <source>Large canvas</source>
        <translation>大きなキャンバス</translation>
    </message>
    <message>
        <source>Screen, HD</source>
        <translation>画面 HD</translation>
    </message>
    <message>
        <source>Screen, QHD</source>
        <translation>画面 QHD</translation>
    </message>
    <message>
        <source>Linen</source>
        <translation>麻布</translation>
    </message>
    <message>
        <source>coarse weave</source>
        <translation>粗い織り</translation>
    </message>
    <message>
        <source>Cotton duck</source>
        <translation>綿布</translation>
    </message>
    <message>
        <source>fine weave</source>
        <translation>細かい織り</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>パネル</translation>
    </message>
    <message>
        <source>smooth gesso</source>
        <translation>なめらかなジェッソ</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>an image</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Medium linen</source>
        <translation>中目の亜麻布</translation>
    </message>
    <message>
        <source>lively weave with slubs</source>
        <translation>節のある生き生きとした織り</translation>
    </message>
    <message>
        <source>Fine portrait linen</source>
        <translation>細目の肖像用亜麻布</translation>
    </message>
    <message>
        <source>Rough jute</source>
        <translation>粗いジュート</translation>
    </message>
    <message>
        <source>fine even weave</source>
        <translation>細かく均一な織り</translation>
    </message>
    <message>
        <source>Gesso panel</source>
        <translation>ジェッソ板</translation>
    </message>
    <message>
        <source>brushed gesso</source>
        <translation>刷毛塗りのジェッソ</translation>
    </message>
</context>
<context>
    <name>Engine</name>
    <message>
        <source>&quot;%1&quot; holds no picture and is left out.</source>
        <translation>「%1」には画像がないため、取り込みません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2, but must lie between %3 and %4.</source>
        <translation>「%1」は %2 ですが、%3 から %4 の範囲でなければなりません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is known in millimetres only; in cells describe a &quot;weave&quot;.</source>
        <translation>「%1」はミリメートル単位でのみ使えます。セル単位では「weave」を記述してください。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is needed on the canvas itself.</source>
        <translation>「%1」はキャンバスの操作に必要です。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither &quot;once&quot; nor &quot;reflected&quot;.</source>
        <translation>「%1」は「once」でも「reflected」でもありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither K nor S.</source>
        <translation>「%1」はKでもSでもありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no form of a shape; there are %2.</source>
        <translation>「%1」という形はありません。使える形は %2 です。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tool that an eraser end can take.</source>
        <translation>「%1」は消しゴム側で持てる道具ではありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none of &quot;particles&quot;, &quot;level_set&quot;, &quot;upwind_level_set&quot; and &quot;particle_level_set&quot;.</source>
        <translation>「%1」は「particles」「level_set」「upwind_level_set」「particle_level_set」のいずれでもありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none of %2.</source>
        <translation>「%1」は次のいずれでもありません: %2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a colour such as #783c14.</source>
        <translation>「%1」は#783c14のような色ではありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a colour; a colour is # and six hexadecimal digits, for example #c03020.</source>
        <translation>「%1」は色ではありません。色は # と 6 桁の 16 進数で書きます。例: #c03020。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a finite number.</source>
        <translation>「%1」は有限の数ではありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a key such as Ctrl+Shift+Z.</source>
        <translation>「%1」は Ctrl+Shift+Z のようなキーではありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number.</source>
        <translation>「%1」は数ではありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a wavelength in nm and a power with one comma.</source>
        <translation>「%1」は、コンマ 1 つで区切った波長 (nm) と強度になっていません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not one of %2.</source>
        <translation>「%1」は次のいずれでもありません: %2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the key of %2 already.</source>
        <translation>「%1」はすでに%2のキーです。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the name of no command.</source>
        <translation>「%1」という名前のコマンドはありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands here twice.</source>
        <translation>「%1」がここに二度あります。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands once for the whole file.</source>
        <translation>「%1」はファイル全体で一度だけ書きます。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was laid over the others by %2 and is laid over them as paint.</source>
        <translation>「%1」は %2 で重ねられていましたが、ここでは絵具として重ねます。</translation>
    </message>
    <message>
        <source>&quot;endloop&quot; is missing before %1.</source>
        <translation>%1 の前に「endloop」がありません。</translation>
    </message>
    <message>
        <source>&quot;tilt&quot; and &quot;gravity&quot; say the same; give one of them.</source>
        <translation>「tilt」と「gravity」は同じことを表します。どちらか一方を指定してください。</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; is not a finite number.</source>
        <translation>%1「%2」は有限の数値ではありません。</translation>
    </message>
    <message>
        <source>%1 (&quot;%2&quot;)</source>
        <translation>%1（「%2」）</translation>
    </message>
    <message>
        <source>%1 (&quot;%2&quot;): the field &quot;family&quot; is missing.</source>
        <translation>%1 (「%2」): 項目「family」がありません。</translation>
    </message>
    <message>
        <source>%1 (&quot;%2&quot;): thinned_with is &quot;%3&quot;, it must be the name of another medium here.</source>
        <translation>%1 (「%2」): thinned_with が「%3」ですが、ここにある別のメディウムの名前でなければなりません。</translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation>%1（%2）。</translation>
    </message>
    <message>
        <source>%1 Not read: %2</source>
        <translation>%1 読み込めなかったもの: %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 と %2</translation>
    </message>
    <message>
        <source>%1 does not belong in an STL file.</source>
        <translation>%1 は STL ファイルでは使えません。</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which cannot set &quot;%3&quot;.</source>
        <translation>%1 が「%2」ですが、これで「%3」を変えることはできません。</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which is none of: %3.</source>
        <translation>%1 が「%2」ですが、次のいずれかでなければなりません: %3。</translation>
    </message>
    <message>
        <source>%1 is %2 in cell (%3, %4), but must lie between 0 and %5 (cells count from 0 at the upper left).</source>
        <translation>セル (%3, %4) の%1は %2 ですが、0 から %5 の範囲でなければなりません (セルは左上を 0 として数えます)。</translation>
    </message>
    <message>
        <source>%1 is %2, it must be a number from %3 to %4.</source>
        <translation>%1 が %2 ですが、%3 から %4 の数値でなければなりません。</translation>
    </message>
    <message>
        <source>%1 is %2, it must be a text.</source>
        <translation>%1 が %2 ですが、文字列でなければなりません。</translation>
    </message>
    <message>
        <source>%1 is %2, more than the length, %3.</source>
        <translation>%1 が %2 で、長さ %3 を超えています。</translation>
    </message>
    <message>
        <source>%1 is %2, not between %3 and %4.</source>
        <translation>%1 (値 %2) は %3 から %4 の範囲にありません。</translation>
    </message>
    <message>
        <source>%1 is %2, outside %3 to %4.</source>
        <translation>%1 が %2 で、%3 から %4 の範囲にありません。</translation>
    </message>
    <message>
        <source>%1 is %2, so that more than 100000 drops a second would fall.</source>
        <translation>%1 が %2 ですが、これでは毎秒 100000 滴を超えて落ちることになります。</translation>
    </message>
    <message>
        <source>%1 is %2, whose input is not above that of the point before it.</source>
        <translation>%1 が %2 で、入力が前の点の入力より大きくありません。</translation>
    </message>
    <message>
        <source>%1 is a file; numbered pictures go into a folder.</source>
        <translation>%1 はファイルです。連番画像はフォルダーに保存します。</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1 が空です。</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1 がありません。</translation>
    </message>
    <message>
        <source>%1 is no corner of a face.</source>
        <translation>%1 は面の頂点ではありません。</translation>
    </message>
    <message>
        <source>%1 is no number.</source>
        <translation>%1 は数値ではありません。</translation>
    </message>
    <message>
        <source>%1 is not a field of a brush preset (value %2).</source>
        <translation>%1 はブラシのプリセットの項目ではありません (値 %2)。</translation>
    </message>
    <message>
        <source>%1 is not a list of %2 numbers.</source>
        <translation>%1 は %2 個の数値のリストではありません。</translation>
    </message>
    <message>
        <source>%1 is not above 0 and at most %2.</source>
        <translation>%1は0より大きく%2以下ではありません。</translation>
    </message>
    <message>
        <source>%1 is not between %2 and %3.</source>
        <translation>%1 は %2 から %3 の範囲にありません。</translation>
    </message>
    <message>
        <source>%1 is not finite in single precision.</source>
        <translation>%1 は単精度では有限の値になりません。</translation>
    </message>
    <message>
        <source>%1 is not from %2 to %3.</source>
        <translation>%1は%2から%3の範囲にありません。</translation>
    </message>
    <message>
        <source>%1 must be a list, not %2.</source>
        <translation>%1 はリストでなければなりませんが、%2 になっています。</translation>
    </message>
    <message>
        <source>%1 must be a number, not %2.</source>
        <translation>%1 は数値でなければなりませんが、%2 になっています。</translation>
    </message>
    <message>
        <source>%1 must be a text, not %2.</source>
        <translation>%1 は文字列でなければなりませんが、%2 になっています。</translation>
    </message>
    <message>
        <source>%1 must be a whole number, not %2.</source>
        <translation>%1 は整数でなければなりませんが、%2 になっています。</translation>
    </message>
    <message>
        <source>%1 must be an object, not %2.</source>
        <translation>%1 はオブジェクトでなければなりませんが、%2 になっています。</translation>
    </message>
    <message>
        <source>%1 must be true or false, not %2.</source>
        <translation>%1 は true か false でなければなりませんが、%2 になっています。</translation>
    </message>
    <message>
        <source>%1 must be two numbers, not %2.</source>
        <translation>%1 は 2 つの数値でなければなりませんが、%2 になっています。</translation>
    </message>
    <message>
        <source>%1 must have 1 to %2 points, not %3.</source>
        <translation>%1 の点は 1 から %2 個でなければなりませんが、%3 個あります。</translation>
    </message>
    <message>
        <source>%1 names %2 %3, but %4 were given until here.</source>
        <translation>%1 は%2の %3 番を指していますが、ここまでに書かれているのは %4 個です。</translation>
    </message>
    <message>
        <source>%1 needs about %2; %3 of memory are free.</source>
        <translation>%1には約 %2 のメモリーが必要ですが、空きは %3 です。</translation>
    </message>
    <message>
        <source>%1 normal</source>
        <translation>%1 の法線</translation>
    </message>
    <message>
        <source>%1 of the pigment &quot;%2&quot; is given twice.</source>
        <translation>顔料「%2」の %1 が 2 回書かれています。</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 または %2</translation>
    </message>
    <message>
        <source>%1 per mm is negative.</source>
        <translation>1 mmあたり%1は負の値です。</translation>
    </message>
    <message>
        <source>%1 position</source>
        <translation>%1 の位置</translation>
    </message>
    <message>
        <source>%1 triangles take %2 bytes, but the file has %3.</source>
        <translation>三角形 %1 個には %2 バイト必要ですが、ファイルは %3 バイトです。</translation>
    </message>
    <message>
        <source>%1 x %2 cells need about %3; %4 of memory are free.</source>
        <translation>%1 x %2 セルには約 %3 のメモリーが必要ですが、空きは %4 です。</translation>
    </message>
    <message>
        <source>%1, %2 nm: %3 is not a number.</source>
        <translation>%1、%2 nm: %3 は数値ではありません。</translation>
    </message>
    <message>
        <source>%1, %2 nm: the weight %3 is negative.</source>
        <translation>%1、%2 nm: 重み %3 が負です。</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1、%2: %3</translation>
    </message>
    <message>
        <source>%1, byte %2</source>
        <translation>%1、%2 バイト目</translation>
    </message>
    <message>
        <source>%1, byte %2: %3</source>
        <translation>%1、%2 バイト目: %3</translation>
    </message>
    <message>
        <source>%1, entry %2</source>
        <translation>%1、項目 %2</translation>
    </message>
    <message>
        <source>%1, event %2: %3</source>
        <translation>%1、イベント %2: %3</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1、%2 行目: %3</translation>
    </message>
    <message>
        <source>%1, line %2: this is not JSON, or it is cut off here.</source>
        <translation>%1、%2 行目: JSON ではないか、ここで途切れています。</translation>
    </message>
    <message>
        <source>%1, line %2: this is not valid JSON.</source>
        <translation>%1、%2 行目: 正しい JSON ではありません。</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a list of %3 bands.</source>
        <translation>%1: 「%2」が %3 個の帯域のリストになっていません。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; stands there twice.</source>
        <translation>%1: 「%2」が 2 回書かれています。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 files do not hold %3-bit pictures.</source>
        <translation>%1: %2 ファイルには %3 ビットの画像を保存できません。</translation>
    </message>
    <message>
        <source>%1: %2 files do not hold %3.</source>
        <translation>%1: %2 ファイルに保存できない種類の画像です (%3)。</translation>
    </message>
    <message>
        <source>%1: %2 files hold at most %3 pixels a side; this picture has %4 x %5.</source>
        <translation>%1: %2 ファイルに保存できるのは一辺 %3 ピクセルまでですが、この画像は %4 x %5 ピクセルです。</translation>
    </message>
    <message>
        <source>%1: %2 of the pigment &quot;%3&quot; is %4 per mm in band %5 of %6, above the %7 that paint can have; give the pigment in a weaker paint.</source>
        <translation>%1: 顔料「%3」の %2 が、%6 個中 %5 番目の帯域で 1 mm あたり %4 になり、絵具の上限 %7 を超えています。もっと薄い絵具での値を指定してください。</translation>
    </message>
    <message>
        <source>%1: %2 x %3 pixels are more than the %4 a side that a PSD file holds.</source>
        <translation>%1: %2 x %3 ピクセルは、PSD ファイルの上限である一辺 %4 ピクセルを超えています。</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2。</translation>
    </message>
    <message>
        <source>%1: 32 bits a channel hold linear light, which needs no ICC profile.</source>
        <translation>%1: 1 チャンネル 32 ビットではリニアな光を保存するため、ICC プロファイルは不要です。</translation>
    </message>
    <message>
        <source>%1: a PSD file of these layers would be larger than 2 GB.</source>
        <translation>%1: これらのレイヤーの PSD ファイルは 2 GB を超えてしまいます。</translation>
    </message>
    <message>
        <source>%1: a batch begins at an action or tick that cannot be.</source>
        <translation>%1: あり得ない操作またはティックから始まるバッチがあります。</translation>
    </message>
    <message>
        <source>%1: a batch is too short.</source>
        <translation>%1: バッチが短すぎます。</translation>
    </message>
    <message>
        <source>%1: a copy in layers is saved as .ora or .psd; this name ends in neither.</source>
        <translation>%1: レイヤー付きのコピーは .ora か .psd で保存します。この名前の拡張子はどちらでもありません。</translation>
    </message>
    <message>
        <source>%1: a mesh is read from .obj or .stl; this name ends otherwise.</source>
        <translation>%1: メッシュは .obj か .stl から読み込みます。この名前は拡張子が違います。</translation>
    </message>
    <message>
        <source>%1: a picture is saved as .png, .tif, .jpg, .webp or .exr; this name ends in none of them.</source>
        <translation>%1: 画像は .png、.tif、.jpg、.webp、.exr のいずれかで保存します。この名前の拡張子はどれでもありません。</translation>
    </message>
    <message>
        <source>%1: a relief is saved as .stl, .ply or .obj; this name ends in none of them.</source>
        <translation>%1: レリーフは .stl、.ply、.obj のいずれかで保存します。この名前の拡張子はどれでもありません。</translation>
    </message>
    <message>
        <source>%1: a relief is saved as .stl, .ply or .obj; this name ends otherwise.</source>
        <translation>%1: レリーフは .stl、.ply、.obj のいずれかで保存します。この名前は拡張子が違います。</translation>
    </message>
    <message>
        <source>%1: a scene is saved as .pbrt; this name ends otherwise.</source>
        <translation>%1: シーンは .pbrt で保存します。この名前は拡張子が違います。</translation>
    </message>
    <message>
        <source>%1: a surface is saved as .obj, .ply, .stl or .pbrt; this name ends otherwise.</source>
        <translation>%1: 表面は .obj、.ply、.stl、.pbrt のいずれかで保存します。この名前は拡張子が違います。</translation>
    </message>
    <message>
        <source>%1: a video is made by the program ffmpeg, which is not installed; a folder&apos;s name instead gives numbered pictures.</source>
        <translation>%1: 動画はプログラム ffmpeg で作りますが、インストールされていません。代わりにフォルダー名を指定すると、連番画像になります。</translation>
    </message>
    <message>
        <source>%1: a video is saved as .mp4, .mkv or .webm, and a folder&apos;s name has no ending.</source>
        <translation>%1: 動画は .mp4、.mkv、.webm のいずれかで保存します。フォルダー名には拡張子を付けません。</translation>
    </message>
    <message>
        <source>%1: a volume is saved as .vdb; this name ends otherwise.</source>
        <translation>%1: ボリュームは .vdb で保存します。この名前は拡張子が違います。</translation>
    </message>
    <message>
        <source>%1: another program is at it.</source>
        <translation>%1: 別のプログラムが使用中です。</translation>
    </message>
    <message>
        <source>%1: band %2 of &quot;%3&quot;</source>
        <translation>%1: 「%3」の帯域 %2</translation>
    </message>
    <message>
        <source>%1: cannot be created (%2).</source>
        <translation>%1: 作成できません (%2)。</translation>
    </message>
    <message>
        <source>%1: cannot be opened (%2).</source>
        <translation>%1: 開けません (%2)。</translation>
    </message>
    <message>
        <source>%1: cannot be read (%2).</source>
        <translation>%1: 読み込めません (%2)。</translation>
    </message>
    <message>
        <source>%1: cannot be read to its end.</source>
        <translation>%1: 最後まで読み込めません。</translation>
    </message>
    <message>
        <source>%1: cannot be removed (%2).</source>
        <translation>%1: 削除できません (%2)。</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2).</source>
        <translation>%1: 書き込めません (%2)。</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2); what is painted now can be saved, but not recovered.</source>
        <translation>%1: 書き込めません (%2)。いま描いているものは保存できますが、復元はできません。</translation>
    </message>
    <message>
        <source>%1: cannot be written, since this program was built without OpenVDB.</source>
        <translation>%1: このプログラムは OpenVDB なしで作られているため、書き込めません。</translation>
    </message>
    <message>
        <source>%1: does not say what was painted on.</source>
        <translation>%1: 何の上に描かれたかが記録されていません。</translation>
    </message>
    <message>
        <source>%1: expected the name of a pigment.</source>
        <translation>%1: 顔料の名前が必要です。</translation>
    </message>
    <message>
        <source>%1: ffmpeg cannot be started (%2).</source>
        <translation>%1: ffmpeg を起動できません (%2)。</translation>
    </message>
    <message>
        <source>%1: ffmpeg cannot make the video (%2).</source>
        <translation>%1: ffmpeg で動画を作れません (%2)。</translation>
    </message>
    <message>
        <source>%1: holds a number that is too large (%2).</source>
        <translation>%1: 大きすぎる数値が含まれています (%2)。</translation>
    </message>
    <message>
        <source>%1: holds a number that is too large.</source>
        <translation>%1: 大きすぎる数値が含まれています。</translation>
    </message>
    <message>
        <source>%1: holds an ICC profile for %2, but the picture&apos;s values are red, green and blue.</source>
        <translation>%1: %2 用の ICC プロファイルが含まれていますが、画像の値は赤、緑、青です。</translation>
    </message>
    <message>
        <source>%1: holds an ICC profile that cannot be applied (%2).</source>
        <translation>%1: 適用できない ICC プロファイルが含まれています (%2)。</translation>
    </message>
    <message>
        <source>%1: holds an ICC profile that is none (%2).</source>
        <translation>%1: 含まれている ICC プロファイルが正しくありません (%2)。</translation>
    </message>
    <message>
        <source>%1: holds frames of another time-lapse; name another folder, or remove them.</source>
        <translation>%1: 別のタイムラプスのフレームがあります。別のフォルダーにするか、フレームを削除してください。</translation>
    </message>
    <message>
        <source>%1: holds no actions of a painting.</source>
        <translation>%1: 作品の操作が含まれていません。</translation>
    </message>
    <message>
        <source>%1: holds no stroke; expected lines &quot;seconds x y pressure&quot;, some with a pressure above 0.</source>
        <translation>%1: ストロークがありません。「秒 x y 筆圧」の行が必要で、筆圧が 0 より大きい行も必要です。</translation>
    </message>
    <message>
        <source>%1: holds no strokes that could be painted again.</source>
        <translation>%1: 描き直せるストロークがありません。</translation>
    </message>
    <message>
        <source>%1: is %2, not a file.</source>
        <translation>%1: ファイルではなく%2です。</translation>
    </message>
    <message>
        <source>%1: is an ICC profile for %2, but a picture is written in red, green and blue.</source>
        <translation>%1: %2 用の ICC プロファイルですが、画像は赤、緑、青で書き出されます。</translation>
    </message>
    <message>
        <source>%1: is an ICC profile for %2, but a screen shows red, green and blue.</source>
        <translation>%1: %2 用の ICC プロファイルですが、画面は赤、緑、青で表示します。</translation>
    </message>
    <message>
        <source>%1: is an ICC profile that no colour can be shown with (%2).</source>
        <translation>%1: この ICC プロファイルでは色を表示できません (%2)。</translation>
    </message>
    <message>
        <source>%1: is an ICC profile that no picture can be written in (%2).</source>
        <translation>%1: この ICC プロファイルでは画像を書き出せません (%2)。</translation>
    </message>
    <message>
        <source>%1: is an ICC profile that no print can be shown with (%2).</source>
        <translation>%1: この ICC プロファイルでは印刷の見え方を表示できません (%2)。</translation>
    </message>
    <message>
        <source>%1: is an OpenRaster picture of another program; it holds no wet paint.</source>
        <translation>%1: ほかのプログラムの OpenRaster 画像で、濡れた絵具は含まれていません。</translation>
    </message>
    <message>
        <source>%1: is damaged; %2 actions after it are lost.</source>
        <translation>%1: 破損しています。これより後の操作 %2 件が失われました。</translation>
    </message>
    <message>
        <source>%1: is damaged; 1 action after it is lost.</source>
        <translation>%1: 破損しています。これより後の操作 1 件が失われました。</translation>
    </message>
    <message>
        <source>%1: is damaged; the painting is there, but some of its strokes are missing, so that they cannot be replayed.</source>
        <translation>%1: 破損しています。作品は残っていますが、一部のストロークがないため、再生できません。</translation>
    </message>
    <message>
        <source>%1: is larger than the %2 bytes that are read at most.</source>
        <translation>%1: 読み込みの上限 %2 バイトを超えています。</translation>
    </message>
    <message>
        <source>%1: is no ICC profile (%2).</source>
        <translation>%1: ICC プロファイルではありません (%2)。</translation>
    </message>
    <message>
        <source>%1: is no OpenRaster file, which would hold %2.</source>
        <translation>%1: OpenRaster ファイルではありません。OpenRaster なら %2 を含むはずです。</translation>
    </message>
    <message>
        <source>%1: is no painting of Pastoso, or its end is missing (%2).</source>
        <translation>%1: Pastoso の作品ではないか、終わりの部分がありません (%2)。</translation>
    </message>
    <message>
        <source>%1: is no painting of Pastoso.</source>
        <translation>%1: Pastoso の作品ではありません。</translation>
    </message>
    <message>
        <source>%1: is not a list of media in square brackets.</source>
        <translation>%1: 角かっこで囲んだメディウムのリストではありません。</translation>
    </message>
    <message>
        <source>%1: is not an object in braces.</source>
        <translation>%1: 波かっこで囲んだオブジェクトではありません。</translation>
    </message>
    <message>
        <source>%1: is of another moment.</source>
        <translation>%1: 別の時点のものです。</translation>
    </message>
    <message>
        <source>%1: is write-protected; allow writing to it, or choose another name.</source>
        <translation>%1: 書き込みが禁止されています。書き込みを許可するか、別の名前を選んでください。</translation>
    </message>
    <message>
        <source>%1: is written, but may be lost in a power cut (%2).</source>
        <translation>%1: 書き込みましたが、停電すると失われるおそれがあります (%2)。</translation>
    </message>
    <message>
        <source>%1: keeps frames of %2; choose another folder.</source>
        <translation>%1: %2のフレームが入っています。別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>%1: lists and objects are nested more than %2 deep.</source>
        <translation>%1: リストとオブジェクトの入れ子が %2 段を超えています。</translation>
    </message>
    <message>
        <source>%1: lists and objects stand more than %2 deep in each other.</source>
        <translation>%1: リストとオブジェクトの入れ子が %2 段を超えています。</translation>
    </message>
    <message>
        <source>%1: maps are saved as .png, .tif or .exr; %2 files do not hold heights.</source>
        <translation>%1: マップは .png、.tif、.exr のいずれかで保存します。%2 ファイルには高さを保存できません。</translation>
    </message>
    <message>
        <source>%1: name is &quot;%2&quot;, which another preset of yours has already.</source>
        <translation>%1: name が「%2」ですが、この名前は自分の別のプリセットがすでに使っています。</translation>
    </message>
    <message>
        <source>%1: only .exr files hold layers.</source>
        <translation>%1: レイヤーを保存できるのは .exr ファイルだけです。</translation>
    </message>
    <message>
        <source>%1: only .exr files hold the layers&apos; heights and normals.</source>
        <translation>%1: レイヤーの高さと法線を保存できるのは .exr ファイルだけです。</translation>
    </message>
    <message>
        <source>%1: the %2 of vertex %3 is not finite; nothing was written.</source>
        <translation>%1: 頂点 %3 の%2が有限の値ではありません。何も書き出していません。</translation>
    </message>
    <message>
        <source>%1: the disk is full.</source>
        <translation>%1: ディスクがいっぱいです。</translation>
    </message>
    <message>
        <source>%1: the entry &quot;%2&quot; is missing.</source>
        <translation>%1: 項目「%2」がありません。</translation>
    </message>
    <message>
        <source>%1: the list &quot;%2&quot; of paints is missing.</source>
        <translation>%1: 絵具のリスト「%2」がありません。</translation>
    </message>
    <message>
        <source>%1: the name &quot;%2&quot; begins with #, as only colours do.</source>
        <translation>%1: 名前「%2」が # で始まっています。# で始まるのは色だけです。</translation>
    </message>
    <message>
        <source>%1: the name must end in .pbrt, .obj, .ply or .stl. Choose one of them.</source>
        <translation>%1: 名前は .pbrt、.obj、.ply、.stl のいずれかで終わる必要があります。どれかを選んでください。</translation>
    </message>
    <message>
        <source>%1: the pigment &quot;%2&quot; has no line for %3.</source>
        <translation>%1: 顔料「%2」に %3 の行がありません。</translation>
    </message>
    <message>
        <source>%1: the readings go from %2 to %3 nm; a light is needed from 400 to 700 nm.</source>
        <translation>%1: 測定値は %2 から %3 nm までです。光には 400 から 700 nm までの値が必要です。</translation>
    </message>
    <message>
        <source>%1: the system refuses this (%2).</source>
        <translation>%1: システムに拒否されました (%2)。</translation>
    </message>
    <message>
        <source>%1: the weights add up to %2 instead of 1.</source>
        <translation>%1: 重みの合計が 1 ではなく %2 です。</translation>
    </message>
    <message>
        <source>%1: there are more than %2 triangles.</source>
        <translation>%1: 三角形が %2 個を超えています。</translation>
    </message>
    <message>
        <source>%1: there is already a pigment &quot;%2&quot;; give yours another name.</source>
        <translation>%1: 顔料「%2」はすでにあります。別の名前を付けてください。</translation>
    </message>
    <message>
        <source>%1: there is no colour in this palette.</source>
        <translation>%1: このパレットには色がありません。</translation>
    </message>
    <message>
        <source>%1: there is no pigment &quot;%2&quot;.</source>
        <translation>%1: 顔料「%2」はありません。</translation>
    </message>
    <message>
        <source>%1: there is no pigment in this file.</source>
        <translation>%1: このファイルには顔料がありません。</translation>
    </message>
    <message>
        <source>%1: there is no reading of a light in this file.</source>
        <translation>%1: このファイルには光の測定値がありません。</translation>
    </message>
    <message>
        <source>%1: this file of the program itself is missing; reinstall it or set PASTOSO_RESOURCES to the folder that holds it.</source>
        <translation>%1: プログラム自体のこのファイルがありません。再インストールするか、これを含むフォルダーを PASTOSO_RESOURCES に指定してください。</translation>
    </message>
    <message>
        <source>%1: this folder cannot be made (%2).</source>
        <translation>%1: このフォルダーを作れません (%2)。</translation>
    </message>
    <message>
        <source>%1: this format holds linear light, which needs no ICC profile.</source>
        <translation>%1: この形式ではリニアな光を保存するため、ICC プロファイルは不要です。</translation>
    </message>
    <message>
        <source>%1: this is not valid JSON.</source>
        <translation>%1: 正しい JSON ではありません。</translation>
    </message>
    <message>
        <source>%1: this light has no power that is seen.</source>
        <translation>%1: この光には、目に見える成分がありません。</translation>
    </message>
    <message>
        <source>%1: this light is so nearly a pure colour that nothing looks white in it.</source>
        <translation>%1: この光はほとんど単色なので、白く見えるものがありません。</translation>
    </message>
    <message>
        <source>%1: this part of the program cannot be loaded (%2).</source>
        <translation>%1: プログラムのこの部分を読み込めません (%2)。</translation>
    </message>
    <message>
        <source>%1: this part of the program is of another version; reinstall it.</source>
        <translation>%1: プログラムのこの部分はバージョンが違います。再インストールしてください。</translation>
    </message>
    <message>
        <source>%1: was saved by Pastoso with another form of %2; where nothing is painted, the canvas looks different.</source>
        <translation>%1: 今とは違う形の %2 を使っていた Pastoso で保存されています。何も描かれていないところは、キャンバスの見え方が変わります。</translation>
    </message>
    <message>
        <source>16-bit pictures</source>
        <translation>16 ビットの画像</translation>
    </message>
    <message>
        <source>8-bit pictures</source>
        <translation>8 ビットの画像</translation>
    </message>
    <message>
        <source>&lt;%1&gt; is left out.</source>
        <translation>&lt;%1&gt; は取り込みません。</translation>
    </message>
    <message>
        <source>A brush needs a name.</source>
        <translation>ブラシには名前が必要です。</translation>
    </message>
    <message>
        <source>A canvas of %1 x %2 mm at %3 px/mm</source>
        <translation>%1 x %2 mm、%3 px/mm のキャンバス</translation>
    </message>
    <message>
        <source>A diffusivity of %1 m2/s over %2 s; both must be 0 or more.</source>
        <translation>拡散率が %1 m2/s、時間が %2 s です。どちらも 0 以上でなければなりません。</translation>
    </message>
    <message>
        <source>A diffusivity or viscosity of %1 m2/s is too large for a step of %2 s.</source>
        <translation>拡散率または粘度 %1 m2/s は、時間刻み %2 s には大きすぎます。</translation>
    </message>
    <message>
        <source>A parcel&apos;s ball</source>
        <translation>滴の属する玉</translation>
    </message>
    <message>
        <source>A parcel&apos;s coldness</source>
        <translation>滴の冷たさ</translation>
    </message>
    <message>
        <source>A parcel&apos;s place</source>
        <translation>滴の位置</translation>
    </message>
    <message>
        <source>A parcel&apos;s shape is none.</source>
        <translation>滴の形が正しくありません。</translation>
    </message>
    <message>
        <source>A parcel&apos;s volume</source>
        <translation>滴の体積</translation>
    </message>
    <message>
        <source>A particle of this state is not within the tank.</source>
        <translation>この状態には、水槽の外にある粒子が含まれています。</translation>
    </message>
    <message>
        <source>A picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels is larger than the 268 million that can be rendered.</source>
        <translation>%1 x %2 ピクセルの画像は、レンダリングの上限 2 億 6800 万ピクセルを超えています。</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels is larger than the 32768 a side that can be made.</source>
        <translation>%1 x %2 ピクセルの画像は、上限の一辺 32768 ピクセルを超えています。</translation>
    </message>
    <message>
        <source>A relief of %1 x %2 points is more than the 25 million that can be made; a coarser resolution takes fewer.</source>
        <translation>%1 x %2 点のレリーフは、上限の 2500 万点を超えています。解像度を粗くすると点が減ります。</translation>
    </message>
    <message>
        <source>Cannot make the folder %1: %2.</source>
        <translation>フォルダー %1 を作れません: %2。</translation>
    </message>
    <message>
        <source>Cannot write </source>
        <translation>書き込めません: </translation>
    </message>
    <message>
        <source>Cup, box, cells, time step, seed and the recipe&apos;s milk cannot change while the tea runs.</source>
        <translation>カップ、箱、セル、時間刻み、シード、レシピのミルクは、紅茶が動いている間は変えられません。</translation>
    </message>
    <message>
        <source>Nothing has been painted yet that a film could show.</source>
        <translation>動画にできるものはまだ描かれていません。</translation>
    </message>
    <message>
        <source>OpenGL reports error %1</source>
        <translation>OpenGLがエラー%1を報告しました</translation>
    </message>
    <message>
        <source>PASTOSO_ISA is &quot;%1&quot;, but there are baseline, avx2 and avx512.</source>
        <translation>PASTOSO_ISA が「%1」ですが、使えるのは baseline、avx2、avx512 です。</translation>
    </message>
    <message>
        <source>The %1 of the canvas is %2 %3, but must lie between %4 and %5.</source>
        <translation>キャンバスの%1が %2 %3 ですが、%4 から %5 の範囲でなければなりません。</translation>
    </message>
    <message>
        <source>The box of liquid has %1 x %2 x %3 cells; each side may have 2 to %4.</source>
        <translation>液体の箱が %1 x %2 x %3 セルですが、各辺は 2 から %4 セルまでです。</translation>
    </message>
    <message>
        <source>The cells of the box of liquid are %1 m wide, which is no size.</source>
        <translation>液体の箱のセルの幅が %1 m ですが、これは大きさとして使えません。</translation>
    </message>
    <message>
        <source>The cup&apos;s radius at its level</source>
        <translation>液面でのカップの半径</translation>
    </message>
    <message>
        <source>The diffusivity or viscosity is %1 m2/s; it must be 0 or more.</source>
        <translation>拡散率または粘度が %1 m2/s ですが、0 以上でなければなりません。</translation>
    </message>
    <message>
        <source>The file needs a name.</source>
        <translation>ファイル名を入力してください。</translation>
    </message>
    <message>
        <source>The film is of %1 media, but may be of %2 at most.</source>
        <translation>膜のメディウムが %1 種類ありますが、%2 種類までです。</translation>
    </message>
    <message>
        <source>The folder %1 holds the frames of another time-lapse; name another one.</source>
        <translation>フォルダー %1 には別のタイムラプスのフレームがあります。別の名前にしてください。</translation>
    </message>
    <message>
        <source>The graphics card cannot draw the canvas: %1.</source>
        <translation>グラフィックスカードがキャンバスを描けません: %1。</translation>
    </message>
    <message>
        <source>The graphics driver refuses a program that pictures are drawn with: %1</source>
        <translation>グラフィックスドライバーが描画用のプログラムを受けつけません: %1</translation>
    </message>
    <message>
        <source>The height of the support</source>
        <translation>支持体の高さ</translation>
    </message>
    <message>
        <source>The latest strokes %1</source>
        <translation>最新のストロークは%1</translation>
    </message>
    <message>
        <source>The light&apos;s %1 is %2, outside the range from %3 to %4.</source>
        <translation>ライトの%1が %2 で、%3 から %4 の範囲にありません。</translation>
    </message>
    <message>
        <source>The milk that was poured</source>
        <translation>注がれたミルクの量</translation>
    </message>
    <message>
        <source>The next ball&apos;s time</source>
        <translation>次の玉の時刻</translation>
    </message>
    <message>
        <source>The number of balls</source>
        <translation>玉の数</translation>
    </message>
    <message>
        <source>The number of parcels</source>
        <translation>滴の数</translation>
    </message>
    <message>
        <source>The painting is as it was saved, but its strokes %1</source>
        <translation>作品は保存したときのままですが、ストロークは%1</translation>
    </message>
    <message>
        <source>The painting is recovered up to an action that cannot be repeated: %1</source>
        <translation>繰り返せない操作があるため、作品はその手前まで復元されました: %1</translation>
    </message>
    <message>
        <source>The painting is whole, but its strokes cannot be replayed: %1</source>
        <translation>作品はすべてそろっていますが、ストロークは再生できません: %1</translation>
    </message>
    <message>
        <source>The part of the canvas to render is empty or reaches beyond the canvas.</source>
        <translation>レンダリングするキャンバスの範囲が空か、キャンバスからはみ出しています。</translation>
    </message>
    <message>
        <source>The picture&apos;s scale is %1 pixels per cell, outside the range from 1/64 to 64.</source>
        <translation>画像の倍率が 1 セルあたり %1 ピクセルで、1/64 から 64 の範囲にありません。</translation>
    </message>
    <message>
        <source>The pressure is allowed %1 iterations; it needs at least 1.</source>
        <translation>圧力の反復回数の上限が %1 ですが、1 以上でなければなりません。</translation>
    </message>
    <message>
        <source>The pressure&apos;s tolerance is %1; it may be 1e-7 to 1.</source>
        <translation>圧力の許容誤差が %1 ですが、使えるのは 1e-7 から 1 までです。</translation>
    </message>
    <message>
        <source>The relief&apos;s %1 is %2, outside the range from %3 to %4.</source>
        <translation>レリーフの%1が %2 で、%3 から %4 の範囲にありません。</translation>
    </message>
    <message>
        <source>The state is that of another box of cells.</source>
        <translation>セルの構成が異なる、別の箱の状態です。</translation>
    </message>
    <message>
        <source>The step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>The stream&apos;s end</source>
        <translation>ミルクの流れの終わり</translation>
    </message>
    <message>
        <source>The stream&apos;s parcels</source>
        <translation>ミルクの流れの滴の数</translation>
    </message>
    <message>
        <source>The stream&apos;s place</source>
        <translation>ミルクの流れの位置</translation>
    </message>
    <message>
        <source>The stream&apos;s time</source>
        <translation>ミルクの流れの経過時間</translation>
    </message>
    <message>
        <source>The support &quot;image&quot; needs a height image; none is named.</source>
        <translation>支持体「image」には高さ画像が必要ですが、指定されていません。</translation>
    </message>
    <message>
        <source>The thickness of the film</source>
        <translation>膜の厚さ</translation>
    </message>
    <message>
        <source>The time of this state is not one of a tank.</source>
        <translation>この状態の時刻は、水槽ではあり得ません。</translation>
    </message>
    <message>
        <source>The time step is %1 s; it must be 0 or more.</source>
        <translation>時間刻みが %1 s ですが、0 以上でなければなりません。</translation>
    </message>
    <message>
        <source>The varnish&apos;s %1 is %2, outside the range from 0 to 1.</source>
        <translation>ワニスの%1が %2 で、0 から 1 の範囲にありません。</translation>
    </message>
    <message>
        <source>The viscosity is %1 m2/s; it must be 0 or more.</source>
        <translation>粘度が %1 m2/s ですが、0 以上でなければなりません。</translation>
    </message>
    <message>
        <source>The vorticity confinement is %1; it may be 0 to 0.3.</source>
        <translation>渦の保持が %1 ですが、使えるのは 0 から 0.3 までです。</translation>
    </message>
    <message>
        <source>The wall&apos;s distance at (%1, %2, %3) m is not a number.</source>
        <translation>位置 (%1, %2, %3) m での壁までの距離が数値ではありません。</translation>
    </message>
    <message>
        <source>There are %1 values for the %2 x %3 cells of the canvas.</source>
        <translation>キャンバスの %2 x %3 セルに対して、値が %1 個あります。</translation>
    </message>
    <message>
        <source>There is already a brush &quot;%1&quot;.</source>
        <translation>ブラシ「%1」はすでにあります。</translation>
    </message>
    <message>
        <source>There is already a file %1.</source>
        <translation>ファイル %1 はすでにあります。</translation>
    </message>
    <message>
        <source>There is no brush &quot;%1&quot;; the brushes are %2.</source>
        <translation>ブラシ「%1」はありません。ブラシの一覧: %2。</translation>
    </message>
    <message>
        <source>There is no case &quot;%1&quot;, only %2.</source>
        <translation>ケース「%1」はありません。あるのは %2 だけです。</translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation>フォルダー %1 がありません。</translation>
    </message>
    <message>
        <source>There is no light &quot;%1&quot;; there are D65, D50, A and LED, or give the path of a CSV file.</source>
        <translation>光「%1」はありません。使えるのは D65、D50、A、LED です。CSV ファイルのパスも指定できます。</translation>
    </message>
    <message>
        <source>There is no medium &quot;%1&quot;; the media are: %2.</source>
        <translation>メディウム「%1」はありません。メディウムの一覧: %2。</translation>
    </message>
    <message>
        <source>There is no picture yet that could be saved.</source>
        <translation>保存できる画像がまだありません。</translation>
    </message>
    <message>
        <source>There is no pigment &quot;%1&quot;; %2</source>
        <translation>顔料「%1」はありません。%2</translation>
    </message>
    <message>
        <source>There is no pigment &quot;%1&quot;; did you mean %2; %3</source>
        <translation>顔料「%1」はありません。%2 のことですか？%3</translation>
    </message>
    <message>
        <source>There is no scene &quot;%1&quot;; give a file ending in .json, or one of: %2.</source>
        <translation>シーン「%1」はありません。.json で終わるファイルか、次のいずれかを指定してください: %2。</translation>
    </message>
    <message>
        <source>There is no support &quot;%1&quot;; the supports are: %2.</source>
        <translation>支持体「%1」はありません。支持体の一覧: %2。</translation>
    </message>
    <message>
        <source>This is the state of a level set, not of particles.</source>
        <translation>粒子ではなく、レベルセットの状態です。</translation>
    </message>
    <message>
        <source>This is the state of a tank that is followed in another way.</source>
        <translation>別の方法で計算される水槽の状態です。</translation>
    </message>
    <message>
        <source>This is the state of another tank.</source>
        <translation>別の水槽の状態です。</translation>
    </message>
    <message>
        <source>a bristle holds what none can.</source>
        <translation>ブラシの毛に、あり得ない量の絵具が含まれています。</translation>
    </message>
    <message>
        <source>a cap is at most a half sphere: its thickness %1 must lie above 0 and not above its radius %2.</source>
        <translation>球冠 (cap) は半球までです。厚さ %1 は 0 より大きく、半径 %2 以下でなければなりません。</translation>
    </message>
    <message>
        <source>a cell holds more of its media than it holds paint.</source>
        <translation>セルのメディウムの量が、そのセルの絵具の量を超えています。</translation>
    </message>
    <message>
        <source>a combination has no parts.</source>
        <translation>組み合わせの中身がありません。</translation>
    </message>
    <message>
        <source>a corner of triangle %1 is not finite (%2).</source>
        <translation>三角形 %1 の頂点が有限の値ではありません (%2)。</translation>
    </message>
    <message>
        <source>a corner stands outside of a loop.</source>
        <translation>ループの外に頂点があります。</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>デバイス</translation>
    </message>
    <message>
        <source>a document type is not read here.</source>
        <translation>文書型宣言は、ここでは読み込めません。</translation>
    </message>
    <message>
        <source>a face has %1 corners, not three or more.</source>
        <translation>面の頂点が %1 個ですが、3 個以上必要です。</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>a glass of milk tea</source>
        <translation>ミルクティーのグラス</translation>
    </message>
    <message>
        <source>a group needs a layer.</source>
        <translation>グループにはレイヤーが必要です。</translation>
    </message>
    <message>
        <source>a height of the support</source>
        <translation>支持体の高さ</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>a loop begins within another one.</source>
        <translation>ループの中で別のループが始まっています。</translation>
    </message>
    <message>
        <source>a loop ends that has no three corners.</source>
        <translation>ループが終わりましたが、頂点が 3 つありません。</translation>
    </message>
    <message>
        <source>a mixture</source>
        <translation>絵具の混ざり方</translation>
    </message>
    <message>
        <source>a named pipe</source>
        <translation>名前付きパイプ</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>a number is missing.</source>
        <translation>数値がありません。</translation>
    </message>
    <message>
        <source>a painting has 1 to %1 layers, not %2.</source>
        <translation>作品のレイヤーは 1 から %1 枚です。%2 枚にはできません。</translation>
    </message>
    <message>
        <source>a painting has at most %1 layers.</source>
        <translation>作品のレイヤーは %1 枚までです。</translation>
    </message>
    <message>
        <source>a painting keeps its last layer.</source>
        <translation>作品の最後のレイヤーは削除できません。</translation>
    </message>
    <message>
        <source>a picture on it has no strokes, and comes no finer than it is.</source>
        <translation>作品にある画像にはストロークがないため、今より細かくはなりません。</translation>
    </message>
    <message>
        <source>a point of an outline has two numbers, x and y.</source>
        <translation>輪郭の点には、x と y の 2 つの数値が必要です。</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>圧力</translation>
    </message>
    <message>
        <source>a pressure curve leads from 0 to 1 and never falls.</source>
        <translation>筆圧のカーブは 0 から 1 へ進み、途中で下がってはいけません。</translation>
    </message>
    <message>
        <source>a reflectance</source>
        <translation>反射率</translation>
    </message>
    <message>
        <source>a run is named by up to 64 small letters, digits and hyphens.</source>
        <translation>実行の名前に使えるのは、英小文字、数字、ハイフンで、64 文字までです。</translation>
    </message>
    <message>
        <source>a scene</source>
        <translation>シーン</translation>
    </message>
    <message>
        <source>a scene of a glass tank</source>
        <translation>ガラスの水槽のシーン</translation>
    </message>
    <message>
        <source>a shape is an object with one entry, its form, which is one of %1.</source>
        <translation>形は項目が 1 つだけのオブジェクトです。その項目は次のいずれかです: %1。</translation>
    </message>
    <message>
        <source>a socket</source>
        <translation>ソケット</translation>
    </message>
    <message>
        <source>a stroke needs at least one sample.</source>
        <translation>ストロークにはサンプルが少なくとも 1 つ必要です。</translation>
    </message>
    <message>
        <source>a stroke recording</source>
        <translation>ストロークの記録</translation>
    </message>
    <message>
        <source>a stroke that goes on stays on its surface.</source>
        <translation>続きのストロークでは面を変えられません。</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文字列</translation>
    </message>
    <message>
        <source>a thickness</source>
        <translation>厚さ</translation>
    </message>
    <message>
        <source>a thickness of dry paint</source>
        <translation>乾いた絵具の厚さ</translation>
    </message>
    <message>
        <source>a tilt needs millimetres; in cells give &quot;gravity&quot;.</source>
        <translation>傾きはミリメートル単位でのみ使えます。セル単位では「gravity」を指定してください。</translation>
    </message>
    <message>
        <source>a triangle has more than three corners.</source>
        <translation>三角形に頂点が 4 つ以上あります。</translation>
    </message>
    <message>
        <source>a velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>alpha_min is %1, it must not be larger than alpha_max, %2.</source>
        <translation>alpha_min が %1 ですが、alpha_max の %2 以下でなければなりません。</translation>
    </message>
    <message>
        <source>ambient share</source>
        <translation>環境光の割合</translation>
    </message>
    <message>
        <source>amount</source>
        <translation>量</translation>
    </message>
    <message>
        <source>an amount of a medium</source>
        <translation>メディウムの量</translation>
    </message>
    <message>
        <source>an amount of dry pigment</source>
        <translation>乾いた顔料の量</translation>
    </message>
    <message>
        <source>an amount of paint</source>
        <translation>絵具の量</translation>
    </message>
    <message>
        <source>an exception of an unknown kind</source>
        <translation>不明な種類の例外</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>オブジェクト</translation>
    </message>
    <message>
        <source>aside</source>
        <translation>脇に置いた</translation>
    </message>
    <message>
        <source>at least one run is needed.</source>
        <translation>実行が少なくとも 1 つ必要です。</translation>
    </message>
    <message>
        <source>axis of the symmetry</source>
        <translation>対称の軸</translation>
    </message>
    <message>
        <source>azimuth in degrees</source>
        <translation>方位角（度）</translation>
    </message>
    <message>
        <source>bare support</source>
        <translation>何も塗られていない支持体</translation>
    </message>
    <message>
        <source>base in mm</source>
        <translation>土台の厚さ（mm）</translation>
    </message>
    <message>
        <source>belongs to another scene.</source>
        <translation>別のシーンのものです。</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>青</translation>
    </message>
    <message>
        <source>camera eye</source>
        <translation>カメラの位置</translation>
    </message>
    <message>
        <source>camera target</source>
        <translation>カメラの目標点</translation>
    </message>
    <message>
        <source>cannot be read (%1).</source>
        <translation>読み込めません (%1)。</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>最後まで読み込めません</translation>
    </message>
    <message>
        <source>canvas</source>
        <translation>キャンバス</translation>
    </message>
    <message>
        <source>cell (%1, %2) holds %3 that cannot be.</source>
        <translation>セル (%1, %2) に、あり得ない%3があります。</translation>
    </message>
    <message>
        <source>cell (%1, %2) holds a lower stratum that is no part of its paint.</source>
        <translation>セル (%1, %2) に、そのセルの絵具に含まれない下の層があります。</translation>
    </message>
    <message>
        <source>checkpoint of a tank</source>
        <translation>水槽のチェックポイント</translation>
    </message>
    <message>
        <source>checkpoint of tea</source>
        <translation>ミルクティーのチェックポイント</translation>
    </message>
    <message>
        <source>column %1 (%2): %3</source>
        <translation>%1 列目 (%2): %3</translation>
    </message>
    <message>
        <source>cup axis</source>
        <translation>カップの軸</translation>
    </message>
    <message>
        <source>cup floor</source>
        <translation>カップの内側の底</translation>
    </message>
    <message>
        <source>cup foot</source>
        <translation>カップの外側の底</translation>
    </message>
    <message>
        <source>cup level</source>
        <translation>カップの液面</translation>
    </message>
    <message>
        <source>cup radius at the foot</source>
        <translation>カップの外側の底での半径</translation>
    </message>
    <message>
        <source>cup radius at the rim</source>
        <translation>カップの縁での半径</translation>
    </message>
    <message>
        <source>cup rim</source>
        <translation>カップの縁</translation>
    </message>
    <message>
        <source>cup slope</source>
        <translation>カップの側面の傾き</translation>
    </message>
    <message>
        <source>cup wall</source>
        <translation>カップの壁の厚さ</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>dent</source>
        <translation>液面のくぼみ</translation>
    </message>
    <message>
        <source>dent depth</source>
        <translation>液面のくぼみの深さ</translation>
    </message>
    <message>
        <source>dent radius</source>
        <translation>液面のくぼみの半径</translation>
    </message>
    <message>
        <source>direction of the tilt</source>
        <translation>傾きの向き</translation>
    </message>
    <message>
        <source>distance from eye to target</source>
        <translation>カメラの位置から目標点までの距離</translation>
    </message>
    <message>
        <source>distance of the ruler&apos;s points</source>
        <translation>定規の 2 点の距離</translation>
    </message>
    <message>
        <source>elevation in degrees</source>
        <translation>仰角（度）</translation>
    </message>
    <message>
        <source>ellipse&apos;s centre</source>
        <translation>楕円の中心</translation>
    </message>
    <message>
        <source>event %1: %2</source>
        <translation>イベント %1: %2</translation>
    </message>
    <message>
        <source>exaggeration</source>
        <translation>高さの倍率</translation>
    </message>
    <message>
        <source>expected &quot;%1&quot;.</source>
        <translation>「%1」が必要です。</translation>
    </message>
    <message>
        <source>expected &quot;levels&quot; or &quot;fine&quot;.</source>
        <translation>「levels」か「fine」が必要です。</translation>
    </message>
    <message>
        <source>expected &quot;none&quot;, &quot;several&quot; or the numbers of one.</source>
        <translation>「none」か「several」、または 1 つ分の数値が必要です。</translation>
    </message>
    <message>
        <source>expected %1 media at most.</source>
        <translation>メディウムは %1 種類までです。</translation>
    </message>
    <message>
        <source>expected %1 numbers, one for each tile.</source>
        <translation>タイルごとに 1 つずつ、%1 個の数値が必要です。</translation>
    </message>
    <message>
        <source>expected %1 numbers.</source>
        <translation>%1 個の数値が必要です。</translation>
    </message>
    <message>
        <source>expected %1, found %2.</source>
        <translation>%1が必要です (見つかったもの: %2)。</translation>
    </message>
    <message>
        <source>expected 0 or more.</source>
        <translation>0 以上の値が必要です。</translation>
    </message>
    <message>
        <source>expected 0 to 10000.</source>
        <translation>0 から 10000 までの値が必要です。</translation>
    </message>
    <message>
        <source>expected 0 to 10000000.</source>
        <translation>0 から 10000000 までの値が必要です。</translation>
    </message>
    <message>
        <source>expected 0 to a million seconds.</source>
        <translation>0 から 100 万秒までの値が必要です。</translation>
    </message>
    <message>
        <source>expected 1 to %1 layers.</source>
        <translation>1 から %1 枚のレイヤーが必要です。</translation>
    </message>
    <message>
        <source>expected 4 numbers, seconds x y pressure, found %1.</source>
        <translation>4 つの数値 (秒 x y 筆圧) が必要ですが、%1 個あります。</translation>
    </message>
    <message>
        <source>expected a colour and its name, for example [&quot;#783c14&quot;, &quot;Umber&quot;].</source>
        <translation>色とその名前が必要です。例: [&quot;#783c14&quot;, &quot;Umber&quot;]。</translation>
    </message>
    <message>
        <source>expected a name that begins with pastoso/.</source>
        <translation>pastoso/ で始まる名前が必要です。</translation>
    </message>
    <message>
        <source>expected a number for &quot;%1&quot;.</source>
        <translation>「%1」には数値が必要です。</translation>
    </message>
    <message>
        <source>expected a number from 1 to 1000.</source>
        <translation>1 から 1000 までの数値が必要です。</translation>
    </message>
    <message>
        <source>expected a pigment and its parts, for example [&quot;PB29&quot;, 1].</source>
        <translation>顔料とその割合が必要です。例: [&quot;PB29&quot;, 1]。</translation>
    </message>
    <message>
        <source>expected a width and a height.</source>
        <translation>幅と高さが必要です。</translation>
    </message>
    <message>
        <source>expected an amount of paint up to 1e18.</source>
        <translation>1e18 までの絵具の量が必要です。</translation>
    </message>
    <message>
        <source>expected four numbers, [left, top, right, bottom].</source>
        <translation>4 つの数値 [左, 上, 右, 下] が必要です。</translation>
    </message>
    <message>
        <source>expected four whole numbers, [left, top, right, bottom].</source>
        <translation>4 つの整数 [左, 上, 右, 下] が必要です。</translation>
    </message>
    <message>
        <source>expected one number for each medium.</source>
        <translation>メディウムごとに 1 つずつ数値が必要です。</translation>
    </message>
    <message>
        <source>expected one of %1 beside the tick.</source>
        <translation>ティックのほかに、次のいずれかが必要です: %1。</translation>
    </message>
    <message>
        <source>expected sixteen hexadecimal digits.</source>
        <translation>16 桁の 16 進数が必要です。</translation>
    </message>
    <message>
        <source>expected the first tile and how many there are.</source>
        <translation>最初のタイルの番号とタイルの数が必要です。</translation>
    </message>
    <message>
        <source>expected the name of a file in the journal&apos;s folder.</source>
        <translation>控えのフォルダーにあるファイルの名前が必要です。</translation>
    </message>
    <message>
        <source>expected three numbers, found %1.</source>
        <translation>3 つの数値が必要ですが、%1 個あります。</translation>
    </message>
    <message>
        <source>expected three whole numbers, found %1.</source>
        <translation>3 つの整数が必要ですが、%1 個あります。</translation>
    </message>
    <message>
        <source>expected two numbers, [width, height].</source>
        <translation>2 つの数値 [幅, 高さ] が必要です。</translation>
    </message>
    <message>
        <source>expected two numbers, [x, y].</source>
        <translation>2 つの数値 [x, y] が必要です。</translation>
    </message>
    <message>
        <source>expected two numbers, for example [0.5, 0.7].</source>
        <translation>2 つの数値が必要です。例: [0.5, 0.7]。</translation>
    </message>
    <message>
        <source>expected two numbers, for example [20, 30].</source>
        <translation>2 つの数値が必要です。例: [20, 30]。</translation>
    </message>
    <message>
        <source>fill of the brush</source>
        <translation>ブラシの含み</translation>
    </message>
    <message>
        <source>frame of tea</source>
        <translation>ミルクティーのフレーム</translation>
    </message>
    <message>
        <source>green</source>
        <translation>緑</translation>
    </message>
    <message>
        <source>group of the layer</source>
        <translation>レイヤーのグループ</translation>
    </message>
    <message>
        <source>grouping layers that do not lie next to each other would tear a group of layers apart.</source>
        <translation>隣り合っていないレイヤーをグループにすると、ほかのレイヤーのグループが分断されてしまいます。</translation>
    </message>
    <message>
        <source>half height of the ellipse</source>
        <translation>楕円の高さの半分</translation>
    </message>
    <message>
        <source>half width of the ellipse</source>
        <translation>楕円の幅の半分</translation>
    </message>
    <message>
        <source>has %1 x %2 pixels, but at most 32768 a side and 100 million in all are read.</source>
        <translation>%1 x %2 ピクセルですが、読み込めるのは一辺 32768 ピクセル、全体で 1 億ピクセルまでです。</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>height of the new canvas</source>
        <translation>新しいキャンバスの高さ</translation>
    </message>
    <message>
        <source>height of the picture</source>
        <translation>画像の高さ</translation>
    </message>
    <message>
        <source>holds %1 bytes, but at most %2 are possible here.</source>
        <translation>%1 バイトありますが、ここでは %2 バイトまでです。</translation>
    </message>
    <message>
        <source>holds a parcel (number %1) whose shape is none.</source>
        <translation>形が正しくない滴 (%1 番) が含まれています。</translation>
    </message>
    <message>
        <source>holds a parcel (number %1) whose values are not finite.</source>
        <translation>値が有限でない滴 (%1 番) が含まれています。</translation>
    </message>
    <message>
        <source>holds a particle whose numbers are not finite.</source>
        <translation>数値が有限でない粒子が含まれています。</translation>
    </message>
    <message>
        <source>holds a value of a cell that is not finite.</source>
        <translation>有限でないセルの値が含まれています。</translation>
    </message>
    <message>
        <source>holds a value that is not a finite number.</source>
        <translation>有限でない値が含まれています。</translation>
    </message>
    <message>
        <source>holds an ICC profile that is none (it is damaged).</source>
        <translation>正しくない ICC プロファイルが含まれています (破損しています)。</translation>
    </message>
    <message>
        <source>holds sizes or numbers that no tank has.</source>
        <translation>水槽ではあり得ない大きさまたは数値が含まれています。</translation>
    </message>
    <message>
        <source>holds sizes or numbers that no tea has.</source>
        <translation>ミルクティーではあり得ない大きさまたは数値が含まれています。</translation>
    </message>
    <message>
        <source>holds sizes or times that no frame has.</source>
        <translation>フレームではあり得ない大きさまたは時刻が含まれています。</translation>
    </message>
    <message>
        <source>holds the paint of another brush than the one %1, which has %2 bristles.</source>
        <translation>%1ブラシ (毛は %2 本) とは別のブラシの絵具が含まれています。</translation>
    </message>
    <message>
        <source>in hand</source>
        <translation>手に持った</translation>
    </message>
    <message>
        <source>is cut off: the end of the JPEG picture is missing.</source>
        <translation>途中で切れています。JPEG 画像の終わりがありません。</translation>
    </message>
    <message>
        <source>is damaged (%1).</source>
        <translation>破損しています (%1)。</translation>
    </message>
    <message>
        <source>is damaged (it cannot be decompressed, or its checksum is another).</source>
        <translation>破損しています (展開できないか、チェックサムが一致しません)。</translation>
    </message>
    <message>
        <source>is damaged (it ends within its first %1 bytes).</source>
        <translation>破損しています (最初の %1 バイトの途中で終わっています)。</translation>
    </message>
    <message>
        <source>is damaged (it is longer than it says).</source>
        <translation>破損しています (記録されている長さより長くなっています)。</translation>
    </message>
    <message>
        <source>is damaged (it is shorter than it says).</source>
        <translation>破損しています (記録されている長さより短くなっています)。</translation>
    </message>
    <message>
        <source>is damaged (its checksum is another).</source>
        <translation>破損しています (チェックサムが一致しません)。</translation>
    </message>
    <message>
        <source>is damaged (its header reaches beyond the end).</source>
        <translation>破損しています (ヘッダーが終わりを越えています)。</translation>
    </message>
    <message>
        <source>is damaged (its length is not the one that is noted).</source>
        <translation>破損しています (長さが記録と一致しません)。</translation>
    </message>
    <message>
        <source>is larger than the %1 bytes that are read of a WebP picture at most.</source>
        <translation>WebP 画像の読み込みの上限 %1 バイトを超えています。</translation>
    </message>
    <message>
        <source>is missing.</source>
        <translation>ありません。</translation>
    </message>
    <message>
        <source>is no %1.</source>
        <translation>%1ではありません。</translation>
    </message>
    <message>
        <source>is no PNG picture</source>
        <translation>PNG 画像ではありません</translation>
    </message>
    <message>
        <source>is not an image that can be read (it is none of %1).</source>
        <translation>読み込める画像ではありません (%1 のいずれでもありません)。</translation>
    </message>
    <message>
        <source>is of version %1, this program reads %2.</source>
        <translation>バージョン %1 のファイルですが、このプログラムが読み込めるのは%2です。</translation>
    </message>
    <message>
        <source>is stored in tiles of %1 x %2 pixels, but 8 a side are the least that are read.</source>
        <translation>%1 x %2 ピクセルのタイルで保存されていますが、読み込めるのは一辺 8 ピクセル以上のタイルです。</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>破損しています</translation>
    </message>
    <message>
        <source>it was reset</source>
        <translation>リセットされました</translation>
    </message>
    <message>
        <source>its end is missing</source>
        <translation>終わりの部分がありません</translation>
    </message>
    <message>
        <source>its memory does not suffice</source>
        <translation>メモリが足りません</translation>
    </message>
    <message>
        <source>its strokes %1</source>
        <translation>ストロークは%1</translation>
    </message>
    <message>
        <source>its support is a picture, and comes no finer than that.</source>
        <translation>支持体が画像なので、その画像より細かくはなりません。</translation>
    </message>
    <message>
        <source>lamp radiance</source>
        <translation>ランプの放射輝度</translation>
    </message>
    <message>
        <source>lamp radius</source>
        <translation>ランプの半径</translation>
    </message>
    <message>
        <source>lamp towards</source>
        <translation>ランプの向き</translation>
    </message>
    <message>
        <source>least height</source>
        <translation>高さの下限</translation>
    </message>
    <message>
        <source>least thickness of wet paint</source>
        <translation>濡れた絵具の厚さの下限</translation>
    </message>
    <message>
        <source>linear pictures</source>
        <translation>リニアな画像</translation>
    </message>
    <message>
        <source>memory ran out: what was asked for last is not done, or not whole.</source>
        <translation>メモリーが足りません。最後の操作は実行されていないか、途中までしか終わっていません。</translation>
    </message>
    <message>
        <source>mesh: &quot;%1&quot; was not read.</source>
        <translation>メッシュ: 「%1」は読み込まれていません。</translation>
    </message>
    <message>
        <source>mesh: it is not closed: the edge from %1 to %2 is not shared by exactly two triangles that run along it in opposite directions.</source>
        <translation>メッシュ: 閉じていません。%1 から %2 への辺は、互いに逆向きに通るちょうど 2 つの三角形に共有されていません。</translation>
    </message>
    <message>
        <source>mesh: there are no triangles.</source>
        <translation>メッシュ: 三角形がありません。</translation>
    </message>
    <message>
        <source>mesh: triangle %1 names vertex %2 of %3.</source>
        <translation>メッシュ: 三角形 %1 が頂点 %2 を指していますが、頂点は %3 個です。</translation>
    </message>
    <message>
        <source>mesh: vertex %1 lies at %2, which is no place.</source>
        <translation>メッシュ: 頂点 %1 の位置 %2 は、あり得ない場所です。</translation>
    </message>
    <message>
        <source>milk share</source>
        <translation>ミルクの割合</translation>
    </message>
    <message>
        <source>milk share&apos;s cell</source>
        <translation>ミルクの割合のセルの大きさ</translation>
    </message>
    <message>
        <source>missing; %1</source>
        <translation>ありません。%1</translation>
    </message>
    <message>
        <source>mixing well</source>
        <translation>混色皿</translation>
    </message>
    <message>
        <source>most height</source>
        <translation>高さの上限</translation>
    </message>
    <message>
        <source>most thickness of wet paint</source>
        <translation>濡れた絵具の厚さの上限</translation>
    </message>
    <message>
        <source>moving the group there would tear a group of layers apart.</source>
        <translation>グループをそこへ移すと、レイヤーのグループが分断されてしまいます。</translation>
    </message>
    <message>
        <source>moving the layer there would tear a group of layers apart.</source>
        <translation>レイヤーをそこへ移すと、レイヤーのグループが分断されてしまいます。</translation>
    </message>
    <message>
        <source>name of a group</source>
        <translation>グループの名前</translation>
    </message>
    <message>
        <source>name of a layer</source>
        <translation>レイヤーの名前</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>理由は不明</translation>
    </message>
    <message>
        <source>no reason was given</source>
        <translation>理由は不明</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>法線</translation>
    </message>
    <message>
        <source>number of parts of %1</source>
        <translation>%1 の割合</translation>
    </message>
    <message>
        <source>number of the group</source>
        <translation>グループの番号</translation>
    </message>
    <message>
        <source>number of the layer</source>
        <translation>レイヤーの番号</translation>
    </message>
    <message>
        <source>number of the outline&apos;s points</source>
        <translation>輪郭の点の数</translation>
    </message>
    <message>
        <source>number of the picture&apos;s pixels</source>
        <translation>画像のピクセル数</translation>
    </message>
    <message>
        <source>number of the symmetry&apos;s copies</source>
        <translation>対称のコピーの数</translation>
    </message>
    <message>
        <source>opacity of the layer</source>
        <translation>レイヤーの不透明度</translation>
    </message>
    <message>
        <source>opacity of the tracing picture</source>
        <translation>下絵の不透明度</translation>
    </message>
    <message>
        <source>other tea</source>
        <translation>別のミルクティー</translation>
    </message>
    <message>
        <source>pictures of %1 million pixels are too large; choose a &quot;picture_scale&quot; for at most 100 million.</source>
        <translation>画像が %1 メガピクセルになり、大きすぎます。100 メガピクセル以下になる「picture_scale」を選んでください。</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>ピクセル</translation>
    </message>
    <message>
        <source>place on the cloth in x</source>
        <translation>布の上での x 方向の位置</translation>
    </message>
    <message>
        <source>place on the cloth in y</source>
        <translation>布の上での y 方向の位置</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>position of the group</source>
        <translation>グループの位置</translation>
    </message>
    <message>
        <source>position of the layer</source>
        <translation>レイヤーの位置</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>筆圧</translation>
    </message>
    <message>
        <source>pressure of the pen</source>
        <translation>ペンの筆圧</translation>
    </message>
    <message>
        <source>radius of the fan</source>
        <translation>扇風機の半径</translation>
    </message>
    <message>
        <source>reach of the guide</source>
        <translation>ガイドの届く範囲</translation>
    </message>
    <message>
        <source>receding_angle_deg is %1, it must not be larger than advancing_angle_deg, %2.</source>
        <translation>receding_angle_deg が %1 ですが、advancing_angle_deg の %2 以下でなければなりません。</translation>
    </message>
    <message>
        <source>red</source>
        <translation>赤</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>解像度</translation>
    </message>
    <message>
        <source>resolution in mm</source>
        <translation>点の間隔（mm）</translation>
    </message>
    <message>
        <source>rotation of the pen</source>
        <translation>ペンの回転</translation>
    </message>
    <message>
        <source>roughness on the dry support</source>
        <translation>乾いた支持体の粗さ</translation>
    </message>
    <message>
        <source>roughness on wet paint</source>
        <translation>濡れた絵具の粗さ</translation>
    </message>
    <message>
        <source>ruler&apos;s first point</source>
        <translation>定規の 1 つ目の点</translation>
    </message>
    <message>
        <source>ruler&apos;s second point</source>
        <translation>定規の 2 つ目の点</translation>
    </message>
    <message>
        <source>scale of the transform along %1, without its sign,</source>
        <translation>変形の %1 方向の倍率（符号を除く）</translation>
    </message>
    <message>
        <source>scene format</source>
        <translation>シーンの形式</translation>
    </message>
    <message>
        <source>scene: %1 is %2, but must be from %3 to %4.</source>
        <translation>シーン: %1 (値 %2) は %3 から %4 の範囲にありません。</translation>
    </message>
    <message>
        <source>scene: %1 is 0, but must be a direction.</source>
        <translation>シーン: %1 (値 0) は向きになりません。</translation>
    </message>
    <message>
        <source>scene: %1&apos;s corner is %2, but must be the number of a position.</source>
        <translation>シーン: %1 の頂点が %2 ですが、位置の番号でなければなりません。</translation>
    </message>
    <message>
        <source>scene: %1&apos;s number of normals is %2, but must be 0 or that of its positions.</source>
        <translation>シーン: %1 の法線の数が %2 ですが、0 か位置の数と同じでなければなりません。</translation>
    </message>
    <message>
        <source>scene: there is not enough memory to trace a mesh of %1 triangles.</source>
        <translation>シーン: 三角形 %1 個のメッシュをたどるにはメモリーが足りません。</translation>
    </message>
    <message>
        <source>seed of the brush</source>
        <translation>ブラシのシード</translation>
    </message>
    <message>
        <source>shadow softness in mm</source>
        <translation>影のやわらかさ（mm）</translation>
    </message>
    <message>
        <source>share of paint</source>
        <translation>絵具の割合</translation>
    </message>
    <message>
        <source>share of the second paint</source>
        <translation>2 番目の絵具の割合</translation>
    </message>
    <message>
        <source>share that is wiped off the brush</source>
        <translation>ブラシから拭き取る割合</translation>
    </message>
    <message>
        <source>single-precision pictures</source>
        <translation>単精度の画像</translation>
    </message>
    <message>
        <source>sky above</source>
        <translation>上の空の明るさ</translation>
    </message>
    <message>
        <source>sky below</source>
        <translation>下の空の明るさ</translation>
    </message>
    <message>
        <source>smoothing of the stabiliser</source>
        <translation>手ぶれ補正の滑らかさ</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>別の種類のもの</translation>
    </message>
    <message>
        <source>something went wrong within the program (%1).</source>
        <translation>プログラムの内部で問題が起きました (%1)。</translation>
    </message>
    <message>
        <source>speed of drying</source>
        <translation>乾燥の速さ</translation>
    </message>
    <message>
        <source>strata that give more light than they get</source>
        <translation>受けた以上の光を返す層</translation>
    </message>
    <message>
        <source>strength of the fan</source>
        <translation>扇風機の強さ</translation>
    </message>
    <message>
        <source>strength of the paint</source>
        <translation>絵具の濃さ</translation>
    </message>
    <message>
        <source>string of the stabiliser</source>
        <translation>手ぶれ補正のひも</translation>
    </message>
    <message>
        <source>stroke format</source>
        <translation>ストロークの形式</translation>
    </message>
    <message>
        <source>support relief</source>
        <translation>支持体の凹凸</translation>
    </message>
    <message>
        <source>table fading</source>
        <translation>テーブルの色の薄れ方</translation>
    </message>
    <message>
        <source>table height</source>
        <translation>テーブルの高さ</translation>
    </message>
    <message>
        <source>table radius</source>
        <translation>テーブルの半径</translation>
    </message>
    <message>
        <source>table reflectance</source>
        <translation>テーブルの反射率</translation>
    </message>
    <message>
        <source>tank format</source>
        <translation>水槽の形式</translation>
    </message>
    <message>
        <source>tank wall</source>
        <translation>水槽の壁の厚さ</translation>
    </message>
    <message>
        <source>tea format</source>
        <translation>ミルクティーの形式</translation>
    </message>
    <message>
        <source>tells of strokes that are later than the painting.</source>
        <translation>作品より後のストロークが含まれています。</translation>
    </message>
    <message>
        <source>the %1 &quot;%2&quot; is not a whole number from 0 to 255.</source>
        <translation>%1「%2」は0から255までの整数ではありません。</translation>
    </message>
    <message>
        <source>the %1 %2 is not a number.</source>
        <translation>%1 %2 は数値ではありません。</translation>
    </message>
    <message>
        <source>the %1 %2 is not between -1e7 and 1e7.</source>
        <translation>%1 %2 は -1e7 から 1e7 の範囲にありません。</translation>
    </message>
    <message>
        <source>the %1 has %2 bytes, but at most %3 are kept.</source>
        <translation>%1が %2 バイトですが、保存できるのは %3 バイトまでです。</translation>
    </message>
    <message>
        <source>the %1 has %2 x %3 cells, but %4 x %5 of another size are expected.</source>
        <translation>%1が %2 x %3 セルですが、大きさの異なる %4 x %5 セルが必要です。</translation>
    </message>
    <message>
        <source>the %1 in %2 is %3, but must lie between %4 and %5.</source>
        <translation>%1 (%2) が %3 ですが、%4 から %5 の範囲でなければなりません。</translation>
    </message>
    <message>
        <source>the %1 is %2, but must lie between %3 and %4.</source>
        <translation>%1が %2 ですが、%3 から %4 の範囲でなければなりません。</translation>
    </message>
    <message>
        <source>the %1 is missing.</source>
        <translation>%1がありません。</translation>
    </message>
    <message>
        <source>the active layer is none.</source>
        <translation>描画中のレイヤーがありません。</translation>
    </message>
    <message>
        <source>the area is empty.</source>
        <translation>範囲が空です。</translation>
    </message>
    <message>
        <source>the brush &quot;%1&quot;</source>
        <translation>ブラシ「%1」</translation>
    </message>
    <message>
        <source>the brush %1 is told of only in part.</source>
        <translation>%1ブラシについての記述が一部しかありません。</translation>
    </message>
    <message>
        <source>the disk is full; make room on it, or choose another place</source>
        <translation>ディスクがいっぱいです。空きを作るか、別の場所を選んでください</translation>
    </message>
    <message>
        <source>the elements are nested too deep.</source>
        <translation>要素の入れ子が深すぎます。</translation>
    </message>
    <message>
        <source>the entry &quot;%1&quot; is missing.</source>
        <translation>項目「%1」がありません。</translation>
    </message>
    <message>
        <source>the field &quot;%1&quot; is missing.</source>
        <translation>項目「%1」がありません。</translation>
    </message>
    <message>
        <source>the file ends here, before &quot;endsolid&quot;.</source>
        <translation>ファイルが「endsolid」の前で終わっています。</translation>
    </message>
    <message>
        <source>the file ends here, within the head of an STL file.</source>
        <translation>STL ファイルのヘッダーの途中でファイルが終わっています。</translation>
    </message>
    <message>
        <source>the groups within &quot;%1&quot; become part of it.</source>
        <translation>「%1」の中のグループは解除され、その一部になります。</translation>
    </message>
    <message>
        <source>the heading is &quot;%1&quot; instead of &quot;%2&quot;.</source>
        <translation>見出しが「%2」ではなく「%1」です。</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is hidden.</source>
        <translation>レイヤー「%1」は非表示です。</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is in a group already.</source>
        <translation>レイヤー「%1」はすでにグループに入っています。</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is locked.</source>
        <translation>レイヤー「%1」はロック中です。</translation>
    </message>
    <message>
        <source>the layers are too large in all.</source>
        <translation>レイヤーの合計が大きすぎます。</translation>
    </message>
    <message>
        <source>the layers of a group do not lie next to each other.</source>
        <translation>同じグループのレイヤーが隣り合っていません。</translation>
    </message>
    <message>
        <source>the medium</source>
        <translation>メディウム</translation>
    </message>
    <message>
        <source>the palette has %1, yours %2.</source>
        <translation>パレットには %1 が、自分の顔料には %2 があります。</translation>
    </message>
    <message>
        <source>the palette has %1.</source>
        <translation>パレットには %1 があります。</translation>
    </message>
    <message>
        <source>the pen touches the canvas with no brush in hand.</source>
        <translation>ブラシを手に持たずに、ペンがキャンバスに触れています。</translation>
    </message>
    <message>
        <source>the pen touches the mixing well with no brush in hand.</source>
        <translation>ブラシを手に持たずに、ペンが混色皿に触れています。</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>the picture %1</source>
        <translation>画像: %1</translation>
    </message>
    <message>
        <source>the picture is no base64.</source>
        <translation>画像が base64 ではありません。</translation>
    </message>
    <message>
        <source>the pictures of this recording are too large; at most 500 million pixels in all are read.</source>
        <translation>この記録の画像は大きすぎます。読み込めるのは全部で 5 億ピクセルまでです。</translation>
    </message>
    <message>
        <source>the pigment has no name.</source>
        <translation>顔料に名前がありません。</translation>
    </message>
    <message>
        <source>the power</source>
        <translation>強度</translation>
    </message>
    <message>
        <source>the power %1 is negative.</source>
        <translation>強度 %1 が負です。</translation>
    </message>
    <message>
        <source>the preset</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>the pressure %1 is not between 0 and 1.</source>
        <translation>筆圧 %1 は 0 から 1 の範囲にありません。</translation>
    </message>
    <message>
        <source>the size of the picture is missing.</source>
        <translation>画像の大きさがありません。</translation>
    </message>
    <message>
        <source>the system refuses this (%1).</source>
        <translation>システムに拒否されました (%1)。</translation>
    </message>
    <message>
        <source>the tick %1 is earlier than %2 before it.</source>
        <translation>ティック %1 が、前の %2 より早くなっています。</translation>
    </message>
    <message>
        <source>the tiles hold %1 bytes, which has to be the size and at most %2.</source>
        <translation>タイルが %1 バイトですが、これは記録された大きさと同じで、%2 バイト以下でなければなりません。</translation>
    </message>
    <message>
        <source>the time %1 s is earlier than %2 s before it.</source>
        <translation>時刻 %1 s が、前の %2 s より早くなっています。</translation>
    </message>
    <message>
        <source>the time %1 s is not between 0 and 86400 s.</source>
        <translation>時刻 %1 s は 0 から 86400 s の範囲にありません。</translation>
    </message>
    <message>
        <source>the wavelength</source>
        <translation>波長</translation>
    </message>
    <message>
        <source>the wavelength %1 nm is not greater than that of the line before.</source>
        <translation>波長 %1 nm が、前の行の波長より大きくありません。</translation>
    </message>
    <message>
        <source>their paint adds up to more than any canvas holds.</source>
        <translation>絵具の合計が、キャンバスに載る量を超えています。</translation>
    </message>
    <message>
        <source>there are %1 columns instead of %2.</source>
        <translation>列が %2 個ではなく %1 個あります。</translation>
    </message>
    <message>
        <source>there are %1 paints, but only %2 have room.</source>
        <translation>絵具が%1色ありますが、%2色しか入りません。</translation>
    </message>
    <message>
        <source>there are %1 ticks for %2 samples.</source>
        <translation>サンプル %2 個に対してティックが %1 個あります。</translation>
    </message>
    <message>
        <source>there are %1 tools instead of %2.</source>
        <translation>道具が%2個ではなく%1個あります。</translation>
    </message>
    <message>
        <source>there are more than %1 layers.</source>
        <translation>レイヤーが %1 枚を超えています。</translation>
    </message>
    <message>
        <source>there are more than %1 triangles.</source>
        <translation>三角形が %1 個を超えています。</translation>
    </message>
    <message>
        <source>there are more than %1 vertices.</source>
        <translation>頂点が %1 個を超えています。</translation>
    </message>
    <message>
        <source>there cannot be a group %1.</source>
        <translation>グループ %1 はあり得ません。</translation>
    </message>
    <message>
        <source>there cannot be a layer %1.</source>
        <translation>レイヤー %1 はあり得ません。</translation>
    </message>
    <message>
        <source>there is another run &quot;%1&quot;.</source>
        <translation>同じ名前の実行「%1」がすでにあります。</translation>
    </message>
    <message>
        <source>there is no brush in hand to take paint with.</source>
        <translation>絵具を付けるブラシを手に持っていません。</translation>
    </message>
    <message>
        <source>there is no field %1.</source>
        <translation>項目 %1 はありません。</translation>
    </message>
    <message>
        <source>there is no form &quot;%1&quot;; the forms are slab, box, disc, cap, gaussian, cosine, noise and image.</source>
        <translation>形「%1」はありません。使える形は slab、box、disc、cap、gaussian、cosine、noise、image です。</translation>
    </message>
    <message>
        <source>there is no group %1 of layers.</source>
        <translation>レイヤーのグループ %1 はありません。</translation>
    </message>
    <message>
        <source>there is no group %1.</source>
        <translation>グループ %1 はありません。</translation>
    </message>
    <message>
        <source>there is no kind of frame %1.</source>
        <translation>種類 %1 のフレームはありません。</translation>
    </message>
    <message>
        <source>there is no layer %1.</source>
        <translation>レイヤー %1 はありません。</translation>
    </message>
    <message>
        <source>there is no layer below &quot;%1&quot; to merge it onto.</source>
        <translation>「%1」の下に、結合できるレイヤーがありません。</translation>
    </message>
    <message>
        <source>there is no medium in hand.</source>
        <translation>手元にメディウムがありません。</translation>
    </message>
    <message>
        <source>there is no place %1 for a layer; the highest is %2.</source>
        <translation>レイヤーの位置 %1 はありません。いちばん上は %2 です。</translation>
    </message>
    <message>
        <source>there is no such entry as &quot;%1&quot; here.</source>
        <translation>ここでは「%1」という項目は使えません。</translation>
    </message>
    <message>
        <source>there is no such kind of tiles as &quot;%1&quot;.</source>
        <translation>「%1」という種類のタイルはありません。</translation>
    </message>
    <message>
        <source>there is no support &quot;%1&quot;; the supports are flat, %2, weave, image, ramp and bump.</source>
        <translation>支持体「%1」はありません。使える支持体は flat、%2、weave、image、ramp、bump です。</translation>
    </message>
    <message>
        <source>there is no surface &quot;%1&quot;; a stroke is on the &quot;canvas&quot; or the &quot;well&quot;.</source>
        <translation>面「%1」はありません。ストロークは「canvas」か「well」に描きます。</translation>
    </message>
    <message>
        <source>there is no visible layer to flatten.</source>
        <translation>結合できる表示レイヤーがありません。</translation>
    </message>
    <message>
        <source>there is no way &quot;%1&quot; to select; they are replace, add, subtract and intersect.</source>
        <translation>選択方法「%1」はありません。使えるのは replace、add、subtract、intersect です。</translation>
    </message>
    <message>
        <source>this is no journal of a painting.</source>
        <translation>作品の控えではありません。</translation>
    </message>
    <message>
        <source>this is no list of layers; it would begin with &lt;image&gt;.</source>
        <translation>レイヤーのリストではありません。&lt;image&gt; で始まるはずです。</translation>
    </message>
    <message>
        <source>this is no painting of Pastoso; it would begin with &quot;format&quot;: &quot;pastoso-project&quot;.</source>
        <translation>Pastoso の作品ではありません。&quot;format&quot;: &quot;pastoso-project&quot; で始まるはずです。</translation>
    </message>
    <message>
        <source>this is not %1; it would begin with &quot;format&quot;: &quot;%2&quot;.</source>
        <translation>%1のファイルではありません。&quot;format&quot;: &quot;%2&quot; で始まるはずです。</translation>
    </message>
    <message>
        <source>this is not a GIMP palette; it would begin with &quot;GIMP Palette&quot;.</source>
        <translation>これはGIMPのパレットではありません。「GIMP Palette」で始まるはずです。</translation>
    </message>
    <message>
        <source>this is not valid JSON: %1.</source>
        <translation>正しい JSON ではありません: %1。</translation>
    </message>
    <message>
        <source>this is not valid XML (%1).</source>
        <translation>正しい XML ではありません (%1)。</translation>
    </message>
    <message>
        <source>this makes %1 cells; 1 to %2 are possible.</source>
        <translation>これでは %1 セルになります。使えるのは 1 から %2 セルまでです。</translation>
    </message>
    <message>
        <source>this must be an object in braces.</source>
        <translation>波かっこで囲んだオブジェクトでなければなりません。</translation>
    </message>
    <message>
        <source>this paint</source>
        <translation>この絵具</translation>
    </message>
    <message>
        <source>this was written by a newer Pastoso (%1 %2; this program reads up to %3).</source>
        <translation>より新しい Pastoso で書かれています (%1 %2、このプログラムが読み込めるのは %3 まで)。</translation>
    </message>
    <message>
        <source>this was written by a newer Pastoso (journal format %1; this program reads up to %2).</source>
        <translation>より新しい Pastoso で書かれています (控えの形式 %1、このプログラムが読み込めるのは %2 まで)。</translation>
    </message>
    <message>
        <source>this was written by a newer Pastoso (project format %1; this program reads up to %2).</source>
        <translation>より新しい Pastoso で書かれています (作品の形式 %1、このプログラムが読み込めるのは %2 まで)。</translation>
    </message>
    <message>
        <source>tile %1 comes twice.</source>
        <translation>タイル %1 が 2 回出てきます。</translation>
    </message>
    <message>
        <source>tile %1 moves as no paint can.</source>
        <translation>タイル %1 が、絵具ではあり得ない動きをしています。</translation>
    </message>
    <message>
        <source>tile %1 moves, but there is no &quot;window&quot; that it started from.</source>
        <translation>タイル %1 は動いていますが、動き始めの「window」がありません。</translation>
    </message>
    <message>
        <source>tile %1 sleeps, and yet its motion is followed.</source>
        <translation>タイル %1 は休止中なのに、動きが記録されています。</translation>
    </message>
    <message>
        <source>tilt of the canvas</source>
        <translation>キャンバスの傾き</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>time of the pen</source>
        <translation>ペンの時刻</translation>
    </message>
    <message>
        <source>touch_dry_s is %1, it must not be larger than typical_thickness_mm times %2.</source>
        <translation>touch_dry_s が %1 ですが、typical_thickness_mm の %2 倍以下でなければなりません。</translation>
    </message>
    <message>
        <source>trace settings: a side of the picture is %1, but must be from 1 to 16384 pixels.</source>
        <translation>レンダリングの設定: 画像の一辺が %1 ですが、1 から 16384 ピクセルの範囲でなければなりません。</translation>
    </message>
    <message>
        <source>trace settings: brightest is %1, but must be above 0 and finite.</source>
        <translation>レンダリングの設定: brightest が %1 ですが、0 より大きい有限の値でなければなりません。</translation>
    </message>
    <message>
        <source>trace settings: most_events is %1, but must be at least 1.</source>
        <translation>レンダリングの設定: most_events が %1 ですが、1 以上でなければなりません。</translation>
    </message>
    <message>
        <source>transform&apos;s centre</source>
        <translation>変形の中心</translation>
    </message>
    <message>
        <source>transform&apos;s move</source>
        <translation>変形の移動</translation>
    </message>
    <message>
        <source>transform&apos;s scale</source>
        <translation>変形の倍率</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true か false の値</translation>
    </message>
    <message>
        <source>turn of the ellipse</source>
        <translation>楕円の回転</translation>
    </message>
    <message>
        <source>turn of the transform</source>
        <translation>変形の回転</translation>
    </message>
    <message>
        <source>variation of the share</source>
        <translation>割合のばらつき</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>バージョン %1</translation>
    </message>
    <message>
        <source>versions %1 to %2</source>
        <translation>バージョン %1 から %2</translation>
    </message>
    <message>
        <source>volume of the squeezed paint</source>
        <translation>絞り出す絵具の体積</translation>
    </message>
    <message>
        <source>were painted with an earlier version of the program (arithmetic %1, now %2): replayed, they come out a little differently.</source>
        <translation>以前のバージョンのプログラムで描かれています (計算方式 %1、現在は %2)。再生すると、少し違う結果になります。</translation>
    </message>
    <message>
        <source>width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>width of the brush</source>
        <translation>ブラシの幅</translation>
    </message>
    <message>
        <source>width of the new canvas</source>
        <translation>新しいキャンバスの幅</translation>
    </message>
    <message>
        <source>width of the picture</source>
        <translation>画像の幅</translation>
    </message>
    <message>
        <source>window radiance</source>
        <translation>窓の放射輝度</translation>
    </message>
    <message>
        <source>window radius</source>
        <translation>窓の半径</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x of the %1</source>
        <translation>%1の x の値</translation>
    </message>
    <message>
        <source>x of the centre of the symmetry</source>
        <translation>対称の中心の x 座標</translation>
    </message>
    <message>
        <source>x of the fan</source>
        <translation>扇風機の x 座標</translation>
    </message>
    <message>
        <source>x of the new canvas</source>
        <translation>新しいキャンバスの x 座標</translation>
    </message>
    <message>
        <source>x of the pen</source>
        <translation>ペンの x 座標</translation>
    </message>
    <message>
        <source>x of the picture</source>
        <translation>画像の x 座標</translation>
    </message>
    <message>
        <source>x of the squeezed paint</source>
        <translation>絞り出す絵具の x 座標</translation>
    </message>
    <message>
        <source>x tilt of the pen</source>
        <translation>ペンの x 方向の傾き</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>y of the %1</source>
        <translation>%1の y の値</translation>
    </message>
    <message>
        <source>y of the centre of the symmetry</source>
        <translation>対称の中心の y 座標</translation>
    </message>
    <message>
        <source>y of the fan</source>
        <translation>扇風機の y 座標</translation>
    </message>
    <message>
        <source>y of the new canvas</source>
        <translation>新しいキャンバスの y 座標</translation>
    </message>
    <message>
        <source>y of the pen</source>
        <translation>ペンの y 座標</translation>
    </message>
    <message>
        <source>y of the picture</source>
        <translation>画像の y 座標</translation>
    </message>
    <message>
        <source>y of the squeezed paint</source>
        <translation>絞り出す絵具の y 座標</translation>
    </message>
    <message>
        <source>y tilt of the pen</source>
        <translation>ペンの y 方向の傾き</translation>
    </message>
    <message>
        <source>yellowing</source>
        <translation>黄変</translation>
    </message>
    <message>
        <source>your share of the disk is used up; make room on it, or choose another place</source>
        <translation>ディスクの割り当て容量を使い切りました。空きを作るか、別の場所を選んでください</translation>
    </message>
    <message>
        <source>difference of the colour</source>
        <translation>色の差</translation>
    </message>
    <message>
        <source>gradient&apos;s point</source>
        <translation>グラデーションの点</translation>
    </message>
    <message>
        <source>length of the gradient&apos;s line</source>
        <translation>グラデーションの線の長さ</translation>
    </message>
    <message>
        <source>no paint has been copied that could be pasted.</source>
        <translation>貼り付けられる絵具がコピーされていません。</translation>
    </message>
    <message>
        <source>number of points of the gradient&apos;s line</source>
        <translation>グラデーションの線の点の数</translation>
    </message>
    <message>
        <source>number of quarter turns</source>
        <translation>90度回転の回数</translation>
    </message>
    <message>
        <source>outline&apos;s point</source>
        <translation>輪郭の点</translation>
    </message>
    <message>
        <source>there is no visible layer to copy.</source>
        <translation>コピーできる表示レイヤーがありません。</translation>
    </message>
    <message>
        <source>thickness of the film</source>
        <translation>膜の厚さ</translation>
    </message>
    <message>
        <source>way from where it was copied</source>
        <translation>コピーした場所からの移動</translation>
    </message>
    <message>
        <source>width of the margin</source>
        <translation>縁の幅</translation>
    </message>
    <message>
        <source>x of the colour&apos;s place</source>
        <translation>色の場所のx</translation>
    </message>
    <message>
        <source>y of the colour&apos;s place</source>
        <translation>色の場所のy</translation>
    </message>
    <message>
        <source>%1: is no bundle of tools; it has no %2.</source>
        <translation>%1: ツールのバンドルではありません。%2がありません。</translation>
    </message>
    <message>
        <source>name is &quot;%1&quot;, which another tool of the bundle has already.</source>
        <translation>nameは「%1」ですが、バンドル内の別のツールと同じです。</translation>
    </message>
    <message>
        <source>there are %1 tools, more than %2.</source>
        <translation>ツールが%1個あり、%2個を超えています。</translation>
    </message>
    <message>
        <source>copied paint</source>
        <translation>コピーした絵具</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there twice.</source>
        <translation>「%1」が二つあります。</translation>
    </message>
    <message>
        <source>a mix needs a name.</source>
        <translation>混色には名前が必要です。</translation>
    </message>
    <message>
        <source>a sample has 4 to 8 numbers, time, x, y, pressure, tilt_x, tilt_y, rotation, wheel; here are %1.</source>
        <translation>サンプルは4から8個の数 time, x, y, pressure, tilt_x, tilt_y, rotation, wheel です。ここには%1個あります。</translation>
    </message>
    <message>
        <source>a set needs a name.</source>
        <translation>セットには名前が必要です。</translation>
    </message>
    <message>
        <source>change of the resolution</source>
        <translation>解像度の倍率</translation>
    </message>
    <message>
        <source>scale of the height</source>
        <translation>高さの倍率</translation>
    </message>
    <message>
        <source>scale of the width</source>
        <translation>幅の倍率</translation>
    </message>
    <message>
        <source>the panel %1 stands there twice.</source>
        <translation>パネル %1 が二か所にあります。</translation>
    </message>
    <message>
        <source>there are %1 mixes, but only %2 have room.</source>
        <translation>混色が%1個ありますが、%2個しか入りません。</translation>
    </message>
    <message>
        <source>there is no &quot;%1&quot;.</source>
        <translation>「%1」はありません。</translation>
    </message>
    <message>
        <source>there is no panel.</source>
        <translation>パネルがありません。</translation>
    </message>
    <message>
        <source>wheel of the pen</source>
        <translation>ペンのホイール</translation>
    </message>
    <message>
        <source>a tag needs a name.</source>
        <translation>タグには名前が必要です。</translation>
    </message>
    <message>
        <source>corner that is distorted</source>
        <translation>変形する範囲の角</translation>
    </message>
    <message>
        <source>diameter of the grains</source>
        <translation>粒の直径</translation>
    </message>
    <message>
        <source>direction of the grid&apos;s first lines</source>
        <translation>グリッドの 1 組目の線の向き</translation>
    </message>
    <message>
        <source>direction of the grid&apos;s other lines</source>
        <translation>グリッドのもう 1 組の線の向き</translation>
    </message>
    <message>
        <source>direction of the horizon</source>
        <translation>水平線の向き</translation>
    </message>
    <message>
        <source>direction of the knife</source>
        <translation>ナイフの向き</translation>
    </message>
    <message>
        <source>direction of uprights</source>
        <translation>垂直線の向き</translation>
    </message>
    <message>
        <source>expected at most %1 references.</source>
        <translation>参考画像は %1 枚までのはずです。</translation>
    </message>
    <message>
        <source>first vanishing point</source>
        <translation>1 つ目の消失点</translation>
    </message>
    <message>
        <source>grid&apos;s point</source>
        <translation>グリッドの点</translation>
    </message>
    <message>
        <source>height of the texture</source>
        <translation>テクスチャーの高さ</translation>
    </message>
    <message>
        <source>holds cells of another canvas than this one.</source>
        <translation>このキャンバスのものではないセルが含まれています。</translation>
    </message>
    <message>
        <source>holds no cell.</source>
        <translation>セルが含まれていません。</translation>
    </message>
    <message>
        <source>length of a side of the distortion, times what it was,</source>
        <translation>変形後の辺の長さ（元の長さに対する倍率）</translation>
    </message>
    <message>
        <source>lower left corner of the distortion</source>
        <translation>変形の左下の角</translation>
    </message>
    <message>
        <source>lower right corner of the distortion</source>
        <translation>変形の右下の角</translation>
    </message>
    <message>
        <source>makes the references larger than any board holds.</source>
        <translation>これで参考画像がボードの限度を超えます。</translation>
    </message>
    <message>
        <source>masking&apos;s point</source>
        <translation>マスキングの点</translation>
    </message>
    <message>
        <source>name of a reference</source>
        <translation>参考画像の名前</translation>
    </message>
    <message>
        <source>number of the masking&apos;s points</source>
        <translation>マスキングの点の数</translation>
    </message>
    <message>
        <source>number of the reference</source>
        <translation>参考画像の番号</translation>
    </message>
    <message>
        <source>number of vanishing points</source>
        <translation>消失点の数</translation>
    </message>
    <message>
        <source>opacity of the reference</source>
        <translation>参考画像の不透明度</translation>
    </message>
    <message>
        <source>position of the reference</source>
        <translation>参考画像の順番</translation>
    </message>
    <message>
        <source>second vanishing point</source>
        <translation>2 つ目の消失点</translation>
    </message>
    <message>
        <source>seed of the texture</source>
        <translation>テクスチャーのシード</translation>
    </message>
    <message>
        <source>size of what is distorted</source>
        <translation>変形する範囲の大きさ</translation>
    </message>
    <message>
        <source>spacing of the grid&apos;s first lines</source>
        <translation>グリッドの 1 組目の線の間隔</translation>
    </message>
    <message>
        <source>spacing of the grid&apos;s other lines</source>
        <translation>グリッドのもう 1 組の線の間隔</translation>
    </message>
    <message>
        <source>spacing of the ridges</source>
        <translation>うねの間隔</translation>
    </message>
    <message>
        <source>strength of the guide</source>
        <translation>ガイドの強さ</translation>
    </message>
    <message>
        <source>the board holds %1 references, and no more are kept.</source>
        <translation>ボードには参考画像が %1 枚あり、これ以上は置けません。</translation>
    </message>
    <message>
        <source>the corners of the distortion have to go round an area that bends outwards at each of them, by %1 degree or more.</source>
        <translation>変形の四隅は、どの角も%1度以上外側に折れた四角形を囲む必要があります。</translation>
    </message>
    <message>
        <source>the name of a reference has %1 bytes, but at most %2 are kept.</source>
        <translation>参考画像の名前が %1 バイトありますが、保存できるのは %2 バイトまでです。</translation>
    </message>
    <message>
        <source>the number %1 has not been given yet.</source>
        <translation>番号 %1 はまだ割り当てられていません。</translation>
    </message>
    <message>
        <source>the references on the board are too large; at most %1 million pixels in all are kept.</source>
        <translation>ボードの参考画像が大きすぎます。置けるのは全部で %1 百万ピクセルまでです。</translation>
    </message>
    <message>
        <source>there are two references %1.</source>
        <translation>参考画像 %1 が 2 つあります。</translation>
    </message>
    <message>
        <source>these are no corners of that mask.</source>
        <translation>これはそのマスクの角ではありません。</translation>
    </message>
    <message>
        <source>third vanishing point</source>
        <translation>3 つ目の消失点</translation>
    </message>
    <message>
        <source>turn of the canvas</source>
        <translation>キャンバスの回転</translation>
    </message>
    <message>
        <source>turn of the reference</source>
        <translation>参考画像の回転</translation>
    </message>
    <message>
        <source>upper left corner of the distortion</source>
        <translation>変形の左上の角</translation>
    </message>
    <message>
        <source>upper right corner of the distortion</source>
        <translation>変形の右上の角</translation>
    </message>
    <message>
        <source>width of the masking</source>
        <translation>マスキングの幅</translation>
    </message>
    <message>
        <source>width of the reference</source>
        <translation>参考画像の幅</translation>
    </message>
    <message>
        <source>x of the reference</source>
        <translation>参考画像の x</translation>
    </message>
    <message>
        <source>y of the reference</source>
        <translation>参考画像の y</translation>
    </message>
    <message>
        <source>a group of layers cannot be clipped; its layers can.</source>
        <translation>グループはクリッピングできません。中のレイヤーならできます。</translation>
    </message>
    <message>
        <source>a map has 4 numbers; here are %1.</source>
        <translation>変換には4つの数値が必要ですが、ここには%1個あります。</translation>
    </message>
    <message>
        <source>a stroke that goes on says nothing of where it began.</source>
        <translation>続きのストロークは、どこで始まったかを指定できません。</translation>
    </message>
    <message>
        <source>holds a cell that is not masked.</source>
        <translation>マスクされていないセルが含まれています。</translation>
    </message>
    <message>
        <source>radius of the feather</source>
        <translation>境界のぼかしの半径</translation>
    </message>
    <message>
        <source>share of the dry paint</source>
        <translation>乾いた絵具の割合</translation>
    </message>
    <message>
        <source>the medium in hand leaves next to nothing when it dries.</source>
        <translation>手持ちのメディウムは乾くとほとんど何も残りません。</translation>
    </message>
    <message>
        <source>there is no dry paint on &quot;%1&quot; to adjust.</source>
        <translation>「%1」には調整できる乾いた絵具がありません。</translation>
    </message>
    <message>
        <source>thickness of the glaze</source>
        <translation>グレーズの厚さ</translation>
    </message>
    <message>
        <source>width of the cloth&apos;s threads</source>
        <translation>布の糸の幅</translation>
    </message>
    <message>
        <source>The cloth has been drawn out too unevenly: for a canvas of %1 x %2 cells, %3 x %4 would have to be woven.</source>
        <translation>布の伸び方が不均一すぎます：%1×%2セルのキャンバスに、%3×%4セルを織る必要があります。</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is clipped to &quot;%2&quot;, which is hidden.</source>
        <translation>レイヤー「%1」は、非表示の「%2」にクリップされています。</translation>
    </message>
    <message>
        <source>%1 bytes of paint follow, but there should be %2.</source>
        <translation>絵具のデータは %1 バイトですが、%2 バイトのはずです。</translation>
    </message>
    <message>
        <source>%1: is no paint that was copied in Pastoso.</source>
        <translation>%1: Pastoso でコピーされた絵具ではありません。</translation>
    </message>
    <message>
        <source>format of copied paint</source>
        <translation>コピーした絵具の形式</translation>
    </message>
    <message>
        <source>no canvas holds so much paint.</source>
        <translation>これほど多くの絵具が載るキャンバスはありません。</translation>
    </message>
    <message>
        <source>no painting has cells of this size.</source>
        <translation>この大きさのセルを持つ絵はありません。</translation>
    </message>
    <message>
        <source>paint that was copied in another painting has no strokes here, and comes no finer than it is.</source>
        <translation>別の絵でコピーした絵具にはここでの筆跡がなく、今より細かくはなりません。</translation>
    </message>
    <message>
        <source>the copied paint has cells of a size that no painting has.</source>
        <translation>コピーした絵具のセルの大きさは、どの絵にもないものです。</translation>
    </message>
    <message>
        <source>the copied paint is no base64.</source>
        <translation>コピーした絵具が base64 ではありません。</translation>
    </message>
    <message>
        <source>the paint of other paintings in this recording is too large; at most 16 GB are read.</source>
        <translation>この記録に含まれる別の絵の絵具が大きすぎます。読み込めるのは最大 16 GB です。</translation>
    </message>
    <message>
        <source>there are %1 puddles, but only %2 have room.</source>
        <translation>絵具だまりが%1個ありますが、%2個しか入りません。</translation>
    </message>
    <message>
        <source>there is more paint than is read, 4 GB.</source>
        <translation>絵具が読み込める量（4 GB）を超えています。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not one of pastoso, krita and photoshop.</source>
        <translation>「%1」は pastoso でも krita でも photoshop でもありません。</translation>
    </message>
    <message>
        <source>%1 would have %2 x %3 pixels; at most %4 a side are possible.</source>
        <translation>%1は %2 x %3 ピクセルになりますが、一辺 %4 ピクセルまでです。</translation>
    </message>
    <message>
        <source>The canvas is %1 x %2 pixels, more than this graphics driver can show.</source>
        <translation>キャンバスは%1 x %2ピクセルあり、このグラフィックスドライバーでは表示しきれません。</translation>
    </message>
</context>
<context>
    <name>ExamplePaintings</name>
    <message>
        <source>Still life</source>
        <translation>静物</translation>
    </message>
    <message>
        <source>Oil, wet in wet</source>
        <translation>油彩、ウェット・イン・ウェット</translation>
    </message>
    <message>
        <source>Surf</source>
        <translation>寄せる波</translation>
    </message>
    <message>
        <source>Oil, in thick impasto</source>
        <translation>油彩、厚いインパスト</translation>
    </message>
    <message>
        <source>Poppies</source>
        <translation>ポピー</translation>
    </message>
    <message>
        <source>Oil over a dry ground</source>
        <translation>油彩、乾いた下地の上に</translation>
    </message>
    <message>
        <source>Evening by a river</source>
        <translation>川辺の夕暮れ</translation>
    </message>
    <message>
        <source>Oil, from ground to glaze</source>
        <translation>油彩、下地からグレーズまで</translation>
    </message>
</context>
<context>
    <name>FactList</name>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
</context>
<context>
    <name>Findable</name>
    <message>
        <source>Take this tool in hand</source>
        <translation>この道具を持つ</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>絵具</translation>
    </message>
    <message>
        <source>Choose this paint</source>
        <translation>この絵具を選ぶ</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>メディウム</translation>
    </message>
    <message>
        <source>Your mix</source>
        <translation>自分の混色</translation>
    </message>
</context>
<context>
    <name>FindableControls</name>
    <message>
        <source>Harmony</source>
        <translation>色の調和</translation>
    </message>
    <message>
        <source>Marks for hues that go together, on the colour wheel</source>
        <translation>調和する色相を色相環に示す</translation>
    </message>
    <message>
        <source>complementary, analogous, triad, tetrad, colour scheme, color scheme</source>
        <translation>補色、類似色、トライアド、配色</translation>
    </message>
    <message>
        <source>Gamut mask</source>
        <translation>色域マスク</translation>
    </message>
    <message>
        <source>A shape on the colour wheel to choose within</source>
        <translation>色相環の上の形。その中から選ぶ</translation>
    </message>
    <message>
        <source>limited palette, color mask</source>
        <translation>ガマットマスク、限定パレット</translation>
    </message>
    <message>
        <source>Keep on your palette</source>
        <translation>自分のパレットに取っておく</translation>
    </message>
    <message>
        <source>Lay the paint in hand out on your palette</source>
        <translation>今の絵具を自分のパレットに置く</translation>
    </message>
    <message>
        <source>swatch, add colour, add color</source>
        <translation>スウォッチ、色を追加</translation>
    </message>
    <message>
        <source>Save the palette</source>
        <translation>パレットを保存</translation>
    </message>
    <message>
        <source>The colours of your palette for GIMP, Krita or Inkscape, as a .gpl file</source>
        <translation>自分のパレットの色をGIMP、Krita、Inkscape用の.gplファイルにする</translation>
    </message>
    <message>
        <source>gpl, swatches, export palette</source>
        <translation>gpl、スウォッチ、パレットの書き出し</translation>
    </message>
    <message>
        <source>Open a palette</source>
        <translation>パレットを開く</translation>
    </message>
    <message>
        <source>Colours of GIMP, Krita or Inkscape, from a .gpl file</source>
        <translation>GIMP、Krita、Inkscapeの色を.gplファイルから</translation>
    </message>
    <message>
        <source>gpl, swatches, import palette</source>
        <translation>gpl、スウォッチ、パレットの読み込み</translation>
    </message>
    <message>
        <source>Palette from a picture</source>
        <translation>画像からパレット</translation>
    </message>
    <message>
        <source>Finds the colours that a picture is made of</source>
        <translation>画像を成す色を見つける</translation>
    </message>
    <message>
        <source>extract, palette from image</source>
        <translation>色を抽出、写真からパレット</translation>
    </message>
    <message>
        <source>Keep as a mix</source>
        <translation>混色として取っておく</translation>
    </message>
    <message>
        <source>Keep the paint in hand as a recipe of tubes, under a name of your own</source>
        <translation>今の絵具を、自分で付けた名前でチューブのレシピとして取っておく</translation>
    </message>
    <message>
        <source>recipe, save colour, save color</source>
        <translation>レシピ、色を保存</translation>
    </message>
    <message>
        <source>Sets of tubes</source>
        <translation>チューブのセット</translation>
    </message>
    <message>
        <source>Which tubes are shown: all of them, or a set of yours</source>
        <translation>どのチューブを出すか。全部か、自分のセットか</translation>
    </message>
    <message>
        <source>tube sets, palette of tubes</source>
        <translation>絵具セット、チューブの選択</translation>
    </message>
    <message>
        <source>Tags of tools</source>
        <translation>ツールのタグ</translation>
    </message>
    <message>
        <source>Which tools are listed: a family, favourites or a tag</source>
        <translation>一覧に出すツール。系統、お気に入り、タグから</translation>
    </message>
    <message>
        <source>tagged, collections, brush sets</source>
        <translation>分類、ブラシセット</translation>
    </message>
    <message>
        <source>Snapping strength</source>
        <translation>スナップの強さ</translation>
    </message>
    <message>
        <source>How far the guide draws the brush from where your hand is</source>
        <translation>ガイドがブラシを手の位置からどれだけ引き寄せるか</translation>
    </message>
    <message>
        <source>magnetic, assistant strength</source>
        <translation>吸着、アシスタントの強さ</translation>
    </message>
    <message>
        <source>Squeeze out the last painting&apos;s palette</source>
        <translation>前の絵のパレットを絞り出す</translation>
    </message>
    <message>
        <source>The paints and mixtures of the earlier well, onto the mixing well</source>
        <translation>前に混色皿にあった絵具と混色を、混色皿に出す</translation>
    </message>
    <message>
        <source>restore palette, palette of before</source>
        <translation>パレットを復元、前のパレット</translation>
    </message>
    <message>
        <source>New tag for the tool in hand</source>
        <translation>手にある道具に新しいタグ</translation>
    </message>
    <message>
        <source>A word of your own under which the tool is listed</source>
        <translation>その道具を一覧に出すための自分の言葉</translation>
    </message>
    <message>
        <source>add tag, label</source>
        <translation>タグを追加、ラベル</translation>
    </message>
</context>
<context>
    <name>FolderFacts</name>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Your tools, paints and lamps</source>
        <translation>自分の道具、絵具、ランプ</translation>
    </message>
    <message>
        <source>Paintings that are not saved</source>
        <translation>保存していない絵</translation>
    </message>
    <message>
        <source>What the program brings along</source>
        <translation>プログラムに付属するもの</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Like Krita</source>
        <translation>Krita風</translation>
    </message>
    <message>
        <source>The keys of Krita, where it has the same command</source>
        <translation>同じコマンドがあればKritaのキーを使う</translation>
    </message>
    <message>
        <source>Like Photoshop</source>
        <translation>Photoshop風</translation>
    </message>
    <message>
        <source>The keys of Photoshop, where it has the same command</source>
        <translation>同じコマンドがあればPhotoshopのキーを使う</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>Krita&apos;s keys, but for short ones of what only wet paint has</source>
        <translation>Kritaのキー。ただし濡れた絵具だけの操作には短いキー</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Drops and sprays</source>
        <translation>しずくとスプレー</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>エアー</translation>
    </message>
    <message>
        <source>Knives and combs</source>
        <translation>ナイフとコーム</translation>
    </message>
    <message>
        <source>Rags and fingers</source>
        <translation>布と指</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source>Cannot be read</source>
        <translation>読み込めないもの</translation>
    </message>
    <message>
        <source>Clear medium</source>
        <translation>透明メディウム</translation>
    </message>
    <message>
        <source>How the next paint flows; what lies on the canvas keeps its own way</source>
        <translation>これから使う絵具の流れ方。キャンバス上の絵具の性質は変わらない</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>付け直す</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>洗う</translation>
    </message>
    <message>
        <source>Medium </source>
        <translation>メディウム </translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Mixing well</source>
        <translation>混色皿</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前を変更</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>絞り出す</translation>
    </message>
    <message>
        <source>Wipe the well</source>
        <translation>混色皿を拭く</translation>
    </message>
    <message>
        <source>the same to the eye</source>
        <translation>見た目は同じ</translation>
    </message>
    <message>
        <source>close</source>
        <translation>近い</translation>
    </message>
    <message>
        <source>a little off</source>
        <translation>少し違う</translation>
    </message>
    <message>
        <source>beyond these tubes</source>
        <translation>このチューブでは作れない</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>筆圧</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>傾き</translation>
    </message>
    <message>
        <source>Barrel</source>
        <translation>ペン軸の回転</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>how far it is pressed</source>
        <translation>押し付ける強さ</translation>
    </message>
    <message>
        <source>how far it leans</source>
        <translation>倒れ具合</translation>
    </message>
    <message>
        <source>how it is turned</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>reach into hollows</source>
        <translation>くぼみへの届き方</translation>
    </message>
    <message>
        <source>film that it leaves</source>
        <translation>残る絵具の膜</translation>
    </message>
    <message>
        <source>paint taken up</source>
        <translation>拾う絵具の量</translation>
    </message>
    <message>
        <source>flow</source>
        <translation>流量</translation>
    </message>
    <message>
        <source>width of the spread</source>
        <translation>広がりの幅</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 % pressure</source>
        <translation>筆圧 %1 %</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>wet, inactive</source>
        <translation>濡れたまま休止中</translation>
    </message>
    <message>
        <source>A group: its eye, its lock and its opacity hold for all of its layers</source>
        <translation>グループ。表示、ロック、不透明度は中のすべてのレイヤーに効く</translation>
    </message>
    <message>
        <source>You paint on this layer; its wet paint flows and dries</source>
        <translation>描画中のレイヤー。濡れた絵具は流れ、乾いていく</translation>
    </message>
    <message>
        <source>Its wet paint keeps still: it neither flows nor dries, and stays as wet as it is until you choose this layer</source>
        <translation>濡れた絵具は休止中。このレイヤーを選ぶまで、流れも乾きもせず濡れたまま保たれる</translation>
    </message>
    <message>
        <source>Click to paint on this layer; a double click names it, dragging moves it</source>
        <translation>クリックするとこのレイヤーに描く。ダブルクリックで名前を変更、ドラッグで移動</translation>
    </message>
    <message>
        <source>Seen; click to hide it. Its relief goes with it</source>
        <translation>表示中。クリックで隠す。凹凸も一緒に隠れる</translation>
    </message>
    <message>
        <source>Hidden, and not painted on; click to show it</source>
        <translation>非表示で、描き込めない。クリックで表示</translation>
    </message>
    <message>
        <source>Locked: nothing is painted on it, cleared or merged. Click to unlock</source>
        <translation>ロック中。描画も消去も結合もできない。クリックでロックを解除</translation>
    </message>
    <message>
        <source>Click to lock it against painting, clearing and merging</source>
        <translation>クリックでロックし、描画、消去、結合から守る</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>ペン先</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>下側</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>中央</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>上側</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>not told</source>
        <comment>rotation</comment>
        <translation>情報なし</translation>
    </message>
    <message>
        <source>Tilt %1 across, %2 along; rotation %3; buttons: %4</source>
        <translation>傾き 横 %1、縦 %2、回転 %3、ボタン: %4</translation>
    </message>
    <message>
        <source>%1, eraser end</source>
        <translation>%1、消しゴム側</translation>
    </message>
    <message>
        <source>%1, puck</source>
        <translation>%1、パック</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>マウス</translation>
    </message>
    <message>
        <source>pressure %1 → %2</source>
        <translation>筆圧 %1 → %2</translation>
    </message>
    <message>
        <source>pressure %1</source>
        <translation>筆圧 %1</translation>
    </message>
    <message>
        <source>%1: %2, %3 events a second</source>
        <translation>%1: %2、毎秒 %3 イベント</translation>
    </message>
    <message>
        <source>Buttons: %1</source>
        <translation>ボタン: %1</translation>
    </message>
    <message>
        <source>clear medium</source>
        <translation>透明メディウム</translation>
    </message>
    <message>
        <source>thinned to %1</source>
        <translation>%1 に希釈</translation>
    </message>
    <message>
        <source>Dry now</source>
        <translation>すぐ乾かす</translation>
    </message>
    <message>
        <source>How fast time passes for the paint: 10 × is ten seconds in one. While you draw a stroke it passes as usual</source>
        <translation>絵具の時間が進む速さ。10 ×では1秒に10秒分進む。描いている間はふつうの速さになる</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>透明</translation>
    </message>
    <message>
        <source>semi-transparent</source>
        <translation>半透明</translation>
    </message>
    <message>
        <source>semi-opaque</source>
        <translation>半不透明</translation>
    </message>
    <message>
        <source>opaque</source>
        <translation>不透明</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>ride on wet paint</source>
        <translation>濡れた絵具への乗り</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>ウォッシュ</translation>
    </message>
    <message>
        <source>paste</source>
        <translation>ペースト</translation>
    </message>
    <message>
        <source>cream</source>
        <translation>クリーム</translation>
    </message>
    <message>
        <source>milk</source>
        <translation>ミルク</translation>
    </message>
    <message>
        <source>wash</source>
        <translation>薄塗り</translation>
    </message>
    <message>
        <source>stain</source>
        <translation>ステイン</translation>
    </message>
    <message>
        <source>Each stroke</source>
        <translation>毎回付け直す</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>向きを合わせる</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>マニュアル</translation>
    </message>
    <message>
        <source>What is new</source>
        <translation>新しくなったこと</translation>
    </message>
    <message>
        <source>About Pastoso</source>
        <translation>Pastoso について</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>編集</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>お気に入り</translation>
    </message>
    <message>
        <source>The brush is not over it</source>
        <translation>ブラシは上にない</translation>
    </message>
    <message>
        <source>Brush at %1, %2 mm</source>
        <translation>ブラシは %1, %2 mm</translation>
    </message>
    <message>
        <source>Kind of paint</source>
        <translation>絵具の種類</translation>
    </message>
    <message>
        <source>Charcoal and pastels</source>
        <translation>木炭とパステル</translation>
    </message>
    <message>
        <source>Pens</source>
        <translation>ペン</translation>
    </message>
    <message>
        <source>Sponges and rollers</source>
        <translation>スポンジとローラー</translation>
    </message>
    <message>
        <source>Direction of the stroke</source>
        <translation>ストロークの向き</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>進んだ距離</translation>
    </message>
    <message>
        <source>Time since the touch</source>
        <translation>触れてからの時間</translation>
    </message>
    <message>
        <source>Distance in brush widths</source>
        <translation>筆幅で測った距離</translation>
    </message>
    <message>
        <source>Chance, each stroke</source>
        <translation>偶然 (ストロークごと)</translation>
    </message>
    <message>
        <source>Chance along the stroke</source>
        <translation>偶然 (ストロークに沿って)</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>ホイール</translation>
    </message>
    <message>
        <source>Paint left on the tool</source>
        <translation>道具に残る絵具</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 widths</source>
        <translation>筆幅の%1倍</translation>
    </message>
    <message>
        <source>What is bare is locked: tools change only what has paint. Click to unlock</source>
        <translation>絵具のない部分はロック中。ツールは絵具のある部分だけを変える。クリックでロックを解除</translation>
    </message>
    <message>
        <source>Click to lock what is bare: tools change only what has paint</source>
        <translation>クリックで絵具のない部分をロックし、絵具のある部分だけをツールで変える</translation>
    </message>
    <message>
        <source>Clipped to the layer below: of its paint, only what lies over paint of that layer shows. The rest is hidden, and kept</source>
        <translation>下のレイヤーでクリッピング中: そのレイヤーの絵具の上にある部分だけが見えます。残りは隠れていますが失われません</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>はい(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>いいえ(&amp;N)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>適用</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>リセット</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>既定値に戻す</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>再試行</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>無視</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>中止</translation>
    </message>
</context>
<context>
    <name>SelectionMargins</name>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
</context>
<context>
    <name>TourCommands</name>
    <message>
        <source>Paint</source>
        <translation>描く</translation>
    </message>
    <message>
        <source>Press on the canvas and drag: the brush lays wet paint, and drags along what is wet already. A pen that presses harder bends the hairs further.</source>
        <translation>キャンバスを押してドラッグすると、ブラシが濡れた絵具を置き、まだ濡れている絵具を引きずります。ペンを強く押すほど毛がしなります。</translation>
    </message>
    <message>
        <source>Move the canvas, and pick paint from it</source>
        <translation>キャンバスを動かし、そこから絵具を取る</translation>
    </message>
    <message>
        <source>Hold Space and drag to move the canvas; the wheel goes nearer. Ctrl and a click put the paint under the pointer on your brush.</source>
        <translation>スペースを押しながらドラッグするとキャンバスが動き、ホイールで近づきます。Ctrl を押しながらクリックすると、ポインターの下の絵具がブラシに付きます。</translation>
    </message>
    <message>
        <source>Take another paint, and take a stroke back</source>
        <translation>絵具を替え、ストロークを取り消す</translation>
    </message>
    <message>
        <source>Choose a paint here. %1 loads the brush anew, %2 takes the last stroke back.</source>
        <translation>ここで絵具を選びます。%1 でブラシに絵具を付け直し、%2 で最後のストロークを取り消します。</translation>
    </message>
</context>
<context>
    <name>pastoso::appearance</name>
    <message>
        <source>Air blower 40</source>
        <translation>エアブロワー 40</translation>
    </message>
    <message>
        <source>Airbrush 7</source>
        <translation>エアブラシ 7</translation>
    </message>
    <message>
        <source>Blender 28</source>
        <translation>ぼかし筆 28</translation>
    </message>
    <message>
        <source>Blotting pad 40</source>
        <translation>吸い取りパッド 40</translation>
    </message>
    <message>
        <source>Bright 12</source>
        <translation>ブライト 12</translation>
    </message>
    <message>
        <source>Comb 25</source>
        <translation>コーム 25</translation>
    </message>
    <message>
        <source>Cotton bud 6</source>
        <translation>綿棒 6</translation>
    </message>
    <message>
        <source>Detail round 3</source>
        <translation>面相筆 3</translation>
    </message>
    <message>
        <source>Diamond knife 9</source>
        <translation>ひし形ナイフ 9</translation>
    </message>
    <message>
        <source>Dropper</source>
        <translation>スポイト</translation>
    </message>
    <message>
        <source>Dry scumbler 22</source>
        <translation>ドライ筆 22</translation>
    </message>
    <message>
        <source>Eraser 15</source>
        <translation>消しゴム 15</translation>
    </message>
    <message>
        <source>Fan 26</source>
        <translation>ファン 26</translation>
    </message>
    <message>
        <source>Filbert 14</source>
        <translation>フィルバート 14</translation>
    </message>
    <message>
        <source>Fine comb 18</source>
        <translation>細目コーム 18</translation>
    </message>
    <message>
        <source>Fingertip 12</source>
        <translation>指先 12</translation>
    </message>
    <message>
        <source>Flat bristle 20</source>
        <translation>豚毛フラット 20</translation>
    </message>
    <message>
        <source>Impasto flat 18</source>
        <translation>厚塗り平筆 18</translation>
    </message>
    <message>
        <source>Large filbert 26</source>
        <translation>大フィルバート 26</translation>
    </message>
    <message>
        <source>Large flat 40</source>
        <translation>大フラット 40</translation>
    </message>
    <message>
        <source>Lifting knife 14</source>
        <translation>すくいナイフ 14</translation>
    </message>
    <message>
        <source>Mop 30</source>
        <translation>モップ 30</translation>
    </message>
    <message>
        <source>Palette knife 17</source>
        <translation>パレットナイフ 17</translation>
    </message>
    <message>
        <source>Pouring bottle</source>
        <translation>ポーリングボトル</translation>
    </message>
    <message>
        <source>Rag 35</source>
        <translation>ウエス 35</translation>
    </message>
    <message>
        <source>Rigger 2</source>
        <translation>リガー 2</translation>
    </message>
    <message>
        <source>Round bristle 12</source>
        <translation>豚毛ラウンド 12</translation>
    </message>
    <message>
        <source>Round sable 9</source>
        <translation>セーブル丸筆 9</translation>
    </message>
    <message>
        <source>Scraper 30</source>
        <translation>スクレーパー 30</translation>
    </message>
    <message>
        <source>Soft glazing flat 16</source>
        <translation>グレーズ平筆 16</translation>
    </message>
    <message>
        <source>Spatter 45</source>
        <translation>スパッタリング 45</translation>
    </message>
    <message>
        <source>Spray can 35</source>
        <translation>スプレー缶 35</translation>
    </message>
    <message>
        <source>Spreading knife 40</source>
        <translation>広刃ナイフ 40</translation>
    </message>
    <message>
        <source>Stippler 15</source>
        <translation>点描筆 15</translation>
    </message>
    <message>
        <source>Straw 8</source>
        <translation>ストロー 8</translation>
    </message>
    <message>
        <source>Thinner brush 16</source>
        <translation>うすめ液筆 16</translation>
    </message>
    <message>
        <source>Titanium white</source>
        <translation>チタニウムホワイト</translation>
    </message>
    <message>
        <source>Zinc white</source>
        <translation>ジンクホワイト</translation>
    </message>
    <message>
        <source>Cadmium yellow</source>
        <translation>カドミウムイエロー</translation>
    </message>
    <message>
        <source>Hansa yellow medium</source>
        <translation>ハンザイエローミディアム</translation>
    </message>
    <message>
        <source>Diarylide (Indian) yellow</source>
        <translation>ジアリライド（インディアン）イエロー</translation>
    </message>
    <message>
        <source>Yellow ochre</source>
        <translation>イエローオーカー</translation>
    </message>
    <message>
        <source>Cadmium orange</source>
        <translation>カドミウムオレンジ</translation>
    </message>
    <message>
        <source>Pyrrole orange</source>
        <translation>ピロールオレンジ</translation>
    </message>
    <message>
        <source>Cadmium red light</source>
        <translation>カドミウムレッドライト</translation>
    </message>
    <message>
        <source>Pyrrole red</source>
        <translation>ピロールレッド</translation>
    </message>
    <message>
        <source>Red oxide (Venetian red)</source>
        <translation>レッドオキサイド（ベネチアンレッド）</translation>
    </message>
    <message>
        <source>Alizarin crimson</source>
        <translation>アリザリンクリムソン</translation>
    </message>
    <message>
        <source>Quinacridone rose</source>
        <translation>キナクリドンローズ</translation>
    </message>
    <message>
        <source>Quinacridone magenta</source>
        <translation>キナクリドンマゼンタ</translation>
    </message>
    <message>
        <source>Dioxazine violet</source>
        <translation>ジオキサジンバイオレット</translation>
    </message>
    <message>
        <source>Ultramarine blue</source>
        <translation>ウルトラマリンブルー</translation>
    </message>
    <message>
        <source>Cobalt blue</source>
        <translation>コバルトブルー</translation>
    </message>
    <message>
        <source>Cerulean blue</source>
        <translation>セルリアンブルー</translation>
    </message>
    <message>
        <source>Phthalo blue GS</source>
        <translation>フタロブルー GS</translation>
    </message>
    <message>
        <source>Prussian blue</source>
        <translation>プルシャンブルー</translation>
    </message>
    <message>
        <source>Phthalo green BS</source>
        <translation>フタログリーン BS</translation>
    </message>
    <message>
        <source>Phthalo green YS</source>
        <translation>フタログリーン YS</translation>
    </message>
    <message>
        <source>Viridian</source>
        <translation>ビリジャン</translation>
    </message>
    <message>
        <source>Chromium oxide green</source>
        <translation>クロムオキサイドグリーン</translation>
    </message>
    <message>
        <source>Burnt sienna</source>
        <translation>バーントシェンナ</translation>
    </message>
    <message>
        <source>Raw umber</source>
        <translation>ローアンバー</translation>
    </message>
    <message>
        <source>Burnt umber</source>
        <translation>バーントアンバー</translation>
    </message>
    <message>
        <source>Ivory (bone) black</source>
        <translation>アイボリー（ボーン）ブラック</translation>
    </message>
    <message>
        <source>Carbon black</source>
        <translation>カーボンブラック</translation>
    </message>
    <message>
        <source>heavy-body oil</source>
        <translation>硬練り油絵具</translation>
    </message>
    <message>
        <source>Stiff, buttery oil straight from the tube: every bristle mark and every peak stays where you put it.</source>
        <translation>チューブから出したままの、バターのように硬い油絵具。筆跡も盛り上がりも、置いたまま残ります。</translation>
    </message>
    <message>
        <source>soft-body acrylic</source>
        <translation>ソフトボディのアクリル</translation>
    </message>
    <message>
        <source>Creamy paint that keeps soft brush marks, and slumps slowly where you lay it on thick.</source>
        <translation>クリーム状の絵具。柔らかな筆跡が残り、厚く置いたところはゆっくり崩れます。</translation>
    </message>
    <message>
        <source>fluid acrylic</source>
        <translation>フルイドアクリル</translation>
    </message>
    <message>
        <source>Pours like cream: brush marks level out, and thick passages sag and run on a tilted canvas.</source>
        <translation>生クリームのように流れる絵具。筆跡はならされ、厚いところは傾けたキャンバスの上で垂れて流れます。</translation>
    </message>
    <message>
        <source>house paint</source>
        <translation>ペンキ</translation>
    </message>
    <message>
        <source>Glossy enamel from the tin: it levels at once, drips freely and leaves long rounded tears.</source>
        <translation>缶入りの艶のあるエナメル。すぐに平らになり、よく滴って、丸く長い垂れを残します。</translation>
    </message>
    <message>
        <source>ink glaze</source>
        <translation>インクのグレーズ</translation>
    </message>
    <message>
        <source>Thin as ink: a transparent film that settles into the weave and runs wherever the canvas leans.</source>
        <translation>インクのように薄い透明な膜。布目に沈み、キャンバスの傾くほうへ流れます。</translation>
    </message>
    <message>
        <source>thinner</source>
        <translation>うすめ液</translation>
    </message>
    <message>
        <source>Clear thinner: loosens wet paint that it meets, lifts dried ink, and leaves nothing behind.</source>
        <translation>透明なうすめ液。触れた濡れた絵具をゆるめ、乾いたインクを浮かせ、あとには何も残しません。</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>絵具</translation>
    </message>
    <message>
        <source>Oils</source>
        <translation>油絵具</translation>
    </message>
    <message>
        <source>Acrylics and others</source>
        <translation>アクリルほか</translation>
    </message>
    <message>
        <source>wax paste</source>
        <translation>ワックスペースト</translation>
    </message>
    <message>
        <source>Oil with cold wax, short and dull: it breaks off sharply at the edge and keeps every cut of the knife.</source>
        <translation>コールドワックスを加えた、切れがよくつやのない油絵具。端がすぱっと切れ、ナイフの跡がそのまま残る。</translation>
    </message>
    <message>
        <source>alkyd gel</source>
        <translation>アルキドゲル</translation>
    </message>
    <message>
        <source>A clear gel with a little paint: transparent, stands as the brush left it, and dries overnight.</source>
        <translation>絵具を少し混ぜた透明ジェル。透けて、筆が置いたままに立ち、一晩で乾く。</translation>
    </message>
    <message>
        <source>linseed oil</source>
        <translation>リンシードオイル</translation>
    </message>
    <message>
        <source>Paint let down with linseed oil, long and buttery: brush marks soften, and thick passages sag slowly.</source>
        <translation>リンシードオイルでのばした、伸びのよいバターのような絵具。筆跡はやわらぎ、厚い部分はゆっくり垂れる。</translation>
    </message>
    <message>
        <source>stand oil</source>
        <translation>スタンドオイル</translation>
    </message>
    <message>
        <source>Paint in thickened oil, smooth as enamel: brush marks flow out, and it runs in slow, round tears.</source>
        <translation>スタンドオイルで練った、エナメルのようになめらかな絵具。筆跡は消え、ゆっくりと丸い涙になって流れる。</translation>
    </message>
    <message>
        <source>thin oil</source>
        <translation>薄い油</translation>
    </message>
    <message>
        <source>Oil thinned with turpentine for the first lay-in: streaky, it settles into the weave and runs when tilted.</source>
        <translation>下描き用にテレピンでうすめた油。筋が残り、布目に沈み、傾けると流れる。</translation>
    </message>
    <message>
        <source>Width of the tip.</source>
        <translation>穂先の幅。</translation>
    </message>
    <message>
        <source>Thickness of the tip; a round one is as thick as it is wide.</source>
        <translation>穂先の厚み。丸い穂先は幅と同じ厚み。</translation>
    </message>
    <message>
        <source>Length of the free hairs.</source>
        <translation>毛の出ている長さ。</translation>
    </message>
    <message>
        <source>How much shorter the outermost hairs are; at most the length.</source>
        <translation>外側の毛がどれだけ短いか。最大で毛の長さまで。</translation>
    </message>
    <message>
        <source>Elements that the tip is made of.</source>
        <translation>穂先を作る要素の数。</translation>
    </message>
    <message>
        <source>Fine streaks within one element.</source>
        <translation>一つの要素の中の細かい筋の数。</translation>
    </message>
    <message>
        <source>Makes one piece differ from the next.</source>
        <translation>一本ごとの違いを決める。</translation>
    </message>
    <message>
        <source>How far a bent hair trails behind the hand.</source>
        <translation>曲がった毛が手からどれだけ遅れるか。</translation>
    </message>
    <message>
        <source>How far the hairs spread at full pressure.</source>
        <translation>最大の筆圧で毛がどれだけ広がるか。</translation>
    </message>
    <message>
        <source>How long the hairs trail after a turn.</source>
        <translation>曲がった後、毛がどれだけ長く遅れるか。</translation>
    </message>
    <message>
        <source>Way of the ferrule at full pressure, in hair lengths.</source>
        <translation>最大の筆圧で口金が下がる量（毛の長さを 1 とする）。</translation>
    </message>
    <message>
        <source>How much a lean lowers one side.</source>
        <translation>傾けたとき片側がどれだけ下がるか。</translation>
    </message>
    <message>
        <source>How steeply hairs follow the weave down: little gives dry brush.</source>
        <translation>毛が布目の谷へどれだけ急に入るか。小さいとかすれる。</translation>
    </message>
    <message>
        <source>0: every hair for itself, 1: one stiff edge.</source>
        <translation>0：毛が一本ずつ動く、1：一枚の硬い縁。</translation>
    </message>
    <message>
        <source>How far wet paint carries it in a light hand, off the ground.</source>
        <translation>軽い手のとき、濡れた絵具が下地からどれだけ浮かせるか。</translation>
    </message>
    <message>
        <source>Wet film that a full brush leaves.</source>
        <translation>十分に含んだブラシが残す濡れた膜。</translation>
    </message>
    <message>
        <source>Stroke that a full load lasts.</source>
        <translation>いっぱいに含んだ絵具で描ける長さ。</translation>
    </message>
    <message>
        <source>Ridges between bristles, in films.</source>
        <translation>毛束の間のうね（膜の厚みを 1 とする）。</translation>
    </message>
    <message>
        <source>Streaks of single hairs, in films.</source>
        <translation>一本一本の毛の筋（膜の厚みを 1 とする）。</translation>
    </message>
    <message>
        <source>Difference from bristle to bristle.</source>
        <translation>毛束ごとの違い。</translation>
    </message>
    <message>
        <source>How far each dip gathers the hairs anew; 0: never.</source>
        <translation>含ませるたびに毛がどれだけ新しくまとまるか。0：まとまらない。</translation>
    </message>
    <message>
        <source>Extra film along the edges, in films.</source>
        <translation>縁に余分に残る膜（膜の厚みを 1 とする）。</translation>
    </message>
    <message>
        <source>Extra film where the stroke starts.</source>
        <translation>描き始めに余分に残る膜。</translation>
    </message>
    <message>
        <source>Share of the load that stays on lifting.</source>
        <translation>持ち上げたときに残していく絵具の割合。</translation>
    </message>
    <message>
        <source>Depth that hanging paint bridges, in films.</source>
        <translation>垂れた絵具が届く深さ（膜の厚みを 1 とする）。</translation>
    </message>
    <message>
        <source>Share of the paint in the way that is taken up.</source>
        <translation>行く手の絵具を拾う割合。</translation>
    </message>
    <message>
        <source>How fast it mixes with the paint below.</source>
        <translation>下の絵具と混ざる速さ。</translation>
    </message>
    <message>
        <source>Exchange between neighbouring hairs.</source>
        <translation>隣り合う毛の間のやり取り。</translation>
    </message>
    <message>
        <source>How far a fast stroke drags paint along and ploughs it aside.</source>
        <translation>速いストロークが絵具を引きずり、脇へ押しのける程度。</translation>
    </message>
    <message>
        <source>Fill above which paint is pushed out sideways.</source>
        <translation>これを超えて含むと絵具が脇へ押し出される。</translation>
    </message>
    <message>
        <source>Step, in radii of an element.</source>
        <translation>一歩の長さ（要素の半径を 1 とする）。</translation>
    </message>
    <message>
        <source>Least step.</source>
        <translation>最小の一歩。</translation>
    </message>
    <message>
        <source>Time over which the hand is steadied.</source>
        <translation>手ぶれを補正する時間。</translation>
    </message>
    <message>
        <source>Length of the string that pulls the tip.</source>
        <translation>穂先を引くひもの長さ。</translation>
    </message>
    <message>
        <source>Mean volume of a drop.</source>
        <translation>しずくの平均の体積。</translation>
    </message>
    <message>
        <source>How much drops differ.</source>
        <translation>しずくのばらつき。</translation>
    </message>
    <message>
        <source>Paint let go while the pen is down.</source>
        <translation>ペンを下ろしている間に出る絵具。</translation>
    </message>
    <message>
        <source>A drop let go when the pen comes down.</source>
        <translation>ペンを下ろしたときに落ちるしずく。</translation>
    </message>
    <message>
        <source>What the bottle holds.</source>
        <translation>瓶に入る量。</translation>
    </message>
    <message>
        <source>Height over radius of a drop that has landed.</source>
        <translation>落ちたしずくの高さと半径の比。</translation>
    </message>
    <message>
        <source>0: evenly over the width, 1: thickest in the middle.</source>
        <translation>0：幅全体に均等、1：中央が最も厚い。</translation>
    </message>
    <message>
        <source>Time that drops fly on with the speed of the tip.</source>
        <translation>しずくが穂先の速さで飛び続ける時間。</translation>
    </message>
    <message>
        <source>Pressure in the middle of the jet.</source>
        <translation>噴流の中央の圧力。</translation>
    </message>
    <message>
        <source>Calligraphy nib 3</source>
        <translation>カリグラフィーペン 3</translation>
    </message>
    <message>
        <source>Charcoal 8</source>
        <translation>木炭 8</translation>
    </message>
    <message>
        <source>Marbling comb 80</source>
        <translation>マーブリング櫛 80</translation>
    </message>
    <message>
        <source>Oil pastel 10</source>
        <translation>オイルパステル 10</translation>
    </message>
    <message>
        <source>Roller 50</source>
        <translation>ローラー 50</translation>
    </message>
    <message>
        <source>Ruling pen 1</source>
        <translation>烏口 1</translation>
    </message>
    <message>
        <source>Sponge 45</source>
        <translation>スポンジ 45</translation>
    </message>
    <message>
        <source>Squeegee 120</source>
        <translation>スキージー 120</translation>
    </message>
    <message>
        <source>Width of a comb&apos;s tooth, in distances of its teeth.</source>
        <translation>櫛の歯の幅。歯の間隔を1とする。</translation>
    </message>
    <message>
        <source>Depth of a sponge&apos;s pores.</source>
        <translation>スポンジの穴の深さ。</translation>
    </message>
    <message>
        <source>Way round a roller, after which its mark comes again; 0: it does not roll.</source>
        <translation>ローラーの一周の長さ。その後に同じ跡が繰り返す。0: 転がらない。</translation>
    </message>
    <message>
        <source>0: levels the hollows that it reaches, 1: coats the grain alone.</source>
        <translation>0: 届くくぼみを埋める。1: 目の山だけに付く。</translation>
    </message>
    <message>
        <source>How many squares of the paint&apos;s grid lie side by side in a millimetre, and pixels in the saved picture: more show finer hairs, and need more memory and time</source>
        <translation>1 ミリメートルに並ぶ絵具の格子のマス目の数で、保存する画像のピクセル数でもあります。多いほど細い毛先まで見えますが、メモリーと時間がかかります</translation>
    </message>
    <message>
        <source>What paint lies on, bare: linen, jute, cotton duck, a panel or a height image</source>
        <translation>絵具をのせる前の素地。麻布、ジュート、綿帆布、パネル、または高さ画像</translation>
    </message>
    <message>
        <source>How steeply the canvas stands, and where down is: wet paint runs there</source>
        <translation>キャンバスの傾きの急さと、下の向き。濡れた絵具はそちらへ流れます</translation>
    </message>
    <message>
        <source>Where the lamp stands that lights the painting: a low one shows the relief, the heights of paint and canvas</source>
        <translation>絵を照らすランプの位置。低いと、絵具とキャンバスの凹凸がよく見えます</translation>
    </message>
    <message>
        <source>How many times as fast as by the clock wet paint becomes dry paint</source>
        <translation>濡れた絵具が、時計の何倍の速さで乾くか</translation>
    </message>
    <message>
        <source>What the brush holds from side to side of its tip, and how full it is of what it can hold</source>
        <translation>穂先の端から端までブラシが含んでいるものと、含める量のどれだけを含んでいるか</translation>
    </message>
    <message>
        <source>What pigment is mixed with: it decides how stiff the paint is, how far it levels and how soon it dries</source>
        <translation>顔料を混ぜるもの。絵具の硬さ、平らになる度合い、乾く早さを決めます</translation>
    </message>
    <message>
        <source>How a trembling hand is steadied, besides the brush&apos;s own smoothing</source>
        <translation>ブラシ自体の滑らかさに加えて、手の震えを抑える方法</translation>
    </message>
    <message>
        <source>Hues that go together by their places on the wheel</source>
        <translation>色相環での位置によって調和する色相</translation>
    </message>
    <message>
        <source>A shape on the disc of hues that choosing on the wheel keeps to</source>
        <translation>色相の円盤の上の形で、ホイールで選ぶ色はこの中に保たれます</translation>
    </message>
    <message>
        <source>The light that the painting is seen in: the same paint has other colours in another one</source>
        <translation>絵を見る光。光が違えば、同じ絵具も違う色に見えます</translation>
    </message>
    <message>
        <source>A clear coat over the whole painting that is looked through, and changes no paint</source>
        <translation>絵全体を覆う透明な層。透かして見るもので、絵具は変わりません</translation>
    </message>
    <message>
        <source>ΔE is how far two colours differ to the eye: 1 is seen side by side, 2 to 3 at a second look</source>
        <translation>ΔE は、目で見た二つの色の違いの大きさ。1 は並べると分かり、2～3 は見直すと分かる</translation>
    </message>
    <message>
        <source>D65, D50 and A are the lights that colours are measured in everywhere: daylight, the light of print booths, and a light bulb</source>
        <translation>D65、D50、A は、色を測るときに広く使われる光。昼光、印刷物を見るための光、電球の光</translation>
    </message>
    <message>
        <source>A soft proof shows on the screen how the painting would be printed; the gamut warning shows what this printer cannot print</source>
        <translation>ソフトプルーフは、絵がどう印刷されるかを画面に示す。色域外の警告は、そのプリンターで印刷できない色を示す</translation>
    </message>
</context>
<context>
    <name>pastoso::appearance::UnitBox</name>
    <message>
        <source>&quot;%1&quot; is not understood here; the number stays as it was.</source>
        <translation>「%1」はここでは解釈できません。数値は元のままです。</translation>
    </message>
</context>
<context>
    <name>pastoso::commands</name>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>ブラシ(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>絵具(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>レイヤー(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>選択(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Guides</source>
        <translation>ガイド(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>ライト(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation>設定(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;New canvas...</source>
        <translation>新規キャンバス(&amp;N)...</translation>
    </message>
    <message>
        <source>Put a fresh canvas on the easel</source>
        <translation>新しいキャンバスをイーゼルに置く</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>開く(&amp;O)...</translation>
    </message>
    <message>
        <source>Go on with a painting that was saved, wet as it was</source>
        <translation>保存した作品の続きを、濡れた絵具もそのままに描く</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save the painting with all its wet paint</source>
        <translation>作品を濡れた絵具ごと保存する</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>名前を付けて保存(&amp;A)...</translation>
    </message>
    <message>
        <source>Save the painting in another file</source>
        <translation>作品を別のファイルに保存する</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>エクスポート(&amp;E)...</translation>
    </message>
    <message>
        <source>Make a picture, layers, maps, a relief to print or a time-lapse of the painting</source>
        <translation>作品から画像、レイヤー、マップ、3Dプリント用レリーフ、タイムラプスを作る</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>もう一度エクスポート(&amp;G)</translation>
    </message>
    <message>
        <source>The same export of the painting as it is now, into the same file</source>
        <translation>今の作品を、前回と同じ設定で同じファイルにエクスポートする</translation>
    </message>
    <message>
        <source>S&amp;top the export</source>
        <translation>エクスポートを中止(&amp;T)</translation>
    </message>
    <message>
        <source>Give up the export that is being written; its file stays as it was</source>
        <translation>書き出し中のエクスポートをやめる。元のファイルは変わらない</translation>
    </message>
    <message>
        <source>Export &amp;recording...</source>
        <translation>記録をエクスポート(&amp;R)...</translation>
    </message>
    <message>
        <source>Save all strokes, to be replayed at any resolution</source>
        <translation>すべてのストロークを保存する。どの解像度でも再生できる</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>ウィンドウを閉じる</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>Take the last stroke back</source>
        <translation>最後のストロークを取り消す</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>Put the last stroke back</source>
        <translation>取り消したストロークをもう一度描く</translation>
    </message>
    <message>
        <source>&amp;Memory for undo...</source>
        <translation>元に戻すためのメモリー(&amp;M)...</translation>
    </message>
    <message>
        <source>How much memory the steps may take that you can return to</source>
        <translation>元に戻せる操作の記憶に使うメモリーの上限</translation>
    </message>
    <message>
        <source>&amp;Canvas size...</source>
        <translation>キャンバスサイズ(&amp;C)...</translation>
    </message>
    <message>
        <source>Make the canvas larger, or cut it, on any side</source>
        <translation>キャンバスを好きな辺で広げる、または切り取る</translation>
    </message>
    <message>
        <source>Crop to the &amp;selection</source>
        <translation>選択範囲で切り抜き(&amp;S)</translation>
    </message>
    <message>
        <source>Cut the canvas to the smallest one that holds what is selected</source>
        <translation>選択範囲がちょうど収まる大きさにキャンバスを切り取る</translation>
    </message>
    <message>
        <source>&amp;Narrower</source>
        <translation>細く(&amp;N)</translation>
    </message>
    <message>
        <source>A narrower brush</source>
        <translation>ブラシを細くする</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>太く(&amp;W)</translation>
    </message>
    <message>
        <source>A wider brush</source>
        <translation>ブラシを太くする</translation>
    </message>
    <message>
        <source>Next &amp;brush</source>
        <translation>次のブラシ(&amp;B)</translation>
    </message>
    <message>
        <source>Take the next brush of the list</source>
        <translation>リストの次のブラシに持ち替える</translation>
    </message>
    <message>
        <source>&amp;Previous brush</source>
        <translation>前のブラシ(&amp;P)</translation>
    </message>
    <message>
        <source>Take the brush before in the list</source>
        <translation>リストの前のブラシに持ち替える</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>付け直す(&amp;R)</translation>
    </message>
    <message>
        <source>Clean the brush and fill it with the paint</source>
        <translation>ブラシを洗い、絵具をたっぷり含ませる</translation>
    </message>
    <message>
        <source>&amp;Top up</source>
        <translation>付け足す(&amp;T)</translation>
    </message>
    <message>
        <source>Dip the brush without cleaning it: what it holds stays on it</source>
        <translation>ブラシを洗わずに絵具を付ける。含んでいた絵具は残る</translation>
    </message>
    <message>
        <source>B&amp;lot</source>
        <translation>吸い取る(&amp;L)</translation>
    </message>
    <message>
        <source>Press the brush into a cloth: a quarter of its paint stays on it</source>
        <translation>ブラシを布に押し当てる。絵具は4分の1だけ残る</translation>
    </message>
    <message>
        <source>&amp;Clean</source>
        <translation>洗う(&amp;C)</translation>
    </message>
    <message>
        <source>Wipe the brush: an empty one moves the paint that lies there</source>
        <translation>ブラシを拭う。空のブラシはその場の絵具を動かす</translation>
    </message>
    <message>
        <source>S&amp;wap the two paints</source>
        <translation>2つの絵具を入れ替え(&amp;W)</translation>
    </message>
    <message>
        <source>Dip the brush in the second paint; the first takes its place</source>
        <translation>ブラシに2番目の絵具を付ける。今の絵具が2番目になる</translation>
    </message>
    <message>
        <source>P&amp;ick up the paint there</source>
        <translation>その場の絵具を取る(&amp;I)</translation>
    </message>
    <message>
        <source>The next click dips the brush in the mixture of pigments that lies there; so does Ctrl and a click</source>
        <translation>次にクリックした場所にある、顔料の混ざった絵具をブラシに付ける。Ctrl+クリックでも同じ</translation>
    </message>
    <message>
        <source>Pick the c&amp;olour seen there</source>
        <translation>見えている色を拾う(&amp;O)</translation>
    </message>
    <message>
        <source>The next click makes paint of the colour that is seen there; so does Alt and a click</source>
        <translation>次にクリックした場所に見えている色の絵具を作る。Alt+クリックでも同じ</translation>
    </message>
    <message>
        <source>Reload before &amp;each stroke</source>
        <translation>ストロークごとに付け直す(&amp;E)</translation>
    </message>
    <message>
        <source>Every stroke starts with a clean, full brush</source>
        <translation>毎回、きれいなブラシに絵具をたっぷり含ませて描き始める</translation>
    </message>
    <message>
        <source>&amp;Turn with the stroke</source>
        <translation>ストロークに合わせて回す(&amp;T)</translation>
    </message>
    <message>
        <source>Flat brushes stand across their path, where the pen does not tell its rotation</source>
        <translation>ペンが回転を伝えないとき、平筆が進む向きと直角に構える</translation>
    </message>
    <message>
        <source>&amp;Save as my own...</source>
        <translation>自分のツールとして保存(&amp;S)...</translation>
    </message>
    <message>
        <source>Keep the tool in hand, with its curves, among your own</source>
        <translation>今のツールをカーブごと自分のツールに加える</translation>
    </message>
    <message>
        <source>Re&amp;name...</source>
        <translation>名前を変更(&amp;N)...</translation>
    </message>
    <message>
        <source>Give your own tool another name</source>
        <translation>自分のツールの名前を変える</translation>
    </message>
    <message>
        <source>&amp;Delete...</source>
        <translation>削除(&amp;D)...</translation>
    </message>
    <message>
        <source>Throw your own tool away</source>
        <translation>自分のツールを捨てる</translation>
    </message>
    <message>
        <source>&amp;Pause the paint</source>
        <translation>絵具を一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>Wet paint stands still until you go on</source>
        <translation>再開するまで濡れた絵具を止めておく</translation>
    </message>
    <message>
        <source>&amp;Dry now</source>
        <translation>すぐ乾かす(&amp;D)</translation>
    </message>
    <message>
        <source>All wet paint dries at once: paint over it without stirring it up</source>
        <translation>濡れた絵具をすべて一度に乾かす。下の絵具を動かさずに塗り重ねられる</translation>
    </message>
    <message>
        <source>Mixing &amp;well</source>
        <translation>混色皿(&amp;W)</translation>
    </message>
    <message>
        <source>A palette of wet paint: mix there with any tool, and carry it to the canvas</source>
        <translation>濡れた絵具のパレット。どのツールでも混ぜられ、キャンバスに運べる</translation>
    </message>
    <message>
        <source>&amp;Squeeze onto the well</source>
        <translation>混色皿に絵具を出す(&amp;S)</translation>
    </message>
    <message>
        <source>Squeeze the paint that you chose onto the mixing well; Control and click says where</source>
        <translation>選んだ絵具を混色皿に絞り出す。Ctrl+クリックで場所を決める</translation>
    </message>
    <message>
        <source>&amp;Clean the well</source>
        <translation>混色皿を拭く(&amp;C)</translation>
    </message>
    <message>
        <source>Wipe the mixing well bare</source>
        <translation>混色皿をすっかり拭き取る</translation>
    </message>
    <message>
        <source>&amp;New layer</source>
        <translation>新規レイヤー(&amp;N)</translation>
    </message>
    <message>
        <source>A bare layer above the one that you paint on</source>
        <translation>描画中のレイヤーの上に空のレイヤーを作る</translation>
    </message>
    <message>
        <source>From a &amp;picture...</source>
        <translation>画像から(&amp;P)...</translation>
    </message>
    <message>
        <source>Put a picture onto the canvas as a layer of dry paint</source>
        <translation>画像を乾いた絵具のレイヤーとしてキャンバスに置く</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>複製(&amp;D)</translation>
    </message>
    <message>
        <source>The same paint once more, on a layer above</source>
        <translation>同じ絵具をもう一つ、上のレイヤーに作る</translation>
    </message>
    <message>
        <source>Na&amp;me...</source>
        <translation>名前(&amp;M)...</translation>
    </message>
    <message>
        <source>Give the layer or the group another name</source>
        <translation>レイヤーやグループの名前を変える</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>削除(&amp;R)</translation>
    </message>
    <message>
        <source>Take the layer away with all its paint</source>
        <translation>レイヤーを絵具ごと取り除く</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>消去(&amp;C)</translation>
    </message>
    <message>
        <source>Wipe all paint off the layer</source>
        <translation>レイヤーの絵具をすべて拭き取る</translation>
    </message>
    <message>
        <source>&amp;Transform</source>
        <translation>変形(&amp;T)</translation>
    </message>
    <message>
        <source>Move, scale, turn and mirror the layer&apos;s paint, or what is selected of it, by a frame</source>
        <translation>レイヤーまたは選択範囲の絵具を、枠を使って移動、拡大縮小、回転、反転する</translation>
    </message>
    <message>
        <source>M&amp;erge down</source>
        <translation>下のレイヤーと結合(&amp;E)</translation>
    </message>
    <message>
        <source>Put the layer&apos;s paint on the layer below, and make them one</source>
        <translation>レイヤーの絵具を下のレイヤーに重ね、一つにする</translation>
    </message>
    <message>
        <source>&amp;Flatten what is visible</source>
        <translation>表示レイヤーを結合(&amp;F)</translation>
    </message>
    <message>
        <source>Make one layer of all that are visible; hidden ones stay</source>
        <translation>見えているすべてのレイヤーを一つにする。非表示のレイヤーは残る</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>グループ化(&amp;G)</translation>
    </message>
    <message>
        <source>Put the chosen layers into a group, which is hidden, locked and faded as one</source>
        <translation>選んだレイヤーをグループにまとめ、表示、ロック、不透明度を一度に変えられるようにする</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>グループ解除(&amp;U)</translation>
    </message>
    <message>
        <source>Dissolve the group; its layers stay where they are</source>
        <translation>グループを解除する。レイヤーは元の位置に残る</translation>
    </message>
    <message>
        <source>&amp;Visible</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>Show or hide the layer or the group</source>
        <translation>レイヤーやグループを表示する、または隠す</translation>
    </message>
    <message>
        <source>&amp;Locked</source>
        <translation>ロック(&amp;L)</translation>
    </message>
    <message>
        <source>Keep the layer or the group from being painted on, cleared and merged</source>
        <translation>レイヤーやグループを描画、消去、結合から守る</translation>
    </message>
    <message>
        <source>Choose the one &amp;above</source>
        <translation>上を選択(&amp;A)</translation>
    </message>
    <message>
        <source>Paint on the layer above</source>
        <translation>上のレイヤーに描く</translation>
    </message>
    <message>
        <source>Choose the one &amp;below</source>
        <translation>下を選択(&amp;B)</translation>
    </message>
    <message>
        <source>Paint on the layer below</source>
        <translation>下のレイヤーに描く</translation>
    </message>
    <message>
        <source>Move u&amp;p</source>
        <translation>上へ移動(&amp;P)</translation>
    </message>
    <message>
        <source>Move the layer or the group one place up, into and out of groups</source>
        <translation>レイヤーやグループを一つ上へ移す。グループの出入りもできる</translation>
    </message>
    <message>
        <source>Move d&amp;own</source>
        <translation>下へ移動(&amp;O)</translation>
    </message>
    <message>
        <source>Move the layer or the group one place down, into and out of groups</source>
        <translation>レイヤーやグループを一つ下へ移す。グループの出入りもできる</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>長方形(&amp;R)</translation>
    </message>
    <message>
        <source>Drag a rectangle that tools keep to; Shift adds, Alt takes away, Ctrl makes a square</source>
        <translation>ドラッグした長方形の中だけにツールが効くようにする。Shiftで追加、Altで除外、Ctrlで正方形</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>なげなわ(&amp;L)</translation>
    </message>
    <message>
        <source>Draw around what tools keep to; Shift adds, Alt takes away</source>
        <translation>囲んだ範囲の中だけにツールが効くようにする。Shiftで追加、Altで除外</translation>
    </message>
    <message>
        <source>End the selection: tools work on all of the canvas</source>
        <translation>選択を解除し、キャンバス全体にツールが効くようにする</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>選択範囲を反転(&amp;I)</translation>
    </message>
    <message>
        <source>Select what is not selected</source>
        <translation>選択されていない部分を選択する</translation>
    </message>
    <message>
        <source>By &amp;height...</source>
        <translation>高さで選択(&amp;H)...</translation>
    </message>
    <message>
        <source>Select where the paint stands so high above the bare canvas</source>
        <translation>絵具の盛り上がりが指定した高さの部分を選択する</translation>
    </message>
    <message>
        <source>By &amp;wetness...</source>
        <translation>濡れ具合で選択(&amp;W)...</translation>
    </message>
    <message>
        <source>Select where the wet paint of the layer is so thick</source>
        <translation>レイヤーの濡れた絵具が指定した厚さの部分を選択する</translation>
    </message>
    <message>
        <source>Show the &amp;outline</source>
        <translation>輪郭を表示(&amp;O)</translation>
    </message>
    <message>
        <source>Hidden, it is out of the way of what you paint; tools keep to it as before</source>
        <translation>隠すと描くときに邪魔にならない。ツールが効く範囲は変わらない</translation>
    </message>
    <message>
        <source>&amp;Mirror left and right</source>
        <translation>左右対称(&amp;M)</translation>
    </message>
    <message>
        <source>Every stroke is painted on both sides of the upright line</source>
        <translation>縦の線の両側に、すべてのストロークを描く</translation>
    </message>
    <message>
        <source>Mirror a&amp;bove and below</source>
        <translation>上下対称(&amp;B)</translation>
    </message>
    <message>
        <source>Every stroke is painted on both sides of the level line</source>
        <translation>横の線の両側に、すべてのストロークを描く</translation>
    </message>
    <message>
        <source>M&amp;ore copies around the middle</source>
        <translation>中心まわりのコピーを増やす(&amp;O)</translation>
    </message>
    <message>
        <source>Every stroke is painted once more around the middle of the canvas</source>
        <translation>キャンバスの中心のまわりに描くストロークを一つ増やす</translation>
    </message>
    <message>
        <source>&amp;Fewer copies around the middle</source>
        <translation>中心まわりのコピーを減らす(&amp;F)</translation>
    </message>
    <message>
        <source>Every stroke is painted once less around the middle of the canvas</source>
        <translation>キャンバスの中心のまわりに描くストロークを一つ減らす</translation>
    </message>
    <message>
        <source>&amp;Ruler along the last stroke</source>
        <translation>最後のストロークに沿う定規(&amp;R)</translation>
    </message>
    <message>
        <source>Strokes run along the ruler, or parallel to it; Shift and drag draw a straight line</source>
        <translation>ストロークが定規に沿う、または平行になる。Shift+ドラッグで直線を描く</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>楕円(&amp;E)</translation>
    </message>
    <message>
        <source>Strokes run along the ellipse, or along another of the same shape</source>
        <translation>ストロークが楕円、または同じ形の別の楕円に沿う</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>ハンドル(&amp;H)</translation>
    </message>
    <message>
        <source>Points by which guides are dragged; Shift keeps to steps and proportions</source>
        <translation>ガイドをドラッグするための点。Shiftで段階や比率を保つ</translation>
    </message>
    <message>
        <source>&amp;No guides</source>
        <translation>ガイドなし(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Trace a picture...</source>
        <translation>下絵を置く(&amp;T)...</translation>
    </message>
    <message>
        <source>Lay a picture below the paint, and beside the canvas; it is in no picture that you save</source>
        <translation>画像を絵具の下とキャンバスの横に置く。保存する画像には含まれない</translation>
    </message>
    <message>
        <source>&amp;Show it below the paint</source>
        <translation>絵具の下に表示(&amp;S)</translation>
    </message>
    <message>
        <source>Show or hide the picture that you trace</source>
        <translation>下絵を表示する、または隠す</translation>
    </message>
    <message>
        <source>F&amp;it it to the canvas</source>
        <translation>キャンバスに合わせる(&amp;I)</translation>
    </message>
    <message>
        <source>In the middle of the canvas, as large as it fits</source>
        <translation>キャンバスの中央に、収まる最大の大きさで置く</translation>
    </message>
    <message>
        <source>Ta&amp;ke it away</source>
        <translation>下絵を外す(&amp;K)</translation>
    </message>
    <message>
        <source>Take the picture that you trace away</source>
        <translation>下絵を取り除く</translation>
    </message>
    <message>
        <source>&amp;Fit the canvas</source>
        <translation>キャンバス全体を表示(&amp;F)</translation>
    </message>
    <message>
        <source>Show the whole canvas</source>
        <translation>キャンバス全体が見えるようにする</translation>
    </message>
    <message>
        <source>&amp;Actual pixels</source>
        <translation>ピクセル等倍(&amp;A)</translation>
    </message>
    <message>
        <source>One screen pixel for every pixel of the saved picture</source>
        <translation>保存される画像の1ピクセルを画面の1ピクセルで表示する</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>ズームイン(&amp;I)</translation>
    </message>
    <message>
        <source>Closer</source>
        <translation>近づいて見る</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>ズームアウト(&amp;O)</translation>
    </message>
    <message>
        <source>Farther</source>
        <translation>離れて見る</translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation>左に回転(&amp;L)</translation>
    </message>
    <message>
        <source>Turn the canvas a little to the left on the screen; so does Shift+Space and a drag</source>
        <translation>画面上のキャンバスを少し左に回す。Shift+Space+ドラッグでも同じ</translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation>正位置に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>The canvas stands again as it is saved</source>
        <translation>キャンバスを保存される向きに戻す</translation>
    </message>
    <message>
        <source>Turn &amp;right</source>
        <translation>右に回転(&amp;R)</translation>
    </message>
    <message>
        <source>Turn the canvas a little to the right on the screen; so does Shift+Space and a drag</source>
        <translation>画面上のキャンバスを少し右に回す。Shift+Space+ドラッグでも同じ</translation>
    </message>
    <message>
        <source>&amp;Mirror the view</source>
        <translation>左右反転表示(&amp;M)</translation>
    </message>
    <message>
        <source>See the painting as in a mirror, and paint on it so; it is saved as it is</source>
        <translation>鏡に映したように作品を見ながら描く。保存される向きは変わらない</translation>
    </message>
    <message>
        <source>Canvas &amp;only</source>
        <translation>キャンバスのみ(&amp;O)</translation>
    </message>
    <message>
        <source>Nothing but the canvas; Tab or Escape brings the panels back</source>
        <translation>キャンバスだけを表示する。TabキーまたはEscキーでパネルが戻る</translation>
    </message>
    <message>
        <source>In its l&amp;ight</source>
        <translation>光を当てて表示(&amp;I)</translation>
    </message>
    <message>
        <source>The paint as it hangs in its light</source>
        <translation>光の中に置いた絵具の見え方</translation>
    </message>
    <message>
        <source>Show &amp;wet</source>
        <translation>濡れた部分を表示(&amp;W)</translation>
    </message>
    <message>
        <source>Tints what is still wet, the more the thicker it is</source>
        <translation>まだ濡れている部分に色を付ける。厚いほど濃い</translation>
    </message>
    <message>
        <source>Show &amp;height</source>
        <translation>高さを表示(&amp;H)</translation>
    </message>
    <message>
        <source>How high the paint stands above the bare canvas, in steps of colour</source>
        <translation>何もないキャンバスから絵具がどれだけ盛り上がっているかを色分けで表示</translation>
    </message>
    <message>
        <source>Show &amp;normals</source>
        <translation>法線を表示(&amp;N)</translation>
    </message>
    <message>
        <source>Where the surface faces: red to the right, green up, blue towards you</source>
        <translation>面の向き。赤は右、緑は上、青は手前</translation>
    </message>
    <message>
        <source>&amp;Flat colour</source>
        <translation>色だけを表示(&amp;F)</translation>
    </message>
    <message>
        <source>The paint&apos;s colours alone, without light and relief</source>
        <translation>光も凹凸もない、絵具の色だけの表示</translation>
    </message>
    <message>
        <source>&amp;Tool panel</source>
        <translation>ツールパネル(&amp;T)</translation>
    </message>
    <message>
        <source>What the brush holds, and how it answers to the hand</source>
        <translation>ブラシが含む絵具と、手の動きへの反応</translation>
    </message>
    <message>
        <source>&amp;Colour panel</source>
        <translation>色パネル(&amp;C)</translation>
    </message>
    <message>
        <source>A paint of any colour, and its recipe from the tubes</source>
        <translation>好きな色の絵具と、チューブから作る配合</translation>
    </message>
    <message>
        <source>P&amp;hysics panel</source>
        <translation>物理パネル(&amp;H)</translation>
    </message>
    <message>
        <source>What the paint is like: how it flows, holds and dries</source>
        <translation>絵具の性質。流れ方、形の保ち方、乾き方</translation>
    </message>
    <message>
        <source>&amp;Guides panel</source>
        <translation>ガイドパネル(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Layers panel</source>
        <translation>レイヤーパネル(&amp;L)</translation>
    </message>
    <message>
        <source>The layers of the painting: seen, locked, faded, in what order</source>
        <translation>作品のレイヤー。表示、ロック、不透明度、重なり順</translation>
    </message>
    <message>
        <source>Tr&amp;acing panel</source>
        <translation>下絵パネル(&amp;A)</translation>
    </message>
    <message>
        <source>The picture that you trace, to look at and to pick colours from</source>
        <translation>下絵を見て、そこから色を拾う</translation>
    </message>
    <message>
        <source>&amp;History panel</source>
        <translation>履歴パネル(&amp;H)</translation>
    </message>
    <message>
        <source>What was done, to go back to any of it</source>
        <translation>これまでの操作。どの時点にも戻れる</translation>
    </message>
    <message>
        <source>&amp;Reset the panels</source>
        <translation>パネルの配置を戻す(&amp;R)</translation>
    </message>
    <message>
        <source>Panels and mixing well as they stood at the first start</source>
        <translation>パネルと混色皿を最初に起動したときの配置に戻す</translation>
    </message>
    <message>
        <source>Colours for s&amp;RGB</source>
        <translation>sRGB用の色(&amp;R)</translation>
    </message>
    <message>
        <source>Shows the painting for common screens</source>
        <translation>一般的な画面向けに作品を表示する</translation>
    </message>
    <message>
        <source>Colours for Display &amp;P3</source>
        <translation>Display P3用の色(&amp;P)</translation>
    </message>
    <message>
        <source>Shows the painting for a screen of wide gamut</source>
        <translation>広色域の画面向けに作品を表示する</translation>
    </message>
    <message>
        <source>&amp;Daylight (D65)</source>
        <translation>昼光 (D65)(&amp;D)</translation>
    </message>
    <message>
        <source>The light that screens are made for</source>
        <translation>画面が基準としている光</translation>
    </message>
    <message>
        <source>&amp;Print booth (D50)</source>
        <translation>印刷評価用の光 (D50)(&amp;P)</translation>
    </message>
    <message>
        <source>The light that prints are judged in</source>
        <translation>印刷物を評価するための光</translation>
    </message>
    <message>
        <source>Light &amp;bulb (A)</source>
        <translation>電球 (A)(&amp;B)</translation>
    </message>
    <message>
        <source>Incandescent lamplight</source>
        <translation>白熱電球の光</translation>
    </message>
    <message>
        <source>&amp;LED lamp</source>
        <translation>LEDランプ(&amp;L)</translation>
    </message>
    <message>
        <source>A white LED with its blue peak</source>
        <translation>青にピークのある白色LED</translation>
    </message>
    <message>
        <source>From a &amp;file...</source>
        <translation>ファイルから(&amp;F)...</translation>
    </message>
    <message>
        <source>A lamp that you have measured, as a CSV file</source>
        <translation>実測したランプのCSVファイル</translation>
    </message>
    <message>
        <source>&amp;Move the light</source>
        <translation>ライトを動かす(&amp;M)</translation>
    </message>
    <message>
        <source>Drag the lamp over the canvas: towards the rim it rakes over the relief</source>
        <translation>キャンバスの上でランプをドラッグする。縁に近いほど光が横から差し、凹凸が際立つ</translation>
    </message>
    <message>
        <source>&amp;Find a command...</source>
        <translation>コマンドを検索(&amp;F)...</translation>
    </message>
    <message>
        <source>Type a few letters of what you want to do</source>
        <translation>したいことを数文字入力する</translation>
    </message>
    <message>
        <source>&amp;Keys...</source>
        <translation>キーの割り当て(&amp;K)...</translation>
    </message>
    <message>
        <source>Choose a set of keys, and give any command keys of your own</source>
        <translation>キーセットを選び、どのコマンドにも好きなキーを割り当てる</translation>
    </message>
    <message>
        <source>&amp;Settings...</source>
        <translation>設定(&amp;S)...</translation>
    </message>
    <message>
        <source>The look of the window, what is kept, and how much of the machine is used</source>
        <translation>ウィンドウの外観、保存のしかた、コンピューターの性能の使い方</translation>
    </message>
    <message>
        <source>Start &amp;page</source>
        <translation>スタートページ(&amp;P)</translation>
    </message>
    <message>
        <source>New canvases, recent paintings and examples at a glance</source>
        <translation>新しいキャンバス、最近の作品、作例を一覧する</translation>
    </message>
    <message>
        <source>&amp;Watch it grow...</source>
        <translation>制作過程を見る(&amp;W)...</translation>
    </message>
    <message>
        <source>See how the painting came about, in a window of its own; the painting stays as it is</source>
        <translation>作品が出来上がっていく様子を別のウィンドウで見る。作品は変わらない</translation>
    </message>
    <message>
        <source>&amp;Make a time-lapse...</source>
        <translation>タイムラプスを作成(&amp;M)...</translation>
    </message>
    <message>
        <source>A film, or numbered pictures, of how the painting came about</source>
        <translation>作品が出来上がっていく様子を、動画または連番画像にする</translation>
    </message>
    <message>
        <source>Pop-&amp;up palette</source>
        <translation>ポップアップパレット(&amp;U)</translation>
    </message>
    <message>
        <source>Tools and paints around the pointer; so does a right click on the canvas</source>
        <translation>ポインターのまわりにツールと絵具を表示する。キャンバスの右クリックでも同じ</translation>
    </message>
    <message>
        <source>&amp;Navigator</source>
        <translation>ナビゲーター(&amp;N)</translation>
    </message>
    <message>
        <source>The whole canvas, to see where the window is and to go elsewhere</source>
        <translation>キャンバス全体を表示し、今の位置の確認や移動ができる</translation>
    </message>
    <message>
        <source>Li&amp;ghts panel</source>
        <translation>ライトパネル(&amp;G)</translation>
    </message>
    <message>
        <source>The lamp, its light, and a coat of varnish to look through</source>
        <translation>ランプとその光、上から重ねて見るワニス</translation>
    </message>
    <message>
        <source>Recor&amp;der panel</source>
        <translation>記録パネル(&amp;D)</translation>
    </message>
    <message>
        <source>What is recorded of the painting: watch it grow again, or make a time-lapse</source>
        <translation>作品の記録。制作過程の再生やタイムラプスの作成ができる</translation>
    </message>
    <message>
        <source>&amp;Pen and tablet...</source>
        <translation>ペンとタブレット(&amp;P)...</translation>
    </message>
    <message>
        <source>How pens and mouse press, what their buttons do, and a sheet to try them on</source>
        <translation>ペンやマウスの筆圧、ボタンの動作、試し書き</translation>
    </message>
    <message>
        <source>&amp;Milk tea</source>
        <translation>ミルクティー(&amp;M)</translation>
    </message>
    <message>
        <source>A glass of tea in place of the canvas, to pour milk into; the painting waits as it is</source>
        <translation>キャンバスの代わりに紅茶のグラスを出し、ミルクを注ぎます。絵はそのまま待っています</translation>
    </message>
    <message>
        <source>&amp;New glass</source>
        <translation>新しいグラス(&amp;N)</translation>
    </message>
    <message>
        <source>Begin again with clear tea</source>
        <translation>澄んだ紅茶からやり直します</translation>
    </message>
    <message>
        <source>&amp;Open a scene...</source>
        <translation>シーンを開く(&amp;O)...</translation>
    </message>
    <message>
        <source>Begin again with the numbers of a file</source>
        <translation>ファイルの数値でやり直します</translation>
    </message>
    <message>
        <source>&amp;Save the scene...</source>
        <translation>シーンを保存(&amp;S)...</translation>
    </message>
    <message>
        <source>Keep all numbers of the glass in a file</source>
        <translation>グラスのすべての数値をファイルに保存します</translation>
    </message>
    <message>
        <source>&amp;Export the surface...</source>
        <translation>表面を書き出す(&amp;E)...</translation>
    </message>
    <message>
        <source>&amp;Render a picture...</source>
        <translation>画像をレンダリング(&amp;R)...</translation>
    </message>
    <message>
        <source>A picture by the light&apos;s true ways, to be saved or painted on</source>
        <translation>光の本当の道筋をたどった画像。保存したり、その上に描いたりできます</translation>
    </message>
    <message>
        <source>As &amp;fast as it can</source>
        <translation>できるだけ速く(&amp;F)</translation>
    </message>
    <message>
        <source>Time in the glass passes as fast as it is computed</source>
        <translation>グラスの時間は計算できるかぎり速く進みます</translation>
    </message>
    <message>
        <source>S&amp;tir</source>
        <translation>かき混ぜる(&amp;T)</translation>
    </message>
    <message>
        <source>A force around an upright axis stirs the tea</source>
        <translation>垂直な軸のまわりの力が紅茶をかき混ぜます</translation>
    </message>
    <message>
        <source>Axis to the &amp;middle</source>
        <translation>軸を中央へ(&amp;M)</translation>
    </message>
    <message>
        <source>The axis of the force stands in the middle of the glass again</source>
        <translation>力の軸をグラスの中央に戻します</translation>
    </message>
    <message>
        <source>The other &amp;way round</source>
        <translation>逆回り(&amp;W)</translation>
    </message>
    <message>
        <source>Stir the other way round</source>
        <translation>逆向きにかき混ぜます</translation>
    </message>
    <message>
        <source>Axis to the &amp;left</source>
        <translation>軸を左へ(&amp;L)</translation>
    </message>
    <message>
        <source>Move the axis of the force to the left</source>
        <translation>力の軸を左へ動かします</translation>
    </message>
    <message>
        <source>Axis to the r&amp;ight</source>
        <translation>軸を右へ(&amp;I)</translation>
    </message>
    <message>
        <source>Move the axis of the force to the right</source>
        <translation>力の軸を右へ動かします</translation>
    </message>
    <message>
        <source>Axis &amp;away</source>
        <translation>軸を奥へ(&amp;A)</translation>
    </message>
    <message>
        <source>Move the axis of the force away from you</source>
        <translation>力の軸を奥へ動かします</translation>
    </message>
    <message>
        <source>Axis n&amp;ear</source>
        <translation>軸を手前へ(&amp;E)</translation>
    </message>
    <message>
        <source>Move the axis of the force towards you</source>
        <translation>力の軸を手前へ動かします</translation>
    </message>
    <message>
        <source>Look from the fr&amp;ont</source>
        <translation>正面から見る(&amp;O)</translation>
    </message>
    <message>
        <source>See the whole glass from the front again</source>
        <translation>グラス全体をもう一度正面から見ます</translation>
    </message>
    <message>
        <source>Liqui&amp;ds</source>
        <translation>液体(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Glass tank</source>
        <translation>ガラスの水槽(&amp;G)</translation>
    </message>
    <message>
        <source>A tank of liquid in place of the canvas, with balls that fall, a drain and wind; the painting waits as it is</source>
        <translation>キャンバスの代わりに液体の水槽を出します。落ちる球、排水口、風があります。絵はそのまま待っています</translation>
    </message>
    <message>
        <source>The liquid&apos;s surface as triangles, for PBRT and other programs</source>
        <translation>液体の表面を三角形で。PBRT などのプログラム向け</translation>
    </message>
    <message>
        <source>&amp;Pause the liquid</source>
        <translation>液体を一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>The liquid stands still until you go on</source>
        <translation>再開するまで液体は静止します</translation>
    </message>
    <message>
        <source>A tank where liquid &amp;falls</source>
        <translation>液体が落ちる水槽(&amp;F)</translation>
    </message>
    <message>
        <source>A ball of liquid falls into a glass tank</source>
        <translation>液体の球がガラスの水槽に落ちます</translation>
    </message>
    <message>
        <source>A tank where t&amp;wo liquids meet</source>
        <translation>二つの液体が出会う水槽(&amp;W)</translation>
    </message>
    <message>
        <source>Liquid breaks over a solid and meets another liquid</source>
        <translation>液体が固体に砕け、別の液体と出会います</translation>
    </message>
    <message>
        <source>&amp;Open a tank...</source>
        <translation>水槽を開く(&amp;O)...</translation>
    </message>
    <message>
        <source>Begin with the tank of a file</source>
        <translation>ファイルの水槽で始めます</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>最初から(&amp;S)</translation>
    </message>
    <message>
        <source>Export &amp;all moments...</source>
        <translation>すべての瞬間を書き出す(&amp;A)...</translation>
    </message>
    <message>
        <source>The liquid&apos;s surface at every moment that is kept, each in a file of its own</source>
        <translation>残されたすべての瞬間の液体の表面を、それぞれ別のファイルに</translation>
    </message>
    <message>
        <source>Add a &amp;ball of liquid</source>
        <translation>液体の球を加える(&amp;B)</translation>
    </message>
    <message>
        <source>A ball of liquid falls from above; press on the liquid to say where</source>
        <translation>液体の球が上から落ちます。場所は液体の上を押して決めます</translation>
    </message>
    <message>
        <source>Open the &amp;drain</source>
        <translation>排水口を開く(&amp;D)</translation>
    </message>
    <message>
        <source>Liquid runs out through the floor until you shut it again</source>
        <translation>閉じるまで液体は底から流れ出ます</translation>
    </message>
    <message>
        <source>W&amp;ind</source>
        <translation>風(&amp;I)</translation>
    </message>
    <message>
        <source>Wind over the tank drags the liquid&apos;s surface along</source>
        <translation>水槽の上の風が液体の表面を引きずります</translation>
    </message>
    <message>
        <source>Turn the wind to the &amp;left</source>
        <translation>風を左へ回す(&amp;L)</translation>
    </message>
    <message>
        <source>Turn the wind by 15 degrees to the left</source>
        <translation>風向きを左へ 15 度回します</translation>
    </message>
    <message>
        <source>Turn the wind to the &amp;right</source>
        <translation>風を右へ回す(&amp;R)</translation>
    </message>
    <message>
        <source>Turn the wind by 15 degrees to the right</source>
        <translation>風向きを右へ 15 度回します</translation>
    </message>
    <message>
        <source>Stron&amp;ger wind</source>
        <translation>風を強く(&amp;G)</translation>
    </message>
    <message>
        <source>The wind blows faster by half a metre a second</source>
        <translation>風が毎秒 0.5 メートル速くなります</translation>
    </message>
    <message>
        <source>W&amp;eaker wind</source>
        <translation>風を弱く(&amp;E)</translation>
    </message>
    <message>
        <source>The wind blows slower by half a metre a second</source>
        <translation>風が毎秒 0.5 メートル遅くなります</translation>
    </message>
    <message>
        <source>Show &amp;velocities</source>
        <translation>速度を表示(&amp;V)</translation>
    </message>
    <message>
        <source>Arrows show where the liquid flows, and how fast</source>
        <translation>液体がどこへどれだけ速く流れるかを矢印で示します</translation>
    </message>
    <message>
        <source>Render a pic&amp;ture...</source>
        <translation>画像をレンダリング(&amp;T)...</translation>
    </message>
    <message>
        <source>Pi&amp;ctures of every step...</source>
        <translation>各ステップの画像(&amp;C)...</translation>
    </message>
    <message>
        <source>While the liquid moves, a picture of every moment, as you see the tank, goes into a folder</source>
        <translation>液体が動く間、見えているままの水槽の画像を、すべての瞬間についてフォルダーに保存します</translation>
    </message>
    <message>
        <source>S&amp;urfaces of every step...</source>
        <translation>各ステップの表面(&amp;U)...</translation>
    </message>
    <message>
        <source>While the liquid moves, its surface at every moment goes into a folder</source>
        <translation>液体が動く間、その表面をすべての瞬間についてフォルダーに保存します</translation>
    </message>
    <message>
        <source>M&amp;essages</source>
        <translation>メッセージ(&amp;E)</translation>
    </message>
    <message>
        <source>What you were told last, to be read again and copied</source>
        <translation>最近のメッセージをもう一度読み、コピーします</translation>
    </message>
    <message>
        <source>Time runs &amp;faster</source>
        <translation>時間を速く(&amp;F)</translation>
    </message>
    <message>
        <source>Watch slow paint run, level and dry: up to 20 times as fast</source>
        <translation>ゆっくりした絵具が流れ、ならされ、乾くのを見る。20倍まで</translation>
    </message>
    <message>
        <source>Time runs s&amp;lower</source>
        <translation>時間を遅く(&amp;L)</translation>
    </message>
    <message>
        <source>A step back towards real time</source>
        <translation>一段、実際の速さに戻す</translation>
    </message>
    <message>
        <source>&amp;Real time</source>
        <translation>実際の速さ(&amp;R)</translation>
    </message>
    <message>
        <source>A second of the paint takes a second again</source>
        <translation>絵具の1秒がまた1秒になる</translation>
    </message>
    <message>
        <source>&amp;Hold it tilted</source>
        <translation>傾けて持つ(&amp;H)</translation>
    </message>
    <message>
        <source>A mouse holds the tool aslant: a knife then scrapes with its edge</source>
        <translation>マウスでも道具を斜めに持つ。ナイフは刃で削る</translation>
    </message>
    <message>
        <source>More &amp;medium</source>
        <translation>メディウムを増やす(&amp;M)</translation>
    </message>
    <message>
        <source>Thin the paint in hand by a quarter, from paste towards a stain</source>
        <translation>手元の絵具を4分の1うすめ、ペーストからステインへ近づける</translation>
    </message>
    <message>
        <source>More p&amp;aint</source>
        <translation>絵具を増やす(&amp;A)</translation>
    </message>
    <message>
        <source>Take a step back towards paint from the tube</source>
        <translation>チューブから出した絵具へ一段戻す</translation>
    </message>
    <message>
        <source>Thin was&amp;h</source>
        <translation>ごく薄塗り(&amp;H)</translation>
    </message>
    <message>
        <source>Thin the paint in hand to a wash for a first lay-in, and back</source>
        <translation>手元の絵具を下塗り用にごく薄くし、もう一度で元に戻す</translation>
    </message>
    <message>
        <source>Po&amp;ur</source>
        <translation>注ぐ(&amp;U)</translation>
    </message>
    <message>
        <source>Pour the recipe&apos;s milk into the middle, or stop pouring it; press on the tea to pour where you point</source>
        <translation>レシピのミルクを中央に注ぐか、注ぐのをやめます。紅茶を押すと、指した場所に注げます</translation>
    </message>
    <message>
        <source>The tank as it stood at the beginning; wind and drain stay as they are</source>
        <translation>水槽を最初の状態に戻します。風と排水口はそのままです</translation>
    </message>
    <message>
        <source>Pa&amp;int it again, finer...</source>
        <translation>再描画(&amp;I)...</translation>
    </message>
    <message>
        <source>Soft &amp;proof</source>
        <translation>ソフトプルーフ(&amp;P)</translation>
    </message>
    <message>
        <source>Shows the painting as the printer chosen in the settings would print it</source>
        <translation>設定で選んだプリンターで印刷したときの見え方を表示します</translation>
    </message>
    <message>
        <source>Gamut &amp;warning</source>
        <translation>色域外の警告(&amp;W)</translation>
    </message>
    <message>
        <source>Colours that this printer has not are grey</source>
        <translation>このプリンターで出せない色を灰色にします</translation>
    </message>
    <message>
        <source>Cance&amp;l opening</source>
        <translation>開くのをやめる(&amp;L)</translation>
    </message>
    <message>
        <source>Give up what is being opened or made; the painting on the easel stays</source>
        <translation>開いている、または作っているものをやめる。イーゼルの絵はそのまま</translation>
    </message>
    <message>
        <source>&amp;Value check</source>
        <translation>明度の確認(&amp;V)</translation>
    </message>
    <message>
        <source>The painting in greys as light as its colours: darks and lights by themselves</source>
        <translation>絵を、色と同じ明るさのグレーで見る。明暗だけが分かる</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>マニュアル(&amp;M)</translation>
    </message>
    <message>
        <source>Read about what is under the pointer</source>
        <translation>ポインターの下にあるものについて読む</translation>
    </message>
    <message>
        <source>What is &amp;new</source>
        <translation>新しくなったこと(&amp;N)</translation>
    </message>
    <message>
        <source>What has changed, version by version</source>
        <translation>バージョンごとの変更点</translation>
    </message>
    <message>
        <source>&amp;About Pastoso</source>
        <translation>Pastoso について(&amp;A)</translation>
    </message>
    <message>
        <source>Its version and licence, what it is made of, this machine, its folders</source>
        <translation>バージョンとライセンス、使っているライブラリ、このコンピューター、フォルダー</translation>
    </message>
    <message>
        <source>Save a &amp;copy...</source>
        <translation>コピーを保存(&amp;C)...</translation>
    </message>
    <message>
        <source>The layers as pictures for other programs, in OpenRaster or PSD</source>
        <translation>レイヤーを画像として、ほかのプログラムのために OpenRaster か PSD で保存する</translation>
    </message>
    <message>
        <source>&amp;Image</source>
        <translation>画像(&amp;I)</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>切り取り(&amp;T)</translation>
    </message>
    <message>
        <source>Copy the layer&apos;s paint, or what is selected of it, and wipe it off</source>
        <translation>レイヤーの絵具、またはその選択部分をコピーして拭き取ります</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
    <message>
        <source>Keep the layer&apos;s paint, or what is selected of it, to be pasted: wet as it is, and as a picture for other programs</source>
        <translation>レイヤーの絵具、またはその選択部分を貼り付け用に保持します。濡れたまま、ほかのプログラムには画像として</translation>
    </message>
    <message>
        <source>Cop&amp;y merged</source>
        <translation>結合したものをコピー(&amp;Y)</translation>
    </message>
    <message>
        <source>The same of all layers that are visible, as if they were one</source>
        <translation>表示中のすべてのレイヤーを一枚のようにコピーします</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>貼り付け(&amp;P)</translation>
    </message>
    <message>
        <source>What was copied as a new layer: paint where it was, or a picture of another program as dry paint</source>
        <translation>コピーしたものを新しいレイヤーに: 絵具は元の位置に、ほかのプログラムの画像は乾いた絵具として</translation>
    </message>
    <message>
        <source>Paste &amp;at cursor</source>
        <translation>カーソル位置に貼り付け(&amp;A)</translation>
    </message>
    <message>
        <source>The same, with the middle of the copied paint where the pointer is</source>
        <translation>同じく、コピーした絵具の中央をポインターの位置に</translation>
    </message>
    <message>
        <source>Mirror image &amp;horizontally</source>
        <translation>画像を左右反転(&amp;H)</translation>
    </message>
    <message>
        <source>Left and right of the whole painting change places, canvas and all</source>
        <translation>絵全体の左右をキャンバスごと入れ替えます</translation>
    </message>
    <message>
        <source>Mirror image &amp;vertically</source>
        <translation>画像を上下反転(&amp;V)</translation>
    </message>
    <message>
        <source>Top and bottom of the whole painting change places, canvas and all</source>
        <translation>絵全体の上下をキャンバスごと入れ替えます</translation>
    </message>
    <message>
        <source>Rotate image 90° to the &amp;right</source>
        <translation>画像を右に90°回転(&amp;R)</translation>
    </message>
    <message>
        <source>The whole painting stands on its right side</source>
        <translation>絵全体を右の辺を下にして立てます</translation>
    </message>
    <message>
        <source>Rotate image 90° to the &amp;left</source>
        <translation>画像を左に90°回転(&amp;L)</translation>
    </message>
    <message>
        <source>The whole painting stands on its left side</source>
        <translation>絵全体を左の辺を下にして立てます</translation>
    </message>
    <message>
        <source>Rotate image &amp;180°</source>
        <translation>画像を180°回転(&amp;1)</translation>
    </message>
    <message>
        <source>The whole painting stands on its head</source>
        <translation>絵全体を逆さに立てます</translation>
    </message>
    <message>
        <source>F&amp;ill with the paint in hand</source>
        <translation>手にした絵具で塗りつぶす(&amp;I)</translation>
    </message>
    <message>
        <source>Pour an even film of wet paint over what is selected, or over the whole canvas</source>
        <translation>選択範囲、またはキャンバス全体に、濡れた絵具を均一な厚さで流す</translation>
    </message>
    <message>
        <source>Fill with the s&amp;econd paint</source>
        <translation>2番目の絵具で塗りつぶす(&amp;E)</translation>
    </message>
    <message>
        <source>Pour an even film of the second paint over what is selected</source>
        <translation>選択範囲に2番目の絵具を均一な厚さで流す</translation>
    </message>
    <message>
        <source>&amp;Gradient of the two paints</source>
        <translation>2つの絵具のグラデーション(&amp;G)</translation>
    </message>
    <message>
        <source>Drag a line: the film goes from the paint in hand to the second one along it</source>
        <translation>線をドラッグすると、それに沿って手にした絵具から2番目の絵具へ移り変わる</translation>
    </message>
    <message>
        <source>&amp;Thickness of fills...</source>
        <translation>塗りつぶしの厚さ(&amp;T)...</translation>
    </message>
    <message>
        <source>How thick a film of paint fills and gradients pour</source>
        <translation>塗りつぶしとグラデーションで流す絵具の厚さ</translation>
    </message>
    <message>
        <source>Elli&amp;pse</source>
        <translation>楕円(&amp;P)</translation>
    </message>
    <message>
        <source>Drag an ellipse that tools keep to; Shift adds, Alt takes away, Ctrl makes a circle</source>
        <translation>ドラッグした楕円の中だけにツールが効くようにする。Shiftで追加、Altで除外、Ctrlで円</translation>
    </message>
    <message>
        <source>Pol&amp;ygon</source>
        <translation>多角形(&amp;Y)</translation>
    </message>
    <message>
        <source>Click the corners of what tools keep to; Enter or a double click closes it</source>
        <translation>ツールを効かせる範囲の角をクリックする。Enterまたはダブルクリックで閉じる</translation>
    </message>
    <message>
        <source>&amp;Contiguous colour</source>
        <translation>隣接する色(&amp;C)</translation>
    </message>
    <message>
        <source>Click a colour: what hangs together there is selected; drag for more or less of it</source>
        <translation>色をクリックすると、つながっている部分を選択する。ドラッグで範囲を増減</translation>
    </message>
    <message>
        <source>&amp;Similar colour</source>
        <translation>似た色(&amp;S)</translation>
    </message>
    <message>
        <source>Click a colour: it is selected wherever it is; drag for more or less of it</source>
        <translation>色をクリックすると、その色をすべて選択する。ドラッグで範囲を増減</translation>
    </message>
    <message>
        <source>&amp;Grow...</source>
        <translation>拡張(&amp;G)...</translation>
    </message>
    <message>
        <source>Make the selection wider on all sides</source>
        <translation>選択範囲を全方向に広げる</translation>
    </message>
    <message>
        <source>Shri&amp;nk...</source>
        <translation>縮小(&amp;N)...</translation>
    </message>
    <message>
        <source>Make the selection narrower on all sides</source>
        <translation>選択範囲を全方向から狭める</translation>
    </message>
    <message>
        <source>&amp;Border...</source>
        <translation>境界線(&amp;B)...</translation>
    </message>
    <message>
        <source>Select a band along the outline of the selection</source>
        <translation>選択範囲の輪郭に沿った帯を選択する</translation>
    </message>
    <message>
        <source>&amp;From the layer</source>
        <translation>レイヤーから(&amp;F)</translation>
    </message>
    <message>
        <source>Select where the layer has paint, wet or dry</source>
        <translation>レイヤーに絵具がある部分を、濡れていても乾いていても選択する</translation>
    </message>
    <message>
        <source>Brush e&amp;ditor...</source>
        <translation>ブラシエディター(&amp;D)...</translation>
    </message>
    <message>
        <source>Every number of the tool in hand, and the stroke that it paints</source>
        <translation>今のツールのすべての数値と、それが描くストローク</translation>
    </message>
    <message>
        <source>&amp;Favourite</source>
        <translation>お気に入り(&amp;F)</translation>
    </message>
    <message>
        <source>Keep the tool in hand among your favourites, which the list can show alone</source>
        <translation>今のツールをお気に入りに加える。一覧にお気に入りだけを表示できる</translation>
    </message>
    <message>
        <source>&amp;Import tools...</source>
        <translation>ツールを読み込む(&amp;I)...</translation>
    </message>
    <message>
        <source>Add the tools of a bundle to your own</source>
        <translation>バンドルのツールを自分のツールに加える</translation>
    </message>
    <message>
        <source>E&amp;xport my tools...</source>
        <translation>自分のツールを書き出す(&amp;X)...</translation>
    </message>
    <message>
        <source>Write all tools of your own into a bundle, a file to keep or to give away</source>
        <translation>自分のツールすべてを一つのバンドルファイルに書き出す。保存や配布に</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>ウィンドウ(&amp;W)</translation>
    </message>
    <message>
        <source>Save a &amp;version</source>
        <translation>バージョンを保存(&amp;V)</translation>
    </message>
    <message>
        <source>Go on in a file of the next number beside this one, which stays as it is</source>
        <translation>次の番号のファイルを隣に作って描き続ける。今のファイルはそのまま残る</translation>
    </message>
    <message>
        <source>Close the pain&amp;ting</source>
        <translation>絵を閉じる(&amp;T)</translation>
    </message>
    <message>
        <source>Put the painting away; the start page says what there is to go on with</source>
        <translation>絵を片付ける。スタートページに、次に描けるものが並ぶ</translation>
    </message>
    <message>
        <source>Scale image to &amp;new size...</source>
        <translation>画像を新しいサイズに変更(&amp;N)...</translation>
    </message>
    <message>
        <source>Draw the whole painting out, or make it of finer or coarser pixels</source>
        <translation>作品全体を拡大・縮小する。または画素を細かく、粗くする</translation>
    </message>
    <message>
        <source>Toned g&amp;round...</source>
        <translation>有色下地(&amp;R)...</translation>
    </message>
    <message>
        <source>Cover the whole canvas with a dry coat of the paint in hand, below all layers</source>
        <translation>手持ちの絵具の乾いた層で、すべてのレイヤーの下からキャンバス全体を覆う</translation>
    </message>
    <message>
        <source>Full scr&amp;een</source>
        <translation>全画面(&amp;E)</translation>
    </message>
    <message>
        <source>The window on the whole screen, without the bars of the desktop</source>
        <translation>デスクトップのバーなしで、ウィンドウを画面いっぱいに表示する</translation>
    </message>
    <message>
        <source>S&amp;quint</source>
        <translation>目を細めて見る(&amp;Q)</translation>
    </message>
    <message>
        <source>The painting as with half-closed eyes: large shapes without their details</source>
        <translation>目を細めたように絵を見る。細部のない大きな形だけが見える</translation>
    </message>
    <message>
        <source>&amp;Brushes panel</source>
        <translation>ブラシパネル(&amp;B)</translation>
    </message>
    <message>
        <source>The tools to paint with, how wide they are and how steady they keep</source>
        <translation>描くツール、その幅と手ぶれの抑え方</translation>
    </message>
    <message>
        <source>&amp;Paints panel</source>
        <translation>絵具パネル(&amp;P)</translation>
    </message>
    <message>
        <source>The tubes of paint</source>
        <translation>絵具のチューブ</translation>
    </message>
    <message>
        <source>&amp;Easel panel</source>
        <translation>イーゼルパネル(&amp;E)</translation>
    </message>
    <message>
        <source>How the canvas stands, where the lamp is, and how fast paint dries</source>
        <translation>キャンバスの立て方、ランプの位置、絵具の乾く速さ</translation>
    </message>
    <message>
        <source>T&amp;ool bar</source>
        <translation>ツールバー(&amp;O)</translation>
    </message>
    <message>
        <source>The bar of buttons; drag it by its end to another side, or off the window</source>
        <translation>ボタンのバー。端をつかんで別の辺へ、またはウィンドウの外へドラッグできる</translation>
    </message>
    <message>
        <source>&amp;New window</source>
        <translation>新しいウィンドウ(&amp;N)</translation>
    </message>
    <message>
        <source>Another window, with an easel of its own</source>
        <translation>別のイーゼルを持つ、もう一つのウィンドウ</translation>
    </message>
    <message>
        <source>S&amp;ketch</source>
        <translation>スケッチ(&amp;K)</translation>
    </message>
    <message>
        <source>Brushes and paints beside a large canvas, and nothing else</source>
        <translation>大きなキャンバスの横に、ブラシと絵具だけ</translation>
    </message>
    <message>
        <source>&amp;Oil</source>
        <translation>油彩(&amp;O)</translation>
    </message>
    <message>
        <source>Brushes, paints and easel beside the tool and the layers</source>
        <translation>ブラシ、絵具、イーゼル、それにツールとレイヤー</translation>
    </message>
    <message>
        <source>&amp;Mixing</source>
        <translation>混色(&amp;M)</translation>
    </message>
    <message>
        <source>Paints, colours and what the paint is like, beside a large mixing well</source>
        <translation>大きな混色皿の横に、絵具、色、絵具の性質</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>書き出し(&amp;E)</translation>
    </message>
    <message>
        <source>Lights, layers, the whole canvas and its recording, to finish a painting</source>
        <translation>光、レイヤー、キャンバス全体とその記録。絵を仕上げるときに</translation>
    </message>
    <message>
        <source>&amp;Save the workspace...</source>
        <translation>ワークスペースを保存(&amp;S)...</translation>
    </message>
    <message>
        <source>Keep the panels as they stand now, under a name of your own</source>
        <translation>パネルの今の並びに名前を付けて残す</translation>
    </message>
    <message>
        <source>&amp;Rename the workspace...</source>
        <translation>ワークスペースの名前を変更(&amp;R)...</translation>
    </message>
    <message>
        <source>Give your own workspace that is in use another name</source>
        <translation>使っている自分のワークスペースの名前を変える</translation>
    </message>
    <message>
        <source>Remo&amp;ve the workspace</source>
        <translation>ワークスペースを削除(&amp;V)</translation>
    </message>
    <message>
        <source>Forget your own workspace that is in use; the panels stay as they stand</source>
        <translation>使っている自分のワークスペースを忘れる。パネルはそのまま</translation>
    </message>
    <message>
        <source>&amp;Left-handed</source>
        <translation>左利き(&amp;L)</translation>
    </message>
    <message>
        <source>What stands on the left changes places with what stands on the right</source>
        <translation>左側と右側のパネルを入れ替える</translation>
    </message>
    <message>
        <source>Show me &amp;round</source>
        <translation>案内を見る(&amp;R)</translation>
    </message>
    <message>
        <source>Three steps: paint, move the canvas, take other paint</source>
        <translation>三つの手順: 描く、キャンバスを動かす、絵具を替える</translation>
    </message>
    <message>
        <source>Rotate &amp;image...</source>
        <translation>画像を回転(&amp;I)...</translation>
    </message>
    <message>
        <source>Turn the whole painting by any angle, to put a horizon straight</source>
        <translation>絵全体を好きな角度だけ回転する。水平線をまっすぐにするときなどに</translation>
    </message>
    <message>
        <source>Te&amp;xture paste...</source>
        <translation>テクスチャーペースト(&amp;X)...</translation>
    </message>
    <message>
        <source>Lay a dry relief of the paint in hand: sand, modelling paste, or a picture pressed in</source>
        <translation>手持ちの絵具で乾いた凹凸を置く。砂、モデリングペースト、または画像の型押し</translation>
    </message>
    <message>
        <source>Lock &amp;what is bare</source>
        <translation>絵具のない部分をロック(&amp;W)</translation>
    </message>
    <message>
        <source>Tools change the layer only where it has paint already</source>
        <translation>レイヤーに既に絵具がある部分だけをツールで変えられるようにする</translation>
    </message>
    <message>
        <source>&amp;Masking fluid</source>
        <translation>マスキング液(&amp;M)</translation>
    </message>
    <message>
        <source>Paint a skin that no paint gets below, as wide as the tool in hand; Alt peels it off</source>
        <translation>手にしたツールと同じ幅で、絵具が下に入らない膜を描く。Altで剥がす</translation>
    </message>
    <message>
        <source>Masking &amp;tape</source>
        <translation>マスキングテープ(&amp;T)</translation>
    </message>
    <message>
        <source>Drag a strip with clean edges that no paint gets below; Alt peels it off</source>
        <translation>縁のきれいな、絵具が下に入らない帯をドラッグして貼る。Altで剥がす</translation>
    </message>
    <message>
        <source>M&amp;ask the selection</source>
        <translation>選択範囲をマスクする(&amp;A)</translation>
    </message>
    <message>
        <source>Keep all paint off what is selected, until the masking is peeled off</source>
        <translation>マスキングを剥がすまで、選択した部分に絵具が付かないようにする</translation>
    </message>
    <message>
        <source>Select what is maske&amp;d</source>
        <translation>マスクした部分を選択する(&amp;D)</translation>
    </message>
    <message>
        <source>Select all that masking fluid and tape cover</source>
        <translation>マスキング液とテープが覆う部分をすべて選択する</translation>
    </message>
    <message>
        <source>Peel off all mas&amp;king</source>
        <translation>マスキングをすべて剥がす(&amp;K)</translation>
    </message>
    <message>
        <source>Take all masking fluid and tape away; the paint below is as it was</source>
        <translation>マスキング液とテープをすべて取り除く。下の絵具は元のまま</translation>
    </message>
    <message>
        <source>&amp;Parallel ruler</source>
        <translation>平行定規(&amp;P)</translation>
    </message>
    <message>
        <source>Strokes run parallel to the ruler from wherever they start</source>
        <translation>ストロークはどこから始めても定規と平行になる</translation>
    </message>
    <message>
        <source>&amp;Concentric ellipse</source>
        <translation>同心楕円(&amp;C)</translation>
    </message>
    <message>
        <source>Strokes run round the same middle from wherever they start</source>
        <translation>ストロークはどこから始めても同じ中心を回る</translation>
    </message>
    <message>
        <source>&amp;1 point perspective</source>
        <translation>1 点透視(&amp;1)</translation>
    </message>
    <message>
        <source>Strokes run to the vanishing point, level or upright</source>
        <translation>ストロークは消失点へ向かうか、水平または垂直になる</translation>
    </message>
    <message>
        <source>&amp;2 point perspective</source>
        <translation>2 点透視(&amp;2)</translation>
    </message>
    <message>
        <source>Strokes run to one of two vanishing points, or upright</source>
        <translation>ストロークは 2 つの消失点のどちらかへ向かうか、垂直になる</translation>
    </message>
    <message>
        <source>&amp;3 point perspective</source>
        <translation>3 点透視(&amp;3)</translation>
    </message>
    <message>
        <source>Strokes run to one of three vanishing points</source>
        <translation>ストロークは 3 つの消失点のどれかへ向かう</translation>
    </message>
    <message>
        <source>Gri&amp;d</source>
        <translation>グリッド(&amp;D)</translation>
    </message>
    <message>
        <source>Strokes run along the lines of a grid, or beside them</source>
        <translation>ストロークがグリッドの線に沿う、または線と平行になる</translation>
    </message>
    <message>
        <source>Snap to the &amp;guide</source>
        <translation>ガイドにスナップ(&amp;G)</translation>
    </message>
    <message>
        <source>Without it your hand is free, and the guide only shows where to go</source>
        <translation>オフにすると手は自由になり、ガイドは道筋を示すだけになる</translation>
    </message>
    <message>
        <source>Take mirrors, copies and the guide away</source>
        <translation>対称、コピー、ガイドをすべて外す</translation>
    </message>
    <message>
        <source>&amp;Add reference pictures...</source>
        <translation>参考画像を追加(&amp;A)...</translation>
    </message>
    <message>
        <source>Lay pictures on the board of references, to look at and to pick colours from</source>
        <translation>参考画像のボードに画像を置き、見たり色を拾ったりする</translation>
    </message>
    <message>
        <source>References in a &amp;window of their own</source>
        <translation>参考画像を別ウィンドウに(&amp;W)</translation>
    </message>
    <message>
        <source>The board of references above the canvas, or among the panels</source>
        <translation>参考画像のボードをキャンバスの上に、またはパネルの中に置く</translation>
    </message>
    <message>
        <source>Mirrors, rulers, perspectives and grids in numbers</source>
        <translation>対称、定規、透視、グリッドを数値で</translation>
    </message>
    <message>
        <source>Re&amp;ferences panel</source>
        <translation>参考画像パネル(&amp;F)</translation>
    </message>
    <message>
        <source>Pictures to look at while you paint, and to pick colours from</source>
        <translation>描きながら見て、色を拾うための画像</translation>
    </message>
    <message>
        <source>Ad&amp;just dry paint...</source>
        <translation>乾いた絵具を調整(&amp;J)...</translation>
    </message>
    <message>
        <source>Colour adjustment of what is dry: a glaze over it, or another hue by other pigments</source>
        <translation>乾いた絵具の色調整。上にグレーズをかける、または別の顔料で色相を変える</translation>
    </message>
    <message>
        <source>Cl&amp;ip to the layer below</source>
        <translation>下のレイヤーでクリッピング(&amp;I)</translation>
    </message>
    <message>
        <source>Show the layer only where the one below has paint; the rest is hidden, and kept</source>
        <translation>下のレイヤーに絵具がある部分だけを表示する。残りは隠れるが失われない</translation>
    </message>
    <message>
        <source>E&amp;verything</source>
        <translation>すべて(&amp;V)</translation>
    </message>
    <message>
        <source>F&amp;eather...</source>
        <translation>境界をぼかす(&amp;E)...</translation>
    </message>
    <message>
        <source>Make the edge of the selection soft, so that paint fades out there</source>
        <translation>選択範囲の境界をぼかし、絵具がそこで薄れるようにする</translation>
    </message>
    <message>
        <source>All strokes once more, finer, beside the painting on the easel</source>
        <translation>イーゼルの絵はそのままに、すべてのストロークをより細かく描き直します</translation>
    </message>
    <message>
        <source>save incremental, iteration</source>
        <translation>増分保存、別バージョン</translation>
    </message>
    <message>
        <source>png, jpeg, tiff, save as a picture</source>
        <translation>png、jpeg、画像として保存</translation>
    </message>
    <message>
        <source>replay, playback</source>
        <translation>再生、リプレイ</translation>
    </message>
    <message>
        <source>video, mp4, speed painting</source>
        <translation>動画、ビデオ、mp4</translation>
    </message>
    <message>
        <source>upscale, higher resolution, enlarge</source>
        <translation>高解像度、拡大</translation>
    </message>
    <message>
        <source>copy visible, copy flattened</source>
        <translation>表示部分をコピー</translation>
    </message>
    <message>
        <source>resize image, resolution, dpi</source>
        <translation>画像サイズ、解像度、dpi</translation>
    </message>
    <message>
        <source>resize canvas, extend, expand</source>
        <translation>キャンバスサイズ、広げる</translation>
    </message>
    <message>
        <source>trim to selection</source>
        <translation>選択範囲で切り抜き、トリミング</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>左右反転</translation>
    </message>
    <message>
        <source>straighten</source>
        <translation>傾き補正</translation>
    </message>
    <message>
        <source>brush size, smaller</source>
        <translation>ブラシサイズ、小さく</translation>
    </message>
    <message>
        <source>brush size, larger, bigger</source>
        <translation>ブラシサイズ、大きく</translation>
    </message>
    <message>
        <source>dip, load</source>
        <translation>絵具を付ける</translation>
    </message>
    <message>
        <source>rinse, wash, smudge, blend</source>
        <translation>洗う、ぼかし</translation>
    </message>
    <message>
        <source>dilute, water, thinner, solvent</source>
        <translation>薄める、水、溶剤</translation>
    </message>
    <message>
        <source>quick menu, radial menu</source>
        <translation>クイックメニュー</translation>
    </message>
    <message>
        <source>eyedropper, colour picker, color picker, pipette</source>
        <translation>スポイト、カラーピッカー</translation>
    </message>
    <message>
        <source>eyedropper, color picker, pipette</source>
        <translation>スポイト、カラーピッカー</translation>
    </message>
    <message>
        <source>brush settings, brush studio, brush engine</source>
        <translation>ブラシ設定</translation>
    </message>
    <message>
        <source>bundle, brush set, resources</source>
        <translation>バンドル、素材</translation>
    </message>
    <message>
        <source>dryer, fast dry, dry layer</source>
        <translation>ドライヤー、速乾</translation>
    </message>
    <message>
        <source>mixing palette, mixer, scratchpad</source>
        <translation>混色パレット、パレット</translation>
    </message>
    <message>
        <source>bucket, flood fill</source>
        <translation>バケツ、塗りつぶし</translation>
    </message>
    <message>
        <source>bucket, background fill</source>
        <translation>バケツ、背景色</translation>
    </message>
    <message>
        <source>imprimatura, background, gesso</source>
        <translation>下塗り、背景、ジェッソ</translation>
    </message>
    <message>
        <source>import layer, insert image, place image</source>
        <translation>画像の読み込み、画像を配置</translation>
    </message>
    <message>
        <source>delete layer</source>
        <translation>レイヤーを削除</translation>
    </message>
    <message>
        <source>free transform, scale, rotate, distort, perspective, skew, move tool</source>
        <translation>自由変形、拡大縮小、回転、遠近</translation>
    </message>
    <message>
        <source>saturation, hsv, colour balance, color balance</source>
        <translation>彩度、カラーバランス</translation>
    </message>
    <message>
        <source>merge visible, merge all</source>
        <translation>表示レイヤーを結合、統合</translation>
    </message>
    <message>
        <source>folder, quick group</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>alpha lock, lock transparency</source>
        <translation>アルファロック、透明度をロック</translation>
    </message>
    <message>
        <source>clipping mask, clipping group, inherit alpha</source>
        <translation>クリッピングマスク、クリッピンググループ</translation>
    </message>
    <message>
        <source>marquee, rectangular selection</source>
        <translation>矩形選択、長方形</translation>
    </message>
    <message>
        <source>marquee, elliptical selection, oval, circle</source>
        <translation>楕円選択、円形</translation>
    </message>
    <message>
        <source>freehand selection</source>
        <translation>フリーハンド選択、投げ縄</translation>
    </message>
    <message>
        <source>magic wand, automatic selection</source>
        <translation>マジックワンド、自動選択</translation>
    </message>
    <message>
        <source>magic wand, colour range, color range</source>
        <translation>マジックワンド、色域選択</translation>
    </message>
    <message>
        <source>deselect, select none, select all</source>
        <translation>選択解除、すべて選択</translation>
    </message>
    <message>
        <source>inverse</source>
        <translation>選択範囲の反転</translation>
    </message>
    <message>
        <source>expand</source>
        <translation>拡張</translation>
    </message>
    <message>
        <source>contract</source>
        <translation>縮小</translation>
    </message>
    <message>
        <source>soften, blur edge</source>
        <translation>境界をぼかす</translation>
    </message>
    <message>
        <source>select opaque, alpha to selection</source>
        <translation>不透明部分を選択</translation>
    </message>
    <message>
        <source>frisket, liquid mask, drawing gum</source>
        <translation>フリスケット、マスキングインク</translation>
    </message>
    <message>
        <source>frisket, stencil</source>
        <translation>フリスケット、養生テープ</translation>
    </message>
    <message>
        <source>frisket, stencil, protect</source>
        <translation>フリスケット、保護</translation>
    </message>
    <message>
        <source>remove frisket</source>
        <translation>マスキングを剥がす</translation>
    </message>
    <message>
        <source>marching ants, display selection</source>
        <translation>選択範囲を表示、点線</translation>
    </message>
    <message>
        <source>symmetry tool, multibrush</source>
        <translation>対称、シンメトリー</translation>
    </message>
    <message>
        <source>radial symmetry, multibrush, mandala</source>
        <translation>回転対称、万華鏡、曼荼羅</translation>
    </message>
    <message>
        <source>assistant, straight line, drawing guide</source>
        <translation>アシスタント、直線</translation>
    </message>
    <message>
        <source>assistant, drawing guide</source>
        <translation>アシスタント、平行線</translation>
    </message>
    <message>
        <source>assistant, vanishing point</source>
        <translation>アシスタント、消失点、パース</translation>
    </message>
    <message>
        <source>assistant, snapping</source>
        <translation>アシスタント、吸着</translation>
    </message>
    <message>
        <source>tracing paper, light table, template</source>
        <translation>トレーシングペーパー、下絵</translation>
    </message>
    <message>
        <source>reference image, mood board</source>
        <translation>資料、参考画像</translation>
    </message>
    <message>
        <source>flip canvas</source>
        <translation>表示を反転</translation>
    </message>
    <message>
        <source>hide panels, canvas-only mode</source>
        <translation>パネルを隠す</translation>
    </message>
    <message>
        <source>greyscale, grayscale, black and white, desaturate</source>
        <translation>グレースケール、白黒、明度</translation>
    </message>
    <message>
        <source>cmyk, print preview</source>
        <translation>cmyk、印刷プレビュー</translation>
    </message>
    <message>
        <source>brush library, presets</source>
        <translation>ブラシライブラリー、プリセット</translation>
    </message>
    <message>
        <source>gravity, drips, canvas tilt</source>
        <translation>重力、しずく、傾き</translation>
    </message>
    <message>
        <source>color wheel, colour selector, swatches</source>
        <translation>カラーホイール、カラーサークル、スウォッチ</translation>
    </message>
    <message>
        <source>gloss, impasto, bump</source>
        <translation>光沢、凹凸</translation>
    </message>
    <message>
        <source>overview</source>
        <translation>全体表示</translation>
    </message>
    <message>
        <source>default layout, reset workspace</source>
        <translation>初期配置、ワークスペース</translation>
    </message>
    <message>
        <source>search actions</source>
        <translation>アクション検索</translation>
    </message>
    <message>
        <source>shortcuts, hotkeys, keyboard</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>preferences, configure, options, theme, language</source>
        <translation>環境設定、オプション、テーマ、言語</translation>
    </message>
    <message>
        <source>stylus, pressure curve</source>
        <translation>スタイラス、筆圧</translation>
    </message>
    <message>
        <source>tutorial, getting started</source>
        <translation>チュートリアル</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 分 %2 秒</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 時間 %2 分</translation>
    </message>
    <message>
        <source>%1 × %2 pixels for %3 × %4 mm, which is %5 pixels per inch.</source>
        <translation>%1 × %2 ピクセル、実寸 %3 × %4 mm、1インチあたり %5 ピクセルです。</translation>
    </message>
    <message>
        <source>Four files of %1 × %2 pixels, %3 to %4.</source>
        <translation>%1 × %2 ピクセルのファイル4つ、%3 から %4 までです。</translation>
    </message>
    <message>
        <source>A solid of %1 × %2 mm; its front has %3 × %4 points, %5 mm apart.</source>
        <translation>%1 × %2 mm の立体。表面は %3 × %4 点、間隔は %5 mm です。</translation>
    </message>
    <message numerus="yes">
        <source>%1 of painting become %2 of film: %n frame(s) of %3 × %4 pixels.</source>
        <translation>
            <numerusform>%1 の制作が %2 の動画になります。%3 × %4 ピクセル、%n フレームです。</numerusform>
        </translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換え</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>名前を付けて保存...</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::AdjustDialog</name>
    <message>
        <source>The medium in hand leaves next to nothing when it dries.</source>
        <translation>手持ちのメディウムは乾くとほとんど何も残りません。</translation>
    </message>
    <message>
        <source>Adjust dry paint</source>
        <translation>乾いた絵具を調整</translation>
    </message>
    <message>
        <source>The dry paint of the layer that you paint on takes another colour, where it is selected or all over. Wet paint stays as it is.</source>
        <translation>描いているレイヤーの乾いた絵具の色が、選択範囲または全体で変わります。濡れた絵具はそのままです。</translation>
    </message>
    <message>
        <source>As a glaze</source>
        <translation>グレーズとして</translation>
    </message>
    <message>
        <source>As other pigments</source>
        <translation>別の顔料として</translation>
    </message>
    <message>
        <source>Adjust</source>
        <translation>調整</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚さ</translation>
    </message>
    <message>
        <source> µm</source>
        <translation> µm</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>割合</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>The mean colour as it is</source>
        <translation>今の平均の色</translation>
    </message>
    <message>
        <source>The mean colour after it is adjusted</source>
        <translation>調整後の平均の色</translation>
    </message>
    <message>
        <source>Before, after</source>
        <translation>調整前、調整後</translation>
    </message>
    <message>
        <source>A thin even coat of the paint in hand dries over it, and what lies below shows through. It is as thick as this when it is dry.</source>
        <translation>手持ちの絵具の薄く均一な層がその上で乾き、下のものが透けて見えます。厚さは乾いたときのものです。</translation>
    </message>
    <message>
        <source>So much of the dry paint is taken out and replaced by the paint in hand, which is stirred in. It stays as thick as it is.</source>
        <translation>この割合の乾いた絵具が取り除かれ、代わりに手持ちの絵具が混ぜ込まれます。厚さは変わりません。</translation>
    </message>
    <message>
        <source>&amp;Preview</source>
        <translation>プレビュー(&amp;P)</translation>
    </message>
    <message>
        <source>Show on the canvas what comes of it</source>
        <translation>結果をキャンバスに表示します</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CanvasSizeDialog</name>
    <message>
        <source>The upper left corner stays where it is</source>
        <translation>左上の角を固定する</translation>
    </message>
    <message>
        <source>The middle of the upper edge stays where it is</source>
        <translation>上辺の中央を固定する</translation>
    </message>
    <message>
        <source>The upper right corner stays where it is</source>
        <translation>右上の角を固定する</translation>
    </message>
    <message>
        <source>The middle of the left edge stays where it is</source>
        <translation>左辺の中央を固定する</translation>
    </message>
    <message>
        <source>The middle stays where it is</source>
        <translation>中央を固定する</translation>
    </message>
    <message>
        <source>The middle of the right edge stays where it is</source>
        <translation>右辺の中央を固定する</translation>
    </message>
    <message>
        <source>The lower left corner stays where it is</source>
        <translation>左下の角を固定する</translation>
    </message>
    <message>
        <source>The middle of the lower edge stays where it is</source>
        <translation>下辺の中央を固定する</translation>
    </message>
    <message>
        <source>The lower right corner stays where it is</source>
        <translation>右下の角を固定する</translation>
    </message>
    <message>
        <source>%1 mm on the left</source>
        <translation>左に %1 mm</translation>
    </message>
    <message>
        <source>%1 mm on the right</source>
        <translation>右に %1 mm</translation>
    </message>
    <message>
        <source>%1 mm at the top</source>
        <translation>上に %1 mm</translation>
    </message>
    <message>
        <source>%1 mm at the bottom</source>
        <translation>下に %1 mm</translation>
    </message>
    <message>
        <source>Added: %1.</source>
        <translation>追加: %1。</translation>
    </message>
    <message>
        <source>Cut off: %1. What lies there is wiped off.</source>
        <translation>切り取り: %1。そこにある絵具は拭き取られます。</translation>
    </message>
    <message>
        <source>Canvas size</source>
        <translation>キャンバスサイズ</translation>
    </message>
    <message>
        <source>Change the size</source>
        <translation>サイズを変更</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>幅(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>高さ(&amp;H)</translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation>固定する位置</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The canvas has this size.</source>
        <translation>キャンバスはこの大きさです。</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels.
%3</source>
        <translation>%1 × %2 ピクセルの画像になります。
%3</translation>
    </message>
    <message>
        <source>Other units may be typed as well: 50 cm, 20 in, 3000 px</source>
        <translation>ほかの単位でも入力できます: 50 cm、20 in、3000 px</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>何をしますか？</translation>
    </message>
    <message>
        <source>Not now: %1</source>
        <translation>今は使えません: %1</translation>
    </message>
    <message>
        <source>Nothing of that name. Fewer letters find more.</source>
        <translation>その名前のものはありません。文字を減らすと見つかりやすくなります。</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CrashDialog</name>
    <message>
        <source>Pastoso failed the last time</source>
        <translation>前回、Pastosoが異常終了しました</translation>
    </message>
    <message>
        <source>We are sorry. What you had painted was kept and is offered to you next. This report says where the program was; it tells nothing of your painting. With it the mistake can be found.</source>
        <translation>申し訳ありません。描いていたものは保存されており、このあと復元できます。この報告にはプログラムのどこで問題が起きたかが書かれています。作品の内容は含まれません。この報告があれば原因を調べられます。</translation>
    </message>
    <message>
        <source>It is kept as %1.</source>
        <translation>%1 として保存してあります。</translation>
    </message>
    <message>
        <source>Copy the report</source>
        <translation>報告をコピー</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>報告</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::ExportDialog</name>
    <message>
        <source>Where the folder is put</source>
        <translation>フォルダーの保存先</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>エクスポート</translation>
    </message>
    <message>
        <source>;;All files (*)</source>
        <translation>;;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>sRGB</source>
        <translation>sRGB</translation>
    </message>
    <message>
        <source>Display P3</source>
        <translation>Display P3</translation>
    </message>
    <message>
        <source>ICC profile...</source>
        <translation>ICCプロファイル...</translation>
    </message>
    <message>
        <source>ICC profile</source>
        <translation>ICCプロファイル</translation>
    </message>
    <message>
        <source>ICC profiles (*.icc *.icm);;All files (*)</source>
        <translation>ICCプロファイル (*.icc *.icm);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>What the painting looks like.</source>
        <translation>作品の見た目そのままの画像です。</translation>
    </message>
    <message>
        <source>The picture, and of every layer its colours, normals, heights in mm, wetness, gloss and cover, as channels of one file.</source>
        <translation>作品の画像と、各レイヤーの色、法線、高さ (mm)、濡れ具合、光沢、被覆を、一つのファイルのチャンネルとして保存します。</translation>
    </message>
    <message>
        <source>Base colour, normal (OpenGL, +Y up), height and roughness, a file for each.</source>
        <translation>ベースカラー、法線 (OpenGL、+Yが上)、高さ、粗さを別々のファイルに保存します。</translation>
    </message>
    <message>
        <source>The paint as it stands on the canvas: a closed solid in millimetres.</source>
        <translation>キャンバス上に盛り上がった絵具を、ミリメートル単位の閉じた立体にします。</translation>
    </message>
    <message>
        <source>How the painting came about. It is painted once more, which takes a while.</source>
        <translation>作品が出来上がっていく様子です。もう一度描き直すので、しばらく時間がかかります。</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>フォルダー(&amp;F)</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換え</translation>
    </message>
    <message>
        <source>What the file is; its name ends accordingly</source>
        <translation>ファイルの形式。拡張子もそれに合わせて変わる</translation>
    </message>
    <message>
        <source>What is made of the painting</source>
        <translation>作品から作るもの</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Layers, for compositing</source>
        <translation>レイヤー（合成用）</translation>
    </message>
    <message>
        <source>Maps, for 3D programs</source>
        <translation>マップ（3Dソフト用）</translation>
    </message>
    <message>
        <source>Relief, for 3D printing</source>
        <translation>レリーフ（3Dプリント用）</translation>
    </message>
    <message>
        <source>Time-lapse</source>
        <translation>タイムラプス</translation>
    </message>
    <message>
        <source>Where it is put; the ending of the name chooses the format</source>
        <translation>保存先。拡張子で形式が決まる</translation>
    </message>
    <message>
        <source>&amp;Browse...</source>
        <translation>参照(&amp;B)...</translation>
    </message>
    <message>
        <source>1 is a small file, 100 a fine picture</source>
        <translation>1はファイルが小さく、100は高画質</translation>
    </message>
    <message>
        <source>What the picture is of</source>
        <translation>画像にするもの</translation>
    </message>
    <message>
        <source>The canvas</source>
        <translation>キャンバス</translation>
    </message>
    <message>
        <source>The mixing well</source>
        <translation>混色皿</translation>
    </message>
    <message>
        <source>&amp;Light and shade</source>
        <translation>光と陰影(&amp;L)</translation>
    </message>
    <message>
        <source>As the window shows the painting; otherwise the paint&apos;s own colours, as a scan would have them</source>
        <translation>ウィンドウで見たとおりの作品。オフにすると、スキャンしたような絵具そのものの色になる</translation>
    </message>
    <message>
        <source> px wide</source>
        <translation> px 幅</translation>
    </message>
    <message>
        <source>The width that the scale comes to, or the scale that gives this width</source>
        <translation>倍率から決まる幅。幅を入れると倍率が決まる</translation>
    </message>
    <message>
        <source>What the numbers in the file mean; the file says so too. sRGB is for common screens, Display P3 for screens of wide gamut, an ICC profile for a printer</source>
        <translation>ファイル内の数値が表す色。この情報はファイルにも書き込まれる。sRGBは一般的な画面、Display P3は広色域の画面、ICCプロファイルはプリンター用</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Thickness from the flat back to the lowest level of the canvas</source>
        <translation>平らな裏面からキャンバスの最も低い面までの厚さ</translation>
    </message>
    <message>
        <source> times as high</source>
        <translation> 倍</translation>
    </message>
    <message>
        <source>1 is the relief as it is painted, 2 twice as high; width and height stay</source>
        <translation>1は描いたとおりのレリーフ、2は高さが2倍。幅と縦の長さは変わらない</translation>
    </message>
    <message>
        <source> mm apart</source>
        <translation> mm 間隔</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source> times as fast</source>
        <translation> 倍速</translation>
    </message>
    <message>
        <source>Seconds of painting in a second of film</source>
        <translation>動画1秒あたりの制作時間（秒）</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> フレーム/秒</translation>
    </message>
    <message>
        <source>Frames in a second of film</source>
        <translation>動画1秒あたりのフレーム数</translation>
    </message>
    <message>
        <source>&amp;Make</source>
        <translation>作るもの(&amp;M)</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>形式(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>画質(&amp;Q)</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>対象(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>倍率(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>色(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Thickness</source>
        <translation>厚さ(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Heights</source>
        <translation>高さ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation>点(&amp;P)</translation>
    </message>
    <message>
        <source>Sp&amp;eed</source>
        <translation>速度(&amp;E)</translation>
    </message>
    <message>
        <source>F&amp;rames</source>
        <translation>フレームレート(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;File name</source>
        <translation>ファイル名(&amp;N)</translation>
    </message>
    <message>
        <source> px/mm</source>
        <translation> px/mm</translation>
    </message>
    <message>
        <source>as it was painted</source>
        <translation>描いたときと同じ</translation>
    </message>
    <message>
        <source>Canvas of &amp;it</source>
        <translation>キャンバスの解像度(&amp;I)</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> 倍</translation>
    </message>
    <message>
        <source>1 as the window paints it, 2 twice as wide and high: finer, not merely enlarged</source>
        <translation>1 はウィンドウで描いたまま、2 は幅も高さも 2 倍。引き伸ばすのではなく、細かくなります</translation>
    </message>
    <message>
        <source>Width of the picture in pixels</source>
        <translation>画像の幅（ピクセル）</translation>
    </message>
    <message>
        <source>Distance between two points of the surface; 0 is as far as the pixels, or farther where the canvas is large</source>
        <translation>表面の点と点の間隔。0はピクセルと同じ間隔、大きなキャンバスではそれより広くなる</translation>
    </message>
    <message>
        <source>Pixels in a millimetre of the canvas that it is painted on once more: more show finer paint and take longer; 0 is as it was painted</source>
        <translation>描き直すキャンバスの1ミリメートルあたりのピクセル数。多いほど絵具が細かく描かれ、時間がかかる。0は描いたときと同じ</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::KeyCatcher</name>
    <message>
        <source>Press the keys... (Esc: none)</source>
        <translation>キーを押してください... (Esc: なし)</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>キーの割り当て</translation>
    </message>
    <message>
        <source>What the keys are to start with; keys of your own stay</source>
        <translation>土台にするキーセット。自分で決めたキーはそのまま残る</translation>
    </message>
    <message>
        <source>Find by words, or by keys such as Ctrl+J</source>
        <translation>言葉、またはCtrl+Jなどのキーで検索</translation>
    </message>
    <message>
        <source>Click, and press other keys</source>
        <translation>クリックして別のキーを押す</translation>
    </message>
    <message>
        <source>Add a key</source>
        <translation>キーを追加</translation>
    </message>
    <message>
        <source>As the set has it</source>
        <translation>キーセットの設定に戻す</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>そのままにする</translation>
    </message>
    <message>
        <source>Forget all my own keys</source>
        <translation>自分のキーをすべて消す</translation>
    </message>
    <message>
        <source>Click, and press other keys in place of these</source>
        <translation>クリックし、代わりのキーを押す</translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation>%1 を外す</translation>
    </message>
    <message>
        <source>%1 is needed on the canvas itself: it can be given to no command. Choose another key.</source>
        <translation>%1 はキャンバスの操作に必要なため、コマンドには割り当てられません。別のキーを選んでください。</translation>
    </message>
    <message>
        <source>%1 is its key already.</source>
        <translation>%1 はすでにこのコマンドのキーです。</translation>
    </message>
    <message>
        <source>%1 is the key of &quot;%2&quot;.</source>
        <translation>%1 は「%2」のキーです。</translation>
    </message>
    <message>
        <source>Take it from there</source>
        <translation>こちらに割り当てる</translation>
    </message>
    <message>
        <source>%1 stays with &quot;%2&quot;, which you gave it to.</source>
        <translation>%1 は、自分で割り当てた「%2」のキーのままになります。</translation>
    </message>
    <message>
        <source>All keys will be as the set &quot;%1&quot; has them.</source>
        <translation>すべてのキーがキーセット「%1」のとおりになります。</translation>
    </message>
    <message>
        <source>Forget my own</source>
        <translation>自分のキーを消す</translation>
    </message>
    <message>
        <source>Set of keys</source>
        <translation>キーセット</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>No command has such words or keys.</source>
        <translation>そのような言葉やキーのコマンドはありません。</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::LengthDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::NewCanvasDialog</name>
    <message>
        <source>New canvas</source>
        <translation>新規キャンバス</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> px/mm</source>
        <translation> px/mm</translation>
    </message>
    <message>
        <source>Height image...</source>
        <translation>高さ画像...</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>解像度</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>支持体</translation>
    </message>
    <message>
        <source>Height image: white is high</source>
        <translation>高さ画像。白いほど高い</translation>
    </message>
    <message>
        <source>Image: %1</source>
        <translation>画像: %1</translation>
    </message>
    <message>
        <source>For large forms: brush marks blur.</source>
        <translation>大きな形向き: 筆跡はぼやけます。</translation>
    </message>
    <message>
        <source>Bristle marks of broad brushes show; close up, edges are soft.</source>
        <translation>太い筆の毛跡が見えます。近くで見ると縁は柔らかめです。</translation>
    </message>
    <message>
        <source>Every bristle and thread shows close up, in fine brushes as well.</source>
        <translation>細い筆でも、毛の一本一本と糸まで間近に見えます。</translation>
    </message>
    <message>
        <source>This machine keeps pace with the hand.</source>
        <translation>このマシンは手の速さについていけます。</translation>
    </message>
    <message>
        <source>Bristle marks and the weave show.</source>
        <translation>毛跡と布目が見えます。</translation>
    </message>
    <message>
        <source>Dots per inch may be typed as well: 127 dpi</source>
        <translation>dpi でも入力できます: 127 dpi</translation>
    </message>
    <message>
        <source>This machine keeps pace with the hand up to %1 px/mm; what is painted can be painted again finer.</source>
        <translation>このマシンが手の速さについていけるのは %1 px/mm までです。描いた絵は、あとからより細かく再描画できます。</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels, %3 dpi; up to %4 MB of memory when all of it is wet.</source>
        <translation>%1 × %2 ピクセル、%3 dpi の画像になります。全体が濡れているときは最大 %4 MB のメモリーを使います。</translation>
    </message>
    <message>
        <source>Other units may be typed as well: 50 cm, 20 in, 3000 px</source>
        <translation>ほかの単位でも入力できます: 50 cm、20 in、3000 px</translation>
    </message>
    <message>
        <source>Toned ground</source>
        <translation>有色下地</translation>
    </message>
    <message>
        <source>A dry coat of the paint in hand covers the whole canvas, on a layer of its own</source>
        <translation>手持ちの絵具の乾いた層がキャンバス全体を覆います（専用のレイヤー）</translation>
    </message>
    <message>
        <source>0.02 mm tints the canvas, 0.1 mm covers it</source>
        <translation>0.02 mm なら薄く色づき、0.1 mm なら覆い隠します</translation>
    </message>
    <message>
        <source>Thickness of the toned ground</source>
        <translation>有色下地の厚さ</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::RecoveryDialog</name>
    <message>
        <source>A painting without a name</source>
        <translation>名前のない作品</translation>
    </message>
    <message>
        <source>A painting that cannot be read
%1</source>
        <translation>読み込めない作品
%1</translation>
    </message>
    <message numerus="yes">
        <source>%1
%2
%3 × %4 mm, %n change(s) not saved</source>
        <translation>
            <numerusform>%1
%2
%3 × %4 mm、未保存の変更 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Unfinished paintings</source>
        <translation>描きかけの作品</translation>
    </message>
    <message>
        <source>Pastoso ended before these were saved.</source>
        <translation>これらを保存する前にPastosoが終了しました。</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>復元</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>あとで</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Discard %1 for good? It is nowhere else.</source>
        <translation>%1 を完全に破棄しますか？ほかの場所には残っていません。</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::RepaintDialog</name>
    <message>
        <source>Paint it again</source>
        <translation>再描画</translation>
    </message>
    <message>
        <source> px/mm</source>
        <translation> px/mm</translation>
    </message>
    <message>
        <source>&amp;Pixels per millimetre</source>
        <translation>1 mm あたりのピクセル数(&amp;P)</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, which take about %3 GB of memory; %4 GB are free. The strokes are painted again beside the painting on the easel, which stays as it is.</source>
        <translation>%1 × %2 ピクセル。メモリを約 %3 GB 使います（空き %4 GB）。ストロークは別に描き直され、イーゼルの絵はそのまま残ります。</translation>
    </message>
    <message>
        <source>Dots per inch may be typed as well: 127 dpi</source>
        <translation>dpi でも入力できます: 127 dpi</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::RotateDialog</name>
    <message>
        <source>&amp;Keep the size of the canvas</source>
        <translation>キャンバスの大きさを保つ(&amp;K)</translation>
    </message>
    <message>
        <source>Rotate the image</source>
        <translation>画像の回転</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Clockwise, about the middle of the canvas</source>
        <translation>キャンバスの中心を軸に時計回り</translation>
    </message>
    <message>
        <source>What comes beyond the canvas is wiped off</source>
        <translation>キャンバスからはみ出した絵具は拭き取られます</translation>
    </message>
    <message>
        <source>Put the &amp;ruler straight</source>
        <translation>定規をまっすぐにする(&amp;R)</translation>
    </message>
    <message>
        <source>Turns until the ruler is level or upright, whichever is nearer</source>
        <translation>定規が水平か垂直（近い方）になるまで回転します</translation>
    </message>
    <message>
        <source>Lay a ruler along the horizon first</source>
        <translation>先に定規を水平線に沿わせてください</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>The image stands like this.</source>
        <translation>画像はすでにこの向きです。</translation>
    </message>
    <message>
        <source>A canvas of %1 × %2 mm.</source>
        <translation>キャンバスは %1 × %2 mm になります。</translation>
    </message>
    <message>
        <source>What comes beyond it is wiped off.</source>
        <translation>はみ出した絵具は拭き取られます。</translation>
    </message>
    <message>
        <source>What is new in its corners is bare.</source>
        <translation>新しくできる隅には何も塗られていません。</translation>
    </message>
    <message>
        <source>The weave turns with the paint.</source>
        <translation>布目も絵具と一緒に回転します。</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::ScaleDialog</name>
    <message>
        <source>Paint keeps its thickness, so that there is %1 times as much of it.</source>
        <translation>絵具の厚みは変わらないので、量は %1 倍になります。</translation>
    </message>
    <message>
        <source>Keep the &amp;proportions</source>
        <translation>縦横比を保つ(&amp;P)</translation>
    </message>
    <message>
        <source>Scale the image</source>
        <translation>画像の拡大・縮小</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> px/mm</source>
        <translation> px/mm</translation>
    </message>
    <message>
        <source>Dots per inch may be typed as well: 127 dpi</source>
        <translation>dpi でも入力できます: 127 dpi</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>解像度</translation>
    </message>
    <message>
        <source>The image has this size and this resolution.</source>
        <translation>画像はすでにこのサイズと解像度です。</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels, %3 dpi; up to %4 MB of memory when all of it is wet.</source>
        <translation>%1 × %2 ピクセル、%3 dpi の画像になります。全体が濡れているときは最大 %4 MB のメモリーを使います。</translation>
    </message>
    <message>
        <source>Other units may be typed as well: 50 cm, 20 in, 3000 px</source>
        <translation>ほかの単位でも入力できます: 50 cm、20 in、3000 px</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::SelectRangeDialog</name>
    <message>
        <source>Select it</source>
        <translation>新しく選択</translation>
    </message>
    <message>
        <source>Add it to the selection</source>
        <translation>選択範囲に追加</translation>
    </message>
    <message>
        <source>Take it out of the selection</source>
        <translation>選択範囲から除外</translation>
    </message>
    <message>
        <source>Keep what is in both</source>
        <translation>重なる部分を残す</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>From</source>
        <translation>下限</translation>
    </message>
    <message>
        <source>To</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>Do</source>
        <translation>操作</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Nothing is there to be selected.</source>
        <translation>選択できるものがありません。</translation>
    </message>
    <message>
        <source>Then %1 % of the canvas is selected.</source>
        <translation>キャンバスの %1 % が選択されます。</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>外観</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>パフォーマンス</translation>
    </message>
    <message>
        <source>This machine</source>
        <translation>このコンピューター</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>テーマ</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Both are neutral greys, so that nothing beside the canvas colours what you see on it.</source>
        <translation>どちらも無彩色のグレーなので、キャンバスの色の見え方に影響しません。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>As on the desktop</source>
        <translation>デスクトップに合わせる</translation>
    </message>
    <message>
        <source>Another language speaks from the next start on.</source>
        <translation>言語の変更は次回の起動から反映されます。</translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation>元に戻すためのメモリー</translation>
    </message>
    <message>
        <source>The steps that you can return to. The oldest are given up when it is full; 500 are kept at most.</source>
        <translation>元に戻せる操作の記憶に使います。いっぱいになると古いものから失われます。最大500回分です。</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>しない</translation>
    </message>
    <message>
        <source>Save by itself every</source>
        <translation>自動保存</translation>
    </message>
    <message>
        <source>Into the painting&apos;s own file, once it has one. Whatever you choose, every stroke is kept aside within a second and offered to you again should the program or the machine fail.</source>
        <translation>一度保存した作品は、そのファイルに自動保存されます。設定にかかわらず、すべてのストロークは1秒以内に控えが取られ、プログラムやコンピューターが異常終了しても復元できます。</translation>
    </message>
    <message>
        <source>All of the machine (%1)</source>
        <translation>すべて使う (%1)</translation>
    </message>
    <message>
        <source>How many things the program works on at once, from the next painting on. The paint flows the same with any number.</source>
        <translation>同時に行う処理の数。次の作品から有効になります。いくつにしても絵具の流れ方は同じです。</translation>
    </message>
    <message>
        <source>How carefully moving paint is shown follows from how fast this machine draws; what stands still is always shown in full.</source>
        <translation>動いている絵具をどこまで細かく表示するかは、コンピューターの描画速度で決まります。止まっている絵具は常に完全に表示されます。</translation>
    </message>
    <message numerus="yes">
        <source> minute(s)</source>
        <translation>
            <numerusform> 分ごと</numerusform>
        </translation>
    </message>
    <message>
        <source>The canvas is drawn by</source>
        <translation>キャンバスの描画</translation>
    </message>
    <message>
        <source>What is faster here</source>
        <translation>この環境で速いほう</translation>
    </message>
    <message>
        <source>The graphics card (OpenGL)</source>
        <translation>グラフィックカード (OpenGL)</translation>
    </message>
    <message>
        <source>The processor</source>
        <translation>プロセッサ</translation>
    </message>
    <message>
        <source>Choose the processor where a graphics driver shows the canvas wrongly.</source>
        <translation>グラフィックドライバでキャンバスが正しく表示されない場合は、プロセッサを選んでください。</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>選択...</translation>
    </message>
    <message>
        <source>ICC profiles (*.icc *.icm);;All files (*)</source>
        <translation>ICCプロファイル (*.icc *.icm);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Of the system, which has none here</source>
        <translation>システムのもの（ここにはありません）</translation>
    </message>
    <message>
        <source>Of the system (%1)</source>
        <translation>システムのもの (%1)</translation>
    </message>
    <message>
        <source>The screen&apos;s profile</source>
        <translation>画面のプロファイル</translation>
    </message>
    <message>
        <source>None (sRGB)</source>
        <translation>なし (sRGB)</translation>
    </message>
    <message>
        <source>A file</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Its file</source>
        <translation>そのファイル</translation>
    </message>
    <message>
        <source>With the profile of your screen, canvas and swatches have the same colours as on any other that is measured. Files and exports are not changed.</source>
        <translation>画面のプロファイルを使うと、カンバスと色見本は、測色されたほかのどの画面とも同じ色になります。ファイルと書き出しは変わりません。</translation>
    </message>
    <message>
        <source>The printer&apos;s profile</source>
        <translation>プリンターのプロファイル</translation>
    </message>
    <message>
        <source>For &quot;Soft proof&quot; and &quot;Gamut warning&quot; in the &quot;View&quot; menu: of your printer and paper, or of your printing house.</source>
        <translation>「表示」メニューの「ソフトプルーフ」と「色域外の警告」に使います。お使いのプリンターと用紙、または印刷所のものを選んでください。</translation>
    </message>
    <message>
        <source>Undo and saving</source>
        <translation>元に戻すと保存</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Processors in use</source>
        <translation>使うプロセッサーの数</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::TextureDialog</name>
    <message>
        <source>A&amp;nother</source>
        <translation>別のもの(&amp;N)</translation>
    </message>
    <message>
        <source>Texture paste</source>
        <translation>テクスチャーペースト</translation>
    </message>
    <message>
        <source>A dry coat of the paint in hand lies on the layer that you paint on, where it is selected or all over. Brushes then catch on it.</source>
        <translation>手持ちの絵具の乾いた層が、描いているレイヤーの選択範囲または全体に載ります。その上で筆が引っかかるようになります。</translation>
    </message>
    <message>
        <source>Sand</source>
        <translation>砂</translation>
    </message>
    <message>
        <source>Modelling paste</source>
        <translation>モデリングペースト</translation>
    </message>
    <message>
        <source>A picture pressed in</source>
        <translation>画像の型押し</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>テクスチャー</translation>
    </message>
    <message>
        <source>Grains</source>
        <translation>粒</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Between ridges</source>
        <translation>うねの間隔</translation>
    </message>
    <message>
        <source>Other grains or other passes of the knife</source>
        <translation>別の粒、または別のナイフの跡にする</translation>
    </message>
    <message>
        <source>Lay the paste</source>
        <translation>ペーストを置く</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Which way the knife went: 0 to the right, 90 down</source>
        <translation>ナイフが進んだ向き。0は右、90は下</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>What is &amp;dark stands up</source>
        <translation>暗いところを盛り上げる(&amp;D)</translation>
    </message>
    <message>
        <source>Picture to press in</source>
        <translation>型押しする画像</translation>
    </message>
    <message>
        <source>Choose a picture...</source>
        <translation>画像を選ぶ...</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::TransformDialog</name>
    <message>
        <source>Transform</source>
        <translation>変形</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Move right</source>
        <translation>右へ移動</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>下へ移動</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Clockwise, about the middle of the frame</source>
        <translation>枠の中心を軸に時計回り</translation>
    </message>
    <message>
        <source>Left–right</source>
        <translation>左右</translation>
    </message>
    <message>
        <source>Left and right of the paint change places, before it is turned</source>
        <translation>回転の前に、絵具の左右を入れ替える</translation>
    </message>
    <message>
        <source>Up–down</source>
        <translation>上下</translation>
    </message>
    <message>
        <source>Above and below change places, before the paint is turned</source>
        <translation>回転の前に、絵具の上下を入れ替える</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>反転</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>適用</translation>
    </message>
    <message>
        <source>The paint keeps its thickness and its amount.</source>
        <translation>絵具の厚さと量は変わりません。</translation>
    </message>
    <message>
        <source>The paint keeps its thickness: %1 % of it will be there.</source>
        <translation>絵具の厚さは変わらず、量は %1 % になります。</translation>
    </message>
    <message>
        <source>What comes beyond the canvas is wiped off.</source>
        <translation>キャンバスからはみ出した絵具は拭き取られます。</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>四隅</translation>
    </message>
    <message>
        <source>Drag with Ctrl: a corner alone, or a side askew. By keys: Tab chooses a corner, arrows move it, with Shift by ten pixels.</source>
        <translation>Ctrlを押しながらドラッグ: 角は一つだけ、辺は斜めに動きます。キーでは: Tabで角を選び、矢印キーで動かします。Shiftを押すと10ピクセルずつです。</translation>
    </message>
</context>
<context>
    <name>pastoso::document::Table</name>
    <message>
        <source>Dry now</source>
        <translation>すぐ乾かす</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Paint squeezed out</source>
        <translation>絵具の絞り出し</translation>
    </message>
    <message>
        <source>Mixing well wiped</source>
        <translation>混色皿の拭き取り</translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>新規レイヤー</translation>
    </message>
    <message>
        <source>Look of a layer</source>
        <translation>レイヤーの表示設定</translation>
    </message>
    <message>
        <source>Layer duplicated</source>
        <translation>レイヤーの複製</translation>
    </message>
    <message>
        <source>Layer removed</source>
        <translation>レイヤーの削除</translation>
    </message>
    <message>
        <source>Layer cleared</source>
        <translation>レイヤーの消去</translation>
    </message>
    <message>
        <source>Transform</source>
        <translation>変形</translation>
    </message>
    <message>
        <source>Layer moved</source>
        <translation>レイヤーの移動</translation>
    </message>
    <message>
        <source>Merged down</source>
        <translation>下のレイヤーと結合</translation>
    </message>
    <message>
        <source>Flattened</source>
        <translation>表示レイヤーを結合</translation>
    </message>
    <message>
        <source>Layers grouped</source>
        <translation>レイヤーのグループ化</translation>
    </message>
    <message>
        <source>Look of a group</source>
        <translation>グループの表示設定</translation>
    </message>
    <message>
        <source>Group moved</source>
        <translation>グループの移動</translation>
    </message>
    <message>
        <source>Group dissolved</source>
        <translation>グループの解除</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>選択範囲</translation>
    </message>
    <message>
        <source>Size of the canvas</source>
        <translation>キャンバスサイズ</translation>
    </message>
    <message>
        <source>Picture as paint</source>
        <translation>画像を絵具として追加</translation>
    </message>
    <message>
        <source>Picture to trace</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>Place of the traced picture</source>
        <translation>下絵の位置</translation>
    </message>
    <message>
        <source>Paint pasted</source>
        <translation>絵具の貼り付け</translation>
    </message>
    <message>
        <source>Filled with paint</source>
        <translation>絵具で塗りつぶし</translation>
    </message>
    <message>
        <source>Painting scaled</source>
        <translation>作品の拡大・縮小</translation>
    </message>
    <message>
        <source>Ground toned</source>
        <translation>下地の着色</translation>
    </message>
    <message>
        <source>Painting rotated</source>
        <translation>作品の回転</translation>
    </message>
    <message>
        <source>Masking fluid</source>
        <translation>マスキング液</translation>
    </message>
    <message>
        <source>Selection masked</source>
        <translation>選択範囲のマスク</translation>
    </message>
    <message>
        <source>Masking peeled off</source>
        <translation>マスキングを剥がす</translation>
    </message>
    <message>
        <source>Reference picture</source>
        <translation>参考画像</translation>
    </message>
    <message>
        <source>Place of a reference</source>
        <translation>参考画像の位置</translation>
    </message>
    <message>
        <source>Order of the references</source>
        <translation>参考画像の順序</translation>
    </message>
    <message>
        <source>Reference taken away</source>
        <translation>参考画像を外す</translation>
    </message>
    <message>
        <source>Texture laid</source>
        <translation>テクスチャーの塗布</translation>
    </message>
    <message>
        <source>Dry paint adjusted</source>
        <translation>乾いた絵具の調整</translation>
    </message>
</context>
<context>
    <name>pastoso::glass</name>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> m/s²</source>
        <translation> m/s²</translation>
    </message>
    <message>
        <source> mm²/s</source>
        <translation> mm²/s</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Pours for</source>
        <translation>注ぐ時間</translation>
    </message>
    <message>
        <source>How long the milk of a new glass is poured</source>
        <translation>新しいグラスにミルクを注ぐ長さ</translation>
    </message>
    <message>
        <source>Stream</source>
        <translation>流れ</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Fat lifts</source>
        <translation>脂肪の浮力</translation>
    </message>
    <message>
        <source>How fast fat lets milk rise</source>
        <translation>脂肪でミルクが浮き上がる速さ</translation>
    </message>
    <message>
        <source>Cold sinks</source>
        <translation>冷たさの重み</translation>
    </message>
    <message>
        <source>How fast cold lets milk sink</source>
        <translation>冷たさでミルクが沈む速さ</translation>
    </message>
    <message>
        <source>Milky tea sinks</source>
        <translation>ミルク入りは沈む</translation>
    </message>
    <message>
        <source>How fast tea with milk in it sinks</source>
        <translation>ミルクの溶けた紅茶が沈む速さ</translation>
    </message>
    <message>
        <source>Warms at rest in</source>
        <translation>静止時に温まる</translation>
    </message>
    <message>
        <source>Time in which milk at rest warms</source>
        <translation>静止したミルクが温まる時間</translation>
    </message>
    <message>
        <source>A ball warms in</source>
        <translation>玉が温まる</translation>
    </message>
    <message>
        <source>Time in which a ball warms</source>
        <translation>玉が温まる時間</translation>
    </message>
    <message>
        <source>Cold given on</source>
        <translation>渡す冷たさ</translation>
    </message>
    <message>
        <source>Share of the milk&apos;s cold that the tea gets</source>
        <translation>ミルクの冷たさのうち紅茶に移る割合</translation>
    </message>
    <message>
        <source>First ball after</source>
        <translation>最初の玉まで</translation>
    </message>
    <message>
        <source>When the first ball forms</source>
        <translation>最初の玉ができる時刻</translation>
    </message>
    <message>
        <source>A ball every</source>
        <translation>玉の間隔</translation>
    </message>
    <message>
        <source>Time between two balls, in the mean</source>
        <translation>玉と玉の間の平均時間</translation>
    </message>
    <message>
        <source>Ball&apos;s radius</source>
        <translation>玉の半径</translation>
    </message>
    <message>
        <source>Radius of a ball, in the mean</source>
        <translation>玉の平均半径</translation>
    </message>
    <message>
        <source>Sizes differ by</source>
        <translation>大きさの違い</translation>
    </message>
    <message>
        <source>How much balls differ in size</source>
        <translation>玉の大きさのばらつき</translation>
    </message>
    <message>
        <source>A warm ball in</source>
        <translation>温かい玉</translation>
    </message>
    <message>
        <source>Time in which a warm ball dissolves</source>
        <translation>温まった玉が溶ける時間</translation>
    </message>
    <message>
        <source>On top in</source>
        <translation>水面の下</translation>
    </message>
    <message>
        <source>Time in which milk under the surface dissolves</source>
        <translation>水面のすぐ下でミルクが溶ける時間</translation>
    </message>
    <message>
        <source>On top is</source>
        <translation>水面の深さ</translation>
    </message>
    <message>
        <source>How far down that is</source>
        <translation>それがどの深さまでか</translation>
    </message>
    <message>
        <source>At rest in</source>
        <translation>静止時</translation>
    </message>
    <message>
        <source>Time in which milk at rest dissolves</source>
        <translation>静止したミルクが溶ける時間</translation>
    </message>
    <message>
        <source>All from</source>
        <translation>すべて溶け始め</translation>
    </message>
    <message>
        <source>When all milk begins to dissolve</source>
        <translation>すべてのミルクが溶け始める時刻</translation>
    </message>
    <message>
        <source>Warm below</source>
        <translation>温かいとみなす</translation>
    </message>
    <message>
        <source>Coldness below which a ball dissolves</source>
        <translation>これより冷たくなければ玉は溶けます</translation>
    </message>
    <message>
        <source>Milk spreads</source>
        <translation>ミルクの広がり</translation>
    </message>
    <message>
        <source>How dissolved milk spreads</source>
        <translation>溶けたミルクの広がり方</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>粘度</translation>
    </message>
    <message>
        <source>Kinematic viscosity: water 1, oil 80, honey 5000</source>
        <translation>動粘度: 水 1、油 80、蜂蜜 5000</translation>
    </message>
    <message>
        <source>Heat spreads</source>
        <translation>熱の広がり</translation>
    </message>
    <message>
        <source>How heat spreads</source>
        <translation>熱の広がり方</translation>
    </message>
    <message>
        <source>Whirls kept</source>
        <translation>渦の保持</translation>
    </message>
    <message>
        <source>Force that keeps small whirls alive</source>
        <translation>小さな渦を保つ力</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>時間刻み</translation>
    </message>
    <message>
        <source>Length of a time step</source>
        <translation>一歩の時間の長さ</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ミリ秒</translation>
    </message>
    <message>
        <source>Pressure within</source>
        <translation>圧力の誤差</translation>
    </message>
    <message>
        <source>How exact the pressure is solved</source>
        <translation>圧力を解く精度</translation>
    </message>
    <message>
        <source>Pouring</source>
        <translation>注ぐ</translation>
    </message>
    <message>
        <source>Sinking and rising</source>
        <translation>沈む・浮く</translation>
    </message>
    <message>
        <source>Balls of milk</source>
        <translation>ミルクの玉</translation>
    </message>
    <message>
        <source>Dissolving</source>
        <translation>溶ける</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>流れ</translation>
    </message>
    <message>
        <source>Milk</source>
        <translation>ミルク</translation>
    </message>
    <message>
        <source>How much milk is poured into a new glass by itself</source>
        <translation>新しいグラスに自動で注がれるミルクの量</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>Force reaches</source>
        <translation>力の届く範囲</translation>
    </message>
    <message>
        <source>How far the force reaches from its axis</source>
        <translation>力が軸からどこまで届くか</translation>
    </message>
    <message>
        <source>Tank: liquid falls</source>
        <translation>水槽: 液体が落ちる</translation>
    </message>
    <message>
        <source>Tank: two liquids meet</source>
        <translation>水槽: 二つの液体が出会う</translation>
    </message>
    <message>
        <source>Back to the painting</source>
        <translation>作品に戻る</translation>
    </message>
    <message>
        <source>The glass waits as it is, and so did the painting</source>
        <translation>グラスはそのまま待ちます。絵もそのまま待っていました</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>重力</translation>
    </message>
    <message>
        <source>How fast what falls gets faster</source>
        <translation>落ちるものがどれだけ速くなるか</translation>
    </message>
    <message>
        <source>Lively</source>
        <translation>活発さ</translation>
    </message>
    <message>
        <source>What of its own velocity a drop keeps from step to step: less is calmer</source>
        <translation>しずくがステップごとに保つ自分の速度の割合。小さいほど穏やか</translation>
    </message>
    <message>
        <source>Volume mended</source>
        <translation>体積の修正</translation>
    </message>
    <message>
        <source>How much of a wrong density a step mends</source>
        <translation>1 ステップで直す密度の誤りの割合</translation>
    </message>
    <message>
        <source>Way of a step</source>
        <translation>ステップの距離</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>Each number of the liquid</source>
        <translation>液体のすべての数値</translation>
    </message>
    <message>
        <source>thin as water</source>
        <translation>水のようにさらさら</translation>
    </message>
    <message>
        <source>thick as honey</source>
        <translation>蜂蜜のようにとろり</translation>
    </message>
    <message>
        <source>Its viscosity</source>
        <translation>液体の粘度</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>穏やか</translation>
    </message>
    <message>
        <source>lively</source>
        <translation>活発</translation>
    </message>
    <message>
        <source>How much of its own movement each drop keeps</source>
        <translation>それぞれの粒が自分の動きをどれだけ保つか</translation>
    </message>
    <message>
        <source>warm milk</source>
        <translation>温かいミルク</translation>
    </message>
    <message>
        <source>cold milk</source>
        <translation>冷たいミルク</translation>
    </message>
    <message>
        <source>Warm milk spreads under the surface, cold milk falls to the floor</source>
        <translation>温かいミルクは水面の下に広がり、冷たいミルクは底に沈みます</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>薄い</translation>
    </message>
    <message>
        <source>creamy</source>
        <translation>濃厚</translation>
    </message>
    <message>
        <source>Thin milk stays below and mixes soon, creamy milk rises in large soft clouds</source>
        <translation>薄いミルクは下にとどまってすぐ混ざり、濃厚なミルクは大きく柔らかな雲になって昇ります</translation>
    </message>
    <message>
        <source>hot tea</source>
        <translation>熱い紅茶</translation>
    </message>
    <message>
        <source>ice-cold tea</source>
        <translation>氷のように冷たい紅茶</translation>
    </message>
    <message>
        <source>Hot tea warms the milk, and it rises again; in ice-cold tea it lies where it fell</source>
        <translation>熱い紅茶ではミルクが温まって再び昇り、冷たい紅茶では落ちた場所にとどまります</translation>
    </message>
    <message>
        <source>Cold milk</source>
        <translation>冷たいミルク</translation>
    </message>
    <message>
        <source>Cold milk sinks, and comes up again in soft clouds as it warms</source>
        <translation>冷たいミルクは沈み、温まると柔らかな雲になって昇ってきます</translation>
    </message>
    <message>
        <source>Cold brew</source>
        <translation>水出し紅茶</translation>
    </message>
    <message>
        <source>A thin stream into cold tea: it heaps up on the floor and stays there for long</source>
        <translation>冷たい紅茶に細く注ぐと、底に積もって長くとどまります</translation>
    </message>
    <message>
        <source>Cream</source>
        <translation>クリーム</translation>
    </message>
    <message>
        <source>Thick cream turns round and floats on the tea</source>
        <translation>濃いクリームは向きを変え、紅茶に浮かびます</translation>
    </message>
    <message>
        <source>A drop</source>
        <translation>ひとしずく</translation>
    </message>
    <message>
        <source>A little thin milk, drawn out to fingers and veils</source>
        <translation>少しの薄いミルクが、指や薄絹のように引き伸ばされます</translation>
    </message>
    <message>
        <source>Stirred</source>
        <translation>かき混ぜて</translation>
    </message>
    <message>
        <source>The spoon goes round while the milk is poured</source>
        <translation>ミルクを注ぐあいだスプーンが回ります</translation>
    </message>
    <message>
        <source>White</source>
        <translation>真っ白</translation>
    </message>
    <message>
        <source>A wide stream of milk billows up and fills the glass</source>
        <translation>太く注いだミルクが湧き上がり、グラスを満たします</translation>
    </message>
    <message>
        <source>poured low</source>
        <translation>低くから注ぐ</translation>
    </message>
    <message>
        <source>from high</source>
        <translation>高くから注ぐ</translation>
    </message>
    <message>
        <source>Poured low, milk comes to lie on the floor; from high, it stirs the whole glass</source>
        <translation>低くから注ぐとミルクは底にたまり、高くから注ぐとグラス全体をかき混ぜます</translation>
    </message>
    <message>
        <source>Radius of the stream at the jug</source>
        <translation>ピッチャーの口での流れの半径</translation>
    </message>
    <message>
        <source>Speed of the stream at the jug, downwards</source>
        <translation>ピッチャーの口での流れの下向きの速さ</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>落差</translation>
    </message>
    <message>
        <source>How high above the tea the lip of the jug is</source>
        <translation>ピッチャーの口が紅茶からどれだけ高いか</translation>
    </message>
    <message>
        <source>The longest way of a step, against the finest detail of the liquid: longer is faster and coarser</source>
        <translation>1 ステップの最長距離を、液体の最も細かい部分と比べたもの。長いほど速く粗い</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::GlassChooser</name>
    <message>
        <source>What is in the glass</source>
        <translation>グラスの中身</translation>
    </message>
    <message>
        <source>What is in the glass: milk tea, or a tank of liquid</source>
        <translation>グラスの中身: ミルクティーまたは液体の水槽</translation>
    </message>
    <message>
        <source>Milk tea</source>
        <translation>ミルクティー</translation>
    </message>
    <message>
        <source>Open a tank...</source>
        <translation>水槽を開く...</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::GlassPage</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 / %2 秒</translation>
    </message>
    <message>
        <source>%1   paused</source>
        <translation>%1   一時停止中</translation>
    </message>
    <message>
        <source>%1   %2 steps/s</source>
        <translation>%1   %2 ステップ/秒</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>一時停止中</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::LiquidPictureDialog</name>
    <message>
        <source>Pixels from left to right</source>
        <translation>左から右までのピクセル数</translation>
    </message>
    <message>
        <source>Pixels from top to bottom</source>
        <translation>上から下までのピクセル数</translation>
    </message>
    <message>
        <source>Ways of light for each pixel: four times as many, half the noise</source>
        <translation>ピクセルごとの光の道筋: 4 倍でノイズは半分になります</translation>
    </message>
    <message>
        <source>As a surface</source>
        <translation>表面として</translation>
    </message>
    <message>
        <source>As a cloud</source>
        <translation>雲として</translation>
    </message>
    <message>
        <source>How milk that has not dissolved is seen: a cloud is softer and takes longer</source>
        <translation>溶けていないミルクの見え方。雲のほうが柔らかく、時間がかかります</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>サンプル数</translation>
    </message>
    <message>
        <source>Milk</source>
        <translation>ミルク</translation>
    </message>
    <message>
        <source>Use on the canvas</source>
        <translation>キャンバスに使う</translation>
    </message>
    <message>
        <source>Puts the picture onto the painting as a layer of dry paint, and goes there</source>
        <translation>画像を乾いた絵具のレイヤーとして絵に置き、絵に戻ります</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>保存...</translation>
    </message>
    <message>
        <source>As PNG and others as it is shown, or as EXR with the light itself</source>
        <translation>PNG などは見えるとおりに、EXR は光そのものを保存します</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Taking the noise out...</source>
        <translation>ノイズを取り除いています...</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>止める</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>レンダリング</translation>
    </message>
    <message>
        <source>Keep the picture as fine as it is by now</source>
        <translation>今の細かさの画像で止めます</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>画像を保存</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>画像 (%1)</translation>
    </message>
    <message>
        <source>Finding the surface...</source>
        <translation>表面を求めています...</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) in %1 s, without noise</source>
        <translation>
            <numerusform>%n サンプル、%1 秒、ノイズ除去済み</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n sample(s)</source>
        <translation>
            <numerusform>%1 / %n サンプル</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) in %1 s: too few to take all noise out</source>
        <translation>
            <numerusform>%n サンプル、%1 秒: ノイズをすべて除くには少なすぎます</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pastoso::glass::TankPage</name>
    <message>
        <source>Moment of the tank</source>
        <translation>水槽の時点</translation>
    </message>
    <message>
        <source>Drag to any moment of the tank; going on goes on from its last</source>
        <translation>任意の時点へドラッグします。再開すると最後から続きます</translation>
    </message>
    <message>
        <source>Liquid in the tank, and how many steps a second are computed</source>
        <translation>水槽の液体の量と、毎秒計算されるステップ数</translation>
    </message>
    <message>
        <source>Filling the tank...</source>
        <translation>水槽を満たしています...</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 l</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::TankPanel</name>
    <message>
        <source>Tank</source>
        <translation>水槽</translation>
    </message>
    <message>
        <source>Balls and drain</source>
        <translation>球と排水口</translation>
    </message>
    <message>
        <source>Ball&apos;s radius</source>
        <translation>玉の半径</translation>
    </message>
    <message>
        <source>How large the ball is that falls where you press</source>
        <translation>押したところに落ちる球の大きさ</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Milk in it</source>
        <translation>含まれるミルク</translation>
    </message>
    <message>
        <source>How much of the ball is milk</source>
        <translation>球のうちミルクの割合</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>風</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source>How fast the air goes</source>
        <translation>空気の速さ</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Blows to</source>
        <translation>風の行き先</translation>
    </message>
    <message>
        <source>0 to the right along the front, 90 away from it</source>
        <translation>0 は手前に沿って右へ、90 は奥へ</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Drags</source>
        <translation>引きずる強さ</translation>
    </message>
    <message>
        <source>How firmly it takes the liquid&apos;s surface along</source>
        <translation>液体の表面をどれだけ強く引きずるか</translation>
    </message>
    <message>
        <source> /s</source>
        <translation> /秒</translation>
    </message>
    <message>
        <source>Look and export</source>
        <translation>表示と書き出し</translation>
    </message>
    <message>
        <source>Liquid</source>
        <translation>液体</translation>
    </message>
    <message>
        <source>Every step into a folder</source>
        <translation>すべてのステップをフォルダーへ</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::TeaPage</name>
    <message>
        <source>Moment of the tea</source>
        <translation>紅茶の時点</translation>
    </message>
    <message>
        <source>Drag to any moment of the glass; going on goes on from its last</source>
        <translation>ドラッグしてグラスのどの時点でも見られます。再開すると最後の時点から進みます</translation>
    </message>
    <message>
        <source>Milk poured so far, and how many steps of 1/30 s a second are computed</source>
        <translation>これまでに注いだミルクと、1 秒間に計算される 1/30 秒の歩数</translation>
    </message>
    <message>
        <source>Filling the glass...</source>
        <translation>グラスに注いでいます...</translation>
    </message>
    <message>
        <source>%1 ml of milk</source>
        <translation>ミルク %1 ml</translation>
    </message>
    <message>
        <source>Press on the tea to pour milk where you point</source>
        <translation>紅茶を押すと、指した場所にミルクを注ぎます</translation>
    </message>
    <message>
        <source>The glass is full</source>
        <translation>グラスがいっぱいです</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::TeaPanel</name>
    <message>
        <source>Pictures</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>グラス</translation>
    </message>
    <message>
        <source>Drops that the next glass&apos; milk is made of</source>
        <translation>次のグラスのミルクを作る滴の数</translation>
    </message>
    <message>
        <source>Drops of milk</source>
        <translation>ミルクの滴</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Around the axis</source>
        <translation>軸まわり</translation>
    </message>
    <message>
        <source>How fast the stirring gets faster; below 0 it goes the other way round</source>
        <translation>かき混ぜが速くなる度合い。0 未満は逆回りです</translation>
    </message>
    <message>
        <source> rad/s²</source>
        <translation> rad/s²</translation>
    </message>
    <message>
        <source>Downwards</source>
        <translation>下向き</translation>
    </message>
    <message>
        <source> m/s²</source>
        <translation> m/s²</translation>
    </message>
    <message>
        <source>A push down along the axis; below 0 it goes up</source>
        <translation>軸に沿って下へ押す力。0 未満は上向きです</translation>
    </message>
    <message>
        <source>Milk and tea</source>
        <translation>ミルクと紅茶</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>レシピ</translation>
    </message>
    <message>
        <source>The next glass</source>
        <translation>次のグラス</translation>
    </message>
    <message>
        <source>Fineness</source>
        <translation>細かさ</translation>
    </message>
    <message>
        <source>Parts that each side of the next glass is divided into: twice as many take sixteen times as long; balls rise from 64 on</source>
        <translation>次のグラスの一辺を分ける数: 2 倍にすると 16 倍の時間がかかります。玉が浮くのは 64 からです</translation>
    </message>
</context>
<context>
    <name>pastoso::help::AboutDialog</name>
    <message>
        <source>About Pastoso</source>
        <translation>Pastoso について</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>This machine</source>
        <translation>このコンピューター</translation>
    </message>
    <message>
        <source>Folders</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>ライブラリ</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>ライセンス</translation>
    </message>
</context>
<context>
    <name>pastoso::help::HelpView</name>
    <message>
        <source>Page of the manual</source>
        <translation>マニュアルのページ</translation>
    </message>
</context>
<context>
    <name>pastoso::help::HelpWindow</name>
    <message>
        <source>Manual</source>
        <translation>マニュアル</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>マニュアルを検索</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>マニュアルのページ一覧</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>見つかったもの</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>進む</translation>
    </message>
    <message>
        <source>Nothing is found.</source>
        <translation>何も見つかりません。</translation>
    </message>
</context>
<context>
    <name>pastoso::help::TourBubble</name>
    <message>
        <source>Skip the tour</source>
        <translation>案内を終える</translation>
    </message>
    <message>
        <source>Go on with the tour</source>
        <translation>案内を続ける</translation>
    </message>
    <message>
        <source>Leave the tour, as Escape does; &quot;Show me round&quot; in the &quot;Help&quot; menu brings it back</source>
        <translation>案内を終える（Esc でも同じ）。「ヘルプ」メニューの「案内を見る」でまた見られます</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>次へ</translation>
    </message>
</context>
<context>
    <name>pastoso::main</name>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Graphics</source>
        <translation>グラフィックス</translation>
    </message>
    <message>
        <source>%1 (the processor draws, no graphics card)</source>
        <translation>%1 (プロセッサーで描画、グラフィックスカードなし)</translation>
    </message>
    <message>
        <source>Its maker</source>
        <translation>開発元</translation>
    </message>
    <message>
        <source>Shading language</source>
        <translation>シェーディング言語</translation>
    </message>
    <message>
        <source>Largest texture</source>
        <translation>テクスチャの最大サイズ</translation>
    </message>
    <message>
        <source>%1 pixels a side</source>
        <translation>一辺 %1 ピクセル</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, %3 for one of the layout</source>
        <translation>%1 × %2 ピクセル、表示倍率 %3</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>System</source>
        <translation>システム</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>プロセッサー</translation>
    </message>
    <message>
        <source>%1 at once, %2, kernels for %3</source>
        <translation>同時処理数 %1、%2、%3 用カーネル</translation>
    </message>
    <message>
        <source>Free memory</source>
        <translation>空きメモリー</translation>
    </message>
    <message>
        <source>Windows by</source>
        <translation>ウィンドウシステム</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Top up</source>
        <translation>付け足す</translation>
    </message>
    <message>
        <source>Blot</source>
        <translation>吸い取る</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>入れ替え</translation>
    </message>
    <message>
        <source>Pick paint</source>
        <translation>絵具を取る</translation>
    </message>
    <message>
        <source>Pick colour</source>
        <translation>色を拾う</translation>
    </message>
    <message>
        <source>Left, right</source>
        <translation>左右</translation>
    </message>
    <message>
        <source>Above, below</source>
        <translation>上下</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>選択...</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>外す</translation>
    </message>
    <message>
        <source>Below the paint</source>
        <translation>絵具の下に表示</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>合わせる</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>正位置</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>反転</translation>
    </message>
    <message>
        <source>Watch it grow...</source>
        <translation>制作過程を見る...</translation>
    </message>
    <message>
        <source>Make a time-lapse...</source>
        <translation>タイムラプスを作成...</translation>
    </message>
    <message>
        <source>Save the recording...</source>
        <translation>記録を保存...</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Physics</source>
        <translation>物理</translation>
    </message>
    <message>
        <source>Guides</source>
        <translation>ガイド</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>Tracing</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Navigator</source>
        <translation>ナビゲーター</translation>
    </message>
    <message>
        <source>Recorder</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>As it was painted</source>
        <translation>描いたときの速さ</translation>
    </message>
    <message>
        <source>4 times as fast</source>
        <translation>4倍速</translation>
    </message>
    <message>
        <source>16 times as fast</source>
        <translation>16倍速</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>できるだけ速く</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Stir</source>
        <translation>かき混ぜる</translation>
    </message>
    <message>
        <source>Other way round</source>
        <translation>逆回り</translation>
    </message>
    <message>
        <source>Render a picture...</source>
        <translation>画像をレンダリング...</translation>
    </message>
    <message>
        <source>Export the surface...</source>
        <translation>表面を書き出す...</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>最初から</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Drain</source>
        <translation>排水口</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>風</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Export all moments...</source>
        <translation>すべての瞬間を書き出す...</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Pour</source>
        <translation>注ぐ</translation>
    </message>
    <message>
        <source>Paint it again, finer...</source>
        <translation>再描画...</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source>Paints</source>
        <translation>絵具</translation>
    </message>
    <message>
        <source>Easel</source>
        <translation>イーゼル</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>スナップ</translation>
    </message>
    <message>
        <source>Add...</source>
        <translation>追加...</translation>
    </message>
    <message>
        <source>Own window</source>
        <translation>別ウィンドウ</translation>
    </message>
    <message>
        <source>References</source>
        <translation>参考画像</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>A recording is being played; the paint is yours when it has ended.</source>
        <translation>記録を再生中です。終わると絵具を使えます。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BackgroundExport</name>
    <message>
        <source>A file is being written already. Try again in a moment.</source>
        <translation>すでにファイルを書き出しています。しばらくしてからもう一度お試しください。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BrushBundles</name>
    <message>
        <source>Import tools</source>
        <translation>ツールを読み込む</translation>
    </message>
    <message>
        <source>Bundles of tools (*.zip)</source>
        <translation>ツールのバンドル (*.zip)</translation>
    </message>
    <message>
        <source>You have all tools of that bundle already.</source>
        <translation>そのバンドルのツールはすべて持っています。</translation>
    </message>
    <message numerus="yes">
        <source>%n tool(s) added to your own.</source>
        <translation>
            <numerusform>%n個のツールを自分のツールに加えました。</numerusform>
        </translation>
    </message>
    <message>
        <source>You have no tools of your own yet; save the one in hand first.</source>
        <translation>自分のツールはまだありません。まず今のツールを保存してください。</translation>
    </message>
    <message>
        <source>Export my tools</source>
        <translation>自分のツールを書き出す</translation>
    </message>
    <message>
        <source>my-tools.zip</source>
        <translation>my-tools.zip</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1を保存しました。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BrushJar</name>
    <message>
        <source>%1 was read again; the next stroke is painted with it.</source>
        <translation>「%1」を読み直しました。次のストロークから使われます。</translation>
    </message>
    <message>
        <source>Name of the tool:</source>
        <translation>ツールの名前:</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>My %1</source>
        <translation>マイ %1</translation>
    </message>
    <message>
        <source>Save as my own</source>
        <translation>自分のツールとして保存</translation>
    </message>
    <message>
        <source>There is already a tool of your own named &quot;%1&quot;.</source>
        <translation>「%1」という名前の自分のツールがすでにあります。</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>上書き</translation>
    </message>
    <message>
        <source>Kept &quot;%1&quot; among your own.</source>
        <translation>「%1」を自分のツールに加えました。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前を変更</translation>
    </message>
    <message>
        <source>Throw your tool &quot;%1&quot; away? Its file is deleted.</source>
        <translation>自分のツール「%1」を捨てますか？ファイルも削除されます。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is thrown away; what you have in hand stays.</source>
        <translation>「%1」を捨てました。手に持っているツールはそのまま使えます。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BrushShelving</name>
    <message>
        <source>A tag needs a name.</source>
        <translation>タグには名前が必要です。</translation>
    </message>
    <message>
        <source>New tag</source>
        <translation>新しいタグ</translation>
    </message>
    <message>
        <source>Name of the tag:</source>
        <translation>タグの名前:</translation>
    </message>
</context>
<context>
    <name>pastoso::main::CanvasSizing</name>
    <message>
        <source>A recording is being played; the canvas is yours when it has ended.</source>
        <translation>記録を再生中です。終わるとキャンバスを操作できます。</translation>
    </message>
    <message>
        <source>The selection reaches over the whole canvas: there is nothing to cut.</source>
        <translation>選択範囲がキャンバス全体に及ぶため、切り取るところがありません。</translation>
    </message>
    <message>
        <source>The canvas is %1 × %2 mm now; Undo brings back what it was.</source>
        <translation>キャンバスは %1 × %2 mm になりました。「元に戻す」で前の大きさに戻ります。</translation>
    </message>
    <message>
        <source>Making the canvas</source>
        <translation>キャンバスを作成中</translation>
    </message>
    <message>
        <source>Meanwhile the canvas has become another one; that keeps its size.</source>
        <translation>その間にキャンバスが別のものになりました。大きさはそのままです。</translation>
    </message>
    <message>
        <source>The selection is too soft to crop to: nothing is outlined.</source>
        <translation>選択範囲がぼけすぎているため、切り抜けません。輪郭がどこにもありません。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Clipboard</name>
    <message>
        <source>There is no paint to copy here.</source>
        <translation>ここにコピーする絵具はありません。</translation>
    </message>
    <message>
        <source>Copied; paste it as a layer, or as a picture in another program.</source>
        <translation>コピーしました。レイヤーとして、またはほかのプログラムで画像として貼り付けられます。</translation>
    </message>
    <message>
        <source>Pasted</source>
        <translation>貼り付け</translation>
    </message>
    <message>
        <source>There is nothing to paste: no paint and no picture has been copied.</source>
        <translation>貼り付けるものがありません。絵具も画像もコピーされていません。</translation>
    </message>
    <message>
        <source>The copied paint is too large to go to another painting as paint (at most %1 MB); a picture of it goes.</source>
        <translation>コピーした絵具は大きすぎて、絵具のまま別の絵に移せません（最大 %1 MB）。画像として貼り付けます。</translation>
    </message>
    <message>
        <source>The clipboard</source>
        <translation>クリップボード</translation>
    </message>
    <message>
        <source>What was dragged here</source>
        <translation>ここにドラッグされたもの</translation>
    </message>
</context>
<context>
    <name>pastoso::main::DroppedFiles</name>
    <message>
        <source>%1 is no painting and no picture that can be opened.</source>
        <translation>%1 は作品としても画像としても開けません。</translation>
    </message>
    <message>
        <source>Put it on a &amp;layer, as dry paint</source>
        <translation>乾いた絵具としてレイヤーに置く(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Trace it, below the paint</source>
        <translation>下絵として絵具の下に置く(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;New canvas made of it</source>
        <translation>この画像から新規キャンバスを作る(&amp;N)</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>そのままにする</translation>
    </message>
    <message>
        <source>&amp;Keep it beside the canvas, as a reference</source>
        <translation>参考画像としてキャンバスの横に置く(&amp;K)</translation>
    </message>
    <message>
        <source>Put each on a &amp;layer, as dry paint</source>
        <translation>1枚ずつ乾いた絵具としてレイヤーに置く(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Keep them beside the canvas, as references</source>
        <translation>まとめて参考画像としてキャンバスの横に置く(&amp;K)</translation>
    </message>
    <message>
        <source>Leave them</source>
        <translation>そのままにする</translation>
    </message>
    <message>
        <source>There is no picture in it that can be read.</source>
        <translation>読み込める画像が含まれていません。</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>Each of the other files opens in a window of its own. Open %1 more windows?</source>
        <translation>ほかのファイルは、それぞれ別のウィンドウで開きます。ウィンドウをさらに%1個開きますか？</translation>
    </message>
    <message>
        <source>Open them</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>画像</translation>
    </message>
</context>
<context>
    <name>pastoso::main::DryAdjusting</name>
    <message>
        <source>The layer that you paint on has no dry paint.</source>
        <translation>描いているレイヤーには乾いた絵具がありません。</translation>
    </message>
    <message>
        <source>The layer that you paint on has no dry paint where it is selected.</source>
        <translation>描いているレイヤーの選択範囲には乾いた絵具がありません。</translation>
    </message>
    <message>
        <source>The glaze lies over the dry paint.</source>
        <translation>グレーズが乾いた絵具の上に載っています。</translation>
    </message>
    <message>
        <source>The dry paint has other pigments in it.</source>
        <translation>乾いた絵具の顔料が変わりました。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Exporting</name>
    <message>
        <source>Exported %1 and %2 more; heights from %3 mm (black) to %4 mm (white).</source>
        <translation>%1 とほか %2 個をエクスポートしました。高さは %3 mm (黒) から %4 mm (白) です。</translation>
    </message>
    <message>
        <source>Exported %1: %2 × %3 pixels.</source>
        <translation>%1 をエクスポートしました: %2 × %3 ピクセル。</translation>
    </message>
    <message>
        <source>Stopped; %1 holds the pictures that are complete.</source>
        <translation>中止しました。完成した画像は %1 にあります。</translation>
    </message>
    <message>
        <source>Stopped; %1 was not written.</source>
        <translation>中止しました。%1 は書き出されていません。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>作品</translation>
    </message>
    <message>
        <source>%1 is still being written; wait for it, or stop it.</source>
        <translation>%1 を書き出し中です。終わるのを待つか、中止してください。</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 をエクスポート中</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>%1 is still being written.</source>
        <translation>%1 を書き出し中です。</translation>
    </message>
    <message>
        <source>Close when it is done</source>
        <translation>終わったら閉じる</translation>
    </message>
    <message>
        <source>Stop it</source>
        <translation>中止する</translation>
    </message>
    <message>
        <source>The window closes as soon as %1 is written.</source>
        <translation>%1 の書き出しが終わるとウィンドウが閉じます。</translation>
    </message>
    <message>
        <source>Export recording</source>
        <translation>記録をエクスポート</translation>
    </message>
    <message>
        <source>painting.json</source>
        <translation>作品.json</translation>
    </message>
    <message>
        <source>Recordings (*.json)</source>
        <translation>記録 (*.json)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message numerus="yes">
        <source>Exported %1: %n triangle(s), %2 × %3 mm.</source>
        <translation>
            <numerusform>%1 をエクスポートしました: 三角形 %n 個、%2 × %3 mm。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Exported %1: %n frame(s) of %2 × %3 pixels.</source>
        <translation>
            <numerusform>%1 をエクスポートしました: %2 × %3 ピクセル、%n フレーム。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Nothing was exported: make room or choose another place.</source>
        <translation>%1 エクスポートされていません。空きを作るか、別の場所を選んでください。</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>エクスポート...</translation>
    </message>
    <message numerus="yes">
        <source>Saved %1: %n layer(s) of %2 × %3 pixels.</source>
        <translation>
            <numerusform>%1 を保存しました：レイヤー %n 枚、%2 × %3 ピクセル。</numerusform>
        </translation>
    </message>
    <message>
        <source>OpenRaster (*.ora)</source>
        <translation>OpenRaster (*.ora)</translation>
    </message>
    <message>
        <source>Photoshop (*.psd)</source>
        <translation>Photoshop (*.psd)</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>コピーを保存</translation>
    </message>
</context>
<context>
    <name>pastoso::main::FillCommands</name>
    <message>
        <source>Nothing was poured. Esc again goes back to painting.</source>
        <translation>何も流していません。もう一度Escを押すと描画に戻ります。</translation>
    </message>
    <message>
        <source>Drag a line from the paint in hand to the second paint; Shift keeps it level, upright or halfway. Esc, or taking a tool, goes back to painting.</source>
        <translation>手にした絵具から2番目の絵具へ線をドラッグします。Shiftで水平、垂直、斜め45度に揃います。Escを押すか、ツールを選ぶと描画に戻ります。</translation>
    </message>
    <message>
        <source>The brush paints again.</source>
        <translation>ブラシで描けるようになりました。</translation>
    </message>
    <message>
        <source>%1 mm of paint are poured over the whole canvas.</source>
        <translation>キャンバス全体に%1 mmの絵具を流します。</translation>
    </message>
    <message>
        <source>%1 mm of paint are poured over what is selected.</source>
        <translation>選択範囲に%1 mmの絵具を流します。</translation>
    </message>
    <message>
        <source>Thickness of fills</source>
        <translation>塗りつぶしの厚さ</translation>
    </message>
    <message>
        <source>Fills and gradients pour an even film of wet paint, as thick as this: 0.05 mm shows what lies below, 0.2 mm covers, 1 mm stands as a paste.</source>
        <translation>塗りつぶしとグラデーションは、濡れた絵具をこの厚さで均一に流します。0.05 mmでは下が透け、0.2 mmで覆い、1 mmではペーストのように盛り上がります。</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚さ</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Toned ground</source>
        <translation>有色下地</translation>
    </message>
    <message>
        <source>An even coat of the paint in hand covers the whole canvas, dry at once, on a layer below all others: 0.02 mm tints the canvas, 0.1 mm covers it.</source>
        <translation>手持ちの絵具の均一な層がキャンバス全体を覆い、すぐに乾きます。ほかのすべてより下のレイヤーになります。0.02 mm なら薄く色づき、0.1 mm なら覆い隠します。</translation>
    </message>
    <message>
        <source>Tone the ground</source>
        <translation>下地をつける</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>下地</translation>
    </message>
</context>
<context>
    <name>pastoso::main::GlassMode</name>
    <message>
        <source>Surfaces (*.pbrt *.obj *.ply *.stl)</source>
        <translation>表面 (*.pbrt *.obj *.ply *.stl)</translation>
    </message>
</context>
<context>
    <name>pastoso::main::GuideCommands</name>
    <message>
        <source>Strokes around the middle: %1</source>
        <translation>中心まわりのストローク: %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::KeepingUp</name>
    <message>
        <source>Real time</source>
        <translation>実際の速さ</translation>
    </message>
    <message>
        <source>Thin less</source>
        <translation>薄めを控える</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Dry</source>
        <translation>乾かす</translation>
    </message>
</context>
<context>
    <name>pastoso::main::LayerCommands</name>
    <message>
        <source>Layer %1</source>
        <translation>レイヤー %1</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>グループ %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::LayerTransform</name>
    <message>
        <source>A recording is being played; the layers are yours when it has ended.</source>
        <translation>記録を再生中です。終わるとレイヤーを操作できます。</translation>
    </message>
    <message>
        <source>There is no paint on this layer.</source>
        <translation>このレイヤーには絵具がありません。</translation>
    </message>
    <message>
        <source>There is no paint of this layer in the selection.</source>
        <translation>選択範囲の中に、このレイヤーの絵具がありません。</translation>
    </message>
    <message>
        <source>The paint stays as it is.</source>
        <translation>絵具はそのままです。</translation>
    </message>
    <message>
        <source>Drag inside to move, a handle to scale, outside to turn (Shift: in steps), with Ctrl a corner or a side alone. Enter applies, Esc gives up.</source>
        <translation>内側をドラッグで移動、ハンドルで拡大縮小、外側で回転 (Shiftで段階的に)、Ctrlで角や辺だけを動かします。Enterで適用、Escで中止します。</translation>
    </message>
    <message>
        <source>No corner is chosen</source>
        <translation>角は選ばれていません</translation>
    </message>
    <message>
        <source>Upper left corner</source>
        <translation>左上の角</translation>
    </message>
    <message>
        <source>Upper right corner</source>
        <translation>右上の角</translation>
    </message>
    <message>
        <source>Lower right corner</source>
        <translation>右下の角</translation>
    </message>
    <message>
        <source>Lower left corner</source>
        <translation>左下の角</translation>
    </message>
    <message>
        <source>%1 at %2, %3 mm</source>
        <translation>%1: %2, %3 mm</translation>
    </message>
</context>
<context>
    <name>pastoso::main::LightChoice</name>
    <message>
        <source>Light from a file</source>
        <translation>ファイルから光を読み込む</translation>
    </message>
    <message>
        <source>Spectra (*.csv)</source>
        <translation>スペクトル (*.csv)</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Loading</name>
    <message>
        <source>%1: given up; all is as it was.</source>
        <translation>%1：中止しました。すべて元のままです。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>%1: wait for it, or cancel it.</source>
        <translation>%1：終わるのを待つか、中止してください。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::MaskingCommands</name>
    <message>
        <source>Paint masking fluid, as wide as the tool in hand: no paint gets below it. Alt peels it off again; Esc, or taking a tool, goes back to painting.</source>
        <translation>手にしたツールと同じ幅でマスキング液を塗ります。その下に絵具は入りません。Altで剥がせます。Escを押すか、ツールを選ぶと描画に戻ります。</translation>
    </message>
    <message>
        <source>Drag a strip of masking tape, as wide as the tool in hand; Shift keeps it level, upright or halfway. Alt peels it off again; Esc, or taking a tool, goes back to painting.</source>
        <translation>手にしたツールと同じ幅のマスキングテープをドラッグして貼ります。Shiftで水平、垂直、斜め45度に揃います。Altで剥がせます。Escを押すか、ツールを選ぶと描画に戻ります。</translation>
    </message>
    <message>
        <source>Nothing was masked. Esc again goes back to painting.</source>
        <translation>何もマスクされていません。もう一度Escを押すと描画に戻ります。</translation>
    </message>
    <message>
        <source>Peels the masking off there.</source>
        <translation>そこのマスキングを剥がします。</translation>
    </message>
    <message>
        <source>Masks the canvas there.</source>
        <translation>そこのキャンバスをマスクします。</translation>
    </message>
    <message>
        <source>The brush paints again.</source>
        <translation>ブラシで描けるようになりました。</translation>
    </message>
    <message>
        <source>The masking is peeled off.</source>
        <translation>マスキングを剥がしました。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::NewWindow</name>
    <message>
        <source>%1 cannot be started: there is no other window.</source>
        <translation>%1 を起動できません。もう一つのウィンドウは開きません。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintPicking</name>
    <message>
        <source>Picked up wet paint: %1</source>
        <translation>濡れた絵具を取りました: %1</translation>
    </message>
    <message>
        <source>Picked up dry paint: %1</source>
        <translation>乾いた絵具を取りました: %1</translation>
    </message>
    <message>
        <source>There is no colour to pick beside the canvas.</source>
        <translation>キャンバスの外には拾える色がありません。</translation>
    </message>
    <message>
        <source>Picked the colour seen: %1</source>
        <translation>見えている色を拾いました: %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintSettings</name>
    <message>
        <source>Open a palette</source>
        <translation>パレットを開く</translation>
    </message>
    <message>
        <source>Palettes (*.gpl)</source>
        <translation>パレット (*.gpl)</translation>
    </message>
    <message>
        <source>Colours of a picture</source>
        <translation>画像の色</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>画像 (%1)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1を読んでいます</translation>
    </message>
    <message>
        <source>Save the palette</source>
        <translation>パレットを保存</translation>
    </message>
    <message>
        <source>my-palette.gpl</source>
        <translation>my-palette.gpl</translation>
    </message>
    <message>
        <source>Export my paints</source>
        <translation>自分の絵具を書き出す</translation>
    </message>
    <message>
        <source>my-paints.json</source>
        <translation>my-paints.json</translation>
    </message>
    <message>
        <source>Sets of paints (*.json)</source>
        <translation>絵具のセット (*.json)</translation>
    </message>
    <message>
        <source>Import paints</source>
        <translation>絵具を読み込む</translation>
    </message>
    <message>
        <source>You have all paints of that set already.</source>
        <translation>そのセットの絵具はすべて持っています。</translation>
    </message>
    <message numerus="yes">
        <source>%n paint(s) added to your own.</source>
        <translation>
            <numerusform>%n 個の絵具を自分の絵具に加えました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1を保存しました。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintTime</name>
    <message>
        <source>%1 × time</source>
        <translation>%1 倍速</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintingAgain</name>
    <message>
        <source>painting</source>
        <translation>絵</translation>
    </message>
    <message>
        <source>Nothing has been painted yet that could be painted again.</source>
        <translation>描き直すものがまだ何も描かれていません。</translation>
    </message>
    <message>
        <source>The painting</source>
        <translation>この絵</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Paintings and pictures (%1)</source>
        <translation>絵と画像 (%1)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>Saved %1: %2 × %3 pixels.</source>
        <translation>%1 を保存しました: %2 × %3 ピクセル。</translation>
    </message>
    <message>
        <source>Another question is open; answer it first.</source>
        <translation>別の質問が開いています。先に答えてください。</translation>
    </message>
    <message>
        <source>The finer painting is still being written.</source>
        <translation>より細かく描き直した絵をまだ書き出しています。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PictureLayers</name>
    <message>
        <source>Layer from a picture</source>
        <translation>画像からレイヤーを作成</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>画像 (%1);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 を読み込み中</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PopupCommands</name>
    <message>
        <source>Mirror</source>
        <translation>反転</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>合わせる</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ProjectFiles</name>
    <message>
        <source>Open re&amp;cent</source>
        <translation>最近の作品を開く(&amp;C)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>キャンバス</translation>
    </message>
    <message>
        <source>%1[*] %2 × %3 mm</source>
        <translation>%1[*] %2 × %3 mm</translation>
    </message>
    <message>
        <source>Saving %1...</source>
        <translation>%1 を保存中...</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Paintings and pictures (*.pastoso *.ora %1);;All files (*)</source>
        <translation>作品と画像 (*.pastoso *.ora %1);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>painting.pastoso</source>
        <translation>作品.pastoso</translation>
    </message>
    <message>
        <source>Paintings (*.pastoso)</source>
        <translation>作品 (*.pastoso)</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>The painting on the easel has changes that are not saved.</source>
        <translation>イーゼルの上の作品に保存していない変更があります。</translation>
    </message>
    <message>
        <source>Discard them</source>
        <translation>変更を破棄</translation>
    </message>
    <message>
        <source>Painted from its strokes; the brush is yours when it is done.</source>
        <translation>ストロークから描き直しています。終わるとブラシを使えます。</translation>
    </message>
    <message>
        <source>What you paint is kept again.</source>
        <translation>描いたものの控えが再び取られています。</translation>
    </message>
    <message>
        <source>Should the program fail, this painting would come back slowly, from its strokes alone: %1 %2 are free there. Make room; you can paint on.</source>
        <translation>プログラムが異常終了した場合、この作品はストロークだけから時間をかけて復元されます。%1 そこの空きは %2 です。空きを作ってください。そのまま描き続けられます。</translation>
    </message>
    <message>
        <source>The disk is full: what you paint now would be lost if the program failed. It is kept in %1, where %2 are free and %3 wait to be written. Make room there, or save the painting to another disk. You can paint on; as soon as there is room, all of it is kept again.</source>
        <translation>ディスクがいっぱいです。いまプログラムが異常終了すると、描いたものが失われます。控えの場所は %1 で、空きは %2、書き込み待ちは %3 です。そこに空きを作るか、作品を別のディスクに保存してください。そのまま描き続けられます。空きができ次第、すべての控えが再び取られます。</translation>
    </message>
    <message>
        <source>What you paint now would be lost if the program failed: %1 %2 are free there. Make room, or save the painting to another disk. You can paint on; as soon as it can be, all of it is kept again.</source>
        <translation>いまプログラムが異常終了すると、描いたものが失われます。%1 そこの空きは %2 です。空きを作るか、作品を別のディスクに保存してください。そのまま描き続けられます。可能になり次第、すべての控えが再び取られます。</translation>
    </message>
    <message>
        <source>The painting</source>
        <translation>作品</translation>
    </message>
    <message>
        <source>%1 The painting is not saved: make room or choose another place, and save again.</source>
        <translation>%1 作品は保存されていません。空きを作るか別の場所を選び、もう一度保存してください。</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>名前を付けて保存...</translation>
    </message>
    <message>
        <source>Another program has changed %1 since you opened or saved it here. Replacing it loses what was changed there.</source>
        <translation>ここで開くか保存したあとに、別のプログラムが %1 を変更しました。置き換えると、その変更は失われます。</translation>
    </message>
    <message>
        <source>%1 is protected against being written to.</source>
        <translation>%1 は書き込みが禁止されています。</translation>
    </message>
    <message>
        <source>%1 The painting was not saved by itself.</source>
        <translation>%1 作品は自動保存されませんでした。</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>保存...</translation>
    </message>
    <message>
        <source>%1 - %2</source>
        <translation>%1 - %2</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 を開いています</translation>
    </message>
    <message>
        <source>Making the canvas</source>
        <translation>キャンバスを作成中</translation>
    </message>
    <message>
        <source>Putting it on the easel</source>
        <translation>イーゼルに載せています</translation>
    </message>
    <message>
        <source>Recovering the painting</source>
        <translation>絵を復元中</translation>
    </message>
    <message>
        <source>Save a version</source>
        <translation>バージョンを保存</translation>
    </message>
</context>
<context>
    <name>pastoso::main::RangeSelection</name>
    <message>
        <source>Wet paint of this layer is up to %1 mm thick, %2 mm on average.</source>
        <translation>このレイヤーの濡れた絵具は最大 %1 mm、平均 %2 mm の厚さです。</translation>
    </message>
    <message>
        <source>Paint, wet and dry, stands up to %1 mm above the canvas, %2 mm on average.</source>
        <translation>絵具は濡れたものも乾いたものも含め、キャンバスから最大 %1 mm、平均 %2 mm の高さです。</translation>
    </message>
    <message>
        <source>Select by wetness</source>
        <translation>濡れ具合で選択</translation>
    </message>
    <message>
        <source>Select by height</source>
        <translation>高さで選択</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Recorder</name>
    <message>
        <source>Nothing has been painted yet that could be shown again.</source>
        <translation>再生できるものはまだ描かれていません。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ReferenceCommands</name>
    <message>
        <source>Add reference pictures</source>
        <translation>参考画像を追加</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>画像 (%1);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>There is no picture in it; save it as a file, and drag that here.</source>
        <translation>画像が含まれていません。ファイルとして保存し、それをここにドラッグしてください。</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1を読んでいます</translation>
    </message>
    <message>
        <source>Picked from the reference: %1</source>
        <translation>参考画像から取りました: %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::RepaintWindow</name>
    <message>
        <source>Paused</source>
        <translation>一時停止中</translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation>残り約 %1</translation>
    </message>
    <message>
        <source>How much is painted</source>
        <translation>描き終えた割合</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>保存...</translation>
    </message>
    <message>
        <source>As a painting, or as a picture</source>
        <translation>絵として、または画像として</translation>
    </message>
    <message>
        <source>Put it on the easel</source>
        <translation>イーゼルに載せる</translation>
    </message>
    <message>
        <source>It cannot be painted any further</source>
        <translation>これ以上描けません</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>再開</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>It is not painted to its end yet. Give it up?</source>
        <translation>まだ最後まで描かれていません。中止しますか？</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Painted again at %1 px/mm</source>
        <translation>%1 px/mm で再描画</translation>
    </message>
    <message>
        <source>The finer painting is in no file yet. Throw it away?</source>
        <translation>より細かく描き直した絵は、まだどのファイルにもありません。破棄しますか？</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ReplayWindow</name>
    <message>
        <source>How it was painted</source>
        <translation>制作過程</translation>
    </message>
    <message>
        <source>Play, or stop for a moment (Space)</source>
        <translation>再生または一時停止 (Space)</translation>
    </message>
    <message>
        <source>Moment of the painting</source>
        <translation>制作中の時点</translation>
    </message>
    <message>
        <source>Drag to any moment of the painting</source>
        <translation>ドラッグで制作中の好きな時点へ</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>It cannot be shown any further</source>
        <translation>これより先は表示できません</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>pastoso::main::SelectionCommands</name>
    <message>
        <source>Outside the selection: nothing is painted there.</source>
        <translation>選択範囲の外なので、何も描かれません。</translation>
    </message>
    <message>
        <source>Nothing was selected. Esc again goes back to painting.</source>
        <translation>何も選択されていません。もう一度Escを押すと描画に戻ります。</translation>
    </message>
    <message>
        <source>Tools keep to the outline. Esc, or taking a tool, goes back to painting.</source>
        <translation>ツールは輪郭の中だけに効きます。Escを押すか、ツールを選ぶと描画に戻ります。</translation>
    </message>
    <message>
        <source>Drag around what tools shall keep to. Shift adds, Alt takes away, both keep what is in both; a click ends the selection.</source>
        <translation>ツールを効かせたい範囲をドラッグで囲みます。Shiftで追加、Altで除外、両方で重なる部分を残します。クリックで選択を解除します。</translation>
    </message>
    <message>
        <source>The brush paints again.</source>
        <translation>ブラシで描けるようになりました。</translation>
    </message>
    <message>
        <source>Selects what is inside.</source>
        <translation>囲んだ部分を選択します。</translation>
    </message>
    <message>
        <source>Adds what is inside to the selection.</source>
        <translation>囲んだ部分を選択範囲に追加します。</translation>
    </message>
    <message>
        <source>Takes what is inside out of the selection.</source>
        <translation>囲んだ部分を選択範囲から除外します。</translation>
    </message>
    <message>
        <source>Keeps what is inside and was selected before.</source>
        <translation>囲んだ部分のうち、すでに選択されていたところを残します。</translation>
    </message>
    <message>
        <source>A recording is being played; the brush is yours when it has ended.</source>
        <translation>記録を再生中です。終わるとブラシを使えます。</translation>
    </message>
    <message>
        <source>Nothing is selected: tools work on all of the canvas.</source>
        <translation>何も選択されていません。ツールはキャンバス全体に効きます。</translation>
    </message>
    <message>
        <source>lasso</source>
        <translation>なげなわ</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>長方形</translation>
    </message>
    <message>
        <source>ellipse</source>
        <translation>楕円</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>多角形</translation>
    </message>
    <message>
        <source>contiguous colour</source>
        <translation>隣接する色</translation>
    </message>
    <message>
        <source>similar colour</source>
        <translation>似た色</translation>
    </message>
    <message>
        <source>Click the colour that tools shall keep to; drag to the right for more, to the left for less of it. Shift adds, Alt takes away, both keep what is in both.</source>
        <translation>ツールを効かせたい色をクリックします。右へドラッグすると範囲が増え、左へドラッグすると減ります。Shiftで追加、Altで除外、両方で重なる部分を残します。</translation>
    </message>
    <message>
        <source>Click the corners of what tools shall keep to. Enter or a double click closes it, Backspace takes the last corner back, Esc gives it up.</source>
        <translation>ツールを効かせたい範囲の角をクリックします。Enterまたはダブルクリックで閉じ、Backspaceで最後の角を取り消し、Escで中止します。</translation>
    </message>
    <message>
        <source>Colours that differ by up to %1. Drag to the right for more, to the left for less.</source>
        <translation>差が%1以下の色です。右へドラッグすると増え、左へドラッグすると減ります。</translation>
    </message>
    <message>
        <source>Tools keep to colours that differ by up to %1 from the one there. Esc, or taking a tool, goes back to painting.</source>
        <translation>ツールはその場所の色との差が%1以下の色だけに効きます。Escを押すか、ツールを選ぶと描画に戻ります。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::SelectionMargins</name>
    <message>
        <source>Grow the selection</source>
        <translation>選択範囲を拡張</translation>
    </message>
    <message>
        <source>The selection becomes so much wider on all sides.</source>
        <translation>選択範囲が全方向にこの幅だけ広がります。</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>拡張</translation>
    </message>
    <message>
        <source>Shrink the selection</source>
        <translation>選択範囲を縮小</translation>
    </message>
    <message>
        <source>The selection becomes so much narrower on all sides, but not along the edges of the canvas.</source>
        <translation>選択範囲が全方向からこの幅だけ狭まります。キャンバスの端に沿った部分は変わりません。</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>縮小</translation>
    </message>
    <message>
        <source>Border of the selection</source>
        <translation>選択範囲の境界線</translation>
    </message>
    <message>
        <source>Selects a band so wide along the outline, half of it on either side.</source>
        <translation>輪郭に沿ったこの幅の帯を、両側に半分ずつ選択します。</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>Feather the selection</source>
        <translation>選択範囲の境界をぼかす</translation>
    </message>
    <message>
        <source>The edge becomes soft: paint fades out so far on either side of the outline.</source>
        <translation>境界がぼけます。輪郭の両側のこの幅で絵具が薄れます。</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Feather</source>
        <translation>ぼかす</translation>
    </message>
    <message>
        <source>Nothing would be left of the selection.</source>
        <translation>選択範囲が何も残らなくなります。</translation>
    </message>
    <message>
        <source>The selection would stay as it is.</source>
        <translation>選択範囲は何も変わりません。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Studio</name>
    <message numerus="yes">
        <source>%1 is open, and %n note(s) tell what is not as it was in the file.</source>
        <translation>
            <numerusform>%1 を開きました。ファイルと異なる点についてのメッセージが %n 件あります。</numerusform>
        </translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>%1 From now on the processor draws the canvas, which is slower.</source>
        <translation>%1 これからはプロセッサがキャンバスを描きます。少し遅くなります。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TankMode</name>
    <message>
        <source>Open a tank</source>
        <translation>水槽を開く</translation>
    </message>
    <message>
        <source>Scenes of a tank (*.json);;All files (*)</source>
        <translation>水槽のシーン (*.json);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Export the liquid&apos;s surface</source>
        <translation>液体の表面を書き出す</translation>
    </message>
    <message>
        <source>A folder for all moments</source>
        <translation>すべての瞬間のためのフォルダー</translation>
    </message>
    <message>
        <source>The liquid&apos;s surface is in %1.</source>
        <translation>液体の表面は %1 にあります。</translation>
    </message>
    <message>
        <source>All surfaces are in %1.</source>
        <translation>すべての表面は %1 にあります。</translation>
    </message>
    <message>
        <source>Picture of the tank</source>
        <translation>水槽の画像</translation>
    </message>
    <message>
        <source>The tank as it is seen in the window, traced along the light&apos;s ways through glass and liquid. Choose a size and press Render.</source>
        <translation>ウィンドウに見える水槽を、ガラスと液体を通る光の道筋をたどって描きます。大きさを選んで「レンダリング」を押してください。</translation>
    </message>
    <message>
        <source>Glass tank</source>
        <translation>ガラスの水槽</translation>
    </message>
    <message>
        <source>A folder for pictures of every step</source>
        <translation>各ステップの画像のためのフォルダー</translation>
    </message>
    <message>
        <source>A folder for surfaces of every step</source>
        <translation>各ステップの表面のためのフォルダー</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s) written</source>
        <translation>
            <numerusform>画像 %n 枚を保存</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n surface(s) written</source>
        <translation>
            <numerusform>表面 %n 個を保存</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pastoso::main::TankRecorder</name>
    <message numerus="yes">
        <source>%n picture(s) are in %1.</source>
        <translation>
            <numerusform>画像 %n 枚は %1 にあります。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n surface(s) are in %1.</source>
        <translation>
            <numerusform>表面 %n 個は %1 にあります。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pastoso::main::TeaMode</name>
    <message>
        <source>Open a scene of milk tea</source>
        <translation>ミルクティーのシーンを開く</translation>
    </message>
    <message>
        <source>Scenes of milk tea (*.json);;All files (*)</source>
        <translation>ミルクティーのシーン (*.json);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>シーンを保存</translation>
    </message>
    <message>
        <source>Scenes of milk tea (*.json)</source>
        <translation>ミルクティーのシーン (*.json)</translation>
    </message>
    <message>
        <source>Export the milk&apos;s surface</source>
        <translation>ミルクの表面を書き出す</translation>
    </message>
    <message>
        <source>The milk&apos;s surface is in %1.</source>
        <translation>ミルクの表面を %1 に書き出しました。</translation>
    </message>
    <message>
        <source>Milk tea</source>
        <translation>ミルクティー</translation>
    </message>
    <message>
        <source>Picture of the glass</source>
        <translation>グラスの画像</translation>
    </message>
    <message>
        <source>The glass as it is seen in the window, traced along the light&apos;s ways through glass, tea and milk. Choose a size and press Render.</source>
        <translation>ウィンドウに見えるグラスを、ガラス・紅茶・ミルクを通る光の道筋をたどって描きます。大きさを選んで「レンダリング」を押してください。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TextureCommands</name>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>画像 (%1);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1を読んでいます</translation>
    </message>
    <message>
        <source>The paste lies on the whole canvas, dry.</source>
        <translation>乾いたペーストがキャンバス全体に載っています。</translation>
    </message>
    <message>
        <source>The paste lies where it is selected, dry.</source>
        <translation>乾いたペーストが選択範囲に載っています。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TracingCommands</name>
    <message>
        <source>Picked the colour of the picture: %1</source>
        <translation>下絵の色を拾いました: %1</translation>
    </message>
    <message>
        <source>Trace a picture</source>
        <translation>下絵を置く</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>画像 (%1);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 を読み込み中</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TubeCommands</name>
    <message>
        <source>Save the tubes as a set</source>
        <translation>チューブをセットとして保存</translation>
    </message>
    <message>
        <source>Rename the set</source>
        <translation>セットの名前を変更</translation>
    </message>
    <message>
        <source>Name of the set:</source>
        <translation>セットの名前:</translation>
    </message>
    <message>
        <source>A set needs a name.</source>
        <translation>セットには名前が必要です。</translation>
    </message>
    <message>
        <source>Type another name: that one is empty, or another set&apos;s.</source>
        <translation>別の名前を入力してください。空か、ほかのセットの名前です。</translation>
    </message>
    <message>
        <source>Export my sets of tubes</source>
        <translation>自分のチューブのセットを書き出す</translation>
    </message>
    <message>
        <source>my-tubes.json</source>
        <translation>my-tubes.json</translation>
    </message>
    <message>
        <source>Sets of tubes (*.json)</source>
        <translation>チューブのセット (*.json)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1を保存しました。</translation>
    </message>
    <message>
        <source>Import sets of tubes</source>
        <translation>チューブのセットを読み込む</translation>
    </message>
    <message>
        <source>You have all sets of that file already.</source>
        <translation>そのファイルのセットはすべて持っています。</translation>
    </message>
    <message numerus="yes">
        <source>%n set(s) added to your own.</source>
        <translation>
            <numerusform>%n 個のセットを自分のセットに加えました。</numerusform>
        </translation>
    </message>
    <message>
        <source>No paint was squeezed out beside an earlier painting yet.</source>
        <translation>前の絵ではまだ絵具を絞り出していません。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ViewCommands</name>
    <message>
        <source>Canvas %1 × %2 mm, %3 pixels per millimetre</source>
        <translation>キャンバス %1 × %2 mm、1 mm に %3 ピクセル</translation>
    </message>
</context>
<context>
    <name>pastoso::main::WorkspaceCommands</name>
    <message>
        <source>There is a workspace &quot;%1&quot; already.</source>
        <translation>ワークスペース「%1」はすでにあります。</translation>
    </message>
    <message>
        <source>The workspace &quot;%1&quot; comes with the program: choose another name.</source>
        <translation>ワークスペース「%1」はプログラムに付属しています。別の名前を選んでください。</translation>
    </message>
    <message>
        <source>Save the workspace</source>
        <translation>ワークスペースを保存</translation>
    </message>
    <message>
        <source>Name of the workspace; one of your own with this name is replaced:</source>
        <translation>ワークスペースの名前（同じ名前の自分のものは置き換わります）:</translation>
    </message>
    <message>
        <source>Rename the workspace</source>
        <translation>ワークスペースの名前を変更</translation>
    </message>
    <message>
        <source>Name of the workspace:</source>
        <translation>ワークスペースの名前:</translation>
    </message>
</context>
<context>
    <name>pastoso::panels</name>
    <message>
        <source>never</source>
        <translation>乾かない</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>実際の速さ</translation>
    </message>
    <message>
        <source>10 times</source>
        <translation>10倍速</translation>
    </message>
    <message>
        <source>a minute a second</source>
        <translation>1秒で1分</translation>
    </message>
    <message>
        <source>10 min a second</source>
        <translation>1秒で10分</translation>
    </message>
    <message>
        <source>an hour a second</source>
        <translation>1秒で1時間</translation>
    </message>
    <message>
        <source>a day a second</source>
        <translation>1秒で1日</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>粘度</translation>
    </message>
    <message>
        <source>How slowly it flows: water 1, ink 100, cream 3000, oil from the tube 300000</source>
        <translation>流れにくさ。水は1、インクは100、クリームは3000、チューブの油絵具は300000</translation>
    </message>
    <message>
        <source> mm²/s</source>
        <translation> mm²/s</translation>
    </message>
    <message>
        <source>Yield stress</source>
        <translation>降伏応力</translation>
    </message>
    <message>
        <source>What it stands up to before it moves at all: at 0 it runs for ever, at 80 it keeps every bristle mark, at 200 it stands in peaks</source>
        <translation>動き出すまでに耐えられる力。0ではどこまでも流れ、80では毛の跡がすべて残り、200では角が立つ</translation>
    </message>
    <message>
        <source> Pa</source>
        <translation> Pa</translation>
    </message>
    <message>
        <source>Flow index</source>
        <translation>流動指数</translation>
    </message>
    <message>
        <source>Below 1 it thins where it is sheared: a brush or a fast run finds it thinner</source>
        <translation>1より小さいと、こすられたところの粘りが減る。ブラシや速い流れの中でさらりとする</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Heavy paint runs faster down a tilted canvas</source>
        <translation>重い絵具は傾いたキャンバスを速く流れ落ちる</translation>
    </message>
    <message>
        <source> kg/m³</source>
        <translation> kg/m³</translation>
    </message>
    <message>
        <source>Surface tension</source>
        <translation>表面張力</translation>
    </message>
    <message>
        <source>Rounds drips and edges, and draws thin lines into drops</source>
        <translation>垂れや縁を丸め、細い線を粒にまとめる</translation>
    </message>
    <message>
        <source> mN/m</source>
        <translation> mN/m</translation>
    </message>
    <message>
        <source>Spreads at</source>
        <translation>広がる角度</translation>
    </message>
    <message>
        <source>The edge moves out where it is steeper than this: low numbers wet the canvas easily, high ones stand in beads</source>
        <translation>縁がこれより急だと外へ広がる。小さいとキャンバスになじみやすく、大きいと玉になる</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Draws back at</source>
        <translation>縮む角度</translation>
    </message>
    <message>
        <source>The edge draws back where it is flatter than this; 0: it stays where it was</source>
        <translation>縁がこれより緩やかだと内へ縮む。0では元の位置にとどまる</translation>
    </message>
    <message>
        <source>Slip</source>
        <translation>すべり</translation>
    </message>
    <message>
        <source>Dry after</source>
        <translation>乾燥時間</translation>
    </message>
    <message>
        <source>Until a film of the usual thickness can be touched, in still air</source>
        <translation>標準の厚さの膜が、静かな空気の中で触れるようになるまでの時間</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分</translation>
    </message>
    <message>
        <source>Usual thickness</source>
        <translation>標準の厚さ</translation>
    </message>
    <message>
        <source>The film that dries in that time; thicker ones take longer</source>
        <translation>上の時間で乾く膜の厚さ。厚い膜はもっと時間がかかる</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Stays when dry</source>
        <translation>乾いて残る量</translation>
    </message>
    <message>
        <source>How much of the wet thickness is left: oil keeps all, watery paint sinks in</source>
        <translation>濡れているときの厚さのうち残る割合。油彩はすべて残り、水っぽい絵具はやせて薄くなる</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>流れ</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Drying</source>
        <translation>乾燥</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Matte</source>
        <translation>マット</translation>
    </message>
    <message>
        <source>Satin</source>
        <translation>サテン</translation>
    </message>
    <message>
        <source>Gloss</source>
        <translation>グロス</translation>
    </message>
    <message>
        <source>half</source>
        <translation>半分</translation>
    </message>
    <message>
        <source>a third</source>
        <translation>3分の1</translation>
    </message>
    <message>
        <source>a quarter</source>
        <translation>4分の1</translation>
    </message>
    <message>
        <source>a fifth</source>
        <translation>5分の1</translation>
    </message>
    <message>
        <source>a tenth</source>
        <translation>10分の1</translation>
    </message>
    <message>
        <source>less than a tenth</source>
        <translation>10分の1未満</translation>
    </message>
    <message>
        <source>stiff</source>
        <translation>硬い</translation>
    </message>
    <message>
        <source>runny</source>
        <translation>流れやすい</translation>
    </message>
    <message>
        <source>From paint that stands in peaks to paint that runs like ink: viscosity and yield stress</source>
        <translation>つのが立つ絵具から、インクのように流れる絵具まで。粘度と降伏応力</translation>
    </message>
    <message>
        <source>short</source>
        <translation>切れがよい</translation>
    </message>
    <message>
        <source>long</source>
        <translation>伸びがよい</translation>
    </message>
    <message>
        <source>opaque</source>
        <translation>不透明</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>透明</translation>
    </message>
    <message>
        <source>From paint that hides what lies below to a glaze: how much pigment is in it</source>
        <translation>下を隠す絵具からグレーズまで。含まれる顔料の量</translation>
    </message>
    <message>
        <source>Pigment</source>
        <translation>顔料</translation>
    </message>
    <message>
        <source>How much of full-strength paint is in it: paint from the tube 100, a glaze 3 to 6</source>
        <translation>濃い絵具がどれだけ含まれるか。チューブの絵具は100、グレーズは3～6</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Loosens by</source>
        <translation>柔らかくなる割合</translation>
    </message>
    <message>
        <source>Thixotropy: how much of its stiffness is gone where a tool or a run works it; brush marks level a little, and then stand</source>
        <translation>チキソトロピー: 道具や流れで練られたところが失う硬さの割合。筆跡は少し平らになってから止まります</translation>
    </message>
    <message>
        <source>Stiffens in</source>
        <translation>硬さが戻る時間</translation>
    </message>
    <message>
        <source>How long it rests until two thirds of what it lost have come back</source>
        <translation>静置して、失った硬さの三分の二が戻るまでの時間</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>Loosens after</source>
        <translation>柔らかくなるまでの流れ</translation>
    </message>
    <message>
        <source>How far it has to run before it is loosened, in times its own thickness</source>
        <translation>柔らかくなるまでに流れる距離。自分の厚みの何倍か</translation>
    </message>
    <message>
        <source>round</source>
        <translation>丸</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>平筆</translation>
    </message>
    <message>
        <source>filbert</source>
        <translation>フィルバート</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>ファン</translation>
    </message>
    <message>
        <source>knife</source>
        <translation>ナイフ</translation>
    </message>
    <message>
        <source>comb</source>
        <translation>コーム</translation>
    </message>
    <message>
        <source>soft pad</source>
        <translation>柔らかいパッド</translation>
    </message>
    <message>
        <source>used as it is</source>
        <translation>そのまま使う</translation>
    </message>
    <message>
        <source>dipped in paint</source>
        <translation>絵具を含ませる</translation>
    </message>
    <message>
        <source>stays on the tool</source>
        <translation>ツールに残る</translation>
    </message>
    <message>
        <source>is thrown away</source>
        <translation>捨てる</translation>
    </message>
    <message>
        <source>another in each stroke</source>
        <translation>ストロークごとに変わる</translation>
    </message>
    <message>
        <source>always the same</source>
        <translation>いつも同じ</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形</translation>
    </message>
    <message>
        <source>How the elements of the tip are arranged.</source>
        <translation>穂先の要素の並び方。</translation>
    </message>
    <message>
        <source>Before use</source>
        <translation>使う前に</translation>
    </message>
    <message>
        <source>A brush is dipped; a rag or a comb is used as it is.</source>
        <translation>ブラシは絵具を含ませる。布やコームはそのまま使う。</translation>
    </message>
    <message>
        <source>What it takes</source>
        <translation>取ったもの</translation>
    </message>
    <message>
        <source>A rag throws away what it takes up; it never comes back.</source>
        <translation>布は取った絵具を捨てる。もう戻らない。</translation>
    </message>
    <message>
        <source>Chance</source>
        <translation>偶然</translation>
    </message>
    <message>
        <source>Small random differences, such as where drops fall.</source>
        <translation>しずくの落ちる場所など、小さな偶然の違い。</translation>
    </message>
    <message>
        <source>%1 From %2 to %3%4.</source>
        <translation>%1%2 から %3%4 まで。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚み</translation>
    </message>
    <message>
        <source>Hair length</source>
        <translation>毛の長さ</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>とがり</translation>
    </message>
    <message>
        <source>Bristles</source>
        <translation>毛束</translation>
    </message>
    <message>
        <source>Hairs in each</source>
        <translation>束ごとの毛</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>個体</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>曲がり</translation>
    </message>
    <message>
        <source>Splay</source>
        <translation>広がり</translation>
    </message>
    <message>
        <source>Trail</source>
        <translation>遅れ</translation>
    </message>
    <message>
        <source>Press depth</source>
        <translation>押し込み</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>傾き</translation>
    </message>
    <message>
        <source>Into the weave</source>
        <translation>布目への入り</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>硬さ</translation>
    </message>
    <message>
        <source>Ride</source>
        <translation>乗り</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>膜</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>持続</translation>
    </message>
    <message>
        <source>Grooves</source>
        <translation>うね</translation>
    </message>
    <message>
        <source>Hair streaks</source>
        <translation>毛筋</translation>
    </message>
    <message>
        <source>Uneven load</source>
        <translation>含みのむら</translation>
    </message>
    <message>
        <source>Gathering</source>
        <translation>まとまり</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>縁</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>描き始め</translation>
    </message>
    <message>
        <source>Stays behind</source>
        <translation>残し</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>届く深さ</translation>
    </message>
    <message>
        <source>Pickup</source>
        <translation>拾い</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>混ざり</translation>
    </message>
    <message>
        <source>Wicking</source>
        <translation>しみ渡り</translation>
    </message>
    <message>
        <source> /mm</source>
        <translation> /mm</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>引きずり</translation>
    </message>
    <message>
        <source>Overflow</source>
        <translation>あふれ</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>一歩</translation>
    </message>
    <message>
        <source>Least step</source>
        <translation>最小の一歩</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>なめらかさ</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>String</source>
        <translation>ひも</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>しずく</translation>
    </message>
    <message>
        <source> mm³</source>
        <translation> mm³</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>ばらつき</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>流量</translation>
    </message>
    <message>
        <source> mm³/s</source>
        <translation> mm³/s</translation>
    </message>
    <message>
        <source>First drop</source>
        <translation>最初のしずく</translation>
    </message>
    <message>
        <source>Bottle</source>
        <translation>瓶</translation>
    </message>
    <message>
        <source>Steepness</source>
        <translation>盛り上がり</translation>
    </message>
    <message>
        <source>Centring</source>
        <translation>中央寄り</translation>
    </message>
    <message>
        <source>Throw</source>
        <translation>飛び</translation>
    </message>
    <message>
        <source>Air pressure</source>
        <translation>空気圧</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>穂先</translation>
    </message>
    <message>
        <source>Hairs</source>
        <translation>毛</translation>
    </message>
    <message>
        <source>Paint it leaves</source>
        <translation>残す絵具</translation>
    </message>
    <message>
        <source>Paint it takes</source>
        <translation>取る絵具</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>しずく</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>空気</translation>
    </message>
    <message>
        <source>nib</source>
        <translation>ペン先</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>歯</translation>
    </message>
    <message>
        <source>Pores</source>
        <translation>穴</translation>
    </message>
    <message>
        <source>Girth</source>
        <translation>周長</translation>
    </message>
    <message>
        <source>On the grain</source>
        <translation>目の上</translation>
    </message>
    <message>
        <source>%1: %2 to %3%4</source>
        <translation>%1: %2 ～ %3%4</translation>
    </message>
    <message>
        <source>Middle, from the left</source>
        <translation>中心、左から</translation>
    </message>
    <message>
        <source>Middle, from above</source>
        <translation>中心、上から</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>傾斜</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>First point, from the left</source>
        <translation>1 つ目の点、左から</translation>
    </message>
    <message>
        <source>First point, from above</source>
        <translation>1 つ目の点、上から</translation>
    </message>
    <message>
        <source>Second point, from the left</source>
        <translation>2 つ目の点、左から</translation>
    </message>
    <message>
        <source>Second point, from above</source>
        <translation>2 つ目の点、上から</translation>
    </message>
    <message>
        <source>Third point, from the left</source>
        <translation>3 つ目の点、左から</translation>
    </message>
    <message>
        <source>Third point, from above</source>
        <translation>3 つ目の点、上から</translation>
    </message>
    <message>
        <source>Slope of the horizon</source>
        <translation>水平線の傾斜</translation>
    </message>
    <message>
        <source>Crossing, from the left</source>
        <translation>交点、左から</translation>
    </message>
    <message>
        <source>Crossing, from above</source>
        <translation>交点、上から</translation>
    </message>
    <message>
        <source>Slope of the first lines</source>
        <translation>1 組目の線の傾斜</translation>
    </message>
    <message>
        <source>Spacing of the first lines</source>
        <translation>1 組目の線の間隔</translation>
    </message>
    <message>
        <source>Slope of the others</source>
        <translation>もう 1 組の傾斜</translation>
    </message>
    <message>
        <source>Spacing of the others</source>
        <translation>もう 1 組の間隔</translation>
    </message>
    <message>
        <source>Snaps within</source>
        <translation>スナップする範囲</translation>
    </message>
    <message>
        <source>From paint that breaks off sharply to paint that flows out at its edges and in long runs: the angle at which it spreads, the front and tail of drips, and the flow index</source>
        <translation>すぱっと切れる絵具から、端へ広がり長く流れる絵具まで。広がる角度、垂れの先端と尾、流動指数</translation>
    </message>
    <message>
        <source>How easily it slides over the canvas, in pixels of the painting: more lets edges run on</source>
        <translation>キャンバスの上のすべりやすさ（絵のピクセル単位）。大きいほど縁が先へ流れる</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Front of drips</source>
        <translation>垂れの先端</translation>
    </message>
    <message>
        <source>How fast a drip goes at its front, where surface tension holds it back: less makes it thicker and rounder there</source>
        <translation>表面張力に引き戻される垂れの先端が進む速さ。小さいとそこが厚く丸くなる</translation>
    </message>
    <message>
        <source>Tail of drips</source>
        <translation>垂れの尾</translation>
    </message>
    <message>
        <source>How fast a drip follows at its tail, where surface tension draws it along: more makes it thinner there</source>
        <translation>表面張力に引かれる垂れの尾がついていく速さ。大きいとそこが薄くなる</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::AidsPart</name>
    <message>
        <source>Harmony and gamut mask</source>
        <translation>色の調和と色域マスク</translation>
    </message>
    <message>
        <source>Marks for hues that go together, and a shape on the wheel to choose within</source>
        <translation>調和する色相の印と、その中で色を選ぶためのホイール上の形</translation>
    </message>
    <message>
        <source>Harmony</source>
        <translation>色の調和</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Complementary</source>
        <translation>補色</translation>
    </message>
    <message>
        <source>Split complementary</source>
        <translation>分裂補色</translation>
    </message>
    <message>
        <source>Analogous</source>
        <translation>類似色</translation>
    </message>
    <message>
        <source>Triad</source>
        <translation>三色配色</translation>
    </message>
    <message>
        <source>Tetrad</source>
        <translation>四色配色</translation>
    </message>
    <message>
        <source>The hues that go with yours are marked on the ring: a click takes one</source>
        <translation>選んだ色相に合う色相をリングに示す。クリックで選べる</translation>
    </message>
    <message>
        <source>Gamut mask</source>
        <translation>色域マスク</translation>
    </message>
    <message>
        <source>Atmospheric triad</source>
        <translation>雰囲気の三色配色</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>円</translation>
    </message>
    <message>
        <source>The colours of one lightness on a disc, and a shape that the wheel keeps to</source>
        <translation>同じ明度の色を円盤に表し、ホイールはその中の形に従う</translation>
    </message>
    <message>
        <source>Turn of the gamut mask</source>
        <translation>色域マスクの回転</translation>
    </message>
    <message>
        <source>Turns the gamut mask</source>
        <translation>色域マスクを回す</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushEditor</name>
    <message>
        <source>Brush editor</source>
        <translation>ブラシエディター</translation>
    </message>
    <message>
        <source>A stroke of the tool in hand, pressed hardest in its middle</source>
        <translation>今のツールのストローク。中ほどで最も強く押している</translation>
    </message>
    <message>
        <source>The same stroke of the tool as it is saved</source>
        <translation>保存されているツールの同じストローク</translation>
    </message>
    <message>
        <source>As saved</source>
        <translation>保存時</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Shows below the stroke of the tool as it is saved</source>
        <translation>保存されているツールのストロークを下に表示する</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Takes back all changes of the tool in hand</source>
        <translation>今のツールへの変更をすべて取り消す</translation>
    </message>
    <message>
        <source>In hand</source>
        <translation>手元</translation>
    </message>
    <message>
        <source>Parts of the tool</source>
        <translation>ツールの項目</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>カーブ</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1（変更あり）</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushFinder</name>
    <message>
        <source>Which tools are listed</source>
        <translation>一覧に出すツール</translation>
    </message>
    <message>
        <source>Find a tool</source>
        <translation>ツールを探す</translation>
    </message>
    <message>
        <source>A few letters of its name or of its family; Return takes the first</source>
        <translation>名前や種類の数文字。Return で先頭のツールを取る</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>お気に入り</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>My own</source>
        <translation>自分のツール</translation>
    </message>
    <message>
        <source>No tool has such a name.</source>
        <translation>そのような名前のツールはありません。</translation>
    </message>
    <message>
        <source>Tools that you mark with a star are listed here.</source>
        <translation>星を付けたツールがここに並びます。</translation>
    </message>
    <message>
        <source>Tools that you have taken are listed here, the latest first.</source>
        <translation>手に取ったツールが新しい順にここに並びます。</translation>
    </message>
    <message>
        <source>Tools that you save as your own are listed here.</source>
        <translation>自分のツールとして保存したものがここに並びます。</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushList</name>
    <message>
        <source>%1, your own</source>
        <translation>%1 (自分のツール)</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushPanel</name>
    <message>
        <source>Brush</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Width of the brush&apos;s tip  ([ and ])</source>
        <translation>ブラシの穂先の幅  ([ と ])</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>手ぶれ補正</translation>
    </message>
    <message>
        <source>How the hand is steadied</source>
        <translation>手ぶれ補正の方法</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>lags behind</source>
        <translation>遅れて追う</translation>
    </message>
    <message>
        <source>pulled on a string</source>
        <translation>ひもで引く</translation>
    </message>
    <message>
        <source>How much the hand is steadied</source>
        <translation>手ぶれ補正の強さ</translation>
    </message>
    <message>
        <source>Length of the string: wide curves without a tremor</source>
        <translation>ひもの長さ。震えのない大きな曲線が描ける</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>How far the brush lags behind the hand</source>
        <translation>ブラシが手からどれだけ遅れるか</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Width of the brush&apos;s tip</source>
        <translation>ブラシ先の幅</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>New tag...</source>
        <translation>新しいタグ...</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ColourPanel</name>
    <message>
        <source>Mix a colour</source>
        <translation>色を作る</translation>
    </message>
    <message>
        <source>Nearest from the tubes</source>
        <translation>チューブで作れる近い色</translation>
    </message>
    <message>
        <source>Use the recipe</source>
        <translation>この配合を使う</translation>
    </message>
    <message>
        <source>Dip the brush in this mixture from the tubes instead</source>
        <translation>代わりに、チューブから混ぜたこの絵具をブラシに付ける</translation>
    </message>
    <message>
        <source>Used before</source>
        <translation>最近使った絵具</translation>
    </message>
    <message>
        <source>Your palette</source>
        <translation>自分のパレット</translation>
    </message>
    <message>
        <source>Paints that you keep stay here.</source>
        <translation>取っておいた絵具がここに並びます。</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>取っておく</translation>
    </message>
    <message>
        <source>Lay the paint in hand out on your palette</source>
        <translation>今の絵具を自分のパレットに置く</translation>
    </message>
    <message>
        <source>The colour itself, as a paint of its own: %1</source>
        <translation>この色そのものの絵具: %1</translation>
    </message>
    <message>
        <source>Your palette is full: the right button takes a paint away.</source>
        <translation>パレットがいっぱいです。右クリックで絵具を取り除けます。</translation>
    </message>
    <message>
        <source>%1
The right button, or Delete, takes it away.</source>
        <translation>%1
右クリックまたはDeleteキーで取り除けます。</translation>
    </message>
    <message>
        <source>%1
ΔE %2, %3; %4</source>
        <translation>%1
ΔE %2、%3、%4</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>保存...</translation>
    </message>
    <message>
        <source>The colours of your palette for GIMP, Krita or Inkscape, as a .gpl file</source>
        <translation>自分のパレットの色をGIMP、Krita、Inkscape用の.gplファイルにする</translation>
    </message>
    <message>
        <source>There is no room for more mixes; take one away first.</source>
        <translation>これ以上混色を取っておけません。先に一つ取り除いてください。</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ColourPicker</name>
    <message>
        <source>OKLCh</source>
        <translation>OKLCh</translation>
    </message>
    <message>
        <source>Lightness, chroma and hue as the eye sees them</source>
        <translation>目に見える明度、彩度、色相</translation>
    </message>
    <message>
        <source>HSV</source>
        <translation>HSV</translation>
    </message>
    <message>
        <source>Hue, saturation and value</source>
        <translation>色相、彩度、明るさ</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>Red, green and blue of the screen</source>
        <translation>画面の赤、緑、青</translation>
    </message>
    <message>
        <source>The colour as it is written, for example #c03020</source>
        <translation>カラーコード。例: #c03020</translation>
    </message>
    <message>
        <source>Colour as written</source>
        <translation>カラーコード</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; write it for example as #c03020.</source>
        <translation>「%1」は色として読めません。#c03020のように書いてください。</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ColourWheel</name>
    <message>
        <source>Colour wheel</source>
        <translation>カラーホイール</translation>
    </message>
    <message>
        <source>The ring is the hue. Inside, lightness goes up and chroma to the right, as far as the
screen has it. Keys: arrows, Page Up and Page Down for the hue, with Ctrl finely.</source>
        <translation>外側の輪は色相です。内側は上ほど明るく、右ほど鮮やかです（画面で出せる範囲まで）。
キー: 色は矢印、色相はPage UpとPage Down、Ctrlで細かく動きます。</translation>
    </message>
    <message>
        <source>Lightness %1 %, chroma %2, hue %3°</source>
        <translation>明度 %1 %、彩度 %2、色相 %3°</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::CurveEditor</name>
    <message>
        <source>Curve</source>
        <translation>カーブ</translation>
    </message>
    <message>
        <source>Drag a point, click beside one to add another, right click to take one away.
Keys: Page Up and Page Down choose, arrows move, Insert adds, Delete takes away.</source>
        <translation>点をドラッグで移動、何もないところをクリックで追加、右クリックで削除。
キー: Page UpとPage Downで選択、矢印で移動、Insertで追加、Deleteで削除。</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n 個の点</numerusform>
        </translation>
    </message>
    <message>
        <source>Point %1 of %2: %3 % across, %4 % up</source>
        <translation>点 %1 / %2: 横 %3 %、縦 %4 %</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::CurvesPanel</name>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Another curve: what of the hand sets what of the tool</source>
        <translation>カーブを追加し、手のどの動きがツールの何を変えるかを決める</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Takes this curve away</source>
        <translation>このカーブを取り除く</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>リセット</translation>
    </message>
    <message>
        <source>The curve as the tool was kept with</source>
        <translation>ツールに保存されているカーブに戻す</translation>
    </message>
    <message>
        <source>How it answers to the hand</source>
        <translation>手の動きへの反応</translation>
    </message>
    <message>
        <source>What of the hand sets what of the tool</source>
        <translation>手のどの動きがツールの何を変えるか</translation>
    </message>
    <message>
        <source>This tool has no curves.</source>
        <translation>このツールにはカーブがありません。</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::EaselPanel</name>
    <message>
        <source>Tilt</source>
        <translation>傾き</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Drying</source>
        <translation>乾燥</translation>
    </message>
    <message>
        <source>How fast wet paint dries; D dries it at once</source>
        <translation>濡れた絵具が乾く速さ。Dですぐに乾く</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>How steeply the canvas stands</source>
        <translation>キャンバスの傾きの角度</translation>
    </message>
    <message>
        <source>Where down is: 0 right, 90 bottom</source>
        <translation>下の向き: 0 は右、90 は下</translation>
    </message>
    <message>
        <source>How high the lamp stands</source>
        <translation>ランプの高さの角度</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 right, 90 top</source>
        <translation>光の来る向き: 0 は右、90 は上</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::FeelRow</name>
    <message>
        <source>From %1 to %2</source>
        <translation>%1から%2まで</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::GuidesPanel</name>
    <message>
        <source>Mirrors and copies</source>
        <translation>対称とコピー</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>コピー数</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>左から</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>上から</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::HistoryModel</name>
    <message>
        <source>As far back as is kept</source>
        <translation>残っている最も古い時点</translation>
    </message>
    <message>
        <source>Click: do again up to here</source>
        <translation>クリックでここまでやり直す</translation>
    </message>
    <message>
        <source>Click: go back to this moment</source>
        <translation>クリックでこの時点に戻る</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::HistoryPanel</name>
    <message>
        <source>What was done</source>
        <translation>これまでの操作</translation>
    </message>
    <message>
        <source>What the steps take; &quot;Memory for undo&quot; in the Edit menu says how much they may</source>
        <translation>履歴が使っているメモリー。上限は「編集」メニューの「元に戻すためのメモリー」で決める</translation>
    </message>
    <message>
        <source>%1 of %2 MB</source>
        <translation>%1 / %2 MB</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::IlluminantBox</name>
    <message>
        <source>The light on the easel; the paint stays as it is</source>
        <translation>イーゼルに当たる光。絵具そのものは変わらない</translation>
    </message>
    <message>
        <source>Daylight (D65)</source>
        <translation>昼光 (D65)</translation>
    </message>
    <message>
        <source>Print booth (D50)</source>
        <translation>印刷評価用の光 (D50)</translation>
    </message>
    <message>
        <source>Light bulb (A)</source>
        <translation>電球 (A)</translation>
    </message>
    <message>
        <source>LED lamp</source>
        <translation>LEDランプ</translation>
    </message>
    <message>
        <source>From a file...</source>
        <translation>ファイルから...</translation>
    </message>
    <message>
        <source>Seen in</source>
        <translation>見るときの光</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LaidGuidePart</name>
    <message>
        <source>Guide</source>
        <translation>ガイド</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Snapping strength</source>
        <translation>スナップの強さ</translation>
    </message>
    <message>
        <source>How far the guide draws the brush from where your hand is: 0 not at all, 100 all the way</source>
        <translation>ガイドが筆を手の位置からどこまで引き寄せるか。0 は引き寄せず、100 は完全に引き寄せる</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>What guides your strokes</source>
        <translation>ストロークを導くもの</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>定規</translation>
    </message>
    <message>
        <source>Parallel ruler</source>
        <translation>平行定規</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>楕円</translation>
    </message>
    <message>
        <source>Concentric ellipse</source>
        <translation>同心楕円</translation>
    </message>
    <message>
        <source>1 point perspective</source>
        <translation>1 点透視</translation>
    </message>
    <message>
        <source>2 point perspective</source>
        <translation>2 点透視</translation>
    </message>
    <message>
        <source>3 point perspective</source>
        <translation>3 点透視</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>グリッド</translation>
    </message>
    <message>
        <source>Lies on the canvas</source>
        <translation>キャンバス上</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LayerModel</name>
    <message>
        <source>a group of %1</source>
        <translation>%1 枚のグループ</translation>
    </message>
    <message>
        <source>the layer that you paint on</source>
        <translation>描画中のレイヤー</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>非表示</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>ロック中</translation>
    </message>
    <message>
        <source>opacity %1 %</source>
        <translation>不透明度 %1 %</translation>
    </message>
    <message>
        <source>what is bare is locked</source>
        <translation>絵具のない部分はロック中</translation>
    </message>
    <message>
        <source>clipped to the layer below</source>
        <translation>下のレイヤーでクリッピング中</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LayerPanel</name>
    <message>
        <source>Layers</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Fades what its paint does to light; its relief stays</source>
        <translation>絵具の色を透けさせる。凹凸は残る</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LightDial</name>
    <message>
        <source>Drag the lamp: near the rim it rakes over the relief. Double-click puts it back.
Keys: arrows move it, Home puts it back.</source>
        <translation>ランプをドラッグします。縁に近いほど光が横から差し、凹凸が際立ちます。ダブルクリックで元に戻ります。
キー: 矢印キーで動かし、Homeで元に戻します。</translation>
    </message>
    <message>
        <source>%1° high, from %2°</source>
        <translation>高さ %1°、%2° の方向から</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LightPanel</name>
    <message>
        <source>Seen in</source>
        <translation>見るときの光</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>ランプ</translation>
    </message>
    <message>
        <source>From</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 right, 90 above, 180 left, 270 below</source>
        <translation>光が来る方向。0は右、90は上、180は左、270は下</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Low light rakes over the relief, 90 is overhead</source>
        <translation>低い光は凹凸を際立たせる。90は真上</translation>
    </message>
    <message>
        <source>Even light</source>
        <translation>環境光</translation>
    </message>
    <message>
        <source>The part of the light that comes from all sides; the lamp gives the rest. More of it softens the relief</source>
        <translation>四方から来る光の割合。残りはランプの光。多いほど凹凸がやわらかく見える</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Varnish</source>
        <translation>ワニス</translation>
    </message>
    <message>
        <source>A clear coat to look through, here and in exports; it changes no paint, and can be taken off again</source>
        <translation>上に重ねる透明な膜。画面とエクスポートで見え方だけが変わり、絵具は変わらない。いつでも外せる</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>量</translation>
    </message>
    <message>
        <source>A thin coat evens the gloss only in part</source>
        <translation>薄く塗ると、つやは部分的にしかそろわない</translation>
    </message>
    <message>
        <source>Aged</source>
        <translation>経年変化</translation>
    </message>
    <message>
        <source>Old varnish turns yellow: 100 % is about a century</source>
        <translation>古いワニスは黄ばむ。100 % はおよそ1世紀分</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LoadBar</name>
    <message>
        <source>The paint in the brush, across its width: how full it is, and of which colour</source>
        <translation>ブラシが含む絵具。幅の各部分の量と色</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LoadPanel</name>
    <message>
        <source>On the brush</source>
        <translation>ブラシの絵具</translation>
    </message>
    <message>
        <source>How the brush is dipped, from the next time on</source>
        <translation>次からの絵具の付け方</translation>
    </message>
    <message>
        <source>Full, in one paint</source>
        <translation>1色をたっぷり</translation>
    </message>
    <message>
        <source>Only the tip</source>
        <translation>先端だけ</translation>
    </message>
    <message>
        <source>One paint on each side</source>
        <translation>両側に1色ずつ</translation>
    </message>
    <message>
        <source>Half mixed from two</source>
        <translation>2色を半混ぜで</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>含み</translation>
    </message>
    <message>
        <source>How full the brush is dipped; little leaves a dry brush</source>
        <translation>ブラシに含ませる絵具の量。少ないとかすれたドライブラシになる</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>2色目</translation>
    </message>
    <message>
        <source>The second paint&apos;s share of a half-mixed load</source>
        <translation>半混ぜにするときの2番目の絵具の割合</translation>
    </message>
    <message>
        <source>In hand: %1</source>
        <translation>今の絵具: %1</translation>
    </message>
    <message>
        <source>The second paint of the load: %1</source>
        <translation>ブラシに付ける2番目の絵具: %1</translation>
    </message>
    <message>
        <source>The second paint, laid out for later: %1</source>
        <translation>後で使う2番目の絵具: %1</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>all but empty</source>
        <translation>ほとんど空</translation>
    </message>
    <message>
        <source>%1 % full</source>
        <translation>含み %1 %</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MediumPanel</name>
    <message>
        <source>As it comes</source>
        <translation>標準</translation>
    </message>
    <message>
        <source>Kind of paint</source>
        <translation>絵具の種類</translation>
    </message>
    <message>
        <source>The brush is cleaned, and dipped in paint of this kind</source>
        <translation>ブラシを洗い、この種類の絵具を付ける</translation>
    </message>
    <message>
        <source>Takes back what was changed below</source>
        <translation>下で変えた値を元に戻す</translation>
    </message>
    <message>
        <source>What it is like</source>
        <translation>どんな絵具か</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>Each number of the paint</source>
        <translation>絵具の数値すべて</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MessageBar</name>
    <message>
        <source>What needs your attention</source>
        <translation>注意が必要なこと</translation>
    </message>
    <message>
        <source>Put away</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MessagePanel</name>
    <message>
        <source>Messages</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Nothing has been told yet.</source>
        <translation>まだメッセージはありません。</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>すべてコピー</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>消去</translation>
    </message>
    <message>
        <source>All messages, to be pasted elsewhere</source>
        <translation>すべてのメッセージをコピーして、ほかで貼り付ける</translation>
    </message>
    <message>
        <source>Take all messages off the list</source>
        <translation>リストのメッセージをすべて消す</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MixesPart</name>
    <message>
        <source>Your mixes</source>
        <translation>自分の混色</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前を変更</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Keep as a mix</source>
        <translation>混色として取っておく</translation>
    </message>
    <message>
        <source>Keep the paint in hand as a recipe of tubes, under a name of your own</source>
        <translation>今の絵具を、自分で付けた名前でチューブのレシピとして取っておく</translation>
    </message>
    <message>
        <source>Take the chosen mix away</source>
        <translation>選んだ混色を取り除く</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>書き出す...</translation>
    </message>
    <message>
        <source>Save your mixes and your palette as a file for others</source>
        <translation>自分の混色とパレットを、ほかの人のためのファイルに保存する</translation>
    </message>
    <message>
        <source>Import...</source>
        <translation>読み込む...</translation>
    </message>
    <message>
        <source>Add the mixes and the palette of such a file</source>
        <translation>そうしたファイルの混色とパレットを加える</translation>
    </message>
    <message>
        <source>Paints that you keep are listed here, under names of your own.</source>
        <translation>取っておいた絵具が、自分で付けた名前でここに並びます。</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MousePart</name>
    <message>
        <source>Pressure</source>
        <translation>筆圧</translation>
    </message>
    <message>
        <source>How hard the brush is pressed</source>
        <translation>ブラシを押す強さ</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Lighter the faster it goes</source>
        <translation>速く動かすほど弱く</translation>
    </message>
    <message>
        <source>A slow line is pressed as set above, a fast one down to a quarter of it</source>
        <translation>ゆっくりした線は上で決めた強さ、速い線はその4分の1まで弱くなる</translation>
    </message>
    <message>
        <source>A mouse, or a finger on the screen, does not tell how hard it presses.</source>
        <translation>マウスや画面に触れる指は、押す強さを伝えません。</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::NavigatorMap</name>
    <message>
        <source>The middle of the window is %1 % from the left and %2 % from the top</source>
        <translation>ウィンドウの中心は左から %1 %、上から %2 %</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::NavigatorPanel</name>
    <message>
        <source>The whole canvas</source>
        <translation>キャンバス全体</translation>
    </message>
    <message>
        <source>Drag the frame, or click, to go there
Wheel: closer, farther</source>
        <translation>枠をドラッグ、またはクリックでその場所へ
ホイール: 近づく、離れる</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>ズーム</translation>
    </message>
    <message>
        <source>Screen pixels for a pixel of the saved picture</source>
        <translation>保存される画像の1ピクセルに対する画面のピクセル数</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>How far the canvas is turned, clockwise</source>
        <translation>キャンバスの回転角度、時計回り</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::OpenedPalette</name>
    <message>
        <source>none opened</source>
        <translation>開いていません</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>開く...</translation>
    </message>
    <message>
        <source>Colours of GIMP, Krita or Inkscape, from a .gpl file</source>
        <translation>GIMP、Krita、Inkscapeの色 (.gplファイル)</translation>
    </message>
    <message>
        <source>From a picture...</source>
        <translation>画像から...</translation>
    </message>
    <message>
        <source>Finds the colours that a picture is made of</source>
        <translation>画像を成す色を見つける</translation>
    </message>
    <message>
        <source>Colours of the picture</source>
        <translation>画像の色</translation>
    </message>
    <message>
        <source>How many colours are looked for</source>
        <translation>探す色の数</translation>
    </message>
    <message>
        <source>As recipes of the tubes</source>
        <translation>チューブのレシピとして</translation>
    </message>
    <message>
        <source>A click dips the brush in the nearest mixture of tubes, not in the colour itself</source>
        <translation>クリックすると、その色そのものではなく、チューブで作れる最も近い混色をブラシに付ける</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>ファイルから</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PaceNotice</name>
    <message>
        <source>The paint runs at %1 of its pace.</source>
        <translation>絵具は本来の%1の速さで動いています。</translation>
    </message>
    <message>
        <source>Time runs at %1 of %2 ×.</source>
        <translation>時間は%2 ×の%1で進んでいます。</translation>
    </message>
    <message>
        <source>What helps</source>
        <translation>対処法</translation>
    </message>
    <message>
        <source>What lets the paint keep up again</source>
        <translation>絵具の動きを追いつかせる方法</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PaintPanel</name>
    <message>
        <source>The medium without pigment, for example thinner</source>
        <translation>顔料を含まないメディウム。薄め液など</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>絵具</translation>
    </message>
    <message>
        <source>%1 (%2), %3
As the tool in hand lays it (%4 mm), thinned over white and over black, and with white</source>
        <translation>%1 (%2)、%3
手にした道具で塗った厚さ (%4 mm) の色、白と黒の上に薄く伸ばした色、白を混ぜた色</translation>
    </message>
    <message>
        <source>Put into a set</source>
        <translation>セットに入れる</translation>
    </message>
    <message>
        <source>Take out of this set</source>
        <translation>このセットから外す</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PenButtons</name>
    <message>
        <source>Ends and buttons of pens</source>
        <translation>ペンの端とボタン</translation>
    </message>
    <message>
        <source>Eraser end</source>
        <translation>消しゴム側</translation>
    </message>
    <message>
        <source>Lower button</source>
        <translation>下側のボタン</translation>
    </message>
    <message>
        <source>Upper button</source>
        <translation>上側のボタン</translation>
    </message>
    <message>
        <source>picks up paint</source>
        <translation>絵具を取る</translation>
    </message>
    <message>
        <source>picks the colour seen</source>
        <translation>見えている色を拾う</translation>
    </message>
    <message>
        <source>moves the canvas</source>
        <translation>キャンバスを動かす</translation>
    </message>
    <message>
        <source>opens the palette</source>
        <translation>パレットを開く</translation>
    </message>
    <message>
        <source>does nothing</source>
        <translation>何もしない</translation>
    </message>
    <message>
        <source>takes %1</source>
        <translation>%1 に持ち替える</translation>
    </message>
    <message>
        <source>paints like the tip</source>
        <translation>ペン先と同じように描く</translation>
    </message>
    <message>
        <source>Third button</source>
        <translation>第3ボタン</translation>
    </message>
    <message>
        <source>Wheel forward</source>
        <translation>ホイールを前へ</translation>
    </message>
    <message>
        <source>Wheel back</source>
        <translation>ホイールを後ろへ</translation>
    </message>
    <message>
        <source>Fingers paint</source>
        <translation>指で描く</translation>
    </message>
    <message>
        <source>Otherwise one finger moves the canvas, as two always do</source>
        <translation>オフのときは1本の指でキャンバスを動かします。2本ではいつも動きます</translation>
    </message>
    <message>
        <source>Wet mark</source>
        <translation>濡れた跡</translation>
    </message>
    <message>
        <source>Shows paint under the pen at once, until the paint itself is on the screen</source>
        <translation>絵具そのものが画面に出るまで、ペンの下にすぐ絵具を見せます</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PenDialog</name>
    <message>
        <source>Pen and tablet</source>
        <translation>ペンとタブレット</translation>
    </message>
    <message>
        <source>Pens and mouse</source>
        <translation>ペンとマウス</translation>
    </message>
    <message>
        <source>A pen that is not listed comes here when it touches the sheet below.</source>
        <translation>リストにないペンは、下の用紙に触れるとここに加わります。</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>やわらかめ</translation>
    </message>
    <message>
        <source>A light hand already presses hard</source>
        <translation>軽い力でも強い筆圧になる</translation>
    </message>
    <message>
        <source>As it comes</source>
        <translation>標準</translation>
    </message>
    <message>
        <source>The pressure as the pen tells it, without a curve</source>
        <translation>カーブを使わない、ペンが伝えるままの筆圧</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>かため</translation>
    </message>
    <message>
        <source>Only a heavy hand presses hard</source>
        <translation>力を入れたときだけ強い筆圧になる</translation>
    </message>
    <message>
        <source>From left to right what the pen tells, upwards what the brush is pressed with.</source>
        <translation>横軸はペンが伝える筆圧、縦軸はブラシを押す強さです。</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>消す</translation>
    </message>
    <message>
        <source>Try it here</source>
        <translation>試し書き</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>マウス</translation>
    </message>
    <message>
        <source>Pressure of %1</source>
        <translation>%1 の筆圧</translation>
    </message>
    <message>
        <source>Pressure of the mouse</source>
        <translation>マウスの筆圧</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PenPad</name>
    <message>
        <source>Sheet to try the pen on</source>
        <translation>ペンの試し書き用紙</translation>
    </message>
    <message>
        <source>Scribble here with a pen or the mouse</source>
        <translation>ペンやマウスで自由に描いてみてください</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PictureBoard</name>
    <message>
        <source>no picture</source>
        <translation>画像なし</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 ピクセル</translation>
    </message>
    <message>
        <source>A picture that you choose to trace lies here, to look at and to pick colours from, and below the paint.</source>
        <translation>なぞるために選んだ画像がここに置かれ、見たり色を拾ったりできます。絵具の下にも表示されます。</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PopupPalette</name>
    <message>
        <source>Pop-up palette</source>
        <translation>ポップアップパレット</translation>
    </message>
    <message>
        <source>A narrower brush</source>
        <translation>ブラシを細くする</translation>
    </message>
    <message>
        <source>A wider brush</source>
        <translation>ブラシを太くする</translation>
    </message>
    <message>
        <source>%1: take this one, and put the other here</source>
        <translation>%1: この絵具に持ち替え、今の絵具をここに置く</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PresetPageView</name>
    <message>
        <source>%1: as the tool is saved</source>
        <translation>%1: 保存した道具の値に戻す</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::RecorderPanel</name>
    <message>
        <source>Strokes</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Painting time</source>
        <translation>制作時間</translation>
    </message>
    <message>
        <source>Recorded so far</source>
        <translation>これまでの記録</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ReferencePanel</name>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>How strongly the chosen picture shows</source>
        <translation>選んだ画像の見え方の強さ</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>Above the next picture (PgUp)</source>
        <translation>次の画像の上へ (PgUp)</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>下へ</translation>
    </message>
    <message>
        <source>Below the picture under it (PgDown)</source>
        <translation>下の画像のさらに下へ (PgDown)</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>反転</translation>
    </message>
    <message>
        <source>Left and right change sides</source>
        <translation>左右を入れ替える</translation>
    </message>
    <message>
        <source>Greys</source>
        <translation>グレー</translation>
    </message>
    <message>
        <source>Shown in greys as light as its colours</source>
        <translation>色と同じ明るさのグレーで表示する</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>外す</translation>
    </message>
    <message>
        <source>Take the chosen picture off the board (Del)</source>
        <translation>選んだ画像をボードから外す (Del)</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ReferenceView</name>
    <message>
        <source>Board of references</source>
        <translation>参考画像のボード</translation>
    </message>
    <message>
        <source>Drag: move a picture, scale it by a corner, turn it by the ring
Control and click: paint of that colour
Wheel: closer, farther; with Shift it turns the picture
Double click, 0: all of it</source>
        <translation>ドラッグ: 画像を動かす。角で拡大・縮小、輪で回転
Ctrl+クリック: その色の絵具を作る
ホイール: 近づく、離れる。Shift を押すと画像を回す
ダブルクリック、0: 全体を表示</translation>
    </message>
    <message>
        <source>pictures: %1</source>
        <translation>画像: %1</translation>
    </message>
    <message>
        <source>pictures: %1; chosen: %2</source>
        <translation>画像: %1、選択中: %2</translation>
    </message>
    <message>
        <source>Drag pictures here, to look at them and pick their colours while you paint.</source>
        <translation>ここに画像をドラッグすると、描きながら見たり色を拾ったりできます。</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::StatusReadings</name>
    <message>
        <source>The pen&apos;s place on the canvas, from its upper left corner</source>
        <translation>ペンのキャンバス上の位置。左上の角から測る</translation>
    </message>
    <message>
        <source>Tools keep to what is outlined; Ctrl+A ends the selection, Esc goes back to painting</source>
        <translation>ツールは輪郭の中だけに効く。Ctrl+Aで選択を解除、Escで描画に戻る</translation>
    </message>
    <message>
        <source>Memory that the program holds: the painting, its history and its pictures</source>
        <translation>プログラムが使っているメモリー。作品、履歴、画像を含む</translation>
    </message>
    <message>
        <source>Size of the canvas and of its saved picture</source>
        <translation>キャンバスと、保存される画像の大きさ</translation>
    </message>
    <message>
        <source>What the canvas shows; Alt+1 shows it in its light again</source>
        <translation>キャンバスの表示方法。Alt+1で光を当てた表示に戻る</translation>
    </message>
    <message>
        <source>How the canvas stands on the screen; 5 puts it upright, M mirrors it</source>
        <translation>画面でのキャンバスの向き。5で正位置に戻し、Mで左右反転</translation>
    </message>
    <message>
        <source>Screen pixels for a pixel of the saved picture</source>
        <translation>保存される画像の1ピクセルに対する画面のピクセル数</translation>
    </message>
    <message>
        <source>%1 × %2 mm   %3 × %4 px</source>
        <translation>%1 × %2 mm   %3 × %4 px</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>左右反転</translation>
    </message>
    <message>
        <source>turned %1°</source>
        <translation>%1° 回転</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>一時停止中</translation>
    </message>
    <message>
        <source>paint at rest</source>
        <translation>絵具は静止</translation>
    </message>
    <message>
        <source>%1 × time</source>
        <translation>%1 倍速</translation>
    </message>
    <message>
        <source>%1 % selected</source>
        <translation>%1 % を選択中</translation>
    </message>
    <message>
        <source>Paint time against the clock: less than you set where there is more wet paint than this computer can move in time</source>
        <translation>実際の時間に対する絵具の時間。濡れた絵具が多く、計算が追いつかないときは設定より遅くなる</translation>
    </message>
    <message>
        <source>Whether paint still moves, and how much of its time this computer works on it</source>
        <translation>絵具がまだ動いているか、このコンピューターがその計算にどれだけ時間を使っているか</translation>
    </message>
    <message>
        <source>paint moving, %1 % busy</source>
        <translation>絵具が動いています、負荷 %1 %</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::StrokeStrip</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ThinningSlider</name>
    <message>
        <source>Paint : medium, from paste to stain. To the right the paint is thinned: it runs sooner, and lets through what lies below</source>
        <translation>絵具 : メディウム。ペーストからステインまで。右へ動かすほどうすまり、流れやすくなって下の層が透ける</translation>
    </message>
    <message>
        <source>Paint : medium</source>
        <translation>絵具 : メディウム</translation>
    </message>
    <message>
        <source>Paint : medium, from paste to stain. Upwards the paint is thinned: it runs sooner, and lets through what lies below</source>
        <translation>絵具 : メディウム。ペーストからステインまで。上へ動かすほどうすまり、流れやすくなって下の層が透ける</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TiltDial</name>
    <message>
        <source>Drag to tilt the canvas: the paint runs towards the knob. Double-click lays it flat.
Keys: arrows tilt it, Home lays it flat.</source>
        <translation>ドラッグでキャンバスを傾けます。絵具はつまみの方へ流れます。ダブルクリックで水平に戻ります。
キー: 矢印キーで傾け、Homeで水平に戻します。</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>%1° steep, down is at %2°</source>
        <translation>傾き %1°、下は %2° の方向</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TracingPanel</name>
    <message>
        <source>Picture to trace</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>Click: paint of that colour
Wheel: closer, farther
Drag: move the picture
0: all of it</source>
        <translation>クリック: その色の絵具を作る
ホイール: 近づく、離れる
ドラッグ: 画像を動かす
0: 全体を表示</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>How strongly it shows below the paint</source>
        <translation>絵具の下での見え方の強さ</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>左から</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>上から</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Its height follows in proportion</source>
        <translation>高さは比率を保って変わる</translation>
    </message>
    <message>
        <source>Where its left edge lies on the canvas</source>
        <translation>左端のキャンバス上の位置</translation>
    </message>
    <message>
        <source>Where its upper edge lies on the canvas</source>
        <translation>上端のキャンバス上の位置</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TubeMenu</name>
    <message>
        <source>Which tubes are shown: all of them, or a set of yours</source>
        <translation>どのチューブを見せるか。すべて、または自分のセット</translation>
    </message>
    <message>
        <source>All tubes</source>
        <translation>全チューブ</translation>
    </message>
    <message>
        <source>Save as a set...</source>
        <translation>セットとして保存...</translation>
    </message>
    <message>
        <source>Rename the set...</source>
        <translation>セットの名前を変更...</translation>
    </message>
    <message>
        <source>Remove the set</source>
        <translation>セットを削除</translation>
    </message>
    <message>
        <source>Squeeze these onto the mixing well</source>
        <translation>これらを混色皿に絞り出す</translation>
    </message>
    <message>
        <source>Import sets...</source>
        <translation>セットを読み込む...</translation>
    </message>
    <message>
        <source>Export my sets...</source>
        <translation>自分のセットを書き出す...</translation>
    </message>
    <message>
        <source>Squeeze out the last painting&apos;s palette</source>
        <translation>前の絵のパレットを絞り出す</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::WorkProgress</name>
    <message>
        <source>%p %</source>
        <translation>%p %</translation>
    </message>
</context>
<context>
    <name>pastoso::screen::GlScreen</name>
    <message>
        <source>There is no OpenGL any more to draw the canvas with.</source>
        <translation>キャンバスを描く OpenGL が使えなくなりました。</translation>
    </message>
</context>
<context>
    <name>pastoso::screens</name>
    <message>
        <source>All commands and their keys</source>
        <translation>すべてのコマンドとキー</translation>
    </message>
    <message>
        <source>In the order of the menus. &quot;Keys&quot; in the &quot;Settings&quot; menu changes them ([how](settings.md#keys)). This page is printed by the program; `packaging/screens.sh --manual` prints it anew.</source>
        <translation>メニューの順に並んでいます。「設定」メニューの「キーの割り当て」で変えられます（[変え方](settings.md#keys)）。このページはプログラムが出力したもので、`packaging/screens.sh --manual`で出力し直せます。</translation>
    </message>
    <message>
        <source>command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>like Krita</source>
        <translation>Krita風</translation>
    </message>
    <message>
        <source>like Photoshop</source>
        <translation>Photoshop風</translation>
    </message>
    <message>
        <source>does</source>
        <translation>はたらき</translation>
    </message>
</context>
<context>
    <name>pastoso::start::ExamplesSection</name>
    <message>
        <source>Examples, painted before your eyes</source>
        <translation>目の前で描かれていく作例</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>作例</translation>
    </message>
    <message>
        <source>Watch how it is painted, stroke by stroke, and paint on</source>
        <translation>一筆ずつ描かれる様子を見て、続きを描ける</translation>
    </message>
</context>
<context>
    <name>pastoso::start::NewCanvasSection</name>
    <message>
        <source>New canvas</source>
        <translation>新規キャンバス</translation>
    </message>
    <message>
        <source>Sizes of a new canvas</source>
        <translation>新規キャンバスのサイズ</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>横長</translation>
    </message>
    <message>
        <source>Wider than high</source>
        <translation>幅が高さより大きい</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>縦長</translation>
    </message>
    <message>
        <source>Higher than wide</source>
        <translation>高さが幅より大きい</translation>
    </message>
    <message>
        <source>More...</source>
        <translation>その他...</translation>
    </message>
    <message>
        <source>Any size</source>
        <translation>好きなサイズ</translation>
    </message>
    <message>
        <source>Choose width, height, resolution and support yourself</source>
        <translation>幅、高さ、解像度、支持体を自分で決める</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, %4 px/mm</source>
        <translation>%1、%2 × %3 ピクセル、%4 px/mm</translation>
    </message>
</context>
<context>
    <name>pastoso::start::PaintingReader</name>
    <message>
        <source>This file is not there any more.</source>
        <translation>このファイルはもうありません。</translation>
    </message>
    <message>
        <source>This file cannot be read.</source>
        <translation>このファイルは読み込めません。</translation>
    </message>
</context>
<context>
    <name>pastoso::start::RecentSection</name>
    <message>
        <source>Today, %1</source>
        <translation>今日 %1</translation>
    </message>
    <message>
        <source>Yesterday, %1</source>
        <translation>昨日 %1</translation>
    </message>
    <message>
        <source>Recent paintings</source>
        <translation>最近の作品</translation>
    </message>
    <message>
        <source>Open a file...</source>
        <translation>ファイルを開く...</translation>
    </message>
    <message>
        <source>Paintings that you save will stand here.</source>
        <translation>保存した作品がここに並びます。</translation>
    </message>
</context>
<context>
    <name>pastoso::start::StartPage</name>
    <message>
        <source>Show this page at start</source>
        <translation>起動時にこのページを表示</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>スタートページ</translation>
    </message>
    <message>
        <source>Esc closes it; &quot;Start page&quot; in the &quot;File&quot; menu brings it back.</source>
        <translation>Escで閉じます。「ファイル」メニューの「スタートページ」でまた開けます。</translation>
    </message>
    <message>
        <source>Back to the painting</source>
        <translation>作品に戻る</translation>
    </message>
    <message>
        <source>Start painting</source>
        <translation>描き始める</translation>
    </message>
    <message>
        <source>The painting stands on the easel as you left it.</source>
        <translation>作品は前のままイーゼルに置いてあります。</translation>
    </message>
    <message>
        <source>A canvas of %1, %2, is ready. You can also just paint on it.</source>
        <translation>%1、%2のキャンバスを用意しました。そのまま描き始めることもできます。</translation>
    </message>
</context>
<context>
    <name>pastoso::start::UnfinishedSection</name>
    <message>
        <source>Not closed last time</source>
        <translation>前回閉じられなかった作品</translation>
    </message>
    <message>
        <source>Choose or discard...</source>
        <translation>選択または破棄...</translation>
    </message>
    <message>
        <source>All paintings that were left unfinished</source>
        <translation>描きかけのまま残っているすべての作品</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>復元</translation>
    </message>
</context>
<context>
    <name>pastoso::tools</name>
    <message>
        <source>PNG, 8 bits</source>
        <translation>PNG、8ビット</translation>
    </message>
    <message>
        <source>PNG, 16 bits</source>
        <translation>PNG、16ビット</translation>
    </message>
    <message>
        <source>JPEG</source>
        <translation>JPEG</translation>
    </message>
    <message>
        <source>TIFF, 8 bits</source>
        <translation>TIFF、8ビット</translation>
    </message>
    <message>
        <source>TIFF, 16 bits</source>
        <translation>TIFF、16ビット</translation>
    </message>
    <message>
        <source>TIFF, 32 bits of linear light</source>
        <translation>TIFF、32ビット、リニア</translation>
    </message>
    <message>
        <source>WebP</source>
        <translation>WebP</translation>
    </message>
    <message>
        <source>OpenEXR, linear light</source>
        <translation>OpenEXR、リニア</translation>
    </message>
    <message>
        <source>PNG, 8 bits, heights in 16</source>
        <translation>PNG、8ビット、高さは16ビット</translation>
    </message>
    <message>
        <source>TIFF, 32 bits, heights in mm</source>
        <translation>TIFF、32ビット、高さは mm</translation>
    </message>
    <message>
        <source>OpenEXR, heights in mm</source>
        <translation>OpenEXR、高さは mm</translation>
    </message>
    <message>
        <source>STL</source>
        <translation>STL</translation>
    </message>
    <message>
        <source>PLY</source>
        <translation>PLY</translation>
    </message>
    <message>
        <source>Wavefront OBJ</source>
        <translation>Wavefront OBJ</translation>
    </message>
    <message>
        <source>Numbered pictures, PNG of 8 bits</source>
        <translation>連番画像、8ビットPNG</translation>
    </message>
    <message>
        <source>Numbered pictures, PNG of 16 bits</source>
        <translation>連番画像、16ビットPNG</translation>
    </message>
    <message>
        <source>Video, MP4</source>
        <translation>動画、MP4</translation>
    </message>
    <message>
        <source>Video, Matroska</source>
        <translation>動画、Matroska</translation>
    </message>
    <message>
        <source>Video, WebM</source>
        <translation>動画、WebM</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>赤</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>緑</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>青</translation>
    </message>
    <message>
        <source>Hue, degrees</source>
        <translation>色相（度）</translation>
    </message>
    <message>
        <source>Saturation, %</source>
        <translation>彩度（%）</translation>
    </message>
    <message>
        <source>Value, %</source>
        <translation>明度（%）</translation>
    </message>
    <message>
        <source>Lightness as it is seen, %</source>
        <translation>見た目の明るさ（%）</translation>
    </message>
    <message>
        <source>Chroma: how far from grey</source>
        <translation>クロマ：灰色からの離れ具合</translation>
    </message>
</context>
<context>
    <name>pastoso::view::LookLegend</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Wet paint</source>
        <translation>濡れた絵具</translation>
    </message>
    <message>
        <source>Height of the paint</source>
        <translation>絵具の高さ</translation>
    </message>
    <message>
        <source>Slopes of the surface</source>
        <translation>表面の傾き</translation>
    </message>
    <message>
        <source>Flat colour</source>
        <translation>色のみ</translation>
    </message>
</context>
<context>
    <name>std</name>
    <message>
        <source>Stroke in the mixing well</source>
        <translation>混色皿でのストローク</translation>
    </message>
    <message>
        <source>Canvas mirrored</source>
        <translation>キャンバスの反転</translation>
    </message>
    <message>
        <source>Canvas turned</source>
        <translation>キャンバスの回転</translation>
    </message>
    <message>
        <source>Masking tape</source>
        <translation>マスキングテープ</translation>
    </message>
    <message>
        <source>Masking peeled off</source>
        <translation>マスキングを剥がす</translation>
    </message>
</context>
</TS>
