<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_TW" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>Painting with thick wet paint</source>
        <translation>用厚而未乾的顏料作畫</translation>
    </message>
    <message>
        <source>The Pastoso authors</source>
        <translation>Pastoso 的作者</translation>
    </message>
    <message>
        <source>Free software: you may use, study, share and change it under the GNU General Public License, version 3 or later. It comes without any warranty.</source>
        <translation>自由軟體：您可以依 GNU 通用公共授權條款第 3 版或更新版本使用、研究、分享及修改。不附任何擔保。</translation>
    </message>
</context>
<context>
    <name>CanvasChoices</name>
    <message>
        <source>Small study</source>
        <translation>小型習作</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>正方形</translation>
    </message>
    <message>
        <source>Small canvas</source>
        <translation>小畫布</translation>
    </message>
    <message>
        <source>Large canvas</source>
        <translation>大畫布</translation>
    </message>
    <message>
        <source>Screen, HD</source>
        <translation>HD 螢幕</translation>
    </message>
    <message>
        <source>Screen, QHD</source>
        <translation>QHD 螢幕</translation>
    </message>
    <message>
        <source>Linen</source>
        <translation>亞麻布</translation>
    </message>
    <message>
        <source>coarse weave</source>
        <translation>粗織紋</translation>
    </message>
    <message>
        <source>Cotton duck</source>
        <translation>棉帆布</translation>
    </message>
    <message>
        <source>fine weave</source>
        <translation>細織紋</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>木板</translation>
    </message>
    <message>
        <source>smooth gesso</source>
        <translation>光滑打底</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>an image</source>
        <translation>圖片</translation>
    </message>
    <message>
        <source>Medium linen</source>
        <translation>中等亞麻布</translation>
    </message>
    <message>
        <source>lively weave with slubs</source>
        <translation>帶粗節的生動織紋</translation>
    </message>
    <message>
        <source>Fine portrait linen</source>
        <translation>細緻肖像亞麻布</translation>
    </message>
    <message>
        <source>Rough jute</source>
        <translation>粗黃麻布</translation>
    </message>
    <message>
        <source>fine even weave</source>
        <translation>細密均勻的織紋</translation>
    </message>
    <message>
        <source>Gesso panel</source>
        <translation>石膏底板</translation>
    </message>
    <message>
        <source>brushed gesso</source>
        <translation>刷塗石膏</translation>
    </message>
</context>
<context>
    <name>Engine</name>
    <message>
        <source>&quot;%1&quot; holds no picture and is left out.</source>
        <translation>「%1」不含圖片，已略過。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2, but must lie between %3 and %4.</source>
        <translation>「%1」為 %2，但必須介於 %3 和 %4 之間。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is known in millimetres only; in cells describe a &quot;weave&quot;.</source>
        <translation>「%1」只能以公釐為單位；以格為單位時請描述「weave」。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is needed on the canvas itself.</source>
        <translation>「%1」在畫布上另有用途。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither &quot;once&quot; nor &quot;reflected&quot;.</source>
        <translation>「%1」不是「once」，也不是「reflected」。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither K nor S.</source>
        <translation>「%1」既不是 K 也不是 S。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no form of a shape; there are %2.</source>
        <translation>「%1」不是形狀的形式；可用的有 %2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tool that an eraser end can take.</source>
        <translation>「%1」不是橡皮擦端可以拿的工具。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none of &quot;particles&quot;, &quot;level_set&quot;, &quot;upwind_level_set&quot; and &quot;particle_level_set&quot;.</source>
        <translation>「%1」不是「particles」、「level_set」、「upwind_level_set」或「particle_level_set」。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none of %2.</source>
        <translation>「%1」不屬於以下任何一個：%2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a colour such as #783c14.</source>
        <translation>「%1」不是像 #783c14 這樣的顏色。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a colour; a colour is # and six hexadecimal digits, for example #c03020.</source>
        <translation>「%1」不是顏色；顏色是 # 加六個十六進位數字，例如 #c03020。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a finite number.</source>
        <translation>「%1」不是有限的數字。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a key such as Ctrl+Shift+Z.</source>
        <translation>「%1」不是像 Ctrl+Shift+Z 這樣的按鍵。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number.</source>
        <translation>「%1」不是數字。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a wavelength in nm and a power with one comma.</source>
        <translation>「%1」不是以一個逗號分隔的波長（nm）和功率。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not one of %2.</source>
        <translation>「%1」不屬於以下任何一個：%2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the key of %2 already.</source>
        <translation>「%1」已經是 %2 的按鍵。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the name of no command.</source>
        <translation>沒有名為「%1」的指令。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands here twice.</source>
        <translation>「%1」在這裡出現了兩次。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands once for the whole file.</source>
        <translation>「%1」由整個檔案共用，只能寫一次。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was laid over the others by %2 and is laid over them as paint.</source>
        <translation>「%1」原以 %2 疊在其他圖層上，現改為像顏料一樣疊上。</translation>
    </message>
    <message>
        <source>&quot;endloop&quot; is missing before %1.</source>
        <translation>%1 之前缺少「endloop」。</translation>
    </message>
    <message>
        <source>&quot;tilt&quot; and &quot;gravity&quot; say the same; give one of them.</source>
        <translation>「tilt」和「gravity」的意思相同；請只提供其中一個。</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; is not a finite number.</source>
        <translation>%1「%2」不是有限的數字。</translation>
    </message>
    <message>
        <source>%1 (&quot;%2&quot;)</source>
        <translation>%1（「%2」）</translation>
    </message>
    <message>
        <source>%1 (&quot;%2&quot;): the field &quot;family&quot; is missing.</source>
        <translation>%1（「%2」）：缺少欄位「family」。</translation>
    </message>
    <message>
        <source>%1 (&quot;%2&quot;): thinned_with is &quot;%3&quot;, it must be the name of another medium here.</source>
        <translation>%1（「%2」）：thinned_with 為「%3」，必須是此處另一種媒材的名稱。</translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation>%1（%2）。</translation>
    </message>
    <message>
        <source>%1 Not read: %2</source>
        <translation>%1 未讀取：%2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>%1 does not belong in an STL file.</source>
        <translation>%1 不屬於 STL 檔案。</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which cannot set &quot;%3&quot;.</source>
        <translation>%1 為「%2」，無法控制「%3」。</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which is none of: %3.</source>
        <translation>%1 為「%2」，不屬於以下任何一個：%3。</translation>
    </message>
    <message>
        <source>%1 is %2 in cell (%3, %4), but must lie between 0 and %5 (cells count from 0 at the upper left).</source>
        <translation>格 (%3, %4) 的%1為 %2，但必須介於 0 和 %5 之間（格從左上角的 0 起算）。</translation>
    </message>
    <message>
        <source>%1 is %2, it must be a number from %3 to %4.</source>
        <translation>%1 為 %2，必須是 %3 到 %4 的數字。</translation>
    </message>
    <message>
        <source>%1 is %2, it must be a text.</source>
        <translation>%1 為 %2，必須是文字。</translation>
    </message>
    <message>
        <source>%1 is %2, more than the length, %3.</source>
        <translation>%1 為 %2，超過長度 %3。</translation>
    </message>
    <message>
        <source>%1 is %2, not between %3 and %4.</source>
        <translation>%1（%2）不在 %3 和 %4 之間。</translation>
    </message>
    <message>
        <source>%1 is %2, outside %3 to %4.</source>
        <translation>%1 為 %2，超出 %3 到 %4 的範圍。</translation>
    </message>
    <message>
        <source>%1 is %2, so that more than 100000 drops a second would fall.</source>
        <translation>%1 為 %2，這樣每秒會落下超過 100000 滴。</translation>
    </message>
    <message>
        <source>%1 is %2, whose input is not above that of the point before it.</source>
        <translation>%1 為 %2，其輸入值沒有大於前一個點。</translation>
    </message>
    <message>
        <source>%1 is a file; numbered pictures go into a folder.</source>
        <translation>%1 是檔案；連號圖片需要放在資料夾裡。</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1 是空的。</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>缺少 %1。</translation>
    </message>
    <message>
        <source>%1 is no corner of a face.</source>
        <translation>%1 不是面的角點。</translation>
    </message>
    <message>
        <source>%1 is no number.</source>
        <translation>%1 不是數字。</translation>
    </message>
    <message>
        <source>%1 is not a field of a brush preset (value %2).</source>
        <translation>%1 不是筆刷預設的欄位（值為 %2）。</translation>
    </message>
    <message>
        <source>%1 is not a list of %2 numbers.</source>
        <translation>%1不是含有 %2 個數字的清單。</translation>
    </message>
    <message>
        <source>%1 is not above 0 and at most %2.</source>
        <translation>%1 不是大於 0 且最多 %2。</translation>
    </message>
    <message>
        <source>%1 is not between %2 and %3.</source>
        <translation>%1 不在 %2 和 %3 之間。</translation>
    </message>
    <message>
        <source>%1 is not finite in single precision.</source>
        <translation>%1 以單精度表示時不是有限值。</translation>
    </message>
    <message>
        <source>%1 is not from %2 to %3.</source>
        <translation>%1 不在 %2 到 %3 之間。</translation>
    </message>
    <message>
        <source>%1 must be a list, not %2.</source>
        <translation>%1 必須是清單，而不是 %2。</translation>
    </message>
    <message>
        <source>%1 must be a number, not %2.</source>
        <translation>%1 必須是數字，而不是 %2。</translation>
    </message>
    <message>
        <source>%1 must be a text, not %2.</source>
        <translation>%1 必須是文字，而不是 %2。</translation>
    </message>
    <message>
        <source>%1 must be a whole number, not %2.</source>
        <translation>%1 必須是整數，而不是 %2。</translation>
    </message>
    <message>
        <source>%1 must be an object, not %2.</source>
        <translation>%1 必須是物件，而不是 %2。</translation>
    </message>
    <message>
        <source>%1 must be true or false, not %2.</source>
        <translation>%1 必須是 true 或 false，而不是 %2。</translation>
    </message>
    <message>
        <source>%1 must be two numbers, not %2.</source>
        <translation>%1 必須是兩個數字，而不是 %2。</translation>
    </message>
    <message>
        <source>%1 must have 1 to %2 points, not %3.</source>
        <translation>%1 必須有 1 到 %2 個點，而不是 %3 個。</translation>
    </message>
    <message>
        <source>%1 names %2 %3, but %4 were given until here.</source>
        <translation>%1 指向%2 %3，但到此處為止只有 %4 個。</translation>
    </message>
    <message>
        <source>%1 needs about %2; %3 of memory are free.</source>
        <translation>%1約需要 %2；可用記憶體為 %3。</translation>
    </message>
    <message>
        <source>%1 normal</source>
        <translation>%1 的法線</translation>
    </message>
    <message>
        <source>%1 of the pigment &quot;%2&quot; is given twice.</source>
        <translation>色料「%2」的 %1 出現兩次。</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 或 %2</translation>
    </message>
    <message>
        <source>%1 per mm is negative.</source>
        <translation>每 mm %1 是負數。</translation>
    </message>
    <message>
        <source>%1 position</source>
        <translation>%1 的位置</translation>
    </message>
    <message>
        <source>%1 triangles take %2 bytes, but the file has %3.</source>
        <translation>%1 個三角形需要 %2 位元組，但檔案有 %3 位元組。</translation>
    </message>
    <message>
        <source>%1 x %2 cells need about %3; %4 of memory are free.</source>
        <translation>%1 x %2 格約需要 %3；可用記憶體為 %4。</translation>
    </message>
    <message>
        <source>%1, %2 nm: %3 is not a number.</source>
        <translation>%1，%2 nm：%3 不是數字。</translation>
    </message>
    <message>
        <source>%1, %2 nm: the weight %3 is negative.</source>
        <translation>%1，%2 nm：權重 %3 是負數。</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1，%2：%3</translation>
    </message>
    <message>
        <source>%1, byte %2</source>
        <translation>%1，位元組 %2</translation>
    </message>
    <message>
        <source>%1, byte %2: %3</source>
        <translation>%1，位元組 %2：%3</translation>
    </message>
    <message>
        <source>%1, entry %2</source>
        <translation>%1，第 %2 項</translation>
    </message>
    <message>
        <source>%1, event %2: %3</source>
        <translation>%1，事件 %2：%3</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1，第 %2 行：%3</translation>
    </message>
    <message>
        <source>%1, line %2: this is not JSON, or it is cut off here.</source>
        <translation>%1，第 %2 行：這不是 JSON，或內容在此中斷。</translation>
    </message>
    <message>
        <source>%1, line %2: this is not valid JSON.</source>
        <translation>%1，第 %2 行：這不是有效的 JSON。</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a list of %3 bands.</source>
        <translation>%1：「%2」不是含有 %3 個波段的清單。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; stands there twice.</source>
        <translation>%1：「%2」出現兩次。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2 files do not hold %3-bit pictures.</source>
        <translation>%1：%2 檔案不能儲存 %3 位元的圖片。</translation>
    </message>
    <message>
        <source>%1: %2 files do not hold %3.</source>
        <translation>%1：%2 檔案不能儲存這種圖片：%3。</translation>
    </message>
    <message>
        <source>%1: %2 files hold at most %3 pixels a side; this picture has %4 x %5.</source>
        <translation>%1：%2 檔案每邊最多 %3 像素；這張圖片為 %4 x %5。</translation>
    </message>
    <message>
        <source>%1: %2 of the pigment &quot;%3&quot; is %4 per mm in band %5 of %6, above the %7 that paint can have; give the pigment in a weaker paint.</source>
        <translation>%1：色料「%3」的 %2 在第 %5 個波段（共 %6 個）為每 mm %4，超過顏料可能的上限 %7；請以較淡的顏料提供這種色料。</translation>
    </message>
    <message>
        <source>%1: %2 x %3 pixels are more than the %4 a side that a PSD file holds.</source>
        <translation>%1：%2 x %3 像素超過 PSD 檔案每邊 %4 像素的上限。</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1：%2。</translation>
    </message>
    <message>
        <source>%1: 32 bits a channel hold linear light, which needs no ICC profile.</source>
        <translation>%1：每色版 32 位元儲存的是線性光，不需要 ICC 描述檔。</translation>
    </message>
    <message>
        <source>%1: a PSD file of these layers would be larger than 2 GB.</source>
        <translation>%1：由這些圖層組成的 PSD 檔案會大於 2 GB。</translation>
    </message>
    <message>
        <source>%1: a batch begins at an action or tick that cannot be.</source>
        <translation>%1：有一個批次的起始動作或 tick 不可能存在。</translation>
    </message>
    <message>
        <source>%1: a batch is too short.</source>
        <translation>%1：有一個批次太短。</translation>
    </message>
    <message>
        <source>%1: a copy in layers is saved as .ora or .psd; this name ends in neither.</source>
        <translation>%1：含圖層的副本要存成 .ora 或 .psd；這個檔名的結尾都不是。</translation>
    </message>
    <message>
        <source>%1: a mesh is read from .obj or .stl; this name ends otherwise.</source>
        <translation>%1：網格要從 .obj 或 .stl 讀取；這個檔名的結尾不符。</translation>
    </message>
    <message>
        <source>%1: a picture is saved as .png, .tif, .jpg, .webp or .exr; this name ends in none of them.</source>
        <translation>%1：圖片要存成 .png、.tif、.jpg、.webp 或 .exr；這個檔名的結尾都不是。</translation>
    </message>
    <message>
        <source>%1: a relief is saved as .stl, .ply or .obj; this name ends in none of them.</source>
        <translation>%1：浮雕要存成 .stl、.ply 或 .obj；這個檔名的結尾都不是。</translation>
    </message>
    <message>
        <source>%1: a relief is saved as .stl, .ply or .obj; this name ends otherwise.</source>
        <translation>%1：浮雕要存成 .stl、.ply 或 .obj；這個檔名的結尾不符。</translation>
    </message>
    <message>
        <source>%1: a scene is saved as .pbrt; this name ends otherwise.</source>
        <translation>%1：場景要存成 .pbrt；這個檔名的結尾不符。</translation>
    </message>
    <message>
        <source>%1: a surface is saved as .obj, .ply, .stl or .pbrt; this name ends otherwise.</source>
        <translation>%1：表面要存成 .obj、.ply、.stl 或 .pbrt；這個檔名的結尾不符。</translation>
    </message>
    <message>
        <source>%1: a video is made by the program ffmpeg, which is not installed; a folder&apos;s name instead gives numbered pictures.</source>
        <translation>%1：影片由 ffmpeg 程式製作，但沒有安裝；改填資料夾名稱則會產生連號圖片。</translation>
    </message>
    <message>
        <source>%1: a video is saved as .mp4, .mkv or .webm, and a folder&apos;s name has no ending.</source>
        <translation>%1：影片要存成 .mp4、.mkv 或 .webm，資料夾名稱則沒有副檔名。</translation>
    </message>
    <message>
        <source>%1: a volume is saved as .vdb; this name ends otherwise.</source>
        <translation>%1：體積資料要存成 .vdb；這個檔名的結尾不符。</translation>
    </message>
    <message>
        <source>%1: another program is at it.</source>
        <translation>%1：另一個程式正在使用。</translation>
    </message>
    <message>
        <source>%1: band %2 of &quot;%3&quot;</source>
        <translation>%1：「%3」的第 %2 個波段</translation>
    </message>
    <message>
        <source>%1: cannot be created (%2).</source>
        <translation>%1：無法建立（%2）。</translation>
    </message>
    <message>
        <source>%1: cannot be opened (%2).</source>
        <translation>%1：無法開啟（%2）。</translation>
    </message>
    <message>
        <source>%1: cannot be read (%2).</source>
        <translation>%1：無法讀取（%2）。</translation>
    </message>
    <message>
        <source>%1: cannot be read to its end.</source>
        <translation>%1：無法讀到結尾。</translation>
    </message>
    <message>
        <source>%1: cannot be removed (%2).</source>
        <translation>%1：無法移除（%2）。</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2).</source>
        <translation>%1：無法寫入（%2）。</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2); what is painted now can be saved, but not recovered.</source>
        <translation>%1：無法寫入（%2）；現在畫的內容可以儲存，但無法救回。</translation>
    </message>
    <message>
        <source>%1: cannot be written, since this program was built without OpenVDB.</source>
        <translation>%1：無法寫入，因為這個程式建置時不含 OpenVDB。</translation>
    </message>
    <message>
        <source>%1: does not say what was painted on.</source>
        <translation>%1：沒有記錄是畫在什麼上面。</translation>
    </message>
    <message>
        <source>%1: expected the name of a pigment.</source>
        <translation>%1：應為色料的名稱。</translation>
    </message>
    <message>
        <source>%1: ffmpeg cannot be started (%2).</source>
        <translation>%1：無法啟動 ffmpeg（%2）。</translation>
    </message>
    <message>
        <source>%1: ffmpeg cannot make the video (%2).</source>
        <translation>%1：ffmpeg 無法製作影片（%2）。</translation>
    </message>
    <message>
        <source>%1: holds a number that is too large (%2).</source>
        <translation>%1：含有太大的數字（%2）。</translation>
    </message>
    <message>
        <source>%1: holds a number that is too large.</source>
        <translation>%1：含有太大的數字。</translation>
    </message>
    <message>
        <source>%1: holds an ICC profile for %2, but the picture&apos;s values are red, green and blue.</source>
        <translation>%1：含有 %2 的 ICC 描述檔，但圖片的值是紅、綠、藍。</translation>
    </message>
    <message>
        <source>%1: holds an ICC profile that cannot be applied (%2).</source>
        <translation>%1：含有無法套用的 ICC 描述檔（%2）。</translation>
    </message>
    <message>
        <source>%1: holds an ICC profile that is none (%2).</source>
        <translation>%1：含有無效的 ICC 描述檔（%2）。</translation>
    </message>
    <message>
        <source>%1: holds frames of another time-lapse; name another folder, or remove them.</source>
        <translation>%1：存有另一段縮時影片的影格；請換個資料夾，或移除這些影格。</translation>
    </message>
    <message>
        <source>%1: holds no actions of a painting.</source>
        <translation>%1：不含任何作畫的動作。</translation>
    </message>
    <message>
        <source>%1: holds no stroke; expected lines &quot;seconds x y pressure&quot;, some with a pressure above 0.</source>
        <translation>%1：不含筆觸；應有「seconds x y pressure」這樣的行，其中有些筆壓大於 0。</translation>
    </message>
    <message>
        <source>%1: holds no strokes that could be painted again.</source>
        <translation>%1：不含可以重新繪製的筆觸。</translation>
    </message>
    <message>
        <source>%1: is %2, not a file.</source>
        <translation>%1：是%2，不是檔案。</translation>
    </message>
    <message>
        <source>%1: is an ICC profile for %2, but a picture is written in red, green and blue.</source>
        <translation>%1：是 %2 的 ICC 描述檔，但圖片是以紅、綠、藍寫入。</translation>
    </message>
    <message>
        <source>%1: is an ICC profile for %2, but a screen shows red, green and blue.</source>
        <translation>%1：是 %2 的 ICC 描述檔，但螢幕顯示的是紅、綠、藍。</translation>
    </message>
    <message>
        <source>%1: is an ICC profile that no colour can be shown with (%2).</source>
        <translation>%1：是無法用來顯示顏色的 ICC 描述檔（%2）。</translation>
    </message>
    <message>
        <source>%1: is an ICC profile that no picture can be written in (%2).</source>
        <translation>%1：是無法用來寫入圖片的 ICC 描述檔（%2）。</translation>
    </message>
    <message>
        <source>%1: is an ICC profile that no print can be shown with (%2).</source>
        <translation>%1：是無法用來顯示列印效果的 ICC 描述檔（%2）。</translation>
    </message>
    <message>
        <source>%1: is an OpenRaster picture of another program; it holds no wet paint.</source>
        <translation>%1：是其他程式的 OpenRaster 圖片，不含濕顏料。</translation>
    </message>
    <message>
        <source>%1: is damaged; %2 actions after it are lost.</source>
        <translation>%1：已損壞；其後的 %2 個動作已遺失。</translation>
    </message>
    <message>
        <source>%1: is damaged; 1 action after it is lost.</source>
        <translation>%1：已損壞；其後的 1 個動作已遺失。</translation>
    </message>
    <message>
        <source>%1: is damaged; the painting is there, but some of its strokes are missing, so that they cannot be replayed.</source>
        <translation>%1：已損壞；畫作還在，但缺少部分筆觸，因此無法重播。</translation>
    </message>
    <message>
        <source>%1: is larger than the %2 bytes that are read at most.</source>
        <translation>%1：大於可讀取的上限 %2 位元組。</translation>
    </message>
    <message>
        <source>%1: is no ICC profile (%2).</source>
        <translation>%1：不是 ICC 描述檔（%2）。</translation>
    </message>
    <message>
        <source>%1: is no OpenRaster file, which would hold %2.</source>
        <translation>%1：不是 OpenRaster 檔案，這種檔案應含有 %2。</translation>
    </message>
    <message>
        <source>%1: is no painting of Pastoso, or its end is missing (%2).</source>
        <translation>%1：不是 Pastoso 的畫作，或缺少結尾（%2）。</translation>
    </message>
    <message>
        <source>%1: is no painting of Pastoso.</source>
        <translation>%1：不是 Pastoso 的畫作。</translation>
    </message>
    <message>
        <source>%1: is not a list of media in square brackets.</source>
        <translation>%1：不是方括號內的媒材清單。</translation>
    </message>
    <message>
        <source>%1: is not an object in braces.</source>
        <translation>%1：不是大括號內的物件。</translation>
    </message>
    <message>
        <source>%1: is of another moment.</source>
        <translation>%1：屬於另一個時刻。</translation>
    </message>
    <message>
        <source>%1: is write-protected; allow writing to it, or choose another name.</source>
        <translation>%1：受到寫入保護；請允許寫入，或選擇別的名稱。</translation>
    </message>
    <message>
        <source>%1: is written, but may be lost in a power cut (%2).</source>
        <translation>%1：已寫入，但停電時可能會遺失（%2）。</translation>
    </message>
    <message>
        <source>%1: keeps frames of %2; choose another folder.</source>
        <translation>%1：存有%2的影格；請選擇別的資料夾。</translation>
    </message>
    <message>
        <source>%1: lists and objects are nested more than %2 deep.</source>
        <translation>%1：清單與物件的巢狀超過 %2 層。</translation>
    </message>
    <message>
        <source>%1: lists and objects stand more than %2 deep in each other.</source>
        <translation>%1：清單與物件互相巢狀超過 %2 層。</translation>
    </message>
    <message>
        <source>%1: maps are saved as .png, .tif or .exr; %2 files do not hold heights.</source>
        <translation>%1：貼圖要存成 .png、.tif 或 .exr；%2 檔案不能儲存高度。</translation>
    </message>
    <message>
        <source>%1: name is &quot;%2&quot;, which another preset of yours has already.</source>
        <translation>%1：name 為「%2」，但你的另一個筆刷預設已使用這個名稱。</translation>
    </message>
    <message>
        <source>%1: only .exr files hold layers.</source>
        <translation>%1：只有 .exr 檔案能儲存圖層。</translation>
    </message>
    <message>
        <source>%1: only .exr files hold the layers&apos; heights and normals.</source>
        <translation>%1：只有 .exr 檔案能儲存圖層的高度和法線。</translation>
    </message>
    <message>
        <source>%1: the %2 of vertex %3 is not finite; nothing was written.</source>
        <translation>%1：頂點 %3 的%2不是有限值；沒有寫入任何內容。</translation>
    </message>
    <message>
        <source>%1: the disk is full.</source>
        <translation>%1：磁碟已滿。</translation>
    </message>
    <message>
        <source>%1: the entry &quot;%2&quot; is missing.</source>
        <translation>%1：缺少項目「%2」。</translation>
    </message>
    <message>
        <source>%1: the list &quot;%2&quot; of paints is missing.</source>
        <translation>%1：缺少顏料清單「%2」。</translation>
    </message>
    <message>
        <source>%1: the name &quot;%2&quot; begins with #, as only colours do.</source>
        <translation>%1：名稱「%2」以 # 開頭，但只有顏色才會這樣。</translation>
    </message>
    <message>
        <source>%1: the name must end in .pbrt, .obj, .ply or .stl. Choose one of them.</source>
        <translation>%1：檔名必須以 .pbrt、.obj、.ply 或 .stl 結尾。請選擇其中一種。</translation>
    </message>
    <message>
        <source>%1: the pigment &quot;%2&quot; has no line for %3.</source>
        <translation>%1：色料「%2」缺少 %3 那一行。</translation>
    </message>
    <message>
        <source>%1: the readings go from %2 to %3 nm; a light is needed from 400 to 700 nm.</source>
        <translation>%1：讀數從 %2 到 %3 nm；光源需要 400 到 700 nm 的讀數。</translation>
    </message>
    <message>
        <source>%1: the system refuses this (%2).</source>
        <translation>%1：系統拒絕這項操作（%2）。</translation>
    </message>
    <message>
        <source>%1: the weights add up to %2 instead of 1.</source>
        <translation>%1：權重總和為 %2，而不是 1。</translation>
    </message>
    <message>
        <source>%1: there are more than %2 triangles.</source>
        <translation>%1：三角形超過 %2 個。</translation>
    </message>
    <message>
        <source>%1: there is already a pigment &quot;%2&quot;; give yours another name.</source>
        <translation>%1：已有色料「%2」；請為你的色料換個名稱。</translation>
    </message>
    <message>
        <source>%1: there is no colour in this palette.</source>
        <translation>%1：這個調色盤中沒有顏色。</translation>
    </message>
    <message>
        <source>%1: there is no pigment &quot;%2&quot;.</source>
        <translation>%1：沒有色料「%2」。</translation>
    </message>
    <message>
        <source>%1: there is no pigment in this file.</source>
        <translation>%1：這個檔案中沒有色料。</translation>
    </message>
    <message>
        <source>%1: there is no reading of a light in this file.</source>
        <translation>%1：這個檔案中沒有光源的讀數。</translation>
    </message>
    <message>
        <source>%1: this file of the program itself is missing; reinstall it or set PASTOSO_RESOURCES to the folder that holds it.</source>
        <translation>%1：缺少這個程式本身的檔案；請重新安裝程式，或將 PASTOSO_RESOURCES 設為含有該檔案的資料夾。</translation>
    </message>
    <message>
        <source>%1: this folder cannot be made (%2).</source>
        <translation>%1：無法建立這個資料夾（%2）。</translation>
    </message>
    <message>
        <source>%1: this format holds linear light, which needs no ICC profile.</source>
        <translation>%1：這種格式儲存的是線性光，不需要 ICC 描述檔。</translation>
    </message>
    <message>
        <source>%1: this is not valid JSON.</source>
        <translation>%1：這不是有效的 JSON。</translation>
    </message>
    <message>
        <source>%1: this light has no power that is seen.</source>
        <translation>%1：這個光源沒有看得見的功率。</translation>
    </message>
    <message>
        <source>%1: this light is so nearly a pure colour that nothing looks white in it.</source>
        <translation>%1：這個光源太接近純色，沒有任何東西在其中看起來是白色。</translation>
    </message>
    <message>
        <source>%1: this part of the program cannot be loaded (%2).</source>
        <translation>%1：無法載入程式的這個部分（%2）。</translation>
    </message>
    <message>
        <source>%1: this part of the program is of another version; reinstall it.</source>
        <translation>%1：程式的這個部分屬於另一個版本；請重新安裝。</translation>
    </message>
    <message>
        <source>%1: was saved by Pastoso with another form of %2; where nothing is painted, the canvas looks different.</source>
        <translation>%1：儲存時 Pastoso 使用了另一種形式的 %2；沒有畫到的地方，畫布看起來會不同。</translation>
    </message>
    <message>
        <source>16-bit pictures</source>
        <translation>16 位元圖片</translation>
    </message>
    <message>
        <source>8-bit pictures</source>
        <translation>8 位元圖片</translation>
    </message>
    <message>
        <source>&lt;%1&gt; is left out.</source>
        <translation>已略過 &lt;%1&gt;。</translation>
    </message>
    <message>
        <source>A brush needs a name.</source>
        <translation>筆刷需要名稱。</translation>
    </message>
    <message>
        <source>A canvas of %1 x %2 mm at %3 px/mm</source>
        <translation>%1 x %2 mm、%3 px/mm 的畫布</translation>
    </message>
    <message>
        <source>A diffusivity of %1 m2/s over %2 s; both must be 0 or more.</source>
        <translation>擴散率為 %1 m2/s，時間為 %2 s；兩者都必須是 0 以上。</translation>
    </message>
    <message>
        <source>A diffusivity or viscosity of %1 m2/s is too large for a step of %2 s.</source>
        <translation>擴散率或黏度 %1 m2/s 對 %2 s 的時間步來說太大。</translation>
    </message>
    <message>
        <source>A parcel&apos;s ball</source>
        <translation>奶滴所屬的奶球</translation>
    </message>
    <message>
        <source>A parcel&apos;s coldness</source>
        <translation>奶滴的冷度</translation>
    </message>
    <message>
        <source>A parcel&apos;s place</source>
        <translation>奶滴的位置</translation>
    </message>
    <message>
        <source>A parcel&apos;s shape is none.</source>
        <translation>奶滴的形狀無效。</translation>
    </message>
    <message>
        <source>A parcel&apos;s volume</source>
        <translation>奶滴的體積</translation>
    </message>
    <message>
        <source>A particle of this state is not within the tank.</source>
        <translation>這個狀態中有粒子不在水槽內。</translation>
    </message>
    <message>
        <source>A picture</source>
        <translation>圖片</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels is larger than the 268 million that can be rendered.</source>
        <translation>%1 x %2 像素的圖片超過可算繪的上限 2.68 億像素。</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels is larger than the 32768 a side that can be made.</source>
        <translation>%1 x %2 像素的圖片超過每邊 32768 像素的上限。</translation>
    </message>
    <message>
        <source>A relief of %1 x %2 points is more than the 25 million that can be made; a coarser resolution takes fewer.</source>
        <translation>%1 x %2 個點的浮雕超過 2500 萬個點的上限；解析度較粗時點數較少。</translation>
    </message>
    <message>
        <source>Cannot make the folder %1: %2.</source>
        <translation>無法建立資料夾 %1：%2。</translation>
    </message>
    <message>
        <source>Cannot write </source>
        <translation>無法寫入 </translation>
    </message>
    <message>
        <source>Cup, box, cells, time step, seed and the recipe&apos;s milk cannot change while the tea runs.</source>
        <translation>茶的模擬進行時，不能變更杯子、範圍、格數、時間步長、種子和配方的牛奶。</translation>
    </message>
    <message>
        <source>Nothing has been painted yet that a film could show.</source>
        <translation>還沒有畫任何東西，無法製作影片。</translation>
    </message>
    <message>
        <source>OpenGL reports error %1</source>
        <translation>OpenGL 回報錯誤 %1</translation>
    </message>
    <message>
        <source>PASTOSO_ISA is &quot;%1&quot;, but there are baseline, avx2 and avx512.</source>
        <translation>PASTOSO_ISA 為「%1」，但可用的只有 baseline、avx2 和 avx512。</translation>
    </message>
    <message>
        <source>The %1 of the canvas is %2 %3, but must lie between %4 and %5.</source>
        <translation>畫布的%1為 %2 %3，但必須介於 %4 和 %5 之間。</translation>
    </message>
    <message>
        <source>The box of liquid has %1 x %2 x %3 cells; each side may have 2 to %4.</source>
        <translation>液體的範圍有 %1 x %2 x %3 格；每邊可為 2 到 %4 格。</translation>
    </message>
    <message>
        <source>The cells of the box of liquid are %1 m wide, which is no size.</source>
        <translation>液體範圍的格寬為 %1 m，這不是有效的大小。</translation>
    </message>
    <message>
        <source>The cup&apos;s radius at its level</source>
        <translation>杯子在液面處的半徑</translation>
    </message>
    <message>
        <source>The diffusivity or viscosity is %1 m2/s; it must be 0 or more.</source>
        <translation>擴散率或黏度為 %1 m2/s；必須是 0 以上。</translation>
    </message>
    <message>
        <source>The file needs a name.</source>
        <translation>檔案需要名稱。</translation>
    </message>
    <message>
        <source>The film is of %1 media, but may be of %2 at most.</source>
        <translation>顏料層由 %1 種媒材組成，但最多只能有 %2 種。</translation>
    </message>
    <message>
        <source>The folder %1 holds the frames of another time-lapse; name another one.</source>
        <translation>資料夾 %1 裡已有另一段縮時影片的影格；請換個名稱。</translation>
    </message>
    <message>
        <source>The graphics card cannot draw the canvas: %1.</source>
        <translation>顯示卡無法繪製畫布：%1。</translation>
    </message>
    <message>
        <source>The graphics driver refuses a program that pictures are drawn with: %1</source>
        <translation>圖形驅動程式拒絕了用來繪製畫面的程式：%1</translation>
    </message>
    <message>
        <source>The height of the support</source>
        <translation>基底材高度</translation>
    </message>
    <message>
        <source>The latest strokes %1</source>
        <translation>最近的筆觸%1</translation>
    </message>
    <message>
        <source>The light&apos;s %1 is %2, outside the range from %3 to %4.</source>
        <translation>光線的%1為 %2，超出 %3 到 %4 的範圍。</translation>
    </message>
    <message>
        <source>The milk that was poured</source>
        <translation>已倒入的牛奶</translation>
    </message>
    <message>
        <source>The next ball&apos;s time</source>
        <translation>下一個奶球的時間</translation>
    </message>
    <message>
        <source>The number of balls</source>
        <translation>奶球的數量</translation>
    </message>
    <message>
        <source>The number of parcels</source>
        <translation>奶滴的數量</translation>
    </message>
    <message>
        <source>The painting is as it was saved, but its strokes %1</source>
        <translation>畫作和儲存時一樣，但其中的筆觸%1</translation>
    </message>
    <message>
        <source>The painting is recovered up to an action that cannot be repeated: %1</source>
        <translation>畫作已救回，直到一個無法重複的動作為止：%1</translation>
    </message>
    <message>
        <source>The painting is whole, but its strokes cannot be replayed: %1</source>
        <translation>畫作完整，但其中的筆觸無法重播：%1</translation>
    </message>
    <message>
        <source>The part of the canvas to render is empty or reaches beyond the canvas.</source>
        <translation>要算繪的畫布部分是空的，或超出畫布。</translation>
    </message>
    <message>
        <source>The picture&apos;s scale is %1 pixels per cell, outside the range from 1/64 to 64.</source>
        <translation>圖片的比例為每格 %1 像素，超出 1/64 到 64 的範圍。</translation>
    </message>
    <message>
        <source>The pressure is allowed %1 iterations; it needs at least 1.</source>
        <translation>壓力求解允許 %1 次迭代；至少需要 1 次。</translation>
    </message>
    <message>
        <source>The pressure&apos;s tolerance is %1; it may be 1e-7 to 1.</source>
        <translation>壓力的容許誤差為 %1；可為 1e-7 到 1。</translation>
    </message>
    <message>
        <source>The relief&apos;s %1 is %2, outside the range from %3 to %4.</source>
        <translation>浮雕的%1為 %2，超出 %3 到 %4 的範圍。</translation>
    </message>
    <message>
        <source>The state is that of another box of cells.</source>
        <translation>這個狀態屬於另一個由格組成的範圍。</translation>
    </message>
    <message>
        <source>The step</source>
        <translation>步數</translation>
    </message>
    <message>
        <source>The stream&apos;s end</source>
        <translation>牛奶細流的結束時間</translation>
    </message>
    <message>
        <source>The stream&apos;s parcels</source>
        <translation>牛奶細流的奶滴數</translation>
    </message>
    <message>
        <source>The stream&apos;s place</source>
        <translation>牛奶細流的位置</translation>
    </message>
    <message>
        <source>The stream&apos;s time</source>
        <translation>牛奶細流的時間</translation>
    </message>
    <message>
        <source>The support &quot;image&quot; needs a height image; none is named.</source>
        <translation>基底材「image」需要高度圖，但沒有指定。</translation>
    </message>
    <message>
        <source>The thickness of the film</source>
        <translation>顏料層厚度</translation>
    </message>
    <message>
        <source>The time of this state is not one of a tank.</source>
        <translation>這個狀態的時間不是水槽的時間。</translation>
    </message>
    <message>
        <source>The time step is %1 s; it must be 0 or more.</source>
        <translation>時間步長為 %1 s；必須是 0 以上。</translation>
    </message>
    <message>
        <source>The varnish&apos;s %1 is %2, outside the range from 0 to 1.</source>
        <translation>凡尼斯的%1為 %2，超出 0 到 1 的範圍。</translation>
    </message>
    <message>
        <source>The viscosity is %1 m2/s; it must be 0 or more.</source>
        <translation>黏度為 %1 m2/s；必須是 0 以上。</translation>
    </message>
    <message>
        <source>The vorticity confinement is %1; it may be 0 to 0.3.</source>
        <translation>渦度約束為 %1；可為 0 到 0.3。</translation>
    </message>
    <message>
        <source>The wall&apos;s distance at (%1, %2, %3) m is not a number.</source>
        <translation>(%1, %2, %3) m 處到壁面的距離不是數字。</translation>
    </message>
    <message>
        <source>There are %1 values for the %2 x %3 cells of the canvas.</source>
        <translation>畫布有 %2 x %3 格，但有 %1 個值。</translation>
    </message>
    <message>
        <source>There is already a brush &quot;%1&quot;.</source>
        <translation>已有筆刷「%1」。</translation>
    </message>
    <message>
        <source>There is already a file %1.</source>
        <translation>已有檔案 %1。</translation>
    </message>
    <message>
        <source>There is no brush &quot;%1&quot;; the brushes are %2.</source>
        <translation>沒有筆刷「%1」；可用的筆刷有 %2。</translation>
    </message>
    <message>
        <source>There is no case &quot;%1&quot;, only %2.</source>
        <translation>沒有案例「%1」，只有 %2。</translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation>沒有資料夾 %1。</translation>
    </message>
    <message>
        <source>There is no light &quot;%1&quot;; there are D65, D50, A and LED, or give the path of a CSV file.</source>
        <translation>沒有光源「%1」；可用的有 D65、D50、A 和 LED，也可以提供 CSV 檔案的路徑。</translation>
    </message>
    <message>
        <source>There is no medium &quot;%1&quot;; the media are: %2.</source>
        <translation>沒有媒材「%1」；可用的媒材有：%2。</translation>
    </message>
    <message>
        <source>There is no picture yet that could be saved.</source>
        <translation>還沒有可以儲存的圖片。</translation>
    </message>
    <message>
        <source>There is no pigment &quot;%1&quot;; %2</source>
        <translation>沒有色料「%1」；%2</translation>
    </message>
    <message>
        <source>There is no pigment &quot;%1&quot;; did you mean %2; %3</source>
        <translation>沒有色料「%1」；是指 %2 嗎？%3</translation>
    </message>
    <message>
        <source>There is no scene &quot;%1&quot;; give a file ending in .json, or one of: %2.</source>
        <translation>沒有場景「%1」；請提供以 .json 結尾的檔案，或下列之一：%2。</translation>
    </message>
    <message>
        <source>There is no support &quot;%1&quot;; the supports are: %2.</source>
        <translation>沒有基底材「%1」；可用的基底材有：%2。</translation>
    </message>
    <message>
        <source>This is the state of a level set, not of particles.</source>
        <translation>這是水平集的狀態，不是粒子的狀態。</translation>
    </message>
    <message>
        <source>This is the state of a tank that is followed in another way.</source>
        <translation>這是以另一種方法計算的水槽的狀態。</translation>
    </message>
    <message>
        <source>This is the state of another tank.</source>
        <translation>這是另一個水槽的狀態。</translation>
    </message>
    <message>
        <source>a bristle holds what none can.</source>
        <translation>有一根筆毛含有不可能的內容。</translation>
    </message>
    <message>
        <source>a cap is at most a half sphere: its thickness %1 must lie above 0 and not above its radius %2.</source>
        <translation>球冠最多為半球：其厚度 %1 必須大於 0，且不大於半徑 %2。</translation>
    </message>
    <message>
        <source>a cell holds more of its media than it holds paint.</source>
        <translation>有一格的媒材多於其顏料。</translation>
    </message>
    <message>
        <source>a combination has no parts.</source>
        <translation>組合中沒有任何部分。</translation>
    </message>
    <message>
        <source>a corner of triangle %1 is not finite (%2).</source>
        <translation>三角形 %1 的一個角點不是有限值（%2）。</translation>
    </message>
    <message>
        <source>a corner stands outside of a loop.</source>
        <translation>有角點在環之外。</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>裝置</translation>
    </message>
    <message>
        <source>a document type is not read here.</source>
        <translation>此處不接受文件類型宣告。</translation>
    </message>
    <message>
        <source>a face has %1 corners, not three or more.</source>
        <translation>有一個面有 %1 個角點，而不是三個以上。</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>檔案</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>資料夾</translation>
    </message>
    <message>
        <source>a glass of milk tea</source>
        <translation>奶茶場景</translation>
    </message>
    <message>
        <source>a group needs a layer.</source>
        <translation>群組需要圖層。</translation>
    </message>
    <message>
        <source>a height of the support</source>
        <translation>基底材高度</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>清單</translation>
    </message>
    <message>
        <source>a loop begins within another one.</source>
        <translation>有一個環在另一個環之內開始。</translation>
    </message>
    <message>
        <source>a loop ends that has no three corners.</source>
        <translation>有一個環結束時沒有三個角點。</translation>
    </message>
    <message>
        <source>a mixture</source>
        <translation>混色</translation>
    </message>
    <message>
        <source>a named pipe</source>
        <translation>具名管道</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>數字</translation>
    </message>
    <message>
        <source>a number is missing.</source>
        <translation>缺少一個數字。</translation>
    </message>
    <message>
        <source>a painting has 1 to %1 layers, not %2.</source>
        <translation>畫作有 1 到 %1 個圖層，而不是 %2 個。</translation>
    </message>
    <message>
        <source>a painting has at most %1 layers.</source>
        <translation>畫作最多有 %1 個圖層。</translation>
    </message>
    <message>
        <source>a painting keeps its last layer.</source>
        <translation>畫作必須保留最後一個圖層。</translation>
    </message>
    <message>
        <source>a picture on it has no strokes, and comes no finer than it is.</source>
        <translation>其中的圖片沒有筆觸，不會變得比原來更細。</translation>
    </message>
    <message>
        <source>a point of an outline has two numbers, x and y.</source>
        <translation>外框線的點有兩個數字，x 和 y。</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>壓力</translation>
    </message>
    <message>
        <source>a pressure curve leads from 0 to 1 and never falls.</source>
        <translation>筆壓曲線從 0 到 1，而且不會下降。</translation>
    </message>
    <message>
        <source>a reflectance</source>
        <translation>反射率</translation>
    </message>
    <message>
        <source>a run is named by up to 64 small letters, digits and hyphens.</source>
        <translation>執行項目的名稱最多 64 個字元，由小寫字母、數字和連字號組成。</translation>
    </message>
    <message>
        <source>a scene</source>
        <translation>場景</translation>
    </message>
    <message>
        <source>a scene of a glass tank</source>
        <translation>玻璃水槽場景</translation>
    </message>
    <message>
        <source>a shape is an object with one entry, its form, which is one of %1.</source>
        <translation>形狀是只有一個項目的物件，該項目就是它的形式，為下列之一：%1。</translation>
    </message>
    <message>
        <source>a socket</source>
        <translation>通訊端</translation>
    </message>
    <message>
        <source>a stroke needs at least one sample.</source>
        <translation>筆觸至少需要一個取樣點。</translation>
    </message>
    <message>
        <source>a stroke recording</source>
        <translation>筆觸錄製檔</translation>
    </message>
    <message>
        <source>a stroke that goes on stays on its surface.</source>
        <translation>接續的筆觸留在原來的表面上。</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>a thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>a thickness of dry paint</source>
        <translation>乾顏料厚度</translation>
    </message>
    <message>
        <source>a tilt needs millimetres; in cells give &quot;gravity&quot;.</source>
        <translation>傾斜需要以公釐為單位；以格為單位時請提供「gravity」。</translation>
    </message>
    <message>
        <source>a triangle has more than three corners.</source>
        <translation>有一個三角形超過三個角點。</translation>
    </message>
    <message>
        <source>a velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整數</translation>
    </message>
    <message>
        <source>alpha_min is %1, it must not be larger than alpha_max, %2.</source>
        <translation>alpha_min 為 %1，不能大於 alpha_max 的 %2。</translation>
    </message>
    <message>
        <source>ambient share</source>
        <translation>環境光比例</translation>
    </message>
    <message>
        <source>amount</source>
        <translation>用量</translation>
    </message>
    <message>
        <source>an amount of a medium</source>
        <translation>媒材量</translation>
    </message>
    <message>
        <source>an amount of dry pigment</source>
        <translation>乾色料量</translation>
    </message>
    <message>
        <source>an amount of paint</source>
        <translation>顏料量</translation>
    </message>
    <message>
        <source>an exception of an unknown kind</source>
        <translation>種類不明的例外狀況</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>物件</translation>
    </message>
    <message>
        <source>aside</source>
        <translation>放在一旁</translation>
    </message>
    <message>
        <source>at least one run is needed.</source>
        <translation>至少需要一個執行項目。</translation>
    </message>
    <message>
        <source>axis of the symmetry</source>
        <translation>對稱軸的角度</translation>
    </message>
    <message>
        <source>azimuth in degrees</source>
        <translation>方位角（度）</translation>
    </message>
    <message>
        <source>bare support</source>
        <translation>空白基底材</translation>
    </message>
    <message>
        <source>base in mm</source>
        <translation>底部厚度（mm）</translation>
    </message>
    <message>
        <source>belongs to another scene.</source>
        <translation>屬於另一個場景。</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>藍色</translation>
    </message>
    <message>
        <source>camera eye</source>
        <translation>攝影機位置</translation>
    </message>
    <message>
        <source>camera target</source>
        <translation>攝影機目標</translation>
    </message>
    <message>
        <source>cannot be read (%1).</source>
        <translation>無法讀取（%1）。</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>無法讀到結尾</translation>
    </message>
    <message>
        <source>canvas</source>
        <translation>畫布</translation>
    </message>
    <message>
        <source>cell (%1, %2) holds %3 that cannot be.</source>
        <translation>格 (%1, %2) 含有不可能的%3。</translation>
    </message>
    <message>
        <source>cell (%1, %2) holds a lower stratum that is no part of its paint.</source>
        <translation>格 (%1, %2) 含有不屬於其顏料的下層。</translation>
    </message>
    <message>
        <source>checkpoint of a tank</source>
        <translation>水槽的檢查點</translation>
    </message>
    <message>
        <source>checkpoint of tea</source>
        <translation>茶的檢查點</translation>
    </message>
    <message>
        <source>column %1 (%2): %3</source>
        <translation>第 %1 欄（%2）：%3</translation>
    </message>
    <message>
        <source>cup axis</source>
        <translation>杯子的軸</translation>
    </message>
    <message>
        <source>cup floor</source>
        <translation>杯底</translation>
    </message>
    <message>
        <source>cup foot</source>
        <translation>杯足</translation>
    </message>
    <message>
        <source>cup level</source>
        <translation>杯中液面</translation>
    </message>
    <message>
        <source>cup radius at the foot</source>
        <translation>杯足處的杯子半徑</translation>
    </message>
    <message>
        <source>cup radius at the rim</source>
        <translation>杯口處的杯子半徑</translation>
    </message>
    <message>
        <source>cup rim</source>
        <translation>杯口</translation>
    </message>
    <message>
        <source>cup slope</source>
        <translation>杯壁斜度</translation>
    </message>
    <message>
        <source>cup wall</source>
        <translation>杯壁</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>dent</source>
        <translation>凹陷</translation>
    </message>
    <message>
        <source>dent depth</source>
        <translation>凹陷深度</translation>
    </message>
    <message>
        <source>dent radius</source>
        <translation>凹陷半徑</translation>
    </message>
    <message>
        <source>direction of the tilt</source>
        <translation>傾斜的方向</translation>
    </message>
    <message>
        <source>distance from eye to target</source>
        <translation>攝影機位置到目標的距離</translation>
    </message>
    <message>
        <source>distance of the ruler&apos;s points</source>
        <translation>直尺兩點的距離</translation>
    </message>
    <message>
        <source>elevation in degrees</source>
        <translation>高度角（度）</translation>
    </message>
    <message>
        <source>ellipse&apos;s centre</source>
        <translation>橢圓中心</translation>
    </message>
    <message>
        <source>event %1: %2</source>
        <translation>事件 %1：%2</translation>
    </message>
    <message>
        <source>exaggeration</source>
        <translation>高度倍率</translation>
    </message>
    <message>
        <source>expected &quot;%1&quot;.</source>
        <translation>應為「%1」。</translation>
    </message>
    <message>
        <source>expected &quot;levels&quot; or &quot;fine&quot;.</source>
        <translation>應為「levels」或「fine」。</translation>
    </message>
    <message>
        <source>expected &quot;none&quot;, &quot;several&quot; or the numbers of one.</source>
        <translation>應為「none」、「several」，或單獨一種的數值。</translation>
    </message>
    <message>
        <source>expected %1 media at most.</source>
        <translation>應為最多 %1 種媒材。</translation>
    </message>
    <message>
        <source>expected %1 numbers, one for each tile.</source>
        <translation>應為 %1 個數字，每個區塊一個。</translation>
    </message>
    <message>
        <source>expected %1 numbers.</source>
        <translation>應為 %1 個數字。</translation>
    </message>
    <message>
        <source>expected %1, found %2.</source>
        <translation>應為%1，實際為：%2。</translation>
    </message>
    <message>
        <source>expected 0 or more.</source>
        <translation>應為 0 以上。</translation>
    </message>
    <message>
        <source>expected 0 to 10000.</source>
        <translation>應為 0 到 10000。</translation>
    </message>
    <message>
        <source>expected 0 to 10000000.</source>
        <translation>應為 0 到 10000000。</translation>
    </message>
    <message>
        <source>expected 0 to a million seconds.</source>
        <translation>應為 0 到一百萬秒。</translation>
    </message>
    <message>
        <source>expected 1 to %1 layers.</source>
        <translation>應為 1 到 %1 個圖層。</translation>
    </message>
    <message>
        <source>expected 4 numbers, seconds x y pressure, found %1.</source>
        <translation>應為 4 個數字，即 seconds x y pressure，實際有 %1 個。</translation>
    </message>
    <message>
        <source>expected a colour and its name, for example [&quot;#783c14&quot;, &quot;Umber&quot;].</source>
        <translation>應為顏色和它的名稱，例如 [&quot;#783c14&quot;, &quot;Umber&quot;]。</translation>
    </message>
    <message>
        <source>expected a name that begins with pastoso/.</source>
        <translation>應為以 pastoso/ 開頭的名稱。</translation>
    </message>
    <message>
        <source>expected a number for &quot;%1&quot;.</source>
        <translation>「%1」應為數字。</translation>
    </message>
    <message>
        <source>expected a number from 1 to 1000.</source>
        <translation>應為 1 到 1000 的數字。</translation>
    </message>
    <message>
        <source>expected a pigment and its parts, for example [&quot;PB29&quot;, 1].</source>
        <translation>應為色料和它的份數，例如 [&quot;PB29&quot;, 1]。</translation>
    </message>
    <message>
        <source>expected a width and a height.</source>
        <translation>應為寬度和高度。</translation>
    </message>
    <message>
        <source>expected an amount of paint up to 1e18.</source>
        <translation>應為不超過 1e18 的顏料量。</translation>
    </message>
    <message>
        <source>expected four numbers, [left, top, right, bottom].</source>
        <translation>應為四個數字，[左, 上, 右, 下]。</translation>
    </message>
    <message>
        <source>expected four whole numbers, [left, top, right, bottom].</source>
        <translation>應為四個整數，[左, 上, 右, 下]。</translation>
    </message>
    <message>
        <source>expected one number for each medium.</source>
        <translation>應為每種媒材一個數字。</translation>
    </message>
    <message>
        <source>expected one of %1 beside the tick.</source>
        <translation>除了 tick 之外，應有下列之一：%1。</translation>
    </message>
    <message>
        <source>expected sixteen hexadecimal digits.</source>
        <translation>應為十六個十六進位數字。</translation>
    </message>
    <message>
        <source>expected the first tile and how many there are.</source>
        <translation>應為第一個區塊和區塊數。</translation>
    </message>
    <message>
        <source>expected the name of a file in the journal&apos;s folder.</source>
        <translation>應為日誌資料夾中的檔案名稱。</translation>
    </message>
    <message>
        <source>expected three numbers, found %1.</source>
        <translation>應為三個數字，實際有 %1 個。</translation>
    </message>
    <message>
        <source>expected three whole numbers, found %1.</source>
        <translation>應為三個整數，實際有 %1 個。</translation>
    </message>
    <message>
        <source>expected two numbers, [width, height].</source>
        <translation>應為兩個數字，[寬度, 高度]。</translation>
    </message>
    <message>
        <source>expected two numbers, [x, y].</source>
        <translation>應為兩個數字，[x, y]。</translation>
    </message>
    <message>
        <source>expected two numbers, for example [0.5, 0.7].</source>
        <translation>應為兩個數字，例如 [0.5, 0.7]。</translation>
    </message>
    <message>
        <source>expected two numbers, for example [20, 30].</source>
        <translation>應為兩個數字，例如 [20, 30]。</translation>
    </message>
    <message>
        <source>fill of the brush</source>
        <translation>筆刷的沾取量</translation>
    </message>
    <message>
        <source>frame of tea</source>
        <translation>茶的影格</translation>
    </message>
    <message>
        <source>green</source>
        <translation>綠色</translation>
    </message>
    <message>
        <source>group of the layer</source>
        <translation>圖層所屬的群組</translation>
    </message>
    <message>
        <source>grouping layers that do not lie next to each other would tear a group of layers apart.</source>
        <translation>將不相鄰的圖層組成群組，會拆散圖層群組。</translation>
    </message>
    <message>
        <source>half height of the ellipse</source>
        <translation>橢圓高度的一半</translation>
    </message>
    <message>
        <source>half width of the ellipse</source>
        <translation>橢圓寬度的一半</translation>
    </message>
    <message>
        <source>has %1 x %2 pixels, but at most 32768 a side and 100 million in all are read.</source>
        <translation>有 %1 x %2 像素，但最多只能讀取每邊 32768 像素、總共 1 億像素。</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>height of the new canvas</source>
        <translation>新畫布的高度</translation>
    </message>
    <message>
        <source>height of the picture</source>
        <translation>圖片的高度</translation>
    </message>
    <message>
        <source>holds %1 bytes, but at most %2 are possible here.</source>
        <translation>有 %1 位元組，但此處最多只能有 %2 位元組。</translation>
    </message>
    <message>
        <source>holds a parcel (number %1) whose shape is none.</source>
        <translation>含有形狀無效的奶滴（編號 %1）。</translation>
    </message>
    <message>
        <source>holds a parcel (number %1) whose values are not finite.</source>
        <translation>含有數值不是有限值的奶滴（編號 %1）。</translation>
    </message>
    <message>
        <source>holds a particle whose numbers are not finite.</source>
        <translation>含有數值不是有限值的粒子。</translation>
    </message>
    <message>
        <source>holds a value of a cell that is not finite.</source>
        <translation>有一格的值不是有限值。</translation>
    </message>
    <message>
        <source>holds a value that is not a finite number.</source>
        <translation>含有不是有限數字的值。</translation>
    </message>
    <message>
        <source>holds an ICC profile that is none (it is damaged).</source>
        <translation>含有無效的 ICC 描述檔（已損壞）。</translation>
    </message>
    <message>
        <source>holds sizes or numbers that no tank has.</source>
        <translation>含有任何水槽都不會有的大小或數字。</translation>
    </message>
    <message>
        <source>holds sizes or numbers that no tea has.</source>
        <translation>含有任何茶都不會有的大小或數字。</translation>
    </message>
    <message>
        <source>holds sizes or times that no frame has.</source>
        <translation>含有任何影格都不會有的大小或時間。</translation>
    </message>
    <message>
        <source>holds the paint of another brush than the one %1, which has %2 bristles.</source>
        <translation>含有另一支筆刷的顏料，與%1的筆刷不符（這支筆刷有 %2 根筆毛）。</translation>
    </message>
    <message>
        <source>in hand</source>
        <translation>手上</translation>
    </message>
    <message>
        <source>is cut off: the end of the JPEG picture is missing.</source>
        <translation>不完整：缺少 JPEG 圖片的結尾。</translation>
    </message>
    <message>
        <source>is damaged (%1).</source>
        <translation>已損壞（%1）。</translation>
    </message>
    <message>
        <source>is damaged (it cannot be decompressed, or its checksum is another).</source>
        <translation>已損壞（無法解壓縮，或總和檢查碼不符）。</translation>
    </message>
    <message>
        <source>is damaged (it ends within its first %1 bytes).</source>
        <translation>已損壞（在前 %1 位元組之內就結束）。</translation>
    </message>
    <message>
        <source>is damaged (it is longer than it says).</source>
        <translation>已損壞（比標示的長）。</translation>
    </message>
    <message>
        <source>is damaged (it is shorter than it says).</source>
        <translation>已損壞（比標示的短）。</translation>
    </message>
    <message>
        <source>is damaged (its checksum is another).</source>
        <translation>已損壞（總和檢查碼不符）。</translation>
    </message>
    <message>
        <source>is damaged (its header reaches beyond the end).</source>
        <translation>已損壞（標頭超出檔案結尾）。</translation>
    </message>
    <message>
        <source>is damaged (its length is not the one that is noted).</source>
        <translation>已損壞（長度與記錄的不符）。</translation>
    </message>
    <message>
        <source>is larger than the %1 bytes that are read of a WebP picture at most.</source>
        <translation>大於 WebP 圖片可讀取的上限 %1 位元組。</translation>
    </message>
    <message>
        <source>is missing.</source>
        <translation>不存在。</translation>
    </message>
    <message>
        <source>is no %1.</source>
        <translation>不是%1。</translation>
    </message>
    <message>
        <source>is no PNG picture</source>
        <translation>不是 PNG 圖片</translation>
    </message>
    <message>
        <source>is not an image that can be read (it is none of %1).</source>
        <translation>不是可以讀取的圖片（不是這些格式：%1）。</translation>
    </message>
    <message>
        <source>is of version %1, this program reads %2.</source>
        <translation>是第 %1 版，本程式可讀取%2。</translation>
    </message>
    <message>
        <source>is stored in tiles of %1 x %2 pixels, but 8 a side are the least that are read.</source>
        <translation>以 %1 x %2 像素的區塊儲存，但可讀取的區塊每邊至少要有 8 像素。</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>已損壞</translation>
    </message>
    <message>
        <source>it was reset</source>
        <translation>已被重設</translation>
    </message>
    <message>
        <source>its end is missing</source>
        <translation>缺少結尾</translation>
    </message>
    <message>
        <source>its memory does not suffice</source>
        <translation>記憶體不足</translation>
    </message>
    <message>
        <source>its strokes %1</source>
        <translation>其中的筆觸%1</translation>
    </message>
    <message>
        <source>its support is a picture, and comes no finer than that.</source>
        <translation>其基底材是圖片，不會變得比原來更細。</translation>
    </message>
    <message>
        <source>lamp radiance</source>
        <translation>燈的輻射亮度</translation>
    </message>
    <message>
        <source>lamp radius</source>
        <translation>燈的半徑</translation>
    </message>
    <message>
        <source>lamp towards</source>
        <translation>燈的朝向</translation>
    </message>
    <message>
        <source>least height</source>
        <translation>最小高度</translation>
    </message>
    <message>
        <source>least thickness of wet paint</source>
        <translation>濕顏料的最小厚度</translation>
    </message>
    <message>
        <source>linear pictures</source>
        <translation>線性圖片</translation>
    </message>
    <message>
        <source>memory ran out: what was asked for last is not done, or not whole.</source>
        <translation>記憶體不足：最後要求的操作沒有完成，或不完整。</translation>
    </message>
    <message>
        <source>mesh: &quot;%1&quot; was not read.</source>
        <translation>網格：沒有讀取「%1」。</translation>
    </message>
    <message>
        <source>mesh: it is not closed: the edge from %1 to %2 is not shared by exactly two triangles that run along it in opposite directions.</source>
        <translation>網格：沒有封閉：從 %1 到 %2 的邊，不是恰好由兩個沿相反方向經過它的三角形共用。</translation>
    </message>
    <message>
        <source>mesh: there are no triangles.</source>
        <translation>網格：沒有三角形。</translation>
    </message>
    <message>
        <source>mesh: triangle %1 names vertex %2 of %3.</source>
        <translation>網格：三角形 %1 指向頂點 %2，但頂點共有 %3 個。</translation>
    </message>
    <message>
        <source>mesh: vertex %1 lies at %2, which is no place.</source>
        <translation>網格：頂點 %1 位於 %2，這不是有效的位置。</translation>
    </message>
    <message>
        <source>milk share</source>
        <translation>牛奶比例</translation>
    </message>
    <message>
        <source>milk share&apos;s cell</source>
        <translation>牛奶比例的格寬</translation>
    </message>
    <message>
        <source>missing; %1</source>
        <translation>缺少；%1</translation>
    </message>
    <message>
        <source>mixing well</source>
        <translation>調色槽</translation>
    </message>
    <message>
        <source>most height</source>
        <translation>最大高度</translation>
    </message>
    <message>
        <source>most thickness of wet paint</source>
        <translation>濕顏料的最大厚度</translation>
    </message>
    <message>
        <source>moving the group there would tear a group of layers apart.</source>
        <translation>將群組移到那裡，會拆散圖層群組。</translation>
    </message>
    <message>
        <source>moving the layer there would tear a group of layers apart.</source>
        <translation>將圖層移到那裡，會拆散圖層群組。</translation>
    </message>
    <message>
        <source>name of a group</source>
        <translation>群組的名稱</translation>
    </message>
    <message>
        <source>name of a layer</source>
        <translation>圖層的名稱</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>未提供原因</translation>
    </message>
    <message>
        <source>no reason was given</source>
        <translation>未提供原因</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>法線</translation>
    </message>
    <message>
        <source>number of parts of %1</source>
        <translation>%1 的份數</translation>
    </message>
    <message>
        <source>number of the group</source>
        <translation>群組的編號</translation>
    </message>
    <message>
        <source>number of the layer</source>
        <translation>圖層的編號</translation>
    </message>
    <message>
        <source>number of the outline&apos;s points</source>
        <translation>外框線的點數</translation>
    </message>
    <message>
        <source>number of the picture&apos;s pixels</source>
        <translation>圖片的像素數</translation>
    </message>
    <message>
        <source>number of the symmetry&apos;s copies</source>
        <translation>對稱的環繞份數</translation>
    </message>
    <message>
        <source>opacity of the layer</source>
        <translation>圖層的不透明度</translation>
    </message>
    <message>
        <source>opacity of the tracing picture</source>
        <translation>描圖底圖的不透明度</translation>
    </message>
    <message>
        <source>other tea</source>
        <translation>另一杯茶</translation>
    </message>
    <message>
        <source>pictures of %1 million pixels are too large; choose a &quot;picture_scale&quot; for at most 100 million.</source>
        <translation>%1 百萬像素的圖片太大；請選擇「picture_scale」，使圖片最多為 1 億像素。</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>place on the cloth in x</source>
        <translation>布面 x 位置</translation>
    </message>
    <message>
        <source>place on the cloth in y</source>
        <translation>布面 y 位置</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>position of the group</source>
        <translation>群組的位置</translation>
    </message>
    <message>
        <source>position of the layer</source>
        <translation>圖層的位置</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>筆壓</translation>
    </message>
    <message>
        <source>pressure of the pen</source>
        <translation>筆的筆壓</translation>
    </message>
    <message>
        <source>radius of the fan</source>
        <translation>風扇的半徑</translation>
    </message>
    <message>
        <source>reach of the guide</source>
        <translation>輔助線的作用範圍</translation>
    </message>
    <message>
        <source>receding_angle_deg is %1, it must not be larger than advancing_angle_deg, %2.</source>
        <translation>receding_angle_deg 為 %1，不能大於 advancing_angle_deg 的 %2。</translation>
    </message>
    <message>
        <source>red</source>
        <translation>紅色</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>解析度</translation>
    </message>
    <message>
        <source>resolution in mm</source>
        <translation>取樣點間距（mm）</translation>
    </message>
    <message>
        <source>rotation of the pen</source>
        <translation>筆的旋轉角度</translation>
    </message>
    <message>
        <source>roughness on the dry support</source>
        <translation>乾基底材上的粗糙度</translation>
    </message>
    <message>
        <source>roughness on wet paint</source>
        <translation>濕顏料上的粗糙度</translation>
    </message>
    <message>
        <source>ruler&apos;s first point</source>
        <translation>直尺第一點</translation>
    </message>
    <message>
        <source>ruler&apos;s second point</source>
        <translation>直尺第二點</translation>
    </message>
    <message>
        <source>scale of the transform along %1, without its sign,</source>
        <translation>變形沿 %1 的比例（不計正負號）</translation>
    </message>
    <message>
        <source>scene format</source>
        <translation>場景格式</translation>
    </message>
    <message>
        <source>scene: %1 is %2, but must be from %3 to %4.</source>
        <translation>場景：%1（%2）必須介於 %3 和 %4 之間。</translation>
    </message>
    <message>
        <source>scene: %1 is 0, but must be a direction.</source>
        <translation>場景：下列方向不能為 0：%1。</translation>
    </message>
    <message>
        <source>scene: %1&apos;s corner is %2, but must be the number of a position.</source>
        <translation>場景：%1 的角點為 %2，但必須是某個位置的編號。</translation>
    </message>
    <message>
        <source>scene: %1&apos;s number of normals is %2, but must be 0 or that of its positions.</source>
        <translation>場景：%1 的法線數為 %2，但必須是 0 或與位置數相同。</translation>
    </message>
    <message>
        <source>scene: there is not enough memory to trace a mesh of %1 triangles.</source>
        <translation>場景：記憶體不足，無法追蹤含 %1 個三角形的網格。</translation>
    </message>
    <message>
        <source>seed of the brush</source>
        <translation>筆刷的種子</translation>
    </message>
    <message>
        <source>shadow softness in mm</source>
        <translation>陰影柔和度（mm）</translation>
    </message>
    <message>
        <source>share of paint</source>
        <translation>顏料的比例</translation>
    </message>
    <message>
        <source>share of the second paint</source>
        <translation>第二種顏料的比例</translation>
    </message>
    <message>
        <source>share that is wiped off the brush</source>
        <translation>從筆刷擦掉的比例</translation>
    </message>
    <message>
        <source>single-precision pictures</source>
        <translation>單精度圖片</translation>
    </message>
    <message>
        <source>sky above</source>
        <translation>上方天空的亮度</translation>
    </message>
    <message>
        <source>sky below</source>
        <translation>下方天空的亮度</translation>
    </message>
    <message>
        <source>smoothing of the stabiliser</source>
        <translation>穩定器的平滑時間</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>其他種類的項目</translation>
    </message>
    <message>
        <source>something went wrong within the program (%1).</source>
        <translation>程式內部發生錯誤（%1）。</translation>
    </message>
    <message>
        <source>speed of drying</source>
        <translation>乾燥的速度</translation>
    </message>
    <message>
        <source>strata that give more light than they get</source>
        <translation>顏料層（射出的光多於射入的光）</translation>
    </message>
    <message>
        <source>strength of the fan</source>
        <translation>風扇的強度</translation>
    </message>
    <message>
        <source>strength of the paint</source>
        <translation>顏料的濃度</translation>
    </message>
    <message>
        <source>string of the stabiliser</source>
        <translation>穩定器的拉繩長度</translation>
    </message>
    <message>
        <source>stroke format</source>
        <translation>筆觸格式</translation>
    </message>
    <message>
        <source>support relief</source>
        <translation>基底材起伏</translation>
    </message>
    <message>
        <source>table fading</source>
        <translation>桌面的淡出</translation>
    </message>
    <message>
        <source>table height</source>
        <translation>桌面的高度</translation>
    </message>
    <message>
        <source>table radius</source>
        <translation>桌面的半徑</translation>
    </message>
    <message>
        <source>table reflectance</source>
        <translation>桌面的反射率</translation>
    </message>
    <message>
        <source>tank format</source>
        <translation>水槽格式</translation>
    </message>
    <message>
        <source>tank wall</source>
        <translation>水槽壁</translation>
    </message>
    <message>
        <source>tea format</source>
        <translation>奶茶格式</translation>
    </message>
    <message>
        <source>tells of strokes that are later than the painting.</source>
        <translation>含有比畫作更晚的筆觸。</translation>
    </message>
    <message>
        <source>the %1 &quot;%2&quot; is not a whole number from 0 to 255.</source>
        <translation>%1「%2」不是 0 到 255 的整數。</translation>
    </message>
    <message>
        <source>the %1 %2 is not a number.</source>
        <translation>%1 %2 不是數字。</translation>
    </message>
    <message>
        <source>the %1 %2 is not between -1e7 and 1e7.</source>
        <translation>%1 %2 不在 -1e7 和 1e7 之間。</translation>
    </message>
    <message>
        <source>the %1 has %2 bytes, but at most %3 are kept.</source>
        <translation>%1有 %2 位元組，但最多只保留 %3 位元組。</translation>
    </message>
    <message>
        <source>the %1 has %2 x %3 cells, but %4 x %5 of another size are expected.</source>
        <translation>%1有 %2 x %3 格，但應為 %4 x %5 格，且格的大小須相符。</translation>
    </message>
    <message>
        <source>the %1 in %2 is %3, but must lie between %4 and %5.</source>
        <translation>%1（%2）為 %3，但必須介於 %4 和 %5 之間。</translation>
    </message>
    <message>
        <source>the %1 is %2, but must lie between %3 and %4.</source>
        <translation>%1為 %2，但必須介於 %3 和 %4 之間。</translation>
    </message>
    <message>
        <source>the %1 is missing.</source>
        <translation>缺少%1。</translation>
    </message>
    <message>
        <source>the active layer is none.</source>
        <translation>使用中的圖層不存在。</translation>
    </message>
    <message>
        <source>the area is empty.</source>
        <translation>這個區域是空的。</translation>
    </message>
    <message>
        <source>the brush &quot;%1&quot;</source>
        <translation>筆刷「%1」</translation>
    </message>
    <message>
        <source>the brush %1 is told of only in part.</source>
        <translation>%1的筆刷只有部分資料。</translation>
    </message>
    <message>
        <source>the disk is full; make room on it, or choose another place</source>
        <translation>磁碟已滿；請清出空間，或選擇別的位置</translation>
    </message>
    <message>
        <source>the elements are nested too deep.</source>
        <translation>元素的巢狀太深。</translation>
    </message>
    <message>
        <source>the entry &quot;%1&quot; is missing.</source>
        <translation>缺少項目「%1」。</translation>
    </message>
    <message>
        <source>the field &quot;%1&quot; is missing.</source>
        <translation>缺少欄位「%1」。</translation>
    </message>
    <message>
        <source>the file ends here, before &quot;endsolid&quot;.</source>
        <translation>檔案在此結束，缺少「endsolid」。</translation>
    </message>
    <message>
        <source>the file ends here, within the head of an STL file.</source>
        <translation>檔案在此結束，STL 檔案的標頭不完整。</translation>
    </message>
    <message>
        <source>the groups within &quot;%1&quot; become part of it.</source>
        <translation>「%1」中的群組併入其中。</translation>
    </message>
    <message>
        <source>the heading is &quot;%1&quot; instead of &quot;%2&quot;.</source>
        <translation>標題是「%1」，而不是「%2」。</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is hidden.</source>
        <translation>圖層「%1」已隱藏。</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is in a group already.</source>
        <translation>圖層「%1」已在群組中。</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is locked.</source>
        <translation>圖層「%1」已鎖定。</translation>
    </message>
    <message>
        <source>the layers are too large in all.</source>
        <translation>所有圖層合計太大。</translation>
    </message>
    <message>
        <source>the layers of a group do not lie next to each other.</source>
        <translation>同一群組的圖層沒有相鄰。</translation>
    </message>
    <message>
        <source>the medium</source>
        <translation>媒材</translation>
    </message>
    <message>
        <source>the palette has %1, yours %2.</source>
        <translation>調色盤中有 %1；你自己的有 %2。</translation>
    </message>
    <message>
        <source>the palette has %1.</source>
        <translation>調色盤中有 %1。</translation>
    </message>
    <message>
        <source>the pen touches the canvas with no brush in hand.</source>
        <translation>筆碰到畫布時，手上沒有筆刷。</translation>
    </message>
    <message>
        <source>the pen touches the mixing well with no brush in hand.</source>
        <translation>筆碰到調色槽時，手上沒有筆刷。</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>圖片</translation>
    </message>
    <message>
        <source>the picture %1</source>
        <translation>圖片%1</translation>
    </message>
    <message>
        <source>the picture is no base64.</source>
        <translation>圖片不是 base64。</translation>
    </message>
    <message>
        <source>the pictures of this recording are too large; at most 500 million pixels in all are read.</source>
        <translation>這個錄製檔中的圖片太大；總共最多只能讀取 5 億像素。</translation>
    </message>
    <message>
        <source>the pigment has no name.</source>
        <translation>顏料沒有名稱。</translation>
    </message>
    <message>
        <source>the power</source>
        <translation>功率</translation>
    </message>
    <message>
        <source>the power %1 is negative.</source>
        <translation>功率 %1 是負數。</translation>
    </message>
    <message>
        <source>the preset</source>
        <translation>這個筆刷預設</translation>
    </message>
    <message>
        <source>the pressure %1 is not between 0 and 1.</source>
        <translation>筆壓 %1 不在 0 和 1 之間。</translation>
    </message>
    <message>
        <source>the size of the picture is missing.</source>
        <translation>缺少圖片的大小。</translation>
    </message>
    <message>
        <source>the system refuses this (%1).</source>
        <translation>系統拒絕這項操作（%1）。</translation>
    </message>
    <message>
        <source>the tick %1 is earlier than %2 before it.</source>
        <translation>tick %1 早於前一個 %2。</translation>
    </message>
    <message>
        <source>the tiles hold %1 bytes, which has to be the size and at most %2.</source>
        <translation>這些區塊有 %1 位元組，必須等於此大小，且最多為 %2。</translation>
    </message>
    <message>
        <source>the time %1 s is earlier than %2 s before it.</source>
        <translation>時間 %1 s 早於前一個 %2 s。</translation>
    </message>
    <message>
        <source>the time %1 s is not between 0 and 86400 s.</source>
        <translation>時間 %1 s 不在 0 和 86400 s 之間。</translation>
    </message>
    <message>
        <source>the wavelength</source>
        <translation>波長</translation>
    </message>
    <message>
        <source>the wavelength %1 nm is not greater than that of the line before.</source>
        <translation>波長 %1 nm 沒有大於前一行的波長。</translation>
    </message>
    <message>
        <source>their paint adds up to more than any canvas holds.</source>
        <translation>其中的顏料合計超過任何畫布所能容納的量。</translation>
    </message>
    <message>
        <source>there are %1 columns instead of %2.</source>
        <translation>有 %1 欄，而不是 %2 欄。</translation>
    </message>
    <message>
        <source>there are %1 paints, but only %2 have room.</source>
        <translation>有 %1 種顏料，但只容得下 %2 種。</translation>
    </message>
    <message>
        <source>there are %1 ticks for %2 samples.</source>
        <translation>%2 個取樣點有 %1 個 tick。</translation>
    </message>
    <message>
        <source>there are %1 tools instead of %2.</source>
        <translation>有 %1 個工具，而不是 %2 個。</translation>
    </message>
    <message>
        <source>there are more than %1 layers.</source>
        <translation>圖層超過 %1 個。</translation>
    </message>
    <message>
        <source>there are more than %1 triangles.</source>
        <translation>三角形超過 %1 個。</translation>
    </message>
    <message>
        <source>there are more than %1 vertices.</source>
        <translation>頂點超過 %1 個。</translation>
    </message>
    <message>
        <source>there cannot be a group %1.</source>
        <translation>不能有群組 %1。</translation>
    </message>
    <message>
        <source>there cannot be a layer %1.</source>
        <translation>不能有圖層 %1。</translation>
    </message>
    <message>
        <source>there is another run &quot;%1&quot;.</source>
        <translation>已有另一個執行項目「%1」。</translation>
    </message>
    <message>
        <source>there is no brush in hand to take paint with.</source>
        <translation>手上沒有可以沾取顏料的筆刷。</translation>
    </message>
    <message>
        <source>there is no field %1.</source>
        <translation>沒有欄位 %1。</translation>
    </message>
    <message>
        <source>there is no form &quot;%1&quot;; the forms are slab, box, disc, cap, gaussian, cosine, noise and image.</source>
        <translation>沒有形式「%1」；可用的形式有 slab、box、disc、cap、gaussian、cosine、noise 和 image。</translation>
    </message>
    <message>
        <source>there is no group %1 of layers.</source>
        <translation>沒有圖層群組 %1。</translation>
    </message>
    <message>
        <source>there is no group %1.</source>
        <translation>沒有群組 %1。</translation>
    </message>
    <message>
        <source>there is no kind of frame %1.</source>
        <translation>沒有 %1 這種資料框。</translation>
    </message>
    <message>
        <source>there is no layer %1.</source>
        <translation>沒有圖層 %1。</translation>
    </message>
    <message>
        <source>there is no layer below &quot;%1&quot; to merge it onto.</source>
        <translation>「%1」下方沒有可以合併的圖層。</translation>
    </message>
    <message>
        <source>there is no medium in hand.</source>
        <translation>手上沒有媒材。</translation>
    </message>
    <message>
        <source>there is no place %1 for a layer; the highest is %2.</source>
        <translation>圖層沒有位置 %1；最高的位置是 %2。</translation>
    </message>
    <message>
        <source>there is no such entry as &quot;%1&quot; here.</source>
        <translation>此處沒有「%1」這個項目。</translation>
    </message>
    <message>
        <source>there is no such kind of tiles as &quot;%1&quot;.</source>
        <translation>沒有「%1」這種區塊。</translation>
    </message>
    <message>
        <source>there is no support &quot;%1&quot;; the supports are flat, %2, weave, image, ramp and bump.</source>
        <translation>沒有基底材「%1」；可用的基底材有 flat、%2、weave、image、ramp 和 bump。</translation>
    </message>
    <message>
        <source>there is no surface &quot;%1&quot;; a stroke is on the &quot;canvas&quot; or the &quot;well&quot;.</source>
        <translation>沒有表面「%1」；筆觸在「canvas」或「well」上。</translation>
    </message>
    <message>
        <source>there is no visible layer to flatten.</source>
        <translation>沒有可以平面化的可見圖層。</translation>
    </message>
    <message>
        <source>there is no way &quot;%1&quot; to select; they are replace, add, subtract and intersect.</source>
        <translation>沒有「%1」這種選取方式；可用的有 replace、add、subtract 和 intersect。</translation>
    </message>
    <message>
        <source>this is no journal of a painting.</source>
        <translation>這不是畫作的日誌。</translation>
    </message>
    <message>
        <source>this is no list of layers; it would begin with &lt;image&gt;.</source>
        <translation>這不是圖層清單；開頭應為 &lt;image&gt;。</translation>
    </message>
    <message>
        <source>this is no painting of Pastoso; it would begin with &quot;format&quot;: &quot;pastoso-project&quot;.</source>
        <translation>這不是 Pastoso 的畫作；開頭應為 &quot;format&quot;: &quot;pastoso-project&quot;。</translation>
    </message>
    <message>
        <source>this is not %1; it would begin with &quot;format&quot;: &quot;%2&quot;.</source>
        <translation>這不是%1；開頭應為 &quot;format&quot;: &quot;%2&quot;。</translation>
    </message>
    <message>
        <source>this is not a GIMP palette; it would begin with &quot;GIMP Palette&quot;.</source>
        <translation>這不是 GIMP 調色盤；它應以「GIMP Palette」開頭。</translation>
    </message>
    <message>
        <source>this is not valid JSON: %1.</source>
        <translation>這不是有效的 JSON：%1。</translation>
    </message>
    <message>
        <source>this is not valid XML (%1).</source>
        <translation>這不是有效的 XML（%1）。</translation>
    </message>
    <message>
        <source>this makes %1 cells; 1 to %2 are possible.</source>
        <translation>這樣會有 %1 格；可為 1 到 %2 格。</translation>
    </message>
    <message>
        <source>this must be an object in braces.</source>
        <translation>這必須是大括號內的物件。</translation>
    </message>
    <message>
        <source>this paint</source>
        <translation>這個顏料</translation>
    </message>
    <message>
        <source>this was written by a newer Pastoso (%1 %2; this program reads up to %3).</source>
        <translation>這是由較新的 Pastoso 寫入的（%1 %2；本程式最多讀到 %3）。</translation>
    </message>
    <message>
        <source>this was written by a newer Pastoso (journal format %1; this program reads up to %2).</source>
        <translation>這是由較新的 Pastoso 寫入的（日誌格式 %1；本程式最多讀到 %2）。</translation>
    </message>
    <message>
        <source>this was written by a newer Pastoso (project format %1; this program reads up to %2).</source>
        <translation>這是由較新的 Pastoso 寫入的（畫作格式 %1；本程式最多讀到 %2）。</translation>
    </message>
    <message>
        <source>tile %1 comes twice.</source>
        <translation>區塊 %1 出現兩次。</translation>
    </message>
    <message>
        <source>tile %1 moves as no paint can.</source>
        <translation>區塊 %1 的流動方式是任何顏料都不會有的。</translation>
    </message>
    <message>
        <source>tile %1 moves, but there is no &quot;window&quot; that it started from.</source>
        <translation>區塊 %1 在流動，但缺少其起始的「window」。</translation>
    </message>
    <message>
        <source>tile %1 sleeps, and yet its motion is followed.</source>
        <translation>區塊 %1 在休眠，卻記錄了它的流動。</translation>
    </message>
    <message>
        <source>tilt of the canvas</source>
        <translation>畫布的傾斜角度</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>time of the pen</source>
        <translation>筆的時間</translation>
    </message>
    <message>
        <source>touch_dry_s is %1, it must not be larger than typical_thickness_mm times %2.</source>
        <translation>touch_dry_s 為 %1，不能大於 typical_thickness_mm 乘以 %2。</translation>
    </message>
    <message>
        <source>trace settings: a side of the picture is %1, but must be from 1 to 16384 pixels.</source>
        <translation>追蹤設定：圖片的一邊為 %1，但必須是 1 到 16384 像素。</translation>
    </message>
    <message>
        <source>trace settings: brightest is %1, but must be above 0 and finite.</source>
        <translation>追蹤設定：brightest 為 %1，但必須是大於 0 的有限值。</translation>
    </message>
    <message>
        <source>trace settings: most_events is %1, but must be at least 1.</source>
        <translation>追蹤設定：most_events 為 %1，但必須至少為 1。</translation>
    </message>
    <message>
        <source>transform&apos;s centre</source>
        <translation>變形中心</translation>
    </message>
    <message>
        <source>transform&apos;s move</source>
        <translation>變形位移</translation>
    </message>
    <message>
        <source>transform&apos;s scale</source>
        <translation>變形比例</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>turn of the ellipse</source>
        <translation>橢圓的旋轉角度</translation>
    </message>
    <message>
        <source>turn of the transform</source>
        <translation>變形的旋轉角度</translation>
    </message>
    <message>
        <source>variation of the share</source>
        <translation>比例的變化量</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>第 %1 版</translation>
    </message>
    <message>
        <source>versions %1 to %2</source>
        <translation>第 %1 到 %2 版</translation>
    </message>
    <message>
        <source>volume of the squeezed paint</source>
        <translation>擠出顏料的體積</translation>
    </message>
    <message>
        <source>were painted with an earlier version of the program (arithmetic %1, now %2): replayed, they come out a little differently.</source>
        <translation>是以較早版本的程式繪製的（運算 %1，現為 %2）：重播時，結果會略有不同。</translation>
    </message>
    <message>
        <source>width</source>
        <translation>寬度</translation>
    </message>
    <message>
        <source>width of the brush</source>
        <translation>筆刷的寬度</translation>
    </message>
    <message>
        <source>width of the new canvas</source>
        <translation>新畫布的寬度</translation>
    </message>
    <message>
        <source>width of the picture</source>
        <translation>圖片的寬度</translation>
    </message>
    <message>
        <source>window radiance</source>
        <translation>窗的輻射亮度</translation>
    </message>
    <message>
        <source>window radius</source>
        <translation>窗的半徑</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x of the %1</source>
        <translation>%1的 x 值</translation>
    </message>
    <message>
        <source>x of the centre of the symmetry</source>
        <translation>對稱中心的 x 座標</translation>
    </message>
    <message>
        <source>x of the fan</source>
        <translation>風扇的 x 座標</translation>
    </message>
    <message>
        <source>x of the new canvas</source>
        <translation>新畫布的 x 座標</translation>
    </message>
    <message>
        <source>x of the pen</source>
        <translation>筆的 x 座標</translation>
    </message>
    <message>
        <source>x of the picture</source>
        <translation>圖片的 x 座標</translation>
    </message>
    <message>
        <source>x of the squeezed paint</source>
        <translation>擠出顏料的 x 座標</translation>
    </message>
    <message>
        <source>x tilt of the pen</source>
        <translation>筆的 x 傾斜角度</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>y of the %1</source>
        <translation>%1的 y 值</translation>
    </message>
    <message>
        <source>y of the centre of the symmetry</source>
        <translation>對稱中心的 y 座標</translation>
    </message>
    <message>
        <source>y of the fan</source>
        <translation>風扇的 y 座標</translation>
    </message>
    <message>
        <source>y of the new canvas</source>
        <translation>新畫布的 y 座標</translation>
    </message>
    <message>
        <source>y of the pen</source>
        <translation>筆的 y 座標</translation>
    </message>
    <message>
        <source>y of the picture</source>
        <translation>圖片的 y 座標</translation>
    </message>
    <message>
        <source>y of the squeezed paint</source>
        <translation>擠出顏料的 y 座標</translation>
    </message>
    <message>
        <source>y tilt of the pen</source>
        <translation>筆的 y 傾斜角度</translation>
    </message>
    <message>
        <source>yellowing</source>
        <translation>泛黃程度</translation>
    </message>
    <message>
        <source>your share of the disk is used up; make room on it, or choose another place</source>
        <translation>你的磁碟配額已用完；請清出空間，或選擇別的位置</translation>
    </message>
    <message>
        <source>difference of the colour</source>
        <translation>顏色差異</translation>
    </message>
    <message>
        <source>gradient&apos;s point</source>
        <translation>漸層的點</translation>
    </message>
    <message>
        <source>length of the gradient&apos;s line</source>
        <translation>漸層線的長度</translation>
    </message>
    <message>
        <source>no paint has been copied that could be pasted.</source>
        <translation>尚未複製任何可以貼上的顏料。</translation>
    </message>
    <message>
        <source>number of points of the gradient&apos;s line</source>
        <translation>漸層線的點數</translation>
    </message>
    <message>
        <source>number of quarter turns</source>
        <translation>四分之一圈的次數</translation>
    </message>
    <message>
        <source>outline&apos;s point</source>
        <translation>輪廓的點</translation>
    </message>
    <message>
        <source>there is no visible layer to copy.</source>
        <translation>沒有可以複製的可見圖層。</translation>
    </message>
    <message>
        <source>thickness of the film</source>
        <translation>薄膜的厚度</translation>
    </message>
    <message>
        <source>way from where it was copied</source>
        <translation>與複製位置的距離</translation>
    </message>
    <message>
        <source>width of the margin</source>
        <translation>邊緣的寬度</translation>
    </message>
    <message>
        <source>x of the colour&apos;s place</source>
        <translation>顏色位置的 x</translation>
    </message>
    <message>
        <source>y of the colour&apos;s place</source>
        <translation>顏色位置的 y</translation>
    </message>
    <message>
        <source>%1: is no bundle of tools; it has no %2.</source>
        <translation>%1：不是工具包；缺少 %2。</translation>
    </message>
    <message>
        <source>name is &quot;%1&quot;, which another tool of the bundle has already.</source>
        <translation>name 是「%1」，工具包中已有另一個工具使用。</translation>
    </message>
    <message>
        <source>there are %1 tools, more than %2.</source>
        <translation>有 %1 個工具，超過 %2 個。</translation>
    </message>
    <message>
        <source>copied paint</source>
        <translation>複製的顏料</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there twice.</source>
        <translation>「%1」出現兩次。</translation>
    </message>
    <message>
        <source>a mix needs a name.</source>
        <translation>混色需要名稱。</translation>
    </message>
    <message>
        <source>a sample has 4 to 8 numbers, time, x, y, pressure, tilt_x, tilt_y, rotation, wheel; here are %1.</source>
        <translation>一個取樣有 4 到 8 個數字：time、x、y、pressure、tilt_x、tilt_y、rotation、wheel；這裡有 %1 個。</translation>
    </message>
    <message>
        <source>a set needs a name.</source>
        <translation>組需要名稱。</translation>
    </message>
    <message>
        <source>change of the resolution</source>
        <translation>解析度的變更倍率</translation>
    </message>
    <message>
        <source>scale of the height</source>
        <translation>高度的縮放倍率</translation>
    </message>
    <message>
        <source>scale of the width</source>
        <translation>寬度的縮放倍率</translation>
    </message>
    <message>
        <source>the panel %1 stands there twice.</source>
        <translation>面板 %1 出現在兩處。</translation>
    </message>
    <message>
        <source>there are %1 mixes, but only %2 have room.</source>
        <translation>有 %1 個混色，但只能容納 %2 個。</translation>
    </message>
    <message>
        <source>there is no &quot;%1&quot;.</source>
        <translation>沒有「%1」。</translation>
    </message>
    <message>
        <source>there is no panel.</source>
        <translation>沒有面板。</translation>
    </message>
    <message>
        <source>wheel of the pen</source>
        <translation>筆的滾輪</translation>
    </message>
    <message>
        <source>a tag needs a name.</source>
        <translation>標籤需要名稱。</translation>
    </message>
    <message>
        <source>corner that is distorted</source>
        <translation>要變形範圍的角</translation>
    </message>
    <message>
        <source>diameter of the grains</source>
        <translation>顆粒的直徑</translation>
    </message>
    <message>
        <source>direction of the grid&apos;s first lines</source>
        <translation>格線第一組線的方向</translation>
    </message>
    <message>
        <source>direction of the grid&apos;s other lines</source>
        <translation>格線另一組線的方向</translation>
    </message>
    <message>
        <source>direction of the horizon</source>
        <translation>地平線的方向</translation>
    </message>
    <message>
        <source>direction of the knife</source>
        <translation>畫刀的方向</translation>
    </message>
    <message>
        <source>direction of uprights</source>
        <translation>垂直線的方向</translation>
    </message>
    <message>
        <source>expected at most %1 references.</source>
        <translation>參考圖片最多應為 %1 張。</translation>
    </message>
    <message>
        <source>first vanishing point</source>
        <translation>第一消失點</translation>
    </message>
    <message>
        <source>grid&apos;s point</source>
        <translation>格線的點</translation>
    </message>
    <message>
        <source>height of the texture</source>
        <translation>肌理的高度</translation>
    </message>
    <message>
        <source>holds cells of another canvas than this one.</source>
        <translation>含有另一張畫布的格子。</translation>
    </message>
    <message>
        <source>holds no cell.</source>
        <translation>沒有任何格子。</translation>
    </message>
    <message>
        <source>length of a side of the distortion, times what it was,</source>
        <translation>變形後一邊的長度（相對於原長的倍數）</translation>
    </message>
    <message>
        <source>lower left corner of the distortion</source>
        <translation>變形的左下角</translation>
    </message>
    <message>
        <source>lower right corner of the distortion</source>
        <translation>變形的右下角</translation>
    </message>
    <message>
        <source>makes the references larger than any board holds.</source>
        <translation>使參考圖片超出圖板的容量。</translation>
    </message>
    <message>
        <source>masking&apos;s point</source>
        <translation>遮蓋的點</translation>
    </message>
    <message>
        <source>name of a reference</source>
        <translation>參考圖片的名稱</translation>
    </message>
    <message>
        <source>number of the masking&apos;s points</source>
        <translation>遮蓋的點數</translation>
    </message>
    <message>
        <source>number of the reference</source>
        <translation>參考圖片的編號</translation>
    </message>
    <message>
        <source>number of vanishing points</source>
        <translation>消失點的數目</translation>
    </message>
    <message>
        <source>opacity of the reference</source>
        <translation>參考圖片的不透明度</translation>
    </message>
    <message>
        <source>position of the reference</source>
        <translation>參考圖片的次序</translation>
    </message>
    <message>
        <source>second vanishing point</source>
        <translation>第二消失點</translation>
    </message>
    <message>
        <source>seed of the texture</source>
        <translation>肌理的種子</translation>
    </message>
    <message>
        <source>size of what is distorted</source>
        <translation>要變形範圍的尺寸</translation>
    </message>
    <message>
        <source>spacing of the grid&apos;s first lines</source>
        <translation>格線第一組線的間距</translation>
    </message>
    <message>
        <source>spacing of the grid&apos;s other lines</source>
        <translation>格線另一組線的間距</translation>
    </message>
    <message>
        <source>spacing of the ridges</source>
        <translation>脊線的間距</translation>
    </message>
    <message>
        <source>strength of the guide</source>
        <translation>輔助線的強度</translation>
    </message>
    <message>
        <source>the board holds %1 references, and no more are kept.</source>
        <translation>圖板上已有 %1 張參考圖片，無法再加入。</translation>
    </message>
    <message>
        <source>the corners of the distortion have to go round an area that bends outwards at each of them, by %1 degree or more.</source>
        <translation>變形的四角必須圍成每個角都向外彎折至少 %1 度的區域。</translation>
    </message>
    <message>
        <source>the name of a reference has %1 bytes, but at most %2 are kept.</source>
        <translation>參考圖片的名稱有 %1 個位元組，但最多只保留 %2 個。</translation>
    </message>
    <message>
        <source>the number %1 has not been given yet.</source>
        <translation>編號 %1 尚未分配。</translation>
    </message>
    <message>
        <source>the references on the board are too large; at most %1 million pixels in all are kept.</source>
        <translation>圖板上的參考圖片太大；總共最多保留 %1 百萬像素。</translation>
    </message>
    <message>
        <source>there are two references %1.</source>
        <translation>有兩張編號 %1 的參考圖片。</translation>
    </message>
    <message>
        <source>these are no corners of that mask.</source>
        <translation>這些不是該遮罩的角。</translation>
    </message>
    <message>
        <source>third vanishing point</source>
        <translation>第三消失點</translation>
    </message>
    <message>
        <source>turn of the canvas</source>
        <translation>畫布的旋轉角度</translation>
    </message>
    <message>
        <source>turn of the reference</source>
        <translation>參考圖片的旋轉</translation>
    </message>
    <message>
        <source>upper left corner of the distortion</source>
        <translation>變形的左上角</translation>
    </message>
    <message>
        <source>upper right corner of the distortion</source>
        <translation>變形的右上角</translation>
    </message>
    <message>
        <source>width of the masking</source>
        <translation>遮蓋的寬度</translation>
    </message>
    <message>
        <source>width of the reference</source>
        <translation>參考圖片的寬度</translation>
    </message>
    <message>
        <source>x of the reference</source>
        <translation>參考圖片的 x</translation>
    </message>
    <message>
        <source>y of the reference</source>
        <translation>參考圖片的 y</translation>
    </message>
    <message>
        <source>a group of layers cannot be clipped; its layers can.</source>
        <translation>群組無法剪裁；其中的圖層可以。</translation>
    </message>
    <message>
        <source>a map has 4 numbers; here are %1.</source>
        <translation>變換需有 4 個數字；此處有 %1 個。</translation>
    </message>
    <message>
        <source>a stroke that goes on says nothing of where it began.</source>
        <translation>接續的筆觸不說明它從哪裡開始。</translation>
    </message>
    <message>
        <source>holds a cell that is not masked.</source>
        <translation>含有未遮蓋的格子。</translation>
    </message>
    <message>
        <source>radius of the feather</source>
        <translation>羽化的半徑</translation>
    </message>
    <message>
        <source>share of the dry paint</source>
        <translation>乾顏料的比例</translation>
    </message>
    <message>
        <source>the medium in hand leaves next to nothing when it dries.</source>
        <translation>手上的媒材乾了以後幾乎什麼都不留。</translation>
    </message>
    <message>
        <source>there is no dry paint on &quot;%1&quot; to adjust.</source>
        <translation>「%1」上沒有可以調整的乾顏料。</translation>
    </message>
    <message>
        <source>thickness of the glaze</source>
        <translation>罩染的厚度</translation>
    </message>
    <message>
        <source>width of the cloth&apos;s threads</source>
        <translation>畫布紗線的寬度</translation>
    </message>
    <message>
        <source>The cloth has been drawn out too unevenly: for a canvas of %1 x %2 cells, %3 x %4 would have to be woven.</source>
        <translation>畫布拉伸得太不均勻：%1 x %2 格的畫布需要織出 %3 x %4 格。</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is clipped to &quot;%2&quot;, which is hidden.</source>
        <translation>圖層「%1」被剪裁到隱藏的「%2」。</translation>
    </message>
    <message>
        <source>%1 bytes of paint follow, but there should be %2.</source>
        <translation>後面有 %1 位元組的顏料，但應為 %2。</translation>
    </message>
    <message>
        <source>%1: is no paint that was copied in Pastoso.</source>
        <translation>%1：不是在 Pastoso 複製的顏料。</translation>
    </message>
    <message>
        <source>format of copied paint</source>
        <translation>複製顏料的格式</translation>
    </message>
    <message>
        <source>no canvas holds so much paint.</source>
        <translation>沒有畫布容得下這麼多顏料。</translation>
    </message>
    <message>
        <source>no painting has cells of this size.</source>
        <translation>沒有任何畫具有這種大小的格子。</translation>
    </message>
    <message>
        <source>paint that was copied in another painting has no strokes here, and comes no finer than it is.</source>
        <translation>在另一幅畫複製的顏料在此沒有筆觸，不會比現在更細緻。</translation>
    </message>
    <message>
        <source>the copied paint has cells of a size that no painting has.</source>
        <translation>複製顏料的格子大小是任何畫都沒有的。</translation>
    </message>
    <message>
        <source>the copied paint is no base64.</source>
        <translation>複製的顏料不是 base64。</translation>
    </message>
    <message>
        <source>the paint of other paintings in this recording is too large; at most 16 GB are read.</source>
        <translation>此錄製中來自其他畫的顏料太大，最多讀取 16 GB。</translation>
    </message>
    <message>
        <source>there are %1 puddles, but only %2 have room.</source>
        <translation>有 %1 灘顏料，但只能容納 %2 灘。</translation>
    </message>
    <message>
        <source>there is more paint than is read, 4 GB.</source>
        <translation>顏料超過可讀取的量（4 GB）。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not one of pastoso, krita and photoshop.</source>
        <translation>「%1」不是 pastoso、krita，也不是 photoshop。</translation>
    </message>
    <message>
        <source>%1 would have %2 x %3 pixels; at most %4 a side are possible.</source>
        <translation>%1會有 %2 x %3 像素；每邊最多 %4 像素。</translation>
    </message>
    <message>
        <source>The canvas is %1 x %2 pixels, more than this graphics driver can show.</source>
        <translation>畫布有 %1 x %2 像素，超過這個圖形驅動程式能顯示的範圍。</translation>
    </message>
</context>
<context>
    <name>ExamplePaintings</name>
    <message>
        <source>Still life</source>
        <translation>靜物</translation>
    </message>
    <message>
        <source>Oil, wet in wet</source>
        <translation>油畫，濕中濕</translation>
    </message>
    <message>
        <source>Surf</source>
        <translation>浪花</translation>
    </message>
    <message>
        <source>Oil, in thick impasto</source>
        <translation>油畫，厚塗</translation>
    </message>
    <message>
        <source>Poppies</source>
        <translation>罌粟花</translation>
    </message>
    <message>
        <source>Oil over a dry ground</source>
        <translation>油畫，畫在乾的底色上</translation>
    </message>
    <message>
        <source>Evening by a river</source>
        <translation>河畔黃昏</translation>
    </message>
    <message>
        <source>Oil, from ground to glaze</source>
        <translation>油畫，從底色到罩染</translation>
    </message>
</context>
<context>
    <name>FactList</name>
    <message>
        <source>Copy</source>
        <translation>複製</translation>
    </message>
</context>
<context>
    <name>Findable</name>
    <message>
        <source>Take this tool in hand</source>
        <translation>拿起這個工具</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>顏料</translation>
    </message>
    <message>
        <source>Choose this paint</source>
        <translation>選用這個顏料</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>媒材</translation>
    </message>
    <message>
        <source>Your mix</source>
        <translation>你的混色</translation>
    </message>
</context>
<context>
    <name>FindableControls</name>
    <message>
        <source>Harmony</source>
        <translation>色彩調和</translation>
    </message>
    <message>
        <source>Marks for hues that go together, on the colour wheel</source>
        <translation>在色輪上標出相配的色相</translation>
    </message>
    <message>
        <source>complementary, analogous, triad, tetrad, colour scheme, color scheme</source>
        <translation>互補色、類似色、三角配色、配色</translation>
    </message>
    <message>
        <source>Gamut mask</source>
        <translation>色域遮罩</translation>
    </message>
    <message>
        <source>A shape on the colour wheel to choose within</source>
        <translation>色輪上的一個形狀，只在其中選色</translation>
    </message>
    <message>
        <source>limited palette, color mask</source>
        <translation>限色、色域</translation>
    </message>
    <message>
        <source>Keep on your palette</source>
        <translation>保留到你的調色盤</translation>
    </message>
    <message>
        <source>Lay the paint in hand out on your palette</source>
        <translation>將手上的顏料放到你的調色盤</translation>
    </message>
    <message>
        <source>swatch, add colour, add color</source>
        <translation>色票、加入顏色</translation>
    </message>
    <message>
        <source>Save the palette</source>
        <translation>儲存調色盤</translation>
    </message>
    <message>
        <source>The colours of your palette for GIMP, Krita or Inkscape, as a .gpl file</source>
        <translation>將你的調色盤顏色存成 GIMP、Krita 或 Inkscape 用的 .gpl 檔案</translation>
    </message>
    <message>
        <source>gpl, swatches, export palette</source>
        <translation>gpl、色票、匯出調色盤</translation>
    </message>
    <message>
        <source>Open a palette</source>
        <translation>開啟調色盤</translation>
    </message>
    <message>
        <source>Colours of GIMP, Krita or Inkscape, from a .gpl file</source>
        <translation>從 .gpl 檔案取得 GIMP、Krita 或 Inkscape 的顏色</translation>
    </message>
    <message>
        <source>gpl, swatches, import palette</source>
        <translation>gpl、色票、匯入調色盤</translation>
    </message>
    <message>
        <source>Palette from a picture</source>
        <translation>從圖片取得調色盤</translation>
    </message>
    <message>
        <source>Finds the colours that a picture is made of</source>
        <translation>找出構成圖片的顏色</translation>
    </message>
    <message>
        <source>extract, palette from image</source>
        <translation>擷取顏色、照片取色</translation>
    </message>
    <message>
        <source>Keep as a mix</source>
        <translation>保留為混色</translation>
    </message>
    <message>
        <source>Keep the paint in hand as a recipe of tubes, under a name of your own</source>
        <translation>將手上的顏料以管裝顏料配方保留，並自行命名</translation>
    </message>
    <message>
        <source>recipe, save colour, save color</source>
        <translation>配方、儲存顏色</translation>
    </message>
    <message>
        <source>Sets of tubes</source>
        <translation>顏料組</translation>
    </message>
    <message>
        <source>Which tubes are shown: all of them, or a set of yours</source>
        <translation>顯示哪些顏料：全部，或你自己的一組</translation>
    </message>
    <message>
        <source>tube sets, palette of tubes</source>
        <translation>管裝顏料、顏料組合</translation>
    </message>
    <message>
        <source>Tags of tools</source>
        <translation>工具的標籤</translation>
    </message>
    <message>
        <source>Which tools are listed: a family, favourites or a tag</source>
        <translation>清單顯示哪些工具：一類、最愛或某個標籤</translation>
    </message>
    <message>
        <source>tagged, collections, brush sets</source>
        <translation>分類、筆刷組</translation>
    </message>
    <message>
        <source>Snapping strength</source>
        <translation>貼齊強度</translation>
    </message>
    <message>
        <source>How far the guide draws the brush from where your hand is</source>
        <translation>參考線把筆刷從手的位置拉過去多少</translation>
    </message>
    <message>
        <source>magnetic, assistant strength</source>
        <translation>吸附、輔助尺強度</translation>
    </message>
    <message>
        <source>Squeeze out the last painting&apos;s palette</source>
        <translation>擠出上一幅畫的調色盤</translation>
    </message>
    <message>
        <source>The paints and mixtures of the earlier well, onto the mixing well</source>
        <translation>把先前調色盤上的顏料與混色擠到調色槽上</translation>
    </message>
    <message>
        <source>restore palette, palette of before</source>
        <translation>還原調色盤、先前的調色盤</translation>
    </message>
    <message>
        <source>New tag for the tool in hand</source>
        <translation>為手上的工具新增標籤</translation>
    </message>
    <message>
        <source>A word of your own under which the tool is listed</source>
        <translation>你自己的詞，工具會列在它之下</translation>
    </message>
    <message>
        <source>add tag, label</source>
        <translation>加標籤、分類</translation>
    </message>
</context>
<context>
    <name>FolderFacts</name>
    <message>
        <source>none</source>
        <translation>無</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Your tools, paints and lamps</source>
        <translation>您的工具、顏料與燈</translation>
    </message>
    <message>
        <source>Paintings that are not saved</source>
        <translation>未儲存的畫作</translation>
    </message>
    <message>
        <source>What the program brings along</source>
        <translation>程式附帶的資料</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Like Krita</source>
        <translation>Krita 風格</translation>
    </message>
    <message>
        <source>The keys of Krita, where it has the same command</source>
        <translation>有相同指令時，使用 Krita 的快速鍵</translation>
    </message>
    <message>
        <source>Like Photoshop</source>
        <translation>Photoshop 風格</translation>
    </message>
    <message>
        <source>The keys of Photoshop, where it has the same command</source>
        <translation>有相同指令時，使用 Photoshop 的快速鍵</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>Krita&apos;s keys, but for short ones of what only wet paint has</source>
        <translation>Krita 的快速鍵，但濕顏料特有的操作用較短的鍵</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Drops and sprays</source>
        <translation>滴灑與噴灑</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>吹氣</translation>
    </message>
    <message>
        <source>Knives and combs</source>
        <translation>畫刀與刮梳</translation>
    </message>
    <message>
        <source>Rags and fingers</source>
        <translation>擦布與手指</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>筆刷</translation>
    </message>
    <message>
        <source>Cannot be read</source>
        <translation>無法讀取</translation>
    </message>
    <message>
        <source>Clear medium</source>
        <translation>透明媒介劑</translation>
    </message>
    <message>
        <source>How the next paint flows; what lies on the canvas keeps its own way</source>
        <translation>接下來的顏料如何流動；畫布上已有的顏料不受影響</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>復原</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新沾料</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>清潔</translation>
    </message>
    <message>
        <source>Medium </source>
        <translation>媒材 </translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暫停</translation>
    </message>
    <message>
        <source>Mixing well</source>
        <translation>調色槽</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>儲存</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重新命名</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>刪除</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>擠出</translation>
    </message>
    <message>
        <source>Wipe the well</source>
        <translation>擦淨調色槽</translation>
    </message>
    <message>
        <source>the same to the eye</source>
        <translation>肉眼看不出差別</translation>
    </message>
    <message>
        <source>close</source>
        <translation>接近</translation>
    </message>
    <message>
        <source>a little off</source>
        <translation>略有偏差</translation>
    </message>
    <message>
        <source>beyond these tubes</source>
        <translation>這些管裝顏料調不出來</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>筆壓</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>傾斜</translation>
    </message>
    <message>
        <source>Barrel</source>
        <translation>筆桿</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>how far it is pressed</source>
        <translation>下壓的程度</translation>
    </message>
    <message>
        <source>how far it leans</source>
        <translation>傾倒的程度</translation>
    </message>
    <message>
        <source>how it is turned</source>
        <translation>轉動的角度</translation>
    </message>
    <message>
        <source>reach into hollows</source>
        <translation>深入凹處的程度</translation>
    </message>
    <message>
        <source>film that it leaves</source>
        <translation>留下的顏料薄層</translation>
    </message>
    <message>
        <source>paint taken up</source>
        <translation>帶起的顏料</translation>
    </message>
    <message>
        <source>flow</source>
        <translation>流量</translation>
    </message>
    <message>
        <source>width of the spread</source>
        <translation>散布的寬度</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 % pressure</source>
        <translation>筆壓 %1 %</translation>
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
        <translation>未乾，休眠中</translation>
    </message>
    <message>
        <source>A group: its eye, its lock and its opacity hold for all of its layers</source>
        <translation>群組：它的眼睛、鎖頭和不透明度，對其中所有圖層都有效</translation>
    </message>
    <message>
        <source>You paint on this layer; its wet paint flows and dries</source>
        <translation>你正畫在這個圖層上；上面的濕顏料會流動、會乾</translation>
    </message>
    <message>
        <source>Its wet paint keeps still: it neither flows nor dries, and stays as wet as it is until you choose this layer</source>
        <translation>這個圖層的濕顏料正在休眠：不流動也不會乾，在你選取這個圖層之前都保持現在的濕度</translation>
    </message>
    <message>
        <source>Click to paint on this layer; a double click names it, dragging moves it</source>
        <translation>按一下就在這個圖層上作畫；按兩下可命名，拖曳可移動</translation>
    </message>
    <message>
        <source>Seen; click to hide it. Its relief goes with it</source>
        <translation>可見；按一下可隱藏，它的起伏也一併隱藏</translation>
    </message>
    <message>
        <source>Hidden, and not painted on; click to show it</source>
        <translation>已隱藏，不會畫到；按一下可顯示</translation>
    </message>
    <message>
        <source>Locked: nothing is painted on it, cleared or merged. Click to unlock</source>
        <translation>已鎖定：無法在上面作畫，也不能清除或合併。按一下可解除鎖定</translation>
    </message>
    <message>
        <source>Click to lock it against painting, clearing and merging</source>
        <translation>按一下可鎖定，避免被畫到、清除或合併</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>筆尖</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左鍵</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>下鍵</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>中鍵</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>上鍵</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右鍵</translation>
    </message>
    <message>
        <source>none</source>
        <translation>無</translation>
    </message>
    <message>
        <source>not told</source>
        <comment>rotation</comment>
        <translation>未提供</translation>
    </message>
    <message>
        <source>Tilt %1 across, %2 along; rotation %3; buttons: %4</source>
        <translation>左右傾斜 %1，前後傾斜 %2；旋轉 %3；按鈕：%4</translation>
    </message>
    <message>
        <source>%1, eraser end</source>
        <translation>%1，橡皮擦端</translation>
    </message>
    <message>
        <source>%1, puck</source>
        <translation>%1，數位板滑鼠</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>滑鼠</translation>
    </message>
    <message>
        <source>pressure %1 → %2</source>
        <translation>筆壓 %1 → %2</translation>
    </message>
    <message>
        <source>pressure %1</source>
        <translation>筆壓 %1</translation>
    </message>
    <message>
        <source>%1: %2, %3 events a second</source>
        <translation>%1：%2，每秒 %3 個事件</translation>
    </message>
    <message>
        <source>Buttons: %1</source>
        <translation>按鈕：%1</translation>
    </message>
    <message>
        <source>clear medium</source>
        <translation>透明媒介劑</translation>
    </message>
    <message>
        <source>thinned to %1</source>
        <translation>稀釋至 %1</translation>
    </message>
    <message>
        <source>Dry now</source>
        <translation>立即乾燥</translation>
    </message>
    <message>
        <source>How fast time passes for the paint: 10 × is ten seconds in one. While you draw a stroke it passes as usual</source>
        <translation>顏料的時間過得多快：10 × 是一秒過十秒。落筆期間照常進行</translation>
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
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>ride on wet paint</source>
        <translation>浮在濕顏料上</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>薄塗</translation>
    </message>
    <message>
        <source>paste</source>
        <translation>膏狀</translation>
    </message>
    <message>
        <source>cream</source>
        <translation>奶油狀</translation>
    </message>
    <message>
        <source>milk</source>
        <translation>牛奶狀</translation>
    </message>
    <message>
        <source>wash</source>
        <translation>薄塗</translation>
    </message>
    <message>
        <source>stain</source>
        <translation>染色</translation>
    </message>
    <message>
        <source>Each stroke</source>
        <translation>每筆沾料</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>隨筆轉</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>使用手冊</translation>
    </message>
    <message>
        <source>What is new</source>
        <translation>新功能</translation>
    </message>
    <message>
        <source>About Pastoso</source>
        <translation>關於 Pastoso</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>編輯</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>最愛</translation>
    </message>
    <message>
        <source>The brush is not over it</source>
        <translation>筆刷不在其上</translation>
    </message>
    <message>
        <source>Brush at %1, %2 mm</source>
        <translation>筆刷位於 %1, %2 mm</translation>
    </message>
    <message>
        <source>Kind of paint</source>
        <translation>顏料種類</translation>
    </message>
    <message>
        <source>Charcoal and pastels</source>
        <translation>炭筆與粉彩</translation>
    </message>
    <message>
        <source>Pens</source>
        <translation>筆尖</translation>
    </message>
    <message>
        <source>Sponges and rollers</source>
        <translation>海綿與滾筒</translation>
    </message>
    <message>
        <source>Direction of the stroke</source>
        <translation>筆觸的方向</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>移動的距離</translation>
    </message>
    <message>
        <source>Time since the touch</source>
        <translation>接觸後的時間</translation>
    </message>
    <message>
        <source>Distance in brush widths</source>
        <translation>以筆寬計的距離</translation>
    </message>
    <message>
        <source>Chance, each stroke</source>
        <translation>隨機（每一筆）</translation>
    </message>
    <message>
        <source>Chance along the stroke</source>
        <translation>隨機（沿著筆觸）</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>滾輪</translation>
    </message>
    <message>
        <source>Paint left on the tool</source>
        <translation>工具上剩餘的顏料</translation>
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
        <translation>%1 個筆寬</translation>
    </message>
    <message>
        <source>What is bare is locked: tools change only what has paint. Click to unlock</source>
        <translation>空白處已鎖定：工具只改變有顏料的地方。按一下可解除鎖定</translation>
    </message>
    <message>
        <source>Click to lock what is bare: tools change only what has paint</source>
        <translation>按一下可鎖定空白處：工具只改變有顏料的地方</translation>
    </message>
    <message>
        <source>Clipped to the layer below: of its paint, only what lies over paint of that layer shows. The rest is hidden, and kept</source>
        <translation>已剪裁至下方圖層：只顯示位於該圖層顏料上的部分，其餘隱藏但保留</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>確定</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>儲存</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開啟</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>是(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>否(&amp;N)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>關閉</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>捨棄</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>說明</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>套用</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重設</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>還原預設值</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重試</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>忽略</translation>
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
        <translation>寬度</translation>
    </message>
</context>
<context>
    <name>TourCommands</name>
    <message>
        <source>Paint</source>
        <translation>作畫</translation>
    </message>
    <message>
        <source>Press on the canvas and drag: the brush lays wet paint, and drags along what is wet already. A pen that presses harder bends the hairs further.</source>
        <translation>在畫布上按下並拖曳：筆刷會塗上濕的顏料，並帶動仍未乾的顏料。筆壓得越重，筆毛彎得越多。</translation>
    </message>
    <message>
        <source>Move the canvas, and pick paint from it</source>
        <translation>移動畫布，並從畫布上取色</translation>
    </message>
    <message>
        <source>Hold Space and drag to move the canvas; the wheel goes nearer. Ctrl and a click put the paint under the pointer on your brush.</source>
        <translation>按住空白鍵並拖曳可移動畫布；滾輪可拉近。按 Ctrl 並點一下，筆刷會沾上指標下的顏料。</translation>
    </message>
    <message>
        <source>Take another paint, and take a stroke back</source>
        <translation>換顏料，並復原筆觸</translation>
    </message>
    <message>
        <source>Choose a paint here. %1 loads the brush anew, %2 takes the last stroke back.</source>
        <translation>在此選擇顏料。%1 重新沾顏料，%2 復原上一筆。</translation>
    </message>
</context>
<context>
    <name>pastoso::appearance</name>
    <message>
        <source>Air blower 40</source>
        <translation>吹氣球 40</translation>
    </message>
    <message>
        <source>Airbrush 7</source>
        <translation>噴筆 7</translation>
    </message>
    <message>
        <source>Blender 28</source>
        <translation>暈染筆 28</translation>
    </message>
    <message>
        <source>Blotting pad 40</source>
        <translation>吸色墊 40</translation>
    </message>
    <message>
        <source>Bright 12</source>
        <translation>短平筆 12</translation>
    </message>
    <message>
        <source>Comb 25</source>
        <translation>梳形刮刀 25</translation>
    </message>
    <message>
        <source>Cotton bud 6</source>
        <translation>棉花棒 6</translation>
    </message>
    <message>
        <source>Detail round 3</source>
        <translation>細部圓筆 3</translation>
    </message>
    <message>
        <source>Diamond knife 9</source>
        <translation>菱形畫刀 9</translation>
    </message>
    <message>
        <source>Dropper</source>
        <translation>滴管</translation>
    </message>
    <message>
        <source>Dry scumbler 22</source>
        <translation>乾擦筆 22</translation>
    </message>
    <message>
        <source>Eraser 15</source>
        <translation>橡皮擦 15</translation>
    </message>
    <message>
        <source>Fan 26</source>
        <translation>扇形筆 26</translation>
    </message>
    <message>
        <source>Filbert 14</source>
        <translation>榛形筆 14</translation>
    </message>
    <message>
        <source>Fine comb 18</source>
        <translation>細齒梳形刮刀 18</translation>
    </message>
    <message>
        <source>Fingertip 12</source>
        <translation>指尖 12</translation>
    </message>
    <message>
        <source>Flat bristle 20</source>
        <translation>豬鬃平筆 20</translation>
    </message>
    <message>
        <source>Impasto flat 18</source>
        <translation>厚塗平筆 18</translation>
    </message>
    <message>
        <source>Large filbert 26</source>
        <translation>大榛形筆 26</translation>
    </message>
    <message>
        <source>Large flat 40</source>
        <translation>大平筆 40</translation>
    </message>
    <message>
        <source>Lifting knife 14</source>
        <translation>挑色刀 14</translation>
    </message>
    <message>
        <source>Mop 30</source>
        <translation>拖把筆 30</translation>
    </message>
    <message>
        <source>Palette knife 17</source>
        <translation>調色刀 17</translation>
    </message>
    <message>
        <source>Pouring bottle</source>
        <translation>倒色瓶</translation>
    </message>
    <message>
        <source>Rag 35</source>
        <translation>抹布 35</translation>
    </message>
    <message>
        <source>Rigger 2</source>
        <translation>拉線筆 2</translation>
    </message>
    <message>
        <source>Round bristle 12</source>
        <translation>豬鬃圓筆 12</translation>
    </message>
    <message>
        <source>Round sable 9</source>
        <translation>貂毛圓筆 9</translation>
    </message>
    <message>
        <source>Scraper 30</source>
        <translation>刮板 30</translation>
    </message>
    <message>
        <source>Soft glazing flat 16</source>
        <translation>軟毛罩染平筆 16</translation>
    </message>
    <message>
        <source>Spatter 45</source>
        <translation>噴濺 45</translation>
    </message>
    <message>
        <source>Spray can 35</source>
        <translation>噴漆罐 35</translation>
    </message>
    <message>
        <source>Spreading knife 40</source>
        <translation>抹刀 40</translation>
    </message>
    <message>
        <source>Stippler 15</source>
        <translation>點畫筆 15</translation>
    </message>
    <message>
        <source>Straw 8</source>
        <translation>吸管 8</translation>
    </message>
    <message>
        <source>Thinner brush 16</source>
        <translation>稀釋劑筆 16</translation>
    </message>
    <message>
        <source>Titanium white</source>
        <translation>鈦白</translation>
    </message>
    <message>
        <source>Zinc white</source>
        <translation>鋅白</translation>
    </message>
    <message>
        <source>Cadmium yellow</source>
        <translation>鎘黃</translation>
    </message>
    <message>
        <source>Hansa yellow medium</source>
        <translation>中漢莎黃</translation>
    </message>
    <message>
        <source>Diarylide (Indian) yellow</source>
        <translation>二芳基黃（印度黃）</translation>
    </message>
    <message>
        <source>Yellow ochre</source>
        <translation>土黃</translation>
    </message>
    <message>
        <source>Cadmium orange</source>
        <translation>鎘橙</translation>
    </message>
    <message>
        <source>Pyrrole orange</source>
        <translation>吡咯橙</translation>
    </message>
    <message>
        <source>Cadmium red light</source>
        <translation>淺鎘紅</translation>
    </message>
    <message>
        <source>Pyrrole red</source>
        <translation>吡咯紅</translation>
    </message>
    <message>
        <source>Red oxide (Venetian red)</source>
        <translation>氧化鐵紅（威尼斯紅）</translation>
    </message>
    <message>
        <source>Alizarin crimson</source>
        <translation>茜素深紅</translation>
    </message>
    <message>
        <source>Quinacridone rose</source>
        <translation>喹吖啶酮玫瑰紅</translation>
    </message>
    <message>
        <source>Quinacridone magenta</source>
        <translation>喹吖啶酮洋紅</translation>
    </message>
    <message>
        <source>Dioxazine violet</source>
        <translation>二噁嗪紫</translation>
    </message>
    <message>
        <source>Ultramarine blue</source>
        <translation>群青</translation>
    </message>
    <message>
        <source>Cobalt blue</source>
        <translation>鈷藍</translation>
    </message>
    <message>
        <source>Cerulean blue</source>
        <translation>天藍</translation>
    </message>
    <message>
        <source>Phthalo blue GS</source>
        <translation>酞菁藍 GS</translation>
    </message>
    <message>
        <source>Prussian blue</source>
        <translation>普魯士藍</translation>
    </message>
    <message>
        <source>Phthalo green BS</source>
        <translation>酞菁綠 BS</translation>
    </message>
    <message>
        <source>Phthalo green YS</source>
        <translation>酞菁綠 YS</translation>
    </message>
    <message>
        <source>Viridian</source>
        <translation>翠綠</translation>
    </message>
    <message>
        <source>Chromium oxide green</source>
        <translation>氧化鉻綠</translation>
    </message>
    <message>
        <source>Burnt sienna</source>
        <translation>岱赭</translation>
    </message>
    <message>
        <source>Raw umber</source>
        <translation>生褐</translation>
    </message>
    <message>
        <source>Burnt umber</source>
        <translation>焦褐</translation>
    </message>
    <message>
        <source>Ivory (bone) black</source>
        <translation>象牙黑（骨黑）</translation>
    </message>
    <message>
        <source>Carbon black</source>
        <translation>碳黑</translation>
    </message>
    <message>
        <source>heavy-body oil</source>
        <translation>厚質油畫顏料</translation>
    </message>
    <message>
        <source>Stiff, buttery oil straight from the tube: every bristle mark and every peak stays where you put it.</source>
        <translation>直接從管中擠出、質地硬而滑順的油畫顏料：每道筆痕、每個尖峰都留在你放下的地方。</translation>
    </message>
    <message>
        <source>soft-body acrylic</source>
        <translation>軟質壓克力顏料</translation>
    </message>
    <message>
        <source>Creamy paint that keeps soft brush marks, and slumps slowly where you lay it on thick.</source>
        <translation>乳霜般的顏料，保留柔和的筆痕，塗得厚的地方會慢慢塌陷。</translation>
    </message>
    <message>
        <source>fluid acrylic</source>
        <translation>流體壓克力顏料</translation>
    </message>
    <message>
        <source>Pours like cream: brush marks level out, and thick passages sag and run on a tilted canvas.</source>
        <translation>像鮮奶油一樣流動：筆痕會攤平，厚的地方在傾斜的畫布上會垂流。</translation>
    </message>
    <message>
        <source>house paint</source>
        <translation>油漆</translation>
    </message>
    <message>
        <source>Glossy enamel from the tin: it levels at once, drips freely and leaves long rounded tears.</source>
        <translation>罐裝的亮光瓷漆：立刻攤平，容易滴落，留下圓而長的淚痕。</translation>
    </message>
    <message>
        <source>ink glaze</source>
        <translation>墨水罩染</translation>
    </message>
    <message>
        <source>Thin as ink: a transparent film that settles into the weave and runs wherever the canvas leans.</source>
        <translation>稀薄如墨的透明薄層，沉入布紋，並往畫布傾斜的方向流去。</translation>
    </message>
    <message>
        <source>thinner</source>
        <translation>稀釋劑</translation>
    </message>
    <message>
        <source>Clear thinner: loosens wet paint that it meets, lifts dried ink, and leaves nothing behind.</source>
        <translation>透明的稀釋劑：使碰到的濕顏料變鬆，溶起乾掉的墨水，不留任何痕跡。</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>顏料</translation>
    </message>
    <message>
        <source>Oils</source>
        <translation>油彩</translation>
    </message>
    <message>
        <source>Acrylics and others</source>
        <translation>壓克力與其他</translation>
    </message>
    <message>
        <source>wax paste</source>
        <translation>蠟膏</translation>
    </message>
    <message>
        <source>Oil with cold wax, short and dull: it breaks off sharply at the edge and keeps every cut of the knife.</source>
        <translation>摻冷蠟的油彩，短而無光：邊緣俐落斷開，刀痕一一保留。</translation>
    </message>
    <message>
        <source>alkyd gel</source>
        <translation>醇酸凝膠</translation>
    </message>
    <message>
        <source>A clear gel with a little paint: transparent, stands as the brush left it, and dries overnight.</source>
        <translation>摻少量顏料的透明凝膠：通透，保持筆觸原樣，一夜即乾。</translation>
    </message>
    <message>
        <source>linseed oil</source>
        <translation>亞麻仁油</translation>
    </message>
    <message>
        <source>Paint let down with linseed oil, long and buttery: brush marks soften, and thick passages sag slowly.</source>
        <translation>以亞麻仁油調開的顏料，柔長滑順：筆觸變柔，厚處緩緩下垂。</translation>
    </message>
    <message>
        <source>stand oil</source>
        <translation>熟油</translation>
    </message>
    <message>
        <source>Paint in thickened oil, smooth as enamel: brush marks flow out, and it runs in slow, round tears.</source>
        <translation>以稠化油調的顏料，平滑如琺瑯：筆觸流平，緩緩流成圓潤的淚滴。</translation>
    </message>
    <message>
        <source>thin oil</source>
        <translation>稀油</translation>
    </message>
    <message>
        <source>Oil thinned with turpentine for the first lay-in: streaky, it settles into the weave and runs when tilted.</source>
        <translation>以松節油稀釋、用於起稿的油彩：帶條痕，沉入布紋，傾斜時流動。</translation>
    </message>
    <message>
        <source>Width of the tip.</source>
        <translation>筆尖的寬度。</translation>
    </message>
    <message>
        <source>Thickness of the tip; a round one is as thick as it is wide.</source>
        <translation>筆尖的厚度；圓形的厚度與寬度相同。</translation>
    </message>
    <message>
        <source>Length of the free hairs.</source>
        <translation>露出筆毛的長度。</translation>
    </message>
    <message>
        <source>How much shorter the outermost hairs are; at most the length.</source>
        <translation>最外側的筆毛短多少；最多等於筆毛長度。</translation>
    </message>
    <message>
        <source>Elements that the tip is made of.</source>
        <translation>組成筆尖的單元數。</translation>
    </message>
    <message>
        <source>Fine streaks within one element.</source>
        <translation>每個單元中的細紋數。</translation>
    </message>
    <message>
        <source>Makes one piece differ from the next.</source>
        <translation>讓每一支彼此不同。</translation>
    </message>
    <message>
        <source>How far a bent hair trails behind the hand.</source>
        <translation>彎曲的筆毛落後手部多遠。</translation>
    </message>
    <message>
        <source>How far the hairs spread at full pressure.</source>
        <translation>全壓力時筆毛散開的程度。</translation>
    </message>
    <message>
        <source>How long the hairs trail after a turn.</source>
        <translation>轉向後筆毛拖曳多久。</translation>
    </message>
    <message>
        <source>Way of the ferrule at full pressure, in hair lengths.</source>
        <translation>全壓力時金屬箍下降的距離，以筆毛長度計。</translation>
    </message>
    <message>
        <source>How much a lean lowers one side.</source>
        <translation>傾斜時一側下降多少。</translation>
    </message>
    <message>
        <source>How steeply hairs follow the weave down: little gives dry brush.</source>
        <translation>筆毛順著布紋下降的陡度：小則成乾筆。</translation>
    </message>
    <message>
        <source>0: every hair for itself, 1: one stiff edge.</source>
        <translation>0：筆毛各自活動，1：一道硬邊。</translation>
    </message>
    <message>
        <source>How far wet paint carries it in a light hand, off the ground.</source>
        <translation>輕手時濕顏料將它托離底面的程度。</translation>
    </message>
    <message>
        <source>Wet film that a full brush leaves.</source>
        <translation>蘸滿的筆刷留下的濕膜。</translation>
    </message>
    <message>
        <source>Stroke that a full load lasts.</source>
        <translation>蘸滿一次能畫的筆觸長度。</translation>
    </message>
    <message>
        <source>Ridges between bristles, in films.</source>
        <translation>鬃毛之間的隆起，以膜厚計。</translation>
    </message>
    <message>
        <source>Streaks of single hairs, in films.</source>
        <translation>單根筆毛的細紋，以膜厚計。</translation>
    </message>
    <message>
        <source>Difference from bristle to bristle.</source>
        <translation>鬃毛之間的差異。</translation>
    </message>
    <message>
        <source>How far each dip gathers the hairs anew; 0: never.</source>
        <translation>每次蘸取時筆毛重新聚攏的程度；0：從不。</translation>
    </message>
    <message>
        <source>Extra film along the edges, in films.</source>
        <translation>邊緣多出的膜，以膜厚計。</translation>
    </message>
    <message>
        <source>Extra film where the stroke starts.</source>
        <translation>筆觸起點多出的膜。</translation>
    </message>
    <message>
        <source>Share of the load that stays on lifting.</source>
        <translation>提筆時留下的顏料比例。</translation>
    </message>
    <message>
        <source>Depth that hanging paint bridges, in films.</source>
        <translation>懸垂的顏料能跨越的深度，以膜厚計。</translation>
    </message>
    <message>
        <source>Share of the paint in the way that is taken up.</source>
        <translation>帶起途中顏料的比例。</translation>
    </message>
    <message>
        <source>How fast it mixes with the paint below.</source>
        <translation>與下方顏料混合的速度。</translation>
    </message>
    <message>
        <source>Exchange between neighbouring hairs.</source>
        <translation>相鄰筆毛之間的交換。</translation>
    </message>
    <message>
        <source>How far a fast stroke drags paint along and ploughs it aside.</source>
        <translation>快速筆觸拖動並推開顏料的程度。</translation>
    </message>
    <message>
        <source>Fill above which paint is pushed out sideways.</source>
        <translation>超過此含量時顏料會被擠向兩側。</translation>
    </message>
    <message>
        <source>Step, in radii of an element.</source>
        <translation>步長，以單元半徑計。</translation>
    </message>
    <message>
        <source>Least step.</source>
        <translation>最小步長。</translation>
    </message>
    <message>
        <source>Time over which the hand is steadied.</source>
        <translation>穩定手部的時間。</translation>
    </message>
    <message>
        <source>Length of the string that pulls the tip.</source>
        <translation>拉動筆尖的繩子長度。</translation>
    </message>
    <message>
        <source>Mean volume of a drop.</source>
        <translation>一滴的平均體積。</translation>
    </message>
    <message>
        <source>How much drops differ.</source>
        <translation>各滴之間的差異。</translation>
    </message>
    <message>
        <source>Paint let go while the pen is down.</source>
        <translation>筆落下時放出的顏料。</translation>
    </message>
    <message>
        <source>A drop let go when the pen comes down.</source>
        <translation>落筆時放出的一滴。</translation>
    </message>
    <message>
        <source>What the bottle holds.</source>
        <translation>瓶子的容量。</translation>
    </message>
    <message>
        <source>Height over radius of a drop that has landed.</source>
        <translation>落下液滴的高度與半徑之比。</translation>
    </message>
    <message>
        <source>0: evenly over the width, 1: thickest in the middle.</source>
        <translation>0：均勻分布於寬度，1：中間最厚。</translation>
    </message>
    <message>
        <source>Time that drops fly on with the speed of the tip.</source>
        <translation>液滴以筆尖速度繼續飛行的時間。</translation>
    </message>
    <message>
        <source>Pressure in the middle of the jet.</source>
        <translation>氣流中心的壓力。</translation>
    </message>
    <message>
        <source>Calligraphy nib 3</source>
        <translation>書法筆尖 3</translation>
    </message>
    <message>
        <source>Charcoal 8</source>
        <translation>炭筆 8</translation>
    </message>
    <message>
        <source>Marbling comb 80</source>
        <translation>大理石紋梳 80</translation>
    </message>
    <message>
        <source>Oil pastel 10</source>
        <translation>油性粉彩 10</translation>
    </message>
    <message>
        <source>Roller 50</source>
        <translation>滾筒 50</translation>
    </message>
    <message>
        <source>Ruling pen 1</source>
        <translation>鴨嘴筆 1</translation>
    </message>
    <message>
        <source>Sponge 45</source>
        <translation>海綿 45</translation>
    </message>
    <message>
        <source>Squeegee 120</source>
        <translation>刮刀膠條 120</translation>
    </message>
    <message>
        <source>Width of a comb&apos;s tooth, in distances of its teeth.</source>
        <translation>梳齒的寬度，以齒距為單位。</translation>
    </message>
    <message>
        <source>Depth of a sponge&apos;s pores.</source>
        <translation>海綿孔洞的深度。</translation>
    </message>
    <message>
        <source>Way round a roller, after which its mark comes again; 0: it does not roll.</source>
        <translation>滾筒一圈的長度，之後痕跡會重複；0：不滾動。</translation>
    </message>
    <message>
        <source>0: levels the hollows that it reaches, 1: coats the grain alone.</source>
        <translation>0：填平所及的凹處；1：只覆在紋理凸處。</translation>
    </message>
    <message>
        <source>How many squares of the paint&apos;s grid lie side by side in a millimetre, and pixels in the saved picture: more show finer hairs, and need more memory and time</source>
        <translation>每毫米並排的顏料格數，也是存成圖片時的像素數：越多，筆毛越細緻，但需要更多記憶體和時間</translation>
    </message>
    <message>
        <source>What paint lies on, bare: linen, jute, cotton duck, a panel or a height image</source>
        <translation>顏料之下的素底：亞麻布、黃麻布、棉帆布、畫板或高度圖</translation>
    </message>
    <message>
        <source>How steeply the canvas stands, and where down is: wet paint runs there</source>
        <translation>畫布立得多陡，以及哪邊是下方：濕顏料會往那裡流</translation>
    </message>
    <message>
        <source>Where the lamp stands that lights the painting: a low one shows the relief, the heights of paint and canvas</source>
        <translation>照亮畫作的燈的位置：燈越低，越能看出顏料和畫布的起伏</translation>
    </message>
    <message>
        <source>How many times as fast as by the clock wet paint becomes dry paint</source>
        <translation>濕顏料變乾的速度是時鐘的幾倍</translation>
    </message>
    <message>
        <source>What the brush holds from side to side of its tip, and how full it is of what it can hold</source>
        <translation>筆刷尖端從一側到另一側所含的顏料，以及占可含量的多少</translation>
    </message>
    <message>
        <source>What pigment is mixed with: it decides how stiff the paint is, how far it levels and how soon it dries</source>
        <translation>與色料混合的東西：決定顏料有多硬、能流平多少、多快乾</translation>
    </message>
    <message>
        <source>How a trembling hand is steadied, besides the brush&apos;s own smoothing</source>
        <translation>在筆刷本身的平滑之外，另外修正手的抖動</translation>
    </message>
    <message>
        <source>Hues that go together by their places on the wheel</source>
        <translation>依色環上的位置彼此相配的色相</translation>
    </message>
    <message>
        <source>A shape on the disc of hues that choosing on the wheel keeps to</source>
        <translation>色相圓盤上的形狀，在色環上選色時會保持在其中</translation>
    </message>
    <message>
        <source>The light that the painting is seen in: the same paint has other colours in another one</source>
        <translation>觀看畫作的光：同樣的顏料在別的光下顏色不同</translation>
    </message>
    <message>
        <source>A clear coat over the whole painting that is looked through, and changes no paint</source>
        <translation>覆蓋整幅畫的透明塗層，隔著它看，不改變任何顏料</translation>
    </message>
    <message>
        <source>ΔE is how far two colours differ to the eye: 1 is seen side by side, 2 to 3 at a second look</source>
        <translation>ΔE 是兩種顏色在肉眼看來的差異：1 並排才看得出，2 到 3 再看一眼就看得出</translation>
    </message>
    <message>
        <source>D65, D50 and A are the lights that colours are measured in everywhere: daylight, the light of print booths, and a light bulb</source>
        <translation>D65、D50 和 A 是各地測量顏色時使用的光：日光、看樣燈箱的光，以及燈泡的光</translation>
    </message>
    <message>
        <source>A soft proof shows on the screen how the painting would be printed; the gamut warning shows what this printer cannot print</source>
        <translation>軟打樣在螢幕上顯示畫作印出來的樣子；色域警告顯示這台印表機印不出的顏色</translation>
    </message>
</context>
<context>
    <name>pastoso::appearance::UnitBox</name>
    <message>
        <source>&quot;%1&quot; is not understood here; the number stays as it was.</source>
        <translation>這裡看不懂「%1」；數值保持原樣。</translation>
    </message>
</context>
<context>
    <name>pastoso::commands</name>
    <message>
        <source>&amp;File</source>
        <translation>檔案(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編輯(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>筆刷(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>顏料(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>圖層(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>選取(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Guides</source>
        <translation>輔助線(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>檢視(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>光線(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation>設定(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;New canvas...</source>
        <translation>新增畫布(&amp;N)...</translation>
    </message>
    <message>
        <source>Put a fresh canvas on the easel</source>
        <translation>在畫架上放一張新的畫布</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>開啟(&amp;O)...</translation>
    </message>
    <message>
        <source>Go on with a painting that was saved, wet as it was</source>
        <translation>接著畫先前儲存的畫作，未乾的顏料也原樣保留</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>儲存(&amp;S)</translation>
    </message>
    <message>
        <source>Save the painting with all its wet paint</source>
        <translation>儲存畫作，包括所有濕顏料</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>另存新檔(&amp;A)...</translation>
    </message>
    <message>
        <source>Save the painting in another file</source>
        <translation>將畫作存成另一個檔案</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>匯出(&amp;E)...</translation>
    </message>
    <message>
        <source>Make a picture, layers, maps, a relief to print or a time-lapse of the painting</source>
        <translation>將畫作輸出為圖片、圖層、貼圖、可列印的浮雕或縮時影片</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>再次匯出(&amp;G)</translation>
    </message>
    <message>
        <source>The same export of the painting as it is now, into the same file</source>
        <translation>以相同設定將畫作目前的樣子匯出到同一個檔案</translation>
    </message>
    <message>
        <source>S&amp;top the export</source>
        <translation>停止匯出(&amp;T)</translation>
    </message>
    <message>
        <source>Give up the export that is being written; its file stays as it was</source>
        <translation>放棄正在寫入的匯出；原有的檔案保持不變</translation>
    </message>
    <message>
        <source>Export &amp;recording...</source>
        <translation>匯出錄製檔(&amp;R)...</translation>
    </message>
    <message>
        <source>Save all strokes, to be replayed at any resolution</source>
        <translation>儲存所有筆觸，可用任何解析度重播</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>結束(&amp;Q)</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>關閉視窗</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>復原(&amp;U)</translation>
    </message>
    <message>
        <source>Take the last stroke back</source>
        <translation>收回上一筆</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Put the last stroke back</source>
        <translation>恢復剛才收回的一筆</translation>
    </message>
    <message>
        <source>&amp;Memory for undo...</source>
        <translation>復原記憶體(&amp;M)...</translation>
    </message>
    <message>
        <source>How much memory the steps may take that you can return to</source>
        <translation>可以返回的步驟最多能占用多少記憶體</translation>
    </message>
    <message>
        <source>&amp;Canvas size...</source>
        <translation>畫布尺寸(&amp;C)...</translation>
    </message>
    <message>
        <source>Make the canvas larger, or cut it, on any side</source>
        <translation>從任一邊加大或裁切畫布</translation>
    </message>
    <message>
        <source>Crop to the &amp;selection</source>
        <translation>裁切到選取範圍(&amp;S)</translation>
    </message>
    <message>
        <source>Cut the canvas to the smallest one that holds what is selected</source>
        <translation>將畫布裁切到剛好容納選取的部分</translation>
    </message>
    <message>
        <source>&amp;Narrower</source>
        <translation>縮小筆刷(&amp;N)</translation>
    </message>
    <message>
        <source>A narrower brush</source>
        <translation>較窄的筆刷</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>加大筆刷(&amp;W)</translation>
    </message>
    <message>
        <source>A wider brush</source>
        <translation>較寬的筆刷</translation>
    </message>
    <message>
        <source>Next &amp;brush</source>
        <translation>下一支筆刷(&amp;B)</translation>
    </message>
    <message>
        <source>Take the next brush of the list</source>
        <translation>換成清單中的下一支筆刷</translation>
    </message>
    <message>
        <source>&amp;Previous brush</source>
        <translation>上一支筆刷(&amp;P)</translation>
    </message>
    <message>
        <source>Take the brush before in the list</source>
        <translation>換成清單中的上一支筆刷</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>重新沾料(&amp;R)</translation>
    </message>
    <message>
        <source>Clean the brush and fill it with the paint</source>
        <translation>清潔筆刷，再沾滿顏料</translation>
    </message>
    <message>
        <source>&amp;Top up</source>
        <translation>補沾顏料(&amp;T)</translation>
    </message>
    <message>
        <source>Dip the brush without cleaning it: what it holds stays on it</source>
        <translation>不清潔就再沾顏料：筆刷上原有的會留著</translation>
    </message>
    <message>
        <source>B&amp;lot</source>
        <translation>吸除顏料(&amp;L)</translation>
    </message>
    <message>
        <source>Press the brush into a cloth: a quarter of its paint stays on it</source>
        <translation>把筆刷按在布上：只留下四分之一的顏料</translation>
    </message>
    <message>
        <source>&amp;Clean</source>
        <translation>清潔筆刷(&amp;C)</translation>
    </message>
    <message>
        <source>Wipe the brush: an empty one moves the paint that lies there</source>
        <translation>擦淨筆刷：乾淨的筆刷可推動畫面上的顏料</translation>
    </message>
    <message>
        <source>S&amp;wap the two paints</source>
        <translation>交換兩種顏料(&amp;W)</translation>
    </message>
    <message>
        <source>Dip the brush in the second paint; the first takes its place</source>
        <translation>讓筆刷改沾第二種顏料；原來的換到第二種的位置</translation>
    </message>
    <message>
        <source>P&amp;ick up the paint there</source>
        <translation>沾取畫面上的顏料(&amp;I)</translation>
    </message>
    <message>
        <source>The next click dips the brush in the mixture of pigments that lies there; so does Ctrl and a click</source>
        <translation>下一次按一下，筆刷就會沾取該處混好的顏料；按住 Ctrl 再按一下也可以</translation>
    </message>
    <message>
        <source>Pick the c&amp;olour seen there</source>
        <translation>取用畫面上的顏色(&amp;O)</translation>
    </message>
    <message>
        <source>The next click makes paint of the colour that is seen there; so does Alt and a click</source>
        <translation>下一次按一下，就會以該處看到的顏色調出顏料；按住 Alt 再按一下也可以</translation>
    </message>
    <message>
        <source>Reload before &amp;each stroke</source>
        <translation>每一筆都重新沾料(&amp;E)</translation>
    </message>
    <message>
        <source>Every stroke starts with a clean, full brush</source>
        <translation>每一筆都從乾淨且沾滿的筆刷開始</translation>
    </message>
    <message>
        <source>&amp;Turn with the stroke</source>
        <translation>隨筆觸轉動(&amp;T)</translation>
    </message>
    <message>
        <source>Flat brushes stand across their path, where the pen does not tell its rotation</source>
        <translation>筆不提供旋轉角度時，讓平頭筆刷與行進方向垂直</translation>
    </message>
    <message>
        <source>&amp;Save as my own...</source>
        <translation>存為自己的工具(&amp;S)...</translation>
    </message>
    <message>
        <source>Keep the tool in hand, with its curves, among your own</source>
        <translation>將手上的工具連同曲線存入自己的工具</translation>
    </message>
    <message>
        <source>Re&amp;name...</source>
        <translation>重新命名(&amp;N)...</translation>
    </message>
    <message>
        <source>Give your own tool another name</source>
        <translation>為自己的工具換個名稱</translation>
    </message>
    <message>
        <source>&amp;Delete...</source>
        <translation>刪除(&amp;D)...</translation>
    </message>
    <message>
        <source>Throw your own tool away</source>
        <translation>丟掉自己的工具</translation>
    </message>
    <message>
        <source>&amp;Pause the paint</source>
        <translation>暫停顏料(&amp;P)</translation>
    </message>
    <message>
        <source>Wet paint stands still until you go on</source>
        <translation>濕顏料靜止不動，直到你繼續為止</translation>
    </message>
    <message>
        <source>&amp;Dry now</source>
        <translation>立即乾燥(&amp;D)</translation>
    </message>
    <message>
        <source>All wet paint dries at once: paint over it without stirring it up</source>
        <translation>所有濕顏料立刻變乾：可以疊畫而不會攪動下層</translation>
    </message>
    <message>
        <source>Mixing &amp;well</source>
        <translation>調色槽(&amp;W)</translation>
    </message>
    <message>
        <source>A palette of wet paint: mix there with any tool, and carry it to the canvas</source>
        <translation>放濕顏料的調色盤：可用任何工具調色，再帶到畫布上</translation>
    </message>
    <message>
        <source>&amp;Squeeze onto the well</source>
        <translation>擠到調色槽(&amp;S)</translation>
    </message>
    <message>
        <source>Squeeze the paint that you chose onto the mixing well; Control and click says where</source>
        <translation>將選好的顏料擠到調色槽上；按住 Ctrl 再按一下可指定位置</translation>
    </message>
    <message>
        <source>&amp;Clean the well</source>
        <translation>清潔調色槽(&amp;C)</translation>
    </message>
    <message>
        <source>Wipe the mixing well bare</source>
        <translation>將調色槽擦乾淨</translation>
    </message>
    <message>
        <source>&amp;New layer</source>
        <translation>新增圖層(&amp;N)</translation>
    </message>
    <message>
        <source>A bare layer above the one that you paint on</source>
        <translation>在目前作畫的圖層上方新增空白圖層</translation>
    </message>
    <message>
        <source>From a &amp;picture...</source>
        <translation>從圖片新增(&amp;P)...</translation>
    </message>
    <message>
        <source>Put a picture onto the canvas as a layer of dry paint</source>
        <translation>將圖片放到畫布上，成為一層乾顏料</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>複製圖層(&amp;D)</translation>
    </message>
    <message>
        <source>The same paint once more, on a layer above</source>
        <translation>在上方圖層再放一份相同的顏料</translation>
    </message>
    <message>
        <source>Na&amp;me...</source>
        <translation>命名(&amp;M)...</translation>
    </message>
    <message>
        <source>Give the layer or the group another name</source>
        <translation>為圖層或群組換個名稱</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除圖層(&amp;R)</translation>
    </message>
    <message>
        <source>Take the layer away with all its paint</source>
        <translation>移除圖層和上面的所有顏料</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>清除(&amp;C)</translation>
    </message>
    <message>
        <source>Wipe all paint off the layer</source>
        <translation>擦掉圖層上的所有顏料</translation>
    </message>
    <message>
        <source>&amp;Transform</source>
        <translation>變形(&amp;T)</translation>
    </message>
    <message>
        <source>Move, scale, turn and mirror the layer&apos;s paint, or what is selected of it, by a frame</source>
        <translation>用外框移動、縮放、旋轉和鏡像圖層的顏料或選取的部分</translation>
    </message>
    <message>
        <source>M&amp;erge down</source>
        <translation>向下合併(&amp;E)</translation>
    </message>
    <message>
        <source>Put the layer&apos;s paint on the layer below, and make them one</source>
        <translation>將圖層的顏料疊到下方圖層上，合成一層</translation>
    </message>
    <message>
        <source>&amp;Flatten what is visible</source>
        <translation>平面化可見圖層(&amp;F)</translation>
    </message>
    <message>
        <source>Make one layer of all that are visible; hidden ones stay</source>
        <translation>將所有可見圖層合成一層；隱藏的圖層保留</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>組成群組(&amp;G)</translation>
    </message>
    <message>
        <source>Put the chosen layers into a group, which is hidden, locked and faded as one</source>
        <translation>將選取的圖層放入群組，一起隱藏、鎖定和調淡</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>解散群組(&amp;U)</translation>
    </message>
    <message>
        <source>Dissolve the group; its layers stay where they are</source>
        <translation>解散群組；其中的圖層留在原處</translation>
    </message>
    <message>
        <source>&amp;Visible</source>
        <translation>可見(&amp;V)</translation>
    </message>
    <message>
        <source>Show or hide the layer or the group</source>
        <translation>顯示或隱藏圖層或群組</translation>
    </message>
    <message>
        <source>&amp;Locked</source>
        <translation>鎖定(&amp;L)</translation>
    </message>
    <message>
        <source>Keep the layer or the group from being painted on, cleared and merged</source>
        <translation>避免圖層或群組被畫到、清除或合併</translation>
    </message>
    <message>
        <source>Choose the one &amp;above</source>
        <translation>選取上方圖層(&amp;A)</translation>
    </message>
    <message>
        <source>Paint on the layer above</source>
        <translation>在上方的圖層作畫</translation>
    </message>
    <message>
        <source>Choose the one &amp;below</source>
        <translation>選取下方圖層(&amp;B)</translation>
    </message>
    <message>
        <source>Paint on the layer below</source>
        <translation>在下方的圖層作畫</translation>
    </message>
    <message>
        <source>Move u&amp;p</source>
        <translation>上移(&amp;P)</translation>
    </message>
    <message>
        <source>Move the layer or the group one place up, into and out of groups</source>
        <translation>將圖層或群組往上移一格，可移入或移出群組</translation>
    </message>
    <message>
        <source>Move d&amp;own</source>
        <translation>下移(&amp;O)</translation>
    </message>
    <message>
        <source>Move the layer or the group one place down, into and out of groups</source>
        <translation>將圖層或群組往下移一格，可移入或移出群組</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>矩形(&amp;R)</translation>
    </message>
    <message>
        <source>Drag a rectangle that tools keep to; Shift adds, Alt takes away, Ctrl makes a square</source>
        <translation>拖曳出工具可作用的矩形範圍；Shift 增加，Alt 減去，Ctrl 畫正方形</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>套索(&amp;L)</translation>
    </message>
    <message>
        <source>Draw around what tools keep to; Shift adds, Alt takes away</source>
        <translation>圈出工具可作用的範圍；Shift 增加，Alt 減去</translation>
    </message>
    <message>
        <source>End the selection: tools work on all of the canvas</source>
        <translation>取消選取：工具可作用於整張畫布</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>反轉(&amp;I)</translation>
    </message>
    <message>
        <source>Select what is not selected</source>
        <translation>改為選取未選取的部分</translation>
    </message>
    <message>
        <source>By &amp;height...</source>
        <translation>依高度(&amp;H)...</translation>
    </message>
    <message>
        <source>Select where the paint stands so high above the bare canvas</source>
        <translation>選取顏料高出空白畫布的高度在指定範圍內的地方</translation>
    </message>
    <message>
        <source>By &amp;wetness...</source>
        <translation>依濕潤度(&amp;W)...</translation>
    </message>
    <message>
        <source>Select where the wet paint of the layer is so thick</source>
        <translation>選取圖層上濕顏料厚度在指定範圍內的地方</translation>
    </message>
    <message>
        <source>Show the &amp;outline</source>
        <translation>顯示外框線(&amp;O)</translation>
    </message>
    <message>
        <source>Hidden, it is out of the way of what you paint; tools keep to it as before</source>
        <translation>隱藏後不會妨礙作畫；工具仍只作用於選取範圍</translation>
    </message>
    <message>
        <source>&amp;Mirror left and right</source>
        <translation>左右鏡像(&amp;M)</translation>
    </message>
    <message>
        <source>Every stroke is painted on both sides of the upright line</source>
        <translation>每一筆都同時畫在垂直線的兩側</translation>
    </message>
    <message>
        <source>Mirror a&amp;bove and below</source>
        <translation>上下鏡像(&amp;B)</translation>
    </message>
    <message>
        <source>Every stroke is painted on both sides of the level line</source>
        <translation>每一筆都同時畫在水平線的兩側</translation>
    </message>
    <message>
        <source>M&amp;ore copies around the middle</source>
        <translation>增加環繞份數(&amp;O)</translation>
    </message>
    <message>
        <source>Every stroke is painted once more around the middle of the canvas</source>
        <translation>每一筆繞著畫布中心多畫一份</translation>
    </message>
    <message>
        <source>&amp;Fewer copies around the middle</source>
        <translation>減少環繞份數(&amp;F)</translation>
    </message>
    <message>
        <source>Every stroke is painted once less around the middle of the canvas</source>
        <translation>每一筆繞著畫布中心少畫一份</translation>
    </message>
    <message>
        <source>&amp;Ruler along the last stroke</source>
        <translation>沿上一筆放直尺(&amp;R)</translation>
    </message>
    <message>
        <source>Strokes run along the ruler, or parallel to it; Shift and drag draw a straight line</source>
        <translation>筆觸沿著直尺走，或與直尺平行；按住 Shift 拖曳可畫直線</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>橢圓(&amp;E)</translation>
    </message>
    <message>
        <source>Strokes run along the ellipse, or along another of the same shape</source>
        <translation>筆觸沿著橢圓走，或沿著另一個同形的橢圓</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>控制點(&amp;H)</translation>
    </message>
    <message>
        <source>Points by which guides are dragged; Shift keeps to steps and proportions</source>
        <translation>用來拖曳輔助線的點；按住 Shift 可依固定間距並維持比例</translation>
    </message>
    <message>
        <source>&amp;No guides</source>
        <translation>移除輔助線(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Trace a picture...</source>
        <translation>描圖(&amp;T)...</translation>
    </message>
    <message>
        <source>Lay a picture below the paint, and beside the canvas; it is in no picture that you save</source>
        <translation>將圖片墊在顏料下方，並放在畫布旁；它不會出現在你儲存的任何圖片中</translation>
    </message>
    <message>
        <source>&amp;Show it below the paint</source>
        <translation>顯示在顏料下方(&amp;S)</translation>
    </message>
    <message>
        <source>Show or hide the picture that you trace</source>
        <translation>顯示或隱藏描圖的底圖</translation>
    </message>
    <message>
        <source>F&amp;it it to the canvas</source>
        <translation>符合畫布大小(&amp;I)</translation>
    </message>
    <message>
        <source>In the middle of the canvas, as large as it fits</source>
        <translation>置於畫布中央，放到能容納的最大尺寸</translation>
    </message>
    <message>
        <source>Ta&amp;ke it away</source>
        <translation>移除底圖(&amp;K)</translation>
    </message>
    <message>
        <source>Take the picture that you trace away</source>
        <translation>移除描圖用的底圖</translation>
    </message>
    <message>
        <source>&amp;Fit the canvas</source>
        <translation>顯示整張畫布(&amp;F)</translation>
    </message>
    <message>
        <source>Show the whole canvas</source>
        <translation>將整張畫布顯示在視窗內</translation>
    </message>
    <message>
        <source>&amp;Actual pixels</source>
        <translation>實際像素(&amp;A)</translation>
    </message>
    <message>
        <source>One screen pixel for every pixel of the saved picture</source>
        <translation>儲存圖片的每個像素對應螢幕上的一個像素</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>放大(&amp;I)</translation>
    </message>
    <message>
        <source>Closer</source>
        <translation>靠近一點</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>縮小(&amp;O)</translation>
    </message>
    <message>
        <source>Farther</source>
        <translation>退遠一點</translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation>向左轉(&amp;L)</translation>
    </message>
    <message>
        <source>Turn the canvas a little to the left on the screen; so does Shift+Space and a drag</source>
        <translation>將螢幕上的畫布稍微向左轉；也可按住 Shift+空白鍵拖曳</translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation>轉正(&amp;U)</translation>
    </message>
    <message>
        <source>The canvas stands again as it is saved</source>
        <translation>讓畫布回到儲存時的方向</translation>
    </message>
    <message>
        <source>Turn &amp;right</source>
        <translation>向右轉(&amp;R)</translation>
    </message>
    <message>
        <source>Turn the canvas a little to the right on the screen; so does Shift+Space and a drag</source>
        <translation>將螢幕上的畫布稍微向右轉；也可按住 Shift+空白鍵拖曳</translation>
    </message>
    <message>
        <source>&amp;Mirror the view</source>
        <translation>鏡像檢視(&amp;M)</translation>
    </message>
    <message>
        <source>See the painting as in a mirror, and paint on it so; it is saved as it is</source>
        <translation>像照鏡子一樣看畫，也能這樣作畫；儲存的畫作不受影響</translation>
    </message>
    <message>
        <source>Canvas &amp;only</source>
        <translation>只顯示畫布(&amp;O)</translation>
    </message>
    <message>
        <source>Nothing but the canvas; Tab or Escape brings the panels back</source>
        <translation>除了畫布什麼都不顯示；按 Tab 或 Esc 恢復面板</translation>
    </message>
    <message>
        <source>In its l&amp;ight</source>
        <translation>燈光下(&amp;I)</translation>
    </message>
    <message>
        <source>The paint as it hangs in its light</source>
        <translation>顏料在燈光下的樣子</translation>
    </message>
    <message>
        <source>Show &amp;wet</source>
        <translation>顯示未乾處(&amp;W)</translation>
    </message>
    <message>
        <source>Tints what is still wet, the more the thicker it is</source>
        <translation>為未乾的地方染色，越厚染得越濃</translation>
    </message>
    <message>
        <source>Show &amp;height</source>
        <translation>顯示高度(&amp;H)</translation>
    </message>
    <message>
        <source>How high the paint stands above the bare canvas, in steps of colour</source>
        <translation>以分階的顏色顯示顏料高出空白畫布多少</translation>
    </message>
    <message>
        <source>Show &amp;normals</source>
        <translation>顯示法線(&amp;N)</translation>
    </message>
    <message>
        <source>Where the surface faces: red to the right, green up, blue towards you</source>
        <translation>表面的朝向：紅色朝右，綠色朝上，藍色朝向你</translation>
    </message>
    <message>
        <source>&amp;Flat colour</source>
        <translation>只看顏色(&amp;F)</translation>
    </message>
    <message>
        <source>The paint&apos;s colours alone, without light and relief</source>
        <translation>只有顏料的顏色，不含光影和起伏</translation>
    </message>
    <message>
        <source>&amp;Tool panel</source>
        <translation>工具面板(&amp;T)</translation>
    </message>
    <message>
        <source>What the brush holds, and how it answers to the hand</source>
        <translation>筆刷沾了什麼，以及它如何隨手的動作變化</translation>
    </message>
    <message>
        <source>&amp;Colour panel</source>
        <translation>顏色面板(&amp;C)</translation>
    </message>
    <message>
        <source>A paint of any colour, and its recipe from the tubes</source>
        <translation>任何顏色的顏料，以及用管裝顏料調出它的配方</translation>
    </message>
    <message>
        <source>P&amp;hysics panel</source>
        <translation>物理面板(&amp;H)</translation>
    </message>
    <message>
        <source>What the paint is like: how it flows, holds and dries</source>
        <translation>顏料的特性：如何流動、定形和乾燥</translation>
    </message>
    <message>
        <source>&amp;Guides panel</source>
        <translation>輔助線面板(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Layers panel</source>
        <translation>圖層面板(&amp;L)</translation>
    </message>
    <message>
        <source>The layers of the painting: seen, locked, faded, in what order</source>
        <translation>畫作的圖層：顯示、鎖定、調淡與順序</translation>
    </message>
    <message>
        <source>Tr&amp;acing panel</source>
        <translation>描圖面板(&amp;A)</translation>
    </message>
    <message>
        <source>The picture that you trace, to look at and to pick colours from</source>
        <translation>描圖用的底圖，可供觀察和取色</translation>
    </message>
    <message>
        <source>&amp;History panel</source>
        <translation>步驟記錄面板(&amp;H)</translation>
    </message>
    <message>
        <source>What was done, to go back to any of it</source>
        <translation>做過的每個步驟，可返回任何一步</translation>
    </message>
    <message>
        <source>&amp;Reset the panels</source>
        <translation>重設面板(&amp;R)</translation>
    </message>
    <message>
        <source>Panels and mixing well as they stood at the first start</source>
        <translation>面板和調色槽恢復到首次啟動時的位置</translation>
    </message>
    <message>
        <source>Colours for s&amp;RGB</source>
        <translation>使用 sRGB 色彩(&amp;R)</translation>
    </message>
    <message>
        <source>Shows the painting for common screens</source>
        <translation>為一般螢幕顯示畫作</translation>
    </message>
    <message>
        <source>Colours for Display &amp;P3</source>
        <translation>使用 Display P3 色彩(&amp;P)</translation>
    </message>
    <message>
        <source>Shows the painting for a screen of wide gamut</source>
        <translation>為廣色域螢幕顯示畫作</translation>
    </message>
    <message>
        <source>&amp;Daylight (D65)</source>
        <translation>日光 (D65)(&amp;D)</translation>
    </message>
    <message>
        <source>The light that screens are made for</source>
        <translation>螢幕所依據的光源</translation>
    </message>
    <message>
        <source>&amp;Print booth (D50)</source>
        <translation>看樣燈箱 (D50)(&amp;P)</translation>
    </message>
    <message>
        <source>The light that prints are judged in</source>
        <translation>評看印刷品所用的光源</translation>
    </message>
    <message>
        <source>Light &amp;bulb (A)</source>
        <translation>燈泡 (A)(&amp;B)</translation>
    </message>
    <message>
        <source>Incandescent lamplight</source>
        <translation>白熾燈的燈光</translation>
    </message>
    <message>
        <source>&amp;LED lamp</source>
        <translation>LED 燈(&amp;L)</translation>
    </message>
    <message>
        <source>A white LED with its blue peak</source>
        <translation>帶有藍光峰值的白光 LED</translation>
    </message>
    <message>
        <source>From a &amp;file...</source>
        <translation>從檔案(&amp;F)...</translation>
    </message>
    <message>
        <source>A lamp that you have measured, as a CSV file</source>
        <translation>你測量過的燈光，CSV 檔案格式</translation>
    </message>
    <message>
        <source>&amp;Move the light</source>
        <translation>移動燈光(&amp;M)</translation>
    </message>
    <message>
        <source>Drag the lamp over the canvas: towards the rim it rakes over the relief</source>
        <translation>在畫布上拖曳燈的位置：越靠邊緣，光線越斜，越能掃出起伏</translation>
    </message>
    <message>
        <source>&amp;Find a command...</source>
        <translation>尋找指令(&amp;F)...</translation>
    </message>
    <message>
        <source>Type a few letters of what you want to do</source>
        <translation>輸入幾個字，找出想做的事</translation>
    </message>
    <message>
        <source>&amp;Keys...</source>
        <translation>快速鍵(&amp;K)...</translation>
    </message>
    <message>
        <source>Choose a set of keys, and give any command keys of your own</source>
        <translation>選擇一組快速鍵，也可以為任何指令自訂按鍵</translation>
    </message>
    <message>
        <source>&amp;Settings...</source>
        <translation>設定(&amp;S)...</translation>
    </message>
    <message>
        <source>The look of the window, what is kept, and how much of the machine is used</source>
        <translation>視窗的外觀、要保留的內容，以及使用多少電腦資源</translation>
    </message>
    <message>
        <source>Start &amp;page</source>
        <translation>起始頁(&amp;P)</translation>
    </message>
    <message>
        <source>New canvases, recent paintings and examples at a glance</source>
        <translation>新畫布、最近的畫作和範例一覽</translation>
    </message>
    <message>
        <source>&amp;Watch it grow...</source>
        <translation>觀看作畫過程(&amp;W)...</translation>
    </message>
    <message>
        <source>See how the painting came about, in a window of its own; the painting stays as it is</source>
        <translation>在另外的視窗觀看畫作如何完成；畫作本身不會改變</translation>
    </message>
    <message>
        <source>&amp;Make a time-lapse...</source>
        <translation>製作縮時影片(&amp;M)...</translation>
    </message>
    <message>
        <source>A film, or numbered pictures, of how the painting came about</source>
        <translation>用影片或連號圖片呈現畫作的完成過程</translation>
    </message>
    <message>
        <source>Pop-&amp;up palette</source>
        <translation>快顯調色盤(&amp;U)</translation>
    </message>
    <message>
        <source>Tools and paints around the pointer; so does a right click on the canvas</source>
        <translation>在指標周圍顯示工具和顏料；在畫布上按右鍵也可以</translation>
    </message>
    <message>
        <source>&amp;Navigator</source>
        <translation>導覽器(&amp;N)</translation>
    </message>
    <message>
        <source>The whole canvas, to see where the window is and to go elsewhere</source>
        <translation>顯示整張畫布，可看出目前的檢視位置，也可前往別處</translation>
    </message>
    <message>
        <source>Li&amp;ghts panel</source>
        <translation>光線面板(&amp;G)</translation>
    </message>
    <message>
        <source>The lamp, its light, and a coat of varnish to look through</source>
        <translation>燈的位置、光源，以及加在畫面上的一層凡尼斯</translation>
    </message>
    <message>
        <source>Recor&amp;der panel</source>
        <translation>錄製面板(&amp;D)</translation>
    </message>
    <message>
        <source>What is recorded of the painting: watch it grow again, or make a time-lapse</source>
        <translation>畫作的錄製內容：可重看作畫過程，或製作縮時影片</translation>
    </message>
    <message>
        <source>&amp;Pen and tablet...</source>
        <translation>筆與數位板(&amp;P)...</translation>
    </message>
    <message>
        <source>How pens and mouse press, what their buttons do, and a sheet to try them on</source>
        <translation>筆和滑鼠的壓力、按鈕的功能，以及試畫區</translation>
    </message>
    <message>
        <source>&amp;Milk tea</source>
        <translation>奶茶(&amp;M)</translation>
    </message>
    <message>
        <source>A glass of tea in place of the canvas, to pour milk into; the painting waits as it is</source>
        <translation>以一杯茶代替畫布，可倒入牛奶；畫作原樣等候</translation>
    </message>
    <message>
        <source>&amp;New glass</source>
        <translation>新的一杯(&amp;N)</translation>
    </message>
    <message>
        <source>Begin again with clear tea</source>
        <translation>從清茶重新開始</translation>
    </message>
    <message>
        <source>&amp;Open a scene...</source>
        <translation>開啟場景(&amp;O)...</translation>
    </message>
    <message>
        <source>Begin again with the numbers of a file</source>
        <translation>以檔案中的數值重新開始</translation>
    </message>
    <message>
        <source>&amp;Save the scene...</source>
        <translation>儲存場景(&amp;S)...</translation>
    </message>
    <message>
        <source>Keep all numbers of the glass in a file</source>
        <translation>將這杯茶的所有數值存入檔案</translation>
    </message>
    <message>
        <source>&amp;Export the surface...</source>
        <translation>匯出表面(&amp;E)...</translation>
    </message>
    <message>
        <source>&amp;Render a picture...</source>
        <translation>算繪圖片(&amp;R)...</translation>
    </message>
    <message>
        <source>A picture by the light&apos;s true ways, to be saved or painted on</source>
        <translation>依光線真實路徑產生的圖片，可儲存或在上面作畫</translation>
    </message>
    <message>
        <source>As &amp;fast as it can</source>
        <translation>盡可能快(&amp;F)</translation>
    </message>
    <message>
        <source>Time in the glass passes as fast as it is computed</source>
        <translation>杯中的時間以計算所及的最快速度前進</translation>
    </message>
    <message>
        <source>S&amp;tir</source>
        <translation>攪拌(&amp;T)</translation>
    </message>
    <message>
        <source>A force around an upright axis stirs the tea</source>
        <translation>繞著垂直軸的力攪動茶</translation>
    </message>
    <message>
        <source>Axis to the &amp;middle</source>
        <translation>軸移到中央(&amp;M)</translation>
    </message>
    <message>
        <source>The axis of the force stands in the middle of the glass again</source>
        <translation>力的軸回到杯子中央</translation>
    </message>
    <message>
        <source>The other &amp;way round</source>
        <translation>反方向(&amp;W)</translation>
    </message>
    <message>
        <source>Stir the other way round</source>
        <translation>往反方向攪拌</translation>
    </message>
    <message>
        <source>Axis to the &amp;left</source>
        <translation>軸向左(&amp;L)</translation>
    </message>
    <message>
        <source>Move the axis of the force to the left</source>
        <translation>將力的軸移向左邊</translation>
    </message>
    <message>
        <source>Axis to the r&amp;ight</source>
        <translation>軸向右(&amp;I)</translation>
    </message>
    <message>
        <source>Move the axis of the force to the right</source>
        <translation>將力的軸移向右邊</translation>
    </message>
    <message>
        <source>Axis &amp;away</source>
        <translation>軸向遠處(&amp;A)</translation>
    </message>
    <message>
        <source>Move the axis of the force away from you</source>
        <translation>將力的軸移離您</translation>
    </message>
    <message>
        <source>Axis n&amp;ear</source>
        <translation>軸向近處(&amp;E)</translation>
    </message>
    <message>
        <source>Move the axis of the force towards you</source>
        <translation>將力的軸移向您</translation>
    </message>
    <message>
        <source>Look from the fr&amp;ont</source>
        <translation>從正面看(&amp;O)</translation>
    </message>
    <message>
        <source>See the whole glass from the front again</source>
        <translation>再次從正面看整個杯子</translation>
    </message>
    <message>
        <source>Liqui&amp;ds</source>
        <translation>液體(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Glass tank</source>
        <translation>玻璃水槽(&amp;G)</translation>
    </message>
    <message>
        <source>A tank of liquid in place of the canvas, with balls that fall, a drain and wind; the painting waits as it is</source>
        <translation>以液體水槽取代畫布，有落下的球、排水口和風；畫作原樣等候</translation>
    </message>
    <message>
        <source>The liquid&apos;s surface as triangles, for PBRT and other programs</source>
        <translation>液體表面的三角形，供 PBRT 等程式使用</translation>
    </message>
    <message>
        <source>&amp;Pause the liquid</source>
        <translation>暫停液體(&amp;P)</translation>
    </message>
    <message>
        <source>The liquid stands still until you go on</source>
        <translation>液體靜止，直到你繼續</translation>
    </message>
    <message>
        <source>A tank where liquid &amp;falls</source>
        <translation>液體落下的水槽(&amp;F)</translation>
    </message>
    <message>
        <source>A ball of liquid falls into a glass tank</source>
        <translation>一顆液體球落入玻璃水槽</translation>
    </message>
    <message>
        <source>A tank where t&amp;wo liquids meet</source>
        <translation>兩種液體相遇的水槽(&amp;W)</translation>
    </message>
    <message>
        <source>Liquid breaks over a solid and meets another liquid</source>
        <translation>液體撞上固體，再遇見另一種液體</translation>
    </message>
    <message>
        <source>&amp;Open a tank...</source>
        <translation>開啟水槽(&amp;O)...</translation>
    </message>
    <message>
        <source>Begin with the tank of a file</source>
        <translation>以檔案中的水槽開始</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>重新開始(&amp;S)</translation>
    </message>
    <message>
        <source>Export &amp;all moments...</source>
        <translation>匯出所有時刻(&amp;A)...</translation>
    </message>
    <message>
        <source>The liquid&apos;s surface at every moment that is kept, each in a file of its own</source>
        <translation>每個保留時刻的液體表面，各存一個檔案</translation>
    </message>
    <message>
        <source>Add a &amp;ball of liquid</source>
        <translation>加入一顆液體球(&amp;B)</translation>
    </message>
    <message>
        <source>A ball of liquid falls from above; press on the liquid to say where</source>
        <translation>一顆液體球自上方落下；按在液體上指定位置</translation>
    </message>
    <message>
        <source>Open the &amp;drain</source>
        <translation>打開排水口(&amp;D)</translation>
    </message>
    <message>
        <source>Liquid runs out through the floor until you shut it again</source>
        <translation>液體由底部流出，直到你再關上</translation>
    </message>
    <message>
        <source>W&amp;ind</source>
        <translation>風(&amp;I)</translation>
    </message>
    <message>
        <source>Wind over the tank drags the liquid&apos;s surface along</source>
        <translation>水槽上方的風拖動液體表面</translation>
    </message>
    <message>
        <source>Turn the wind to the &amp;left</source>
        <translation>將風轉向左(&amp;L)</translation>
    </message>
    <message>
        <source>Turn the wind by 15 degrees to the left</source>
        <translation>將風向左轉 15 度</translation>
    </message>
    <message>
        <source>Turn the wind to the &amp;right</source>
        <translation>將風轉向右(&amp;R)</translation>
    </message>
    <message>
        <source>Turn the wind by 15 degrees to the right</source>
        <translation>將風向右轉 15 度</translation>
    </message>
    <message>
        <source>Stron&amp;ger wind</source>
        <translation>風更強(&amp;G)</translation>
    </message>
    <message>
        <source>The wind blows faster by half a metre a second</source>
        <translation>風速增加每秒半公尺</translation>
    </message>
    <message>
        <source>W&amp;eaker wind</source>
        <translation>風更弱(&amp;E)</translation>
    </message>
    <message>
        <source>The wind blows slower by half a metre a second</source>
        <translation>風速減少每秒半公尺</translation>
    </message>
    <message>
        <source>Show &amp;velocities</source>
        <translation>顯示速度(&amp;V)</translation>
    </message>
    <message>
        <source>Arrows show where the liquid flows, and how fast</source>
        <translation>箭頭顯示液體流向與快慢</translation>
    </message>
    <message>
        <source>Render a pic&amp;ture...</source>
        <translation>算繪圖片(&amp;T)...</translation>
    </message>
    <message>
        <source>Pi&amp;ctures of every step...</source>
        <translation>每一步的圖片(&amp;C)...</translation>
    </message>
    <message>
        <source>While the liquid moves, a picture of every moment, as you see the tank, goes into a folder</source>
        <translation>液體流動時，依您所見的水槽，將每個時刻的圖片存入資料夾</translation>
    </message>
    <message>
        <source>S&amp;urfaces of every step...</source>
        <translation>每一步的表面(&amp;U)...</translation>
    </message>
    <message>
        <source>While the liquid moves, its surface at every moment goes into a folder</source>
        <translation>液體流動時，將每個時刻的表面存入資料夾</translation>
    </message>
    <message>
        <source>M&amp;essages</source>
        <translation>訊息(&amp;E)</translation>
    </message>
    <message>
        <source>What you were told last, to be read again and copied</source>
        <translation>最近的訊息，可再次閱讀和複製</translation>
    </message>
    <message>
        <source>Time runs &amp;faster</source>
        <translation>時間加快(&amp;F)</translation>
    </message>
    <message>
        <source>Watch slow paint run, level and dry: up to 20 times as fast</source>
        <translation>看緩慢的顏料流動、變平、乾燥：最快 20 倍</translation>
    </message>
    <message>
        <source>Time runs s&amp;lower</source>
        <translation>時間放慢(&amp;L)</translation>
    </message>
    <message>
        <source>A step back towards real time</source>
        <translation>往實際時間退一步</translation>
    </message>
    <message>
        <source>&amp;Real time</source>
        <translation>實際時間(&amp;R)</translation>
    </message>
    <message>
        <source>A second of the paint takes a second again</source>
        <translation>顏料的一秒又是一秒</translation>
    </message>
    <message>
        <source>&amp;Hold it tilted</source>
        <translation>傾斜握持(&amp;H)</translation>
    </message>
    <message>
        <source>A mouse holds the tool aslant: a knife then scrapes with its edge</source>
        <translation>用滑鼠也能斜握工具:畫刀此時以刀緣刮除</translation>
    </message>
    <message>
        <source>More &amp;medium</source>
        <translation>多加媒介(&amp;M)</translation>
    </message>
    <message>
        <source>Thin the paint in hand by a quarter, from paste towards a stain</source>
        <translation>將手上的顏料稀釋四分之一，由膏狀趨向染色</translation>
    </message>
    <message>
        <source>More p&amp;aint</source>
        <translation>多加顏料(&amp;A)</translation>
    </message>
    <message>
        <source>Take a step back towards paint from the tube</source>
        <translation>退回一步，趨向原管顏料</translation>
    </message>
    <message>
        <source>Thin was&amp;h</source>
        <translation>薄塗打底(&amp;H)</translation>
    </message>
    <message>
        <source>Thin the paint in hand to a wash for a first lay-in, and back</source>
        <translation>將手上的顏料稀釋成打底用的薄塗，再按一次復原</translation>
    </message>
    <message>
        <source>Po&amp;ur</source>
        <translation>倒入(&amp;U)</translation>
    </message>
    <message>
        <source>Pour the recipe&apos;s milk into the middle, or stop pouring it; press on the tea to pour where you point</source>
        <translation>將配方的牛奶倒入中央，或停止倒入；按住茶面即可倒在所指之處</translation>
    </message>
    <message>
        <source>The tank as it stood at the beginning; wind and drain stay as they are</source>
        <translation>水槽回到最初的樣子；風與排水口保持不變</translation>
    </message>
    <message>
        <source>Pa&amp;int it again, finer...</source>
        <translation>重新繪製(&amp;I)...</translation>
    </message>
    <message>
        <source>Soft &amp;proof</source>
        <translation>軟打樣(&amp;P)</translation>
    </message>
    <message>
        <source>Shows the painting as the printer chosen in the settings would print it</source>
        <translation>以設定中所選印表機列印的樣子顯示畫作</translation>
    </message>
    <message>
        <source>Gamut &amp;warning</source>
        <translation>色域警告(&amp;W)</translation>
    </message>
    <message>
        <source>Colours that this printer has not are grey</source>
        <translation>這部印表機印不出的顏色顯示為灰色</translation>
    </message>
    <message>
        <source>Cance&amp;l opening</source>
        <translation>取消開啟(&amp;L)</translation>
    </message>
    <message>
        <source>Give up what is being opened or made; the painting on the easel stays</source>
        <translation>放棄正在開啟或製作的內容；畫架上的畫保持不變</translation>
    </message>
    <message>
        <source>&amp;Value check</source>
        <translation>明度檢查(&amp;V)</translation>
    </message>
    <message>
        <source>The painting in greys as light as its colours: darks and lights by themselves</source>
        <translation>以與顏色同樣明亮的灰階顯示畫作：只看明暗</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>說明(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>使用手冊(&amp;M)</translation>
    </message>
    <message>
        <source>Read about what is under the pointer</source>
        <translation>閱讀指標下方項目的說明</translation>
    </message>
    <message>
        <source>What is &amp;new</source>
        <translation>新功能(&amp;N)</translation>
    </message>
    <message>
        <source>What has changed, version by version</source>
        <translation>各版本的變更</translation>
    </message>
    <message>
        <source>&amp;About Pastoso</source>
        <translation>關於 Pastoso(&amp;A)</translation>
    </message>
    <message>
        <source>Its version and licence, what it is made of, this machine, its folders</source>
        <translation>版本與授權、所用的程式庫、這台電腦、資料夾</translation>
    </message>
    <message>
        <source>Save a &amp;copy...</source>
        <translation>儲存副本(&amp;C)...</translation>
    </message>
    <message>
        <source>The layers as pictures for other programs, in OpenRaster or PSD</source>
        <translation>將圖層以圖片形式存成 OpenRaster 或 PSD，供其他程式使用</translation>
    </message>
    <message>
        <source>&amp;Image</source>
        <translation>影像(&amp;I)</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪下(&amp;T)</translation>
    </message>
    <message>
        <source>Copy the layer&apos;s paint, or what is selected of it, and wipe it off</source>
        <translation>複製圖層的顏料或其選取部分，並將其擦去</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>複製(&amp;C)</translation>
    </message>
    <message>
        <source>Keep the layer&apos;s paint, or what is selected of it, to be pasted: wet as it is, and as a picture for other programs</source>
        <translation>保留圖層的顏料或其選取部分以供貼上：濕潤如故，對其他程式則為圖片</translation>
    </message>
    <message>
        <source>Cop&amp;y merged</source>
        <translation>合併複製(&amp;Y)</translation>
    </message>
    <message>
        <source>The same of all layers that are visible, as if they were one</source>
        <translation>對所有可見圖層做同樣的事，如同一層</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>貼上(&amp;P)</translation>
    </message>
    <message>
        <source>What was copied as a new layer: paint where it was, or a picture of another program as dry paint</source>
        <translation>將複製的內容作為新圖層：顏料在原處，其他程式的圖片則為乾顏料</translation>
    </message>
    <message>
        <source>Paste &amp;at cursor</source>
        <translation>貼上於游標處(&amp;A)</translation>
    </message>
    <message>
        <source>The same, with the middle of the copied paint where the pointer is</source>
        <translation>同上，但複製的顏料以游標處為中心</translation>
    </message>
    <message>
        <source>Mirror image &amp;horizontally</source>
        <translation>水平鏡射影像(&amp;H)</translation>
    </message>
    <message>
        <source>Left and right of the whole painting change places, canvas and all</source>
        <translation>整幅畫的左右連同畫布一起對調</translation>
    </message>
    <message>
        <source>Mirror image &amp;vertically</source>
        <translation>垂直鏡射影像(&amp;V)</translation>
    </message>
    <message>
        <source>Top and bottom of the whole painting change places, canvas and all</source>
        <translation>整幅畫的上下連同畫布一起對調</translation>
    </message>
    <message>
        <source>Rotate image 90° to the &amp;right</source>
        <translation>向右旋轉影像 90°(&amp;R)</translation>
    </message>
    <message>
        <source>The whole painting stands on its right side</source>
        <translation>整幅畫以右側為底立起</translation>
    </message>
    <message>
        <source>Rotate image 90° to the &amp;left</source>
        <translation>向左旋轉影像 90°(&amp;L)</translation>
    </message>
    <message>
        <source>The whole painting stands on its left side</source>
        <translation>整幅畫以左側為底立起</translation>
    </message>
    <message>
        <source>Rotate image &amp;180°</source>
        <translation>旋轉影像 180°(&amp;1)</translation>
    </message>
    <message>
        <source>The whole painting stands on its head</source>
        <translation>整幅畫上下顛倒</translation>
    </message>
    <message>
        <source>F&amp;ill with the paint in hand</source>
        <translation>以手上的顏料填滿(&amp;I)</translation>
    </message>
    <message>
        <source>Pour an even film of wet paint over what is selected, or over the whole canvas</source>
        <translation>在選取範圍或整張畫布上倒上一層均勻的濕顏料</translation>
    </message>
    <message>
        <source>Fill with the s&amp;econd paint</source>
        <translation>以第二種顏料填滿(&amp;E)</translation>
    </message>
    <message>
        <source>Pour an even film of the second paint over what is selected</source>
        <translation>在選取範圍倒上一層均勻的第二種顏料</translation>
    </message>
    <message>
        <source>&amp;Gradient of the two paints</source>
        <translation>兩種顏料的漸層(&amp;G)</translation>
    </message>
    <message>
        <source>Drag a line: the film goes from the paint in hand to the second one along it</source>
        <translation>拖曳一條線：顏料沿著線從手上的顏料漸變為第二種</translation>
    </message>
    <message>
        <source>&amp;Thickness of fills...</source>
        <translation>填滿的厚度(&amp;T)...</translation>
    </message>
    <message>
        <source>How thick a film of paint fills and gradients pour</source>
        <translation>填滿與漸層倒上的顏料有多厚</translation>
    </message>
    <message>
        <source>Elli&amp;pse</source>
        <translation>橢圓(&amp;P)</translation>
    </message>
    <message>
        <source>Drag an ellipse that tools keep to; Shift adds, Alt takes away, Ctrl makes a circle</source>
        <translation>拖曳出工具可作用的橢圓範圍；Shift 增加，Alt 減去，Ctrl 畫圓</translation>
    </message>
    <message>
        <source>Pol&amp;ygon</source>
        <translation>多邊形(&amp;Y)</translation>
    </message>
    <message>
        <source>Click the corners of what tools keep to; Enter or a double click closes it</source>
        <translation>按一下工具可作用範圍的各個角；Enter 或按兩下即可封閉</translation>
    </message>
    <message>
        <source>&amp;Contiguous colour</source>
        <translation>相連的顏色(&amp;C)</translation>
    </message>
    <message>
        <source>Click a colour: what hangs together there is selected; drag for more or less of it</source>
        <translation>按一下顏色：選取那裡相連的部分；拖曳可增減範圍</translation>
    </message>
    <message>
        <source>&amp;Similar colour</source>
        <translation>相似的顏色(&amp;S)</translation>
    </message>
    <message>
        <source>Click a colour: it is selected wherever it is; drag for more or less of it</source>
        <translation>按一下顏色：選取各處的這種顏色；拖曳可增減範圍</translation>
    </message>
    <message>
        <source>&amp;Grow...</source>
        <translation>擴張(&amp;G)...</translation>
    </message>
    <message>
        <source>Make the selection wider on all sides</source>
        <translation>讓選取範圍向四周變寬</translation>
    </message>
    <message>
        <source>Shri&amp;nk...</source>
        <translation>縮減(&amp;N)...</translation>
    </message>
    <message>
        <source>Make the selection narrower on all sides</source>
        <translation>讓選取範圍從四周變窄</translation>
    </message>
    <message>
        <source>&amp;Border...</source>
        <translation>邊框(&amp;B)...</translation>
    </message>
    <message>
        <source>Select a band along the outline of the selection</source>
        <translation>選取沿著選取範圍外框線的帶狀區域</translation>
    </message>
    <message>
        <source>&amp;From the layer</source>
        <translation>從圖層(&amp;F)</translation>
    </message>
    <message>
        <source>Select where the layer has paint, wet or dry</source>
        <translation>選取圖層上有顏料的地方，不論乾濕</translation>
    </message>
    <message>
        <source>Brush e&amp;ditor...</source>
        <translation>筆刷編輯器(&amp;D)...</translation>
    </message>
    <message>
        <source>Every number of the tool in hand, and the stroke that it paints</source>
        <translation>手上工具的每個數值，以及它畫出的筆觸</translation>
    </message>
    <message>
        <source>&amp;Favourite</source>
        <translation>最愛(&amp;F)</translation>
    </message>
    <message>
        <source>Keep the tool in hand among your favourites, which the list can show alone</source>
        <translation>將手上的工具存入最愛，清單可只顯示最愛</translation>
    </message>
    <message>
        <source>&amp;Import tools...</source>
        <translation>匯入工具(&amp;I)...</translation>
    </message>
    <message>
        <source>Add the tools of a bundle to your own</source>
        <translation>將套件中的工具加入自己的工具</translation>
    </message>
    <message>
        <source>E&amp;xport my tools...</source>
        <translation>匯出我的工具(&amp;X)...</translation>
    </message>
    <message>
        <source>Write all tools of your own into a bundle, a file to keep or to give away</source>
        <translation>將自己的所有工具寫入一個套件檔，可保存或分享</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>視窗(&amp;W)</translation>
    </message>
    <message>
        <source>Save a &amp;version</source>
        <translation>儲存版本(&amp;V)</translation>
    </message>
    <message>
        <source>Go on in a file of the next number beside this one, which stays as it is</source>
        <translation>在旁邊以下一個編號的檔案繼續；目前的檔案保持不變</translation>
    </message>
    <message>
        <source>Close the pain&amp;ting</source>
        <translation>關閉畫作(&amp;T)</translation>
    </message>
    <message>
        <source>Put the painting away; the start page says what there is to go on with</source>
        <translation>把畫收起來；起始頁會列出可以繼續的內容</translation>
    </message>
    <message>
        <source>Scale image to &amp;new size...</source>
        <translation>縮放影像到新尺寸(&amp;N)...</translation>
    </message>
    <message>
        <source>Draw the whole painting out, or make it of finer or coarser pixels</source>
        <translation>放大或縮小整幅畫，或改用更細或更粗的像素</translation>
    </message>
    <message>
        <source>Toned g&amp;round...</source>
        <translation>有色底(&amp;R)...</translation>
    </message>
    <message>
        <source>Cover the whole canvas with a dry coat of the paint in hand, below all layers</source>
        <translation>用手上的顏料在所有圖層之下鋪滿一層乾的底色</translation>
    </message>
    <message>
        <source>Full scr&amp;een</source>
        <translation>全螢幕(&amp;E)</translation>
    </message>
    <message>
        <source>The window on the whole screen, without the bars of the desktop</source>
        <translation>視窗占滿整個螢幕，不顯示桌面的工作列</translation>
    </message>
    <message>
        <source>S&amp;quint</source>
        <translation>瞇眼觀看(&amp;Q)</translation>
    </message>
    <message>
        <source>The painting as with half-closed eyes: large shapes without their details</source>
        <translation>像瞇著眼看畫：只見大形，不見細節</translation>
    </message>
    <message>
        <source>&amp;Brushes panel</source>
        <translation>筆刷面板(&amp;B)</translation>
    </message>
    <message>
        <source>The tools to paint with, how wide they are and how steady they keep</source>
        <translation>作畫用的工具、寬度與穩定程度</translation>
    </message>
    <message>
        <source>&amp;Paints panel</source>
        <translation>顏料面板(&amp;P)</translation>
    </message>
    <message>
        <source>The tubes of paint</source>
        <translation>各管顏料</translation>
    </message>
    <message>
        <source>&amp;Easel panel</source>
        <translation>畫架面板(&amp;E)</translation>
    </message>
    <message>
        <source>How the canvas stands, where the lamp is, and how fast paint dries</source>
        <translation>畫布的擺放方式、燈的位置與顏料乾燥的速度</translation>
    </message>
    <message>
        <source>T&amp;ool bar</source>
        <translation>工具列(&amp;O)</translation>
    </message>
    <message>
        <source>The bar of buttons; drag it by its end to another side, or off the window</source>
        <translation>按鈕列；拖曳其末端可移到另一邊，或移出視窗</translation>
    </message>
    <message>
        <source>&amp;New window</source>
        <translation>開新視窗(&amp;N)</translation>
    </message>
    <message>
        <source>Another window, with an easel of its own</source>
        <translation>另一個視窗，有自己的畫架</translation>
    </message>
    <message>
        <source>S&amp;ketch</source>
        <translation>草圖(&amp;K)</translation>
    </message>
    <message>
        <source>Brushes and paints beside a large canvas, and nothing else</source>
        <translation>大畫布旁只有筆刷與顏料</translation>
    </message>
    <message>
        <source>&amp;Oil</source>
        <translation>油畫(&amp;O)</translation>
    </message>
    <message>
        <source>Brushes, paints and easel beside the tool and the layers</source>
        <translation>筆刷、顏料與畫架，以及工具與圖層</translation>
    </message>
    <message>
        <source>&amp;Mixing</source>
        <translation>調色(&amp;M)</translation>
    </message>
    <message>
        <source>Paints, colours and what the paint is like, beside a large mixing well</source>
        <translation>大調色槽旁有顏料、色彩與顏料的性質</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>匯出(&amp;E)</translation>
    </message>
    <message>
        <source>Lights, layers, the whole canvas and its recording, to finish a painting</source>
        <translation>光源、圖層、整張畫布與其記錄，用於完成畫作</translation>
    </message>
    <message>
        <source>&amp;Save the workspace...</source>
        <translation>儲存工作區(&amp;S)...</translation>
    </message>
    <message>
        <source>Keep the panels as they stand now, under a name of your own</source>
        <translation>以自訂的名稱保留面板目前的排列</translation>
    </message>
    <message>
        <source>&amp;Rename the workspace...</source>
        <translation>重新命名工作區(&amp;R)...</translation>
    </message>
    <message>
        <source>Give your own workspace that is in use another name</source>
        <translation>為使用中的自訂工作區取另一個名稱</translation>
    </message>
    <message>
        <source>Remo&amp;ve the workspace</source>
        <translation>移除工作區(&amp;V)</translation>
    </message>
    <message>
        <source>Forget your own workspace that is in use; the panels stay as they stand</source>
        <translation>忘掉使用中的自訂工作區；面板保持不變</translation>
    </message>
    <message>
        <source>&amp;Left-handed</source>
        <translation>左手模式(&amp;L)</translation>
    </message>
    <message>
        <source>What stands on the left changes places with what stands on the right</source>
        <translation>左邊與右邊的面板互換位置</translation>
    </message>
    <message>
        <source>Show me &amp;round</source>
        <translation>帶我看看(&amp;R)</translation>
    </message>
    <message>
        <source>Three steps: paint, move the canvas, take other paint</source>
        <translation>三個步驟：作畫、移動畫布、換顏料</translation>
    </message>
    <message>
        <source>Rotate &amp;image...</source>
        <translation>旋轉影像(&amp;I)...</translation>
    </message>
    <message>
        <source>Turn the whole painting by any angle, to put a horizon straight</source>
        <translation>將整幅畫旋轉任意角度，例如把地平線擺正</translation>
    </message>
    <message>
        <source>Te&amp;xture paste...</source>
        <translation>肌理膏(&amp;X)...</translation>
    </message>
    <message>
        <source>Lay a dry relief of the paint in hand: sand, modelling paste, or a picture pressed in</source>
        <translation>用手上的顏料鋪一層乾的浮雕：砂、塑型膏，或壓印的圖片</translation>
    </message>
    <message>
        <source>Lock &amp;what is bare</source>
        <translation>鎖定空白處(&amp;W)</translation>
    </message>
    <message>
        <source>Tools change the layer only where it has paint already</source>
        <translation>工具只改變圖層上已有顏料的地方</translation>
    </message>
    <message>
        <source>&amp;Masking fluid</source>
        <translation>遮蓋液(&amp;M)</translation>
    </message>
    <message>
        <source>Paint a skin that no paint gets below, as wide as the tool in hand; Alt peels it off</source>
        <translation>畫上一層顏料滲不進去的膜，和手上的工具一樣寬；Alt 可撕掉</translation>
    </message>
    <message>
        <source>Masking &amp;tape</source>
        <translation>遮蓋膠帶(&amp;T)</translation>
    </message>
    <message>
        <source>Drag a strip with clean edges that no paint gets below; Alt peels it off</source>
        <translation>拖曳貼上邊緣俐落、顏料滲不進去的膠帶；Alt 可撕掉</translation>
    </message>
    <message>
        <source>M&amp;ask the selection</source>
        <translation>遮蓋選取範圍(&amp;A)</translation>
    </message>
    <message>
        <source>Keep all paint off what is selected, until the masking is peeled off</source>
        <translation>在撕掉遮蓋之前，讓選取的部分沾不到任何顏料</translation>
    </message>
    <message>
        <source>Select what is maske&amp;d</source>
        <translation>選取被遮蓋的部分(&amp;D)</translation>
    </message>
    <message>
        <source>Select all that masking fluid and tape cover</source>
        <translation>選取遮蓋液和膠帶蓋住的所有部分</translation>
    </message>
    <message>
        <source>Peel off all mas&amp;king</source>
        <translation>撕掉所有遮蓋(&amp;K)</translation>
    </message>
    <message>
        <source>Take all masking fluid and tape away; the paint below is as it was</source>
        <translation>拿掉所有遮蓋液和膠帶；底下的顏料保持原樣</translation>
    </message>
    <message>
        <source>&amp;Parallel ruler</source>
        <translation>平行直尺(&amp;P)</translation>
    </message>
    <message>
        <source>Strokes run parallel to the ruler from wherever they start</source>
        <translation>筆觸不論從哪裡開始，都與直尺平行</translation>
    </message>
    <message>
        <source>&amp;Concentric ellipse</source>
        <translation>同心橢圓(&amp;C)</translation>
    </message>
    <message>
        <source>Strokes run round the same middle from wherever they start</source>
        <translation>筆觸不論從哪裡開始，都繞著同一個中心走</translation>
    </message>
    <message>
        <source>&amp;1 point perspective</source>
        <translation>一點透視(&amp;1)</translation>
    </message>
    <message>
        <source>Strokes run to the vanishing point, level or upright</source>
        <translation>筆觸朝向消失點，或呈水平或垂直</translation>
    </message>
    <message>
        <source>&amp;2 point perspective</source>
        <translation>兩點透視(&amp;2)</translation>
    </message>
    <message>
        <source>Strokes run to one of two vanishing points, or upright</source>
        <translation>筆觸朝向兩個消失點之一，或呈垂直</translation>
    </message>
    <message>
        <source>&amp;3 point perspective</source>
        <translation>三點透視(&amp;3)</translation>
    </message>
    <message>
        <source>Strokes run to one of three vanishing points</source>
        <translation>筆觸朝向三個消失點之一</translation>
    </message>
    <message>
        <source>Gri&amp;d</source>
        <translation>格線(&amp;D)</translation>
    </message>
    <message>
        <source>Strokes run along the lines of a grid, or beside them</source>
        <translation>筆觸沿著格線走，或在格線旁平行</translation>
    </message>
    <message>
        <source>Snap to the &amp;guide</source>
        <translation>貼齊輔助線(&amp;G)</translation>
    </message>
    <message>
        <source>Without it your hand is free, and the guide only shows where to go</source>
        <translation>關閉時手不受限制，輔助線只供參考</translation>
    </message>
    <message>
        <source>Take mirrors, copies and the guide away</source>
        <translation>移除鏡像、環繞份數和輔助線</translation>
    </message>
    <message>
        <source>&amp;Add reference pictures...</source>
        <translation>加入參考圖片(&amp;A)...</translation>
    </message>
    <message>
        <source>Lay pictures on the board of references, to look at and to pick colours from</source>
        <translation>把圖片放上參考圖板，可供觀察和取色</translation>
    </message>
    <message>
        <source>References in a &amp;window of their own</source>
        <translation>參考圖片用獨立視窗(&amp;W)</translation>
    </message>
    <message>
        <source>The board of references above the canvas, or among the panels</source>
        <translation>參考圖板浮在畫布上方，或放在面板之中</translation>
    </message>
    <message>
        <source>Mirrors, rulers, perspectives and grids in numbers</source>
        <translation>以數值設定鏡像、直尺、透視和格線</translation>
    </message>
    <message>
        <source>Re&amp;ferences panel</source>
        <translation>參考圖片面板(&amp;F)</translation>
    </message>
    <message>
        <source>Pictures to look at while you paint, and to pick colours from</source>
        <translation>作畫時可供觀察和取色的圖片</translation>
    </message>
    <message>
        <source>Ad&amp;just dry paint...</source>
        <translation>調整乾顏料(&amp;J)...</translation>
    </message>
    <message>
        <source>Colour adjustment of what is dry: a glaze over it, or another hue by other pigments</source>
        <translation>調整乾顏料的顏色：上面加一層罩染，或換用其他色料改變色相</translation>
    </message>
    <message>
        <source>Cl&amp;ip to the layer below</source>
        <translation>剪裁至下方圖層(&amp;I)</translation>
    </message>
    <message>
        <source>Show the layer only where the one below has paint; the rest is hidden, and kept</source>
        <translation>只在下方圖層有顏料處顯示此圖層；其餘部分隱藏但保留</translation>
    </message>
    <message>
        <source>E&amp;verything</source>
        <translation>全部(&amp;V)</translation>
    </message>
    <message>
        <source>F&amp;eather...</source>
        <translation>羽化(&amp;E)...</translation>
    </message>
    <message>
        <source>Make the edge of the selection soft, so that paint fades out there</source>
        <translation>讓選取範圍的邊緣變柔，使顏料在那裡漸漸淡出</translation>
    </message>
    <message>
        <source>All strokes once more, finer, beside the painting on the easel</source>
        <translation>在畫架上的畫之外，以更高的解析度重新繪製所有筆觸</translation>
    </message>
    <message>
        <source>save incremental, iteration</source>
        <translation>遞增儲存、另存版本</translation>
    </message>
    <message>
        <source>png, jpeg, tiff, save as a picture</source>
        <translation>png、jpeg、儲存成圖片</translation>
    </message>
    <message>
        <source>replay, playback</source>
        <translation>重播、播放</translation>
    </message>
    <message>
        <source>video, mp4, speed painting</source>
        <translation>影片、縮時攝影、mp4</translation>
    </message>
    <message>
        <source>upscale, higher resolution, enlarge</source>
        <translation>提高解析度、放大</translation>
    </message>
    <message>
        <source>copy visible, copy flattened</source>
        <translation>拷貝可見、合併拷貝</translation>
    </message>
    <message>
        <source>resize image, resolution, dpi</source>
        <translation>影像大小、解析度、dpi</translation>
    </message>
    <message>
        <source>resize canvas, extend, expand</source>
        <translation>畫布尺寸、擴展</translation>
    </message>
    <message>
        <source>trim to selection</source>
        <translation>修剪、裁切</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>水平翻轉</translation>
    </message>
    <message>
        <source>straighten</source>
        <translation>拉直、旋轉</translation>
    </message>
    <message>
        <source>brush size, smaller</source>
        <translation>筆刷大小、縮小</translation>
    </message>
    <message>
        <source>brush size, larger, bigger</source>
        <translation>筆刷大小、放大</translation>
    </message>
    <message>
        <source>dip, load</source>
        <translation>沾顏料</translation>
    </message>
    <message>
        <source>rinse, wash, smudge, blend</source>
        <translation>清洗、塗抹</translation>
    </message>
    <message>
        <source>dilute, water, thinner, solvent</source>
        <translation>稀釋、水、溶劑</translation>
    </message>
    <message>
        <source>quick menu, radial menu</source>
        <translation>快速選單、輪盤</translation>
    </message>
    <message>
        <source>eyedropper, colour picker, color picker, pipette</source>
        <translation>滴管、吸管、選色</translation>
    </message>
    <message>
        <source>eyedropper, color picker, pipette</source>
        <translation>滴管、吸管、選色</translation>
    </message>
    <message>
        <source>brush settings, brush studio, brush engine</source>
        <translation>筆刷設定</translation>
    </message>
    <message>
        <source>bundle, brush set, resources</source>
        <translation>筆刷包、資源</translation>
    </message>
    <message>
        <source>dryer, fast dry, dry layer</source>
        <translation>吹風機、速乾</translation>
    </message>
    <message>
        <source>mixing palette, mixer, scratchpad</source>
        <translation>調色盤、混色盤</translation>
    </message>
    <message>
        <source>bucket, flood fill</source>
        <translation>油漆桶、填色</translation>
    </message>
    <message>
        <source>bucket, background fill</source>
        <translation>油漆桶、背景色</translation>
    </message>
    <message>
        <source>imprimatura, background, gesso</source>
        <translation>底色、背景、打底</translation>
    </message>
    <message>
        <source>import layer, insert image, place image</source>
        <translation>匯入圖層、置入圖片</translation>
    </message>
    <message>
        <source>delete layer</source>
        <translation>刪除圖層</translation>
    </message>
    <message>
        <source>free transform, scale, rotate, distort, perspective, skew, move tool</source>
        <translation>自由變形、縮放、旋轉、扭曲、透視</translation>
    </message>
    <message>
        <source>saturation, hsv, colour balance, color balance</source>
        <translation>飽和度、色彩平衡</translation>
    </message>
    <message>
        <source>merge visible, merge all</source>
        <translation>合併可見圖層</translation>
    </message>
    <message>
        <source>folder, quick group</source>
        <translation>資料夾、群組</translation>
    </message>
    <message>
        <source>alpha lock, lock transparency</source>
        <translation>鎖定透明、阿爾法鎖定</translation>
    </message>
    <message>
        <source>clipping mask, clipping group, inherit alpha</source>
        <translation>剪裁遮罩、繼承透明</translation>
    </message>
    <message>
        <source>marquee, rectangular selection</source>
        <translation>矩形選取、長方形</translation>
    </message>
    <message>
        <source>marquee, elliptical selection, oval, circle</source>
        <translation>橢圓選取、圓形</translation>
    </message>
    <message>
        <source>freehand selection</source>
        <translation>自由選取、套索</translation>
    </message>
    <message>
        <source>magic wand, automatic selection</source>
        <translation>魔術棒、自動選取</translation>
    </message>
    <message>
        <source>magic wand, colour range, color range</source>
        <translation>魔術棒、顏色範圍</translation>
    </message>
    <message>
        <source>deselect, select none, select all</source>
        <translation>取消選取、全選</translation>
    </message>
    <message>
        <source>inverse</source>
        <translation>反選</translation>
    </message>
    <message>
        <source>expand</source>
        <translation>擴張</translation>
    </message>
    <message>
        <source>contract</source>
        <translation>收縮</translation>
    </message>
    <message>
        <source>soften, blur edge</source>
        <translation>柔化邊緣</translation>
    </message>
    <message>
        <source>select opaque, alpha to selection</source>
        <translation>選取不透明</translation>
    </message>
    <message>
        <source>frisket, liquid mask, drawing gum</source>
        <translation>留白膠、遮罩液</translation>
    </message>
    <message>
        <source>frisket, stencil</source>
        <translation>紙膠帶、遮罩</translation>
    </message>
    <message>
        <source>frisket, stencil, protect</source>
        <translation>遮罩、保護</translation>
    </message>
    <message>
        <source>remove frisket</source>
        <translation>撕除、移除遮罩</translation>
    </message>
    <message>
        <source>marching ants, display selection</source>
        <translation>螞蟻線、顯示選取</translation>
    </message>
    <message>
        <source>symmetry tool, multibrush</source>
        <translation>對稱</translation>
    </message>
    <message>
        <source>radial symmetry, multibrush, mandala</source>
        <translation>放射對稱、曼陀羅</translation>
    </message>
    <message>
        <source>assistant, straight line, drawing guide</source>
        <translation>輔助尺、直線</translation>
    </message>
    <message>
        <source>assistant, drawing guide</source>
        <translation>輔助尺、平行線</translation>
    </message>
    <message>
        <source>assistant, vanishing point</source>
        <translation>輔助尺、消失點</translation>
    </message>
    <message>
        <source>assistant, snapping</source>
        <translation>輔助尺、吸附</translation>
    </message>
    <message>
        <source>tracing paper, light table, template</source>
        <translation>描圖紙、底稿</translation>
    </message>
    <message>
        <source>reference image, mood board</source>
        <translation>參考圖、靈感板</translation>
    </message>
    <message>
        <source>flip canvas</source>
        <translation>翻轉檢視</translation>
    </message>
    <message>
        <source>hide panels, canvas-only mode</source>
        <translation>隱藏面板</translation>
    </message>
    <message>
        <source>greyscale, grayscale, black and white, desaturate</source>
        <translation>灰階、黑白、明度</translation>
    </message>
    <message>
        <source>cmyk, print preview</source>
        <translation>cmyk、列印預覽</translation>
    </message>
    <message>
        <source>brush library, presets</source>
        <translation>筆刷庫、預設</translation>
    </message>
    <message>
        <source>gravity, drips, canvas tilt</source>
        <translation>重力、滴流、傾斜</translation>
    </message>
    <message>
        <source>color wheel, colour selector, swatches</source>
        <translation>色輪、色環、色票</translation>
    </message>
    <message>
        <source>gloss, impasto, bump</source>
        <translation>光澤、凹凸</translation>
    </message>
    <message>
        <source>overview</source>
        <translation>總覽</translation>
    </message>
    <message>
        <source>default layout, reset workspace</source>
        <translation>預設版面、重設工作區</translation>
    </message>
    <message>
        <source>search actions</source>
        <translation>搜尋動作</translation>
    </message>
    <message>
        <source>shortcuts, hotkeys, keyboard</source>
        <translation>捷徑、快捷鍵</translation>
    </message>
    <message>
        <source>preferences, configure, options, theme, language</source>
        <translation>偏好設定、選項、主題、語言</translation>
    </message>
    <message>
        <source>stylus, pressure curve</source>
        <translation>觸控筆、筆壓</translation>
    </message>
    <message>
        <source>tutorial, getting started</source>
        <translation>教學、入門</translation>
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
        <translation>%1 小時 %2 分</translation>
    </message>
    <message>
        <source>%1 × %2 pixels for %3 × %4 mm, which is %5 pixels per inch.</source>
        <translation>%3 × %4 mm 的畫面為 %1 × %2 像素，相當於每英寸 %5 像素。</translation>
    </message>
    <message>
        <source>Four files of %1 × %2 pixels, %3 to %4.</source>
        <translation>四個 %1 × %2 像素的檔案，%3 到 %4。</translation>
    </message>
    <message>
        <source>A solid of %1 × %2 mm; its front has %3 × %4 points, %5 mm apart.</source>
        <translation>%1 × %2 mm 的實體；正面有 %3 × %4 個點，間距 %5 mm。</translation>
    </message>
    <message numerus="yes">
        <source>%1 of painting become %2 of film: %n frame(s) of %3 × %4 pixels.</source>
        <translation>
            <numerusform>%1 的作畫過程會成為 %2 的影片：%n 個影格，%3 × %4 像素。</numerusform>
        </translation>
    </message>
    <message>
        <source>Save</source>
        <translation>儲存</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>取代</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>另存新檔...</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::AdjustDialog</name>
    <message>
        <source>The medium in hand leaves next to nothing when it dries.</source>
        <translation>手上的媒材乾了以後幾乎什麼都不留。</translation>
    </message>
    <message>
        <source>Adjust dry paint</source>
        <translation>調整乾顏料</translation>
    </message>
    <message>
        <source>The dry paint of the layer that you paint on takes another colour, where it is selected or all over. Wet paint stays as it is.</source>
        <translation>正在畫的圖層上，選取範圍或整張畫布的乾顏料會換成另一種顏色；濕顏料保持不變。</translation>
    </message>
    <message>
        <source>As a glaze</source>
        <translation>作為罩染</translation>
    </message>
    <message>
        <source>As other pigments</source>
        <translation>換成其他色料</translation>
    </message>
    <message>
        <source>Adjust</source>
        <translation>調整</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source> µm</source>
        <translation> µm</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>比例</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>The mean colour as it is</source>
        <translation>現在的平均顏色</translation>
    </message>
    <message>
        <source>The mean colour after it is adjusted</source>
        <translation>調整後的平均顏色</translation>
    </message>
    <message>
        <source>Before, after</source>
        <translation>調整前、調整後</translation>
    </message>
    <message>
        <source>A thin even coat of the paint in hand dries over it, and what lies below shows through. It is as thick as this when it is dry.</source>
        <translation>手上的顏料在上面乾成一層均勻的薄膜，下方仍會透出來。這是乾了以後的厚度。</translation>
    </message>
    <message>
        <source>So much of the dry paint is taken out and replaced by the paint in hand, which is stirred in. It stays as thick as it is.</source>
        <translation>這個比例的乾顏料會被取走，換成手上的顏料並拌進去；厚度不變。</translation>
    </message>
    <message>
        <source>&amp;Preview</source>
        <translation>預覽(&amp;P)</translation>
    </message>
    <message>
        <source>Show on the canvas what comes of it</source>
        <translation>在畫布上顯示調整後的結果</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CanvasSizeDialog</name>
    <message>
        <source>The upper left corner stays where it is</source>
        <translation>左上角維持不動</translation>
    </message>
    <message>
        <source>The middle of the upper edge stays where it is</source>
        <translation>上邊中點維持不動</translation>
    </message>
    <message>
        <source>The upper right corner stays where it is</source>
        <translation>右上角維持不動</translation>
    </message>
    <message>
        <source>The middle of the left edge stays where it is</source>
        <translation>左邊中點維持不動</translation>
    </message>
    <message>
        <source>The middle stays where it is</source>
        <translation>中心維持不動</translation>
    </message>
    <message>
        <source>The middle of the right edge stays where it is</source>
        <translation>右邊中點維持不動</translation>
    </message>
    <message>
        <source>The lower left corner stays where it is</source>
        <translation>左下角維持不動</translation>
    </message>
    <message>
        <source>The middle of the lower edge stays where it is</source>
        <translation>下邊中點維持不動</translation>
    </message>
    <message>
        <source>The lower right corner stays where it is</source>
        <translation>右下角維持不動</translation>
    </message>
    <message>
        <source>%1 mm on the left</source>
        <translation>左側 %1 mm</translation>
    </message>
    <message>
        <source>%1 mm on the right</source>
        <translation>右側 %1 mm</translation>
    </message>
    <message>
        <source>%1 mm at the top</source>
        <translation>上方 %1 mm</translation>
    </message>
    <message>
        <source>%1 mm at the bottom</source>
        <translation>下方 %1 mm</translation>
    </message>
    <message>
        <source>Added: %1.</source>
        <translation>增加：%1。</translation>
    </message>
    <message>
        <source>Cut off: %1. What lies there is wiped off.</source>
        <translation>裁掉：%1。該處的內容會被擦掉。</translation>
    </message>
    <message>
        <source>Canvas size</source>
        <translation>畫布尺寸</translation>
    </message>
    <message>
        <source>Change the size</source>
        <translation>變更尺寸</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>寬度(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>高度(&amp;H)</translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation>維持不動的位置</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The canvas has this size.</source>
        <translation>畫布已是這個尺寸。</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels.
%3</source>
        <translation>%1 × %2 像素的圖片。
%3</translation>
    </message>
    <message>
        <source>Other units may be typed as well: 50 cm, 20 in, 3000 px</source>
        <translation>也可以輸入其他單位：50 cm、20 in、3000 px</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>你想做什麼？</translation>
    </message>
    <message>
        <source>Not now: %1</source>
        <translation>目前無法使用：%1</translation>
    </message>
    <message>
        <source>Nothing of that name. Fewer letters find more.</source>
        <translation>找不到這個名稱。少打幾個字，可以找到更多。</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CrashDialog</name>
    <message>
        <source>Pastoso failed the last time</source>
        <translation>Pastoso 上次發生錯誤而中斷</translation>
    </message>
    <message>
        <source>We are sorry. What you had painted was kept and is offered to you next. This report says where the program was; it tells nothing of your painting. With it the mistake can be found.</source>
        <translation>很抱歉。你畫的內容已經保留，接下來可以救回。這份報告說明程式中斷的位置，不包含任何畫作內容。有了它就能找出錯誤。</translation>
    </message>
    <message>
        <source>It is kept as %1.</source>
        <translation>報告已存為 %1。</translation>
    </message>
    <message>
        <source>Copy the report</source>
        <translation>複製報告</translation>
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
        <translation>資料夾要放在哪裡</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>匯出</translation>
    </message>
    <message>
        <source>;;All files (*)</source>
        <translation>;;所有檔案 (*)</translation>
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
        <translation>ICC 描述檔...</translation>
    </message>
    <message>
        <source>ICC profile</source>
        <translation>ICC 描述檔</translation>
    </message>
    <message>
        <source>ICC profiles (*.icc *.icm);;All files (*)</source>
        <translation>ICC 描述檔 (*.icc *.icm);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>What the painting looks like.</source>
        <translation>畫作看起來的樣子。</translation>
    </message>
    <message>
        <source>The picture, and of every layer its colours, normals, heights in mm, wetness, gloss and cover, as channels of one file.</source>
        <translation>畫作圖片，以及每個圖層的顏色、法線、高度 (mm)、濕潤度、光澤和覆蓋率，存成同一檔案的色版。</translation>
    </message>
    <message>
        <source>Base colour, normal (OpenGL, +Y up), height and roughness, a file for each.</source>
        <translation>基本顏色、法線（OpenGL，+Y 朝上）、高度和粗糙度，各存成一個檔案。</translation>
    </message>
    <message>
        <source>The paint as it stands on the canvas: a closed solid in millimetres.</source>
        <translation>顏料在畫布上的立體形狀：以公釐為單位的封閉實體。</translation>
    </message>
    <message>
        <source>How the painting came about. It is painted once more, which takes a while.</source>
        <translation>畫作的完成過程。需要重新畫一次，會花一些時間。</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>資料夾(&amp;F)</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>取代</translation>
    </message>
    <message>
        <source>What the file is; its name ends accordingly</source>
        <translation>檔案的類型；檔名的結尾會隨之改變</translation>
    </message>
    <message>
        <source>What is made of the painting</source>
        <translation>要從畫作做出什麼</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>圖片</translation>
    </message>
    <message>
        <source>Layers, for compositing</source>
        <translation>圖層，供合成使用</translation>
    </message>
    <message>
        <source>Maps, for 3D programs</source>
        <translation>貼圖，供 3D 程式使用</translation>
    </message>
    <message>
        <source>Relief, for 3D printing</source>
        <translation>浮雕，供 3D 列印</translation>
    </message>
    <message>
        <source>Time-lapse</source>
        <translation>縮時影片</translation>
    </message>
    <message>
        <source>Where it is put; the ending of the name chooses the format</source>
        <translation>存放的位置；副檔名決定格式</translation>
    </message>
    <message>
        <source>&amp;Browse...</source>
        <translation>瀏覽(&amp;B)...</translation>
    </message>
    <message>
        <source>1 is a small file, 100 a fine picture</source>
        <translation>1 檔案最小，100 畫質最好</translation>
    </message>
    <message>
        <source>What the picture is of</source>
        <translation>圖片的內容</translation>
    </message>
    <message>
        <source>The canvas</source>
        <translation>畫布</translation>
    </message>
    <message>
        <source>The mixing well</source>
        <translation>調色槽</translation>
    </message>
    <message>
        <source>&amp;Light and shade</source>
        <translation>光影(&amp;L)</translation>
    </message>
    <message>
        <source>As the window shows the painting; otherwise the paint&apos;s own colours, as a scan would have them</source>
        <translation>和視窗顯示的畫作一樣；否則只輸出顏料本身的顏色，像掃描的結果</translation>
    </message>
    <message>
        <source> px wide</source>
        <translation> px 寬</translation>
    </message>
    <message>
        <source>The width that the scale comes to, or the scale that gives this width</source>
        <translation>這個比例得出的寬度，或得出這個寬度的比例</translation>
    </message>
    <message>
        <source>What the numbers in the file mean; the file says so too. sRGB is for common screens, Display P3 for screens of wide gamut, an ICC profile for a printer</source>
        <translation>檔案中數值所代表的顏色，檔案裡也會註明。sRGB 適合一般螢幕，Display P3 適合廣色域螢幕，ICC 描述檔適合印表機</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Thickness from the flat back to the lowest level of the canvas</source>
        <translation>從平坦的背面到畫布最低處的厚度</translation>
    </message>
    <message>
        <source> times as high</source>
        <translation> 倍高</translation>
    </message>
    <message>
        <source>1 is the relief as it is painted, 2 twice as high; width and height stay</source>
        <translation>1 是畫出來的起伏，2 則起伏高度加倍；畫面的寬和高不變</translation>
    </message>
    <message>
        <source> mm apart</source>
        <translation> mm 間距</translation>
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
        <translation>一秒影片呈現幾秒的作畫過程</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> 影格/秒</translation>
    </message>
    <message>
        <source>Frames in a second of film</source>
        <translation>影片每秒的影格數</translation>
    </message>
    <message>
        <source>&amp;Make</source>
        <translation>製作(&amp;M)</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>格式(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>品質(&amp;Q)</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>內容(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>比例(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>色彩(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Thickness</source>
        <translation>厚度(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Heights</source>
        <translation>起伏高度(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation>取樣點(&amp;P)</translation>
    </message>
    <message>
        <source>Sp&amp;eed</source>
        <translation>速度(&amp;E)</translation>
    </message>
    <message>
        <source>F&amp;rames</source>
        <translation>影格(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;File name</source>
        <translation>檔案名稱(&amp;N)</translation>
    </message>
    <message>
        <source> px/mm</source>
        <translation> px/mm</translation>
    </message>
    <message>
        <source>as it was painted</source>
        <translation>與原作相同</translation>
    </message>
    <message>
        <source>Canvas of &amp;it</source>
        <translation>重畫用的畫布(&amp;I)</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> 倍</translation>
    </message>
    <message>
        <source>1 as the window paints it, 2 twice as wide and high: finer, not merely enlarged</source>
        <translation>1 為視窗中繪製的大小，2 為寬高各兩倍：更精細，而不只是放大</translation>
    </message>
    <message>
        <source>Width of the picture in pixels</source>
        <translation>圖片寬度（像素）</translation>
    </message>
    <message>
        <source>Distance between two points of the surface; 0 is as far as the pixels, or farther where the canvas is large</source>
        <translation>表面上兩點之間的距離；0 表示與像素間距相同，畫布較大時會更寬</translation>
    </message>
    <message>
        <source>Pixels in a millimetre of the canvas that it is painted on once more: more show finer paint and take longer; 0 is as it was painted</source>
        <translation>重畫時畫布每公釐的像素數：越多越能呈現細緻的顏料，但也越花時間；0 表示與原作相同</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::KeyCatcher</name>
    <message>
        <source>Press the keys... (Esc: none)</source>
        <translation>請按下按鍵...（Esc：不設定）</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>快速鍵</translation>
    </message>
    <message>
        <source>What the keys are to start with; keys of your own stay</source>
        <translation>一開始使用的快速鍵；自訂的按鍵會保留</translation>
    </message>
    <message>
        <source>Find by words, or by keys such as Ctrl+J</source>
        <translation>用文字尋找，或用 Ctrl+J 之類的按鍵尋找</translation>
    </message>
    <message>
        <source>Click, and press other keys</source>
        <translation>按一下，再按其他按鍵</translation>
    </message>
    <message>
        <source>Add a key</source>
        <translation>新增快速鍵</translation>
    </message>
    <message>
        <source>As the set has it</source>
        <translation>恢復成這組的按鍵</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>保持原狀</translation>
    </message>
    <message>
        <source>Forget all my own keys</source>
        <translation>清除所有自訂按鍵</translation>
    </message>
    <message>
        <source>Click, and press other keys in place of these</source>
        <translation>按一下，再按要取代的按鍵</translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>%1 is needed on the canvas itself: it can be given to no command. Choose another key.</source>
        <translation>%1 在畫布上另有用途，不能指定給任何指令。請選擇其他按鍵。</translation>
    </message>
    <message>
        <source>%1 is its key already.</source>
        <translation>%1 已經是這個指令的快速鍵。</translation>
    </message>
    <message>
        <source>%1 is the key of &quot;%2&quot;.</source>
        <translation>%1 是「%2」的快速鍵。</translation>
    </message>
    <message>
        <source>Take it from there</source>
        <translation>改給這個指令</translation>
    </message>
    <message>
        <source>%1 stays with &quot;%2&quot;, which you gave it to.</source>
        <translation>%1 仍屬於「%2」，那是你指定的。</translation>
    </message>
    <message>
        <source>All keys will be as the set &quot;%1&quot; has them.</source>
        <translation>所有快速鍵都會恢復成「%1」的設定。</translation>
    </message>
    <message>
        <source>Forget my own</source>
        <translation>清除自訂按鍵</translation>
    </message>
    <message>
        <source>Set of keys</source>
        <translation>快速鍵組合</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>指令</translation>
    </message>
    <message>
        <source>No command has such words or keys.</source>
        <translation>沒有符合這些文字或按鍵的指令。</translation>
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
        <translation>新增畫布</translation>
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
        <translation>高度圖...</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>寬度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>解析度</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>基底材</translation>
    </message>
    <message>
        <source>Height image: white is high</source>
        <translation>高度圖：白色為高處</translation>
    </message>
    <message>
        <source>Image: %1</source>
        <translation>圖片：%1</translation>
    </message>
    <message>
        <source>For large forms: brush marks blur.</source>
        <translation>適合大塊面：筆痕會模糊。</translation>
    </message>
    <message>
        <source>Bristle marks of broad brushes show; close up, edges are soft.</source>
        <translation>可見寬筆的鬃毛痕；近看邊緣較柔。</translation>
    </message>
    <message>
        <source>Every bristle and thread shows close up, in fine brushes as well.</source>
        <translation>近看每根鬃毛與織線皆可見，細筆亦然。</translation>
    </message>
    <message>
        <source>This machine keeps pace with the hand.</source>
        <translation>這台電腦跟得上手的速度。</translation>
    </message>
    <message>
        <source>Bristle marks and the weave show.</source>
        <translation>可見鬃毛痕與布紋。</translation>
    </message>
    <message>
        <source>Dots per inch may be typed as well: 127 dpi</source>
        <translation>也可以輸入每英吋點數：127 dpi</translation>
    </message>
    <message>
        <source>This machine keeps pace with the hand up to %1 px/mm; what is painted can be painted again finer.</source>
        <translation>這台電腦在 %1 px/mm 以內跟得上手的速度；畫好的可以再重新繪製得更細。</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels, %3 dpi; up to %4 MB of memory when all of it is wet.</source>
        <translation>%1 × %2 像素、%3 dpi 的圖片；全部都是濕顏料時，最多占用 %4 MB 記憶體。</translation>
    </message>
    <message>
        <source>Other units may be typed as well: 50 cm, 20 in, 3000 px</source>
        <translation>也可以輸入其他單位：50 cm、20 in、3000 px</translation>
    </message>
    <message>
        <source>Toned ground</source>
        <translation>有色底</translation>
    </message>
    <message>
        <source>A dry coat of the paint in hand covers the whole canvas, on a layer of its own</source>
        <translation>用手上的顏料在獨立的圖層上鋪滿整張畫布，並且是乾的</translation>
    </message>
    <message>
        <source>0.02 mm tints the canvas, 0.1 mm covers it</source>
        <translation>0.02 mm 微微上色，0.1 mm 完全覆蓋</translation>
    </message>
    <message>
        <source>Thickness of the toned ground</source>
        <translation>有色底的厚度</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::RecoveryDialog</name>
    <message>
        <source>A painting without a name</source>
        <translation>未命名的畫作</translation>
    </message>
    <message>
        <source>A painting that cannot be read
%1</source>
        <translation>無法讀取的畫作
%1</translation>
    </message>
    <message numerus="yes">
        <source>%1
%2
%3 × %4 mm, %n change(s) not saved</source>
        <translation>
            <numerusform>%1
%2
%3 × %4 mm，%n 項變更尚未儲存</numerusform>
        </translation>
    </message>
    <message>
        <source>Unfinished paintings</source>
        <translation>未完成的畫作</translation>
    </message>
    <message>
        <source>Pastoso ended before these were saved.</source>
        <translation>Pastoso 結束時，這些畫作還沒有儲存。</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>救回</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>稍後再說</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>捨棄</translation>
    </message>
    <message>
        <source>Discard %1 for good? It is nowhere else.</source>
        <translation>要永久捨棄 %1 嗎？別處沒有備份。</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::RepaintDialog</name>
    <message>
        <source>Paint it again</source>
        <translation>重新繪製</translation>
    </message>
    <message>
        <source> px/mm</source>
        <translation> px/mm</translation>
    </message>
    <message>
        <source>&amp;Pixels per millimetre</source>
        <translation>每公釐像素數(&amp;P)</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, which take about %3 GB of memory; %4 GB are free. The strokes are painted again beside the painting on the easel, which stays as it is.</source>
        <translation>%1 × %2 像素，約需要 %3 GB 記憶體；可用 %4 GB。筆觸會另外重新繪製，畫架上的畫保持不變。</translation>
    </message>
    <message>
        <source>Dots per inch may be typed as well: 127 dpi</source>
        <translation>也可以輸入每英吋點數：127 dpi</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::RotateDialog</name>
    <message>
        <source>&amp;Keep the size of the canvas</source>
        <translation>維持畫布尺寸(&amp;K)</translation>
    </message>
    <message>
        <source>Rotate the image</source>
        <translation>旋轉影像</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Clockwise, about the middle of the canvas</source>
        <translation>繞畫布中心順時針旋轉</translation>
    </message>
    <message>
        <source>What comes beyond the canvas is wiped off</source>
        <translation>超出畫布的部分會被擦掉</translation>
    </message>
    <message>
        <source>Put the &amp;ruler straight</source>
        <translation>把直尺擺正(&amp;R)</translation>
    </message>
    <message>
        <source>Turns until the ruler is level or upright, whichever is nearer</source>
        <translation>旋轉到直尺變成水平或垂直，取較近者</translation>
    </message>
    <message>
        <source>Lay a ruler along the horizon first</source>
        <translation>請先沿地平線放一把直尺</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>旋轉</translation>
    </message>
    <message>
        <source>The image stands like this.</source>
        <translation>影像已經是這個方向。</translation>
    </message>
    <message>
        <source>A canvas of %1 × %2 mm.</source>
        <translation>畫布為 %1 × %2 mm。</translation>
    </message>
    <message>
        <source>What comes beyond it is wiped off.</source>
        <translation>超出的部分會被擦掉。</translation>
    </message>
    <message>
        <source>What is new in its corners is bare.</source>
        <translation>四角新增的部分是空白的。</translation>
    </message>
    <message>
        <source>The weave turns with the paint.</source>
        <translation>織紋會隨顏料一起旋轉。</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::ScaleDialog</name>
    <message>
        <source>Paint keeps its thickness, so that there is %1 times as much of it.</source>
        <translation>顏料厚度不變，因此用量變為 %1 倍。</translation>
    </message>
    <message>
        <source>Keep the &amp;proportions</source>
        <translation>維持比例(&amp;P)</translation>
    </message>
    <message>
        <source>Scale the image</source>
        <translation>縮放影像</translation>
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
        <translation>也可以輸入每英吋點數：127 dpi</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>寬度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>解析度</translation>
    </message>
    <message>
        <source>The image has this size and this resolution.</source>
        <translation>影像已經是這個尺寸和解析度。</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels, %3 dpi; up to %4 MB of memory when all of it is wet.</source>
        <translation>%1 × %2 像素、%3 dpi 的圖片；全部都是濕顏料時，最多占用 %4 MB 記憶體。</translation>
    </message>
    <message>
        <source>Other units may be typed as well: 50 cm, 20 in, 3000 px</source>
        <translation>也可以輸入其他單位：50 cm、20 in、3000 px</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::SelectRangeDialog</name>
    <message>
        <source>Select it</source>
        <translation>建立選取範圍</translation>
    </message>
    <message>
        <source>Add it to the selection</source>
        <translation>加入選取範圍</translation>
    </message>
    <message>
        <source>Take it out of the selection</source>
        <translation>從選取範圍減去</translation>
    </message>
    <message>
        <source>Keep what is in both</source>
        <translation>保留兩者重疊的部分</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>選取</translation>
    </message>
    <message>
        <source>From</source>
        <translation>從</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Do</source>
        <translation>動作</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Nothing is there to be selected.</source>
        <translation>沒有可選取的部分。</translation>
    </message>
    <message>
        <source>Then %1 % of the canvas is selected.</source>
        <translation>結果會選取畫布的 %1 %。</translation>
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
        <translation>外觀</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>效能</translation>
    </message>
    <message>
        <source>This machine</source>
        <translation>這部電腦</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>佈景主題</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>淺色</translation>
    </message>
    <message>
        <source>Both are neutral greys, so that nothing beside the canvas colours what you see on it.</source>
        <translation>兩者都是中性灰，畫布旁的顏色才不會影響你對畫面的判斷。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>語言</translation>
    </message>
    <message>
        <source>As on the desktop</source>
        <translation>與桌面相同</translation>
    </message>
    <message>
        <source>Another language speaks from the next start on.</source>
        <translation>下次啟動後會改用新的語言。</translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation>復原記憶體</translation>
    </message>
    <message>
        <source>The steps that you can return to. The oldest are given up when it is full; 500 are kept at most.</source>
        <translation>可以返回的步驟。存滿時會捨棄最舊的步驟；最多保留 500 步。</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>永不</translation>
    </message>
    <message>
        <source>Save by itself every</source>
        <translation>自動儲存間隔</translation>
    </message>
    <message>
        <source>Into the painting&apos;s own file, once it has one. Whatever you choose, every stroke is kept aside within a second and offered to you again should the program or the machine fail.</source>
        <translation>畫作有了自己的檔案後，就自動存入該檔案。無論怎麼選，每一筆都會在一秒內另外保留；萬一程式或電腦出問題，也能讓你救回。</translation>
    </message>
    <message>
        <source>All of the machine (%1)</source>
        <translation>電腦的全部資源 (%1)</translation>
    </message>
    <message>
        <source>How many things the program works on at once, from the next painting on. The paint flows the same with any number.</source>
        <translation>程式同時處理多少工作，從下一幅畫作開始生效。無論數目多少，顏料的流動都一樣。</translation>
    </message>
    <message>
        <source>How carefully moving paint is shown follows from how fast this machine draws; what stands still is always shown in full.</source>
        <translation>流動中的顏料顯示得多細緻，取決於這部電腦的繪圖速度；靜止的部分一律完整顯示。</translation>
    </message>
    <message numerus="yes">
        <source> minute(s)</source>
        <translation>
            <numerusform> 分鐘</numerusform>
        </translation>
    </message>
    <message>
        <source>The canvas is drawn by</source>
        <translation>畫布的繪製方式</translation>
    </message>
    <message>
        <source>What is faster here</source>
        <translation>此電腦上較快的方式</translation>
    </message>
    <message>
        <source>The graphics card (OpenGL)</source>
        <translation>顯示卡 (OpenGL)</translation>
    </message>
    <message>
        <source>The processor</source>
        <translation>處理器</translation>
    </message>
    <message>
        <source>Choose the processor where a graphics driver shows the canvas wrongly.</source>
        <translation>若顯示卡驅動程式無法正確顯示畫布，請選擇處理器。</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色彩</translation>
    </message>
    <message>
        <source>None</source>
        <translation>無</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>選擇...</translation>
    </message>
    <message>
        <source>ICC profiles (*.icc *.icm);;All files (*)</source>
        <translation>ICC 描述檔 (*.icc *.icm);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Of the system, which has none here</source>
        <translation>系統的（此處沒有）</translation>
    </message>
    <message>
        <source>Of the system (%1)</source>
        <translation>系統的 (%1)</translation>
    </message>
    <message>
        <source>The screen&apos;s profile</source>
        <translation>螢幕的描述檔</translation>
    </message>
    <message>
        <source>None (sRGB)</source>
        <translation>無 (sRGB)</translation>
    </message>
    <message>
        <source>A file</source>
        <translation>檔案</translation>
    </message>
    <message>
        <source>Its file</source>
        <translation>其檔案</translation>
    </message>
    <message>
        <source>With the profile of your screen, canvas and swatches have the same colours as on any other that is measured. Files and exports are not changed.</source>
        <translation>使用螢幕的描述檔後，畫布和色樣的顏色會與其他經過量測的螢幕相同。檔案與匯出不會改變。</translation>
    </message>
    <message>
        <source>The printer&apos;s profile</source>
        <translation>印表機的描述檔</translation>
    </message>
    <message>
        <source>For &quot;Soft proof&quot; and &quot;Gamut warning&quot; in the &quot;View&quot; menu: of your printer and paper, or of your printing house.</source>
        <translation>用於「檢視」選單中的「軟打樣」與「色域警告」：您的印表機與紙張的，或印刷廠的描述檔。</translation>
    </message>
    <message>
        <source>Undo and saving</source>
        <translation>復原與儲存</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Processors in use</source>
        <translation>使用的處理器數</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::TextureDialog</name>
    <message>
        <source>A&amp;nother</source>
        <translation>換一種(&amp;N)</translation>
    </message>
    <message>
        <source>Texture paste</source>
        <translation>肌理膏</translation>
    </message>
    <message>
        <source>A dry coat of the paint in hand lies on the layer that you paint on, where it is selected or all over. Brushes then catch on it.</source>
        <translation>手上顏料的乾層會鋪在正在畫的圖層上，只在選取範圍或整張畫布；之後筆刷會在上面刮擦著色。</translation>
    </message>
    <message>
        <source>Sand</source>
        <translation>砂</translation>
    </message>
    <message>
        <source>Modelling paste</source>
        <translation>塑型膏</translation>
    </message>
    <message>
        <source>A picture pressed in</source>
        <translation>壓印的圖片</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>肌理</translation>
    </message>
    <message>
        <source>Grains</source>
        <translation>顆粒</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Between ridges</source>
        <translation>脊線間距</translation>
    </message>
    <message>
        <source>Other grains or other passes of the knife</source>
        <translation>換另一批顆粒或另一組刀痕</translation>
    </message>
    <message>
        <source>Lay the paste</source>
        <translation>鋪上肌理膏</translation>
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
        <translation>畫刀移動的方向：0 為向右，90 為向下</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>圖片</translation>
    </message>
    <message>
        <source>What is &amp;dark stands up</source>
        <translation>暗處凸起(&amp;D)</translation>
    </message>
    <message>
        <source>Picture to press in</source>
        <translation>要壓印的圖片</translation>
    </message>
    <message>
        <source>Choose a picture...</source>
        <translation>選擇圖片...</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::TransformDialog</name>
    <message>
        <source>Transform</source>
        <translation>變形</translation>
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
        <translation>右移</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>下移</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>寬度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>旋轉</translation>
    </message>
    <message>
        <source>Clockwise, about the middle of the frame</source>
        <translation>繞外框中心順時針旋轉</translation>
    </message>
    <message>
        <source>Left–right</source>
        <translation>左右</translation>
    </message>
    <message>
        <source>Left and right of the paint change places, before it is turned</source>
        <translation>旋轉之前，先將顏料左右對調</translation>
    </message>
    <message>
        <source>Up–down</source>
        <translation>上下</translation>
    </message>
    <message>
        <source>Above and below change places, before the paint is turned</source>
        <translation>旋轉之前，先將顏料上下對調</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>鏡像</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>套用</translation>
    </message>
    <message>
        <source>The paint keeps its thickness and its amount.</source>
        <translation>顏料的厚度和總量都不變。</translation>
    </message>
    <message>
        <source>The paint keeps its thickness: %1 % of it will be there.</source>
        <translation>顏料的厚度不變：總量會變成原來的 %1 %。</translation>
    </message>
    <message>
        <source>What comes beyond the canvas is wiped off.</source>
        <translation>超出畫布的部分會被擦掉。</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>四角</translation>
    </message>
    <message>
        <source>Drag with Ctrl: a corner alone, or a side askew. By keys: Tab chooses a corner, arrows move it, with Shift by ten pixels.</source>
        <translation>按住 Ctrl 拖曳：單獨移動一個角，或讓一邊傾斜。用鍵盤：Tab 選一個角，方向鍵移動它，按住 Shift 一次十個像素。</translation>
    </message>
</context>
<context>
    <name>pastoso::document::Table</name>
    <message>
        <source>Dry now</source>
        <translation>立即乾燥</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>筆觸</translation>
    </message>
    <message>
        <source>Paint squeezed out</source>
        <translation>擠出顏料</translation>
    </message>
    <message>
        <source>Mixing well wiped</source>
        <translation>擦淨調色槽</translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>新增圖層</translation>
    </message>
    <message>
        <source>Look of a layer</source>
        <translation>圖層外觀</translation>
    </message>
    <message>
        <source>Layer duplicated</source>
        <translation>複製圖層</translation>
    </message>
    <message>
        <source>Layer removed</source>
        <translation>移除圖層</translation>
    </message>
    <message>
        <source>Layer cleared</source>
        <translation>清除圖層</translation>
    </message>
    <message>
        <source>Transform</source>
        <translation>變形</translation>
    </message>
    <message>
        <source>Layer moved</source>
        <translation>移動圖層</translation>
    </message>
    <message>
        <source>Merged down</source>
        <translation>向下合併</translation>
    </message>
    <message>
        <source>Flattened</source>
        <translation>平面化</translation>
    </message>
    <message>
        <source>Layers grouped</source>
        <translation>將圖層組成群組</translation>
    </message>
    <message>
        <source>Look of a group</source>
        <translation>群組外觀</translation>
    </message>
    <message>
        <source>Group moved</source>
        <translation>移動群組</translation>
    </message>
    <message>
        <source>Group dissolved</source>
        <translation>解散群組</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>選取範圍</translation>
    </message>
    <message>
        <source>Size of the canvas</source>
        <translation>畫布尺寸</translation>
    </message>
    <message>
        <source>Picture as paint</source>
        <translation>圖片轉為顏料</translation>
    </message>
    <message>
        <source>Picture to trace</source>
        <translation>描圖底圖</translation>
    </message>
    <message>
        <source>Place of the traced picture</source>
        <translation>底圖的位置</translation>
    </message>
    <message>
        <source>Paint pasted</source>
        <translation>已貼上顏料</translation>
    </message>
    <message>
        <source>Filled with paint</source>
        <translation>以顏料填滿</translation>
    </message>
    <message>
        <source>Painting scaled</source>
        <translation>整幅畫已縮放</translation>
    </message>
    <message>
        <source>Ground toned</source>
        <translation>已鋪有色底</translation>
    </message>
    <message>
        <source>Painting rotated</source>
        <translation>整幅畫已旋轉</translation>
    </message>
    <message>
        <source>Masking fluid</source>
        <translation>遮蓋液</translation>
    </message>
    <message>
        <source>Selection masked</source>
        <translation>選取範圍已遮蓋</translation>
    </message>
    <message>
        <source>Masking peeled off</source>
        <translation>撕掉遮蓋</translation>
    </message>
    <message>
        <source>Reference picture</source>
        <translation>參考圖片</translation>
    </message>
    <message>
        <source>Place of a reference</source>
        <translation>參考圖片的位置</translation>
    </message>
    <message>
        <source>Order of the references</source>
        <translation>參考圖片的順序</translation>
    </message>
    <message>
        <source>Reference taken away</source>
        <translation>移除參考圖片</translation>
    </message>
    <message>
        <source>Texture laid</source>
        <translation>已鋪肌理</translation>
    </message>
    <message>
        <source>Dry paint adjusted</source>
        <translation>已調整乾顏料</translation>
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
        <translation>倒入時間</translation>
    </message>
    <message>
        <source>How long the milk of a new glass is poured</source>
        <translation>新的一杯倒入牛奶的時間</translation>
    </message>
    <message>
        <source>Stream</source>
        <translation>水流</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Fat lifts</source>
        <translation>脂肪上浮</translation>
    </message>
    <message>
        <source>How fast fat lets milk rise</source>
        <translation>脂肪使牛奶上升的快慢</translation>
    </message>
    <message>
        <source>Cold sinks</source>
        <translation>低溫下沉</translation>
    </message>
    <message>
        <source>How fast cold lets milk sink</source>
        <translation>低溫使牛奶下沉的快慢</translation>
    </message>
    <message>
        <source>Milky tea sinks</source>
        <translation>含奶茶下沉</translation>
    </message>
    <message>
        <source>How fast tea with milk in it sinks</source>
        <translation>含牛奶的茶下沉的快慢</translation>
    </message>
    <message>
        <source>Warms at rest in</source>
        <translation>靜置回溫</translation>
    </message>
    <message>
        <source>Time in which milk at rest warms</source>
        <translation>靜置的牛奶變暖所需的時間</translation>
    </message>
    <message>
        <source>A ball warms in</source>
        <translation>奶球回溫</translation>
    </message>
    <message>
        <source>Time in which a ball warms</source>
        <translation>奶球變暖所需的時間</translation>
    </message>
    <message>
        <source>Cold given on</source>
        <translation>傳給茶的冷</translation>
    </message>
    <message>
        <source>Share of the milk&apos;s cold that the tea gets</source>
        <translation>牛奶的冷傳給茶的比例</translation>
    </message>
    <message>
        <source>First ball after</source>
        <translation>首個奶球</translation>
    </message>
    <message>
        <source>When the first ball forms</source>
        <translation>第一個奶球形成的時刻</translation>
    </message>
    <message>
        <source>A ball every</source>
        <translation>奶球間隔</translation>
    </message>
    <message>
        <source>Time between two balls, in the mean</source>
        <translation>兩個奶球之間的平均時間</translation>
    </message>
    <message>
        <source>Ball&apos;s radius</source>
        <translation>奶球半徑</translation>
    </message>
    <message>
        <source>Radius of a ball, in the mean</source>
        <translation>奶球的平均半徑</translation>
    </message>
    <message>
        <source>Sizes differ by</source>
        <translation>大小差異</translation>
    </message>
    <message>
        <source>How much balls differ in size</source>
        <translation>奶球大小的差異程度</translation>
    </message>
    <message>
        <source>A warm ball in</source>
        <translation>暖奶球</translation>
    </message>
    <message>
        <source>Time in which a warm ball dissolves</source>
        <translation>變暖的奶球溶解所需的時間</translation>
    </message>
    <message>
        <source>On top in</source>
        <translation>頂層</translation>
    </message>
    <message>
        <source>Time in which milk under the surface dissolves</source>
        <translation>液面下的牛奶溶解所需的時間</translation>
    </message>
    <message>
        <source>On top is</source>
        <translation>頂層厚度</translation>
    </message>
    <message>
        <source>How far down that is</source>
        <translation>頂層向下延伸多深</translation>
    </message>
    <message>
        <source>At rest in</source>
        <translation>靜置時</translation>
    </message>
    <message>
        <source>Time in which milk at rest dissolves</source>
        <translation>靜置的牛奶溶解所需的時間</translation>
    </message>
    <message>
        <source>All from</source>
        <translation>全部自</translation>
    </message>
    <message>
        <source>When all milk begins to dissolve</source>
        <translation>所有牛奶開始溶解的時刻</translation>
    </message>
    <message>
        <source>Warm below</source>
        <translation>視為暖於</translation>
    </message>
    <message>
        <source>Coldness below which a ball dissolves</source>
        <translation>冷度低於此值時奶球會溶解</translation>
    </message>
    <message>
        <source>Milk spreads</source>
        <translation>牛奶擴散</translation>
    </message>
    <message>
        <source>How dissolved milk spreads</source>
        <translation>溶解的牛奶如何擴散</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>黏度</translation>
    </message>
    <message>
        <source>Kinematic viscosity: water 1, oil 80, honey 5000</source>
        <translation>動黏度：水 1、油 80、蜂蜜 5000</translation>
    </message>
    <message>
        <source>Heat spreads</source>
        <translation>熱擴散</translation>
    </message>
    <message>
        <source>How heat spreads</source>
        <translation>熱如何擴散</translation>
    </message>
    <message>
        <source>Whirls kept</source>
        <translation>渦旋保持</translation>
    </message>
    <message>
        <source>Force that keeps small whirls alive</source>
        <translation>維持小渦旋的力</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>時間步長</translation>
    </message>
    <message>
        <source>Length of a time step</source>
        <translation>一個時間步的長度</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> 毫秒</translation>
    </message>
    <message>
        <source>Pressure within</source>
        <translation>壓力誤差</translation>
    </message>
    <message>
        <source>How exact the pressure is solved</source>
        <translation>求解壓力的精確度</translation>
    </message>
    <message>
        <source>Pouring</source>
        <translation>倒入</translation>
    </message>
    <message>
        <source>Sinking and rising</source>
        <translation>下沉與上升</translation>
    </message>
    <message>
        <source>Balls of milk</source>
        <translation>奶球</translation>
    </message>
    <message>
        <source>Dissolving</source>
        <translation>溶解</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>流動</translation>
    </message>
    <message>
        <source>Milk</source>
        <translation>牛奶</translation>
    </message>
    <message>
        <source>How much milk is poured into a new glass by itself</source>
        <translation>自動倒入新的一杯的牛奶量</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> 毫升</translation>
    </message>
    <message>
        <source>Force reaches</source>
        <translation>力的範圍</translation>
    </message>
    <message>
        <source>How far the force reaches from its axis</source>
        <translation>力從軸心所及的距離</translation>
    </message>
    <message>
        <source>Tank: liquid falls</source>
        <translation>水槽：液體落下</translation>
    </message>
    <message>
        <source>Tank: two liquids meet</source>
        <translation>水槽：兩種液體相遇</translation>
    </message>
    <message>
        <source>Back to the painting</source>
        <translation>回到畫作</translation>
    </message>
    <message>
        <source>The glass waits as it is, and so did the painting</source>
        <translation>杯子原樣等候，畫作也一直如此</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>重力</translation>
    </message>
    <message>
        <source>How fast what falls gets faster</source>
        <translation>落下之物加速的快慢</translation>
    </message>
    <message>
        <source>Lively</source>
        <translation>活潑</translation>
    </message>
    <message>
        <source>What of its own velocity a drop keeps from step to step: less is calmer</source>
        <translation>水滴在每步之間保留自身速度的比例：越少越平靜</translation>
    </message>
    <message>
        <source>Volume mended</source>
        <translation>體積修正</translation>
    </message>
    <message>
        <source>How much of a wrong density a step mends</source>
        <translation>每步修正多少錯誤的密度</translation>
    </message>
    <message>
        <source>Way of a step</source>
        <translation>每步距離</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>數值</translation>
    </message>
    <message>
        <source>Each number of the liquid</source>
        <translation>液體的每個數值</translation>
    </message>
    <message>
        <source>thin as water</source>
        <translation>稀如水</translation>
    </message>
    <message>
        <source>thick as honey</source>
        <translation>濃如蜜</translation>
    </message>
    <message>
        <source>Its viscosity</source>
        <translation>液體的黏度</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>平靜</translation>
    </message>
    <message>
        <source>lively</source>
        <translation>活潑</translation>
    </message>
    <message>
        <source>How much of its own movement each drop keeps</source>
        <translation>每一滴保留多少自身的運動</translation>
    </message>
    <message>
        <source>warm milk</source>
        <translation>溫牛奶</translation>
    </message>
    <message>
        <source>cold milk</source>
        <translation>冷牛奶</translation>
    </message>
    <message>
        <source>Warm milk spreads under the surface, cold milk falls to the floor</source>
        <translation>溫牛奶在液面下散開，冷牛奶沉到杯底</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>稀薄</translation>
    </message>
    <message>
        <source>creamy</source>
        <translation>濃郁</translation>
    </message>
    <message>
        <source>Thin milk stays below and mixes soon, creamy milk rises in large soft clouds</source>
        <translation>稀薄的牛奶留在下方並很快混合，濃郁的牛奶以柔軟的大團雲狀上升</translation>
    </message>
    <message>
        <source>hot tea</source>
        <translation>熱茶</translation>
    </message>
    <message>
        <source>ice-cold tea</source>
        <translation>冰茶</translation>
    </message>
    <message>
        <source>Hot tea warms the milk, and it rises again; in ice-cold tea it lies where it fell</source>
        <translation>熱茶使牛奶變暖而再度上升；在冰茶中，牛奶留在落下之處</translation>
    </message>
    <message>
        <source>Cold milk</source>
        <translation>冷牛奶</translation>
    </message>
    <message>
        <source>Cold milk sinks, and comes up again in soft clouds as it warms</source>
        <translation>冷牛奶下沉，變暖後以柔軟的雲狀再度上升</translation>
    </message>
    <message>
        <source>Cold brew</source>
        <translation>冷泡茶</translation>
    </message>
    <message>
        <source>A thin stream into cold tea: it heaps up on the floor and stays there for long</source>
        <translation>細流倒入冷茶：堆積在杯底並久久停留</translation>
    </message>
    <message>
        <source>Cream</source>
        <translation>鮮奶油</translation>
    </message>
    <message>
        <source>Thick cream turns round and floats on the tea</source>
        <translation>濃稠的鮮奶油折返並浮在茶上</translation>
    </message>
    <message>
        <source>A drop</source>
        <translation>一滴</translation>
    </message>
    <message>
        <source>A little thin milk, drawn out to fingers and veils</source>
        <translation>少許稀薄的牛奶，拉成指狀與薄紗</translation>
    </message>
    <message>
        <source>Stirred</source>
        <translation>攪拌</translation>
    </message>
    <message>
        <source>The spoon goes round while the milk is poured</source>
        <translation>倒牛奶時湯匙不停轉動</translation>
    </message>
    <message>
        <source>White</source>
        <translation>白</translation>
    </message>
    <message>
        <source>A wide stream of milk billows up and fills the glass</source>
        <translation>寬闊的牛奶流翻湧而上，充滿杯子</translation>
    </message>
    <message>
        <source>poured low</source>
        <translation>低處倒入</translation>
    </message>
    <message>
        <source>from high</source>
        <translation>高處倒入</translation>
    </message>
    <message>
        <source>Poured low, milk comes to lie on the floor; from high, it stirs the whole glass</source>
        <translation>從低處倒入，牛奶沉積於杯底；從高處倒入，則攪動整杯</translation>
    </message>
    <message>
        <source>Radius of the stream at the jug</source>
        <translation>壺嘴處細流的半徑</translation>
    </message>
    <message>
        <source>Speed of the stream at the jug, downwards</source>
        <translation>壺嘴處細流向下的速度</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>落差</translation>
    </message>
    <message>
        <source>How high above the tea the lip of the jug is</source>
        <translation>壺嘴高於茶面多少</translation>
    </message>
    <message>
        <source>The longest way of a step, against the finest detail of the liquid: longer is faster and coarser</source>
        <translation>每步最長距離，與液體最細部分相比：越長越快也越粗</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::GlassChooser</name>
    <message>
        <source>What is in the glass</source>
        <translation>杯中之物</translation>
    </message>
    <message>
        <source>What is in the glass: milk tea, or a tank of liquid</source>
        <translation>杯中之物：奶茶，或一缸液體</translation>
    </message>
    <message>
        <source>Milk tea</source>
        <translation>奶茶</translation>
    </message>
    <message>
        <source>Open a tank...</source>
        <translation>開啟水槽...</translation>
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
        <translation>%1   已暫停</translation>
    </message>
    <message>
        <source>%1   %2 steps/s</source>
        <translation>%1   %2 步/秒</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>已暫停</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::LiquidPictureDialog</name>
    <message>
        <source>Pixels from left to right</source>
        <translation>由左至右的像素數</translation>
    </message>
    <message>
        <source>Pixels from top to bottom</source>
        <translation>由上至下的像素數</translation>
    </message>
    <message>
        <source>Ways of light for each pixel: four times as many, half the noise</source>
        <translation>每個像素的光路數：四倍的數量，一半的雜訊</translation>
    </message>
    <message>
        <source>As a surface</source>
        <translation>作為表面</translation>
    </message>
    <message>
        <source>As a cloud</source>
        <translation>作為雲霧</translation>
    </message>
    <message>
        <source>How milk that has not dissolved is seen: a cloud is softer and takes longer</source>
        <translation>未溶解的牛奶的呈現方式：雲霧較柔和，但較費時</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>寬度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>取樣數</translation>
    </message>
    <message>
        <source>Milk</source>
        <translation>牛奶</translation>
    </message>
    <message>
        <source>Use on the canvas</source>
        <translation>用於畫布</translation>
    </message>
    <message>
        <source>Puts the picture onto the painting as a layer of dry paint, and goes there</source>
        <translation>將圖片作為一層乾顏料放到畫作上，並回到畫作</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>儲存...</translation>
    </message>
    <message>
        <source>As PNG and others as it is shown, or as EXR with the light itself</source>
        <translation>PNG 等格式依所見儲存，EXR 則儲存光本身</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>關閉</translation>
    </message>
    <message>
        <source>Taking the noise out...</source>
        <translation>正在去除雜訊...</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>算繪</translation>
    </message>
    <message>
        <source>Keep the picture as fine as it is by now</source>
        <translation>保留目前細緻程度的圖片</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>儲存圖片</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>圖片 (%1)</translation>
    </message>
    <message>
        <source>Finding the surface...</source>
        <translation>正在尋找表面...</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) in %1 s, without noise</source>
        <translation>
            <numerusform>%n 次取樣，%1 秒，已去除雜訊</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n sample(s)</source>
        <translation>
            <numerusform>%1 / %n 次取樣</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) in %1 s: too few to take all noise out</source>
        <translation>
            <numerusform>%n 次取樣，%1 秒：太少，無法除去所有雜訊</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pastoso::glass::TankPage</name>
    <message>
        <source>Moment of the tank</source>
        <translation>水槽的時刻</translation>
    </message>
    <message>
        <source>Drag to any moment of the tank; going on goes on from its last</source>
        <translation>拖到水槽的任一時刻；繼續時由最後一刻接下去</translation>
    </message>
    <message>
        <source>Liquid in the tank, and how many steps a second are computed</source>
        <translation>水槽中的液體，以及每秒計算的步數</translation>
    </message>
    <message>
        <source>Filling the tank...</source>
        <translation>正在注滿水槽...</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 公升</translation>
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
        <translation>球與排水口</translation>
    </message>
    <message>
        <source>Ball&apos;s radius</source>
        <translation>奶球半徑</translation>
    </message>
    <message>
        <source>How large the ball is that falls where you press</source>
        <translation>你按下處落下的球有多大</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Milk in it</source>
        <translation>其中的牛奶</translation>
    </message>
    <message>
        <source>How much of the ball is milk</source>
        <translation>球中有多少是牛奶</translation>
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
        <translation>速度</translation>
    </message>
    <message>
        <source>How fast the air goes</source>
        <translation>空氣的速度</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Blows to</source>
        <translation>吹向</translation>
    </message>
    <message>
        <source>0 to the right along the front, 90 away from it</source>
        <translation>0 為沿正面向右，90 為遠離正面</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Drags</source>
        <translation>拖曳</translation>
    </message>
    <message>
        <source>How firmly it takes the liquid&apos;s surface along</source>
        <translation>帶動液體表面的力道</translation>
    </message>
    <message>
        <source> /s</source>
        <translation> /秒</translation>
    </message>
    <message>
        <source>Look and export</source>
        <translation>檢視與匯出</translation>
    </message>
    <message>
        <source>Liquid</source>
        <translation>液體</translation>
    </message>
    <message>
        <source>Every step into a folder</source>
        <translation>每一步存入資料夾</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::TeaPage</name>
    <message>
        <source>Moment of the tea</source>
        <translation>茶的時刻</translation>
    </message>
    <message>
        <source>Drag to any moment of the glass; going on goes on from its last</source>
        <translation>拖曳到任何時刻；繼續時會從最後一刻接續</translation>
    </message>
    <message>
        <source>Milk poured so far, and how many steps of 1/30 s a second are computed</source>
        <translation>目前倒入的牛奶，以及每秒計算多少個 1/30 秒的步</translation>
    </message>
    <message>
        <source>Filling the glass...</source>
        <translation>正在斟茶...</translation>
    </message>
    <message>
        <source>%1 ml of milk</source>
        <translation>牛奶 %1 毫升</translation>
    </message>
    <message>
        <source>Press on the tea to pour milk where you point</source>
        <translation>按住茶面，在所指之處倒入牛奶</translation>
    </message>
    <message>
        <source>The glass is full</source>
        <translation>杯子已滿</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::TeaPanel</name>
    <message>
        <source>Pictures</source>
        <translation>圖片</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>杯子</translation>
    </message>
    <message>
        <source>Drops that the next glass&apos; milk is made of</source>
        <translation>組成下一杯牛奶的奶滴數</translation>
    </message>
    <message>
        <source>Drops of milk</source>
        <translation>奶滴</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Around the axis</source>
        <translation>繞軸</translation>
    </message>
    <message>
        <source>How fast the stirring gets faster; below 0 it goes the other way round</source>
        <translation>攪拌加快的程度；低於 0 則反向</translation>
    </message>
    <message>
        <source> rad/s²</source>
        <translation> rad/s²</translation>
    </message>
    <message>
        <source>Downwards</source>
        <translation>向下</translation>
    </message>
    <message>
        <source> m/s²</source>
        <translation> m/s²</translation>
    </message>
    <message>
        <source>A push down along the axis; below 0 it goes up</source>
        <translation>沿軸向下的推力；低於 0 則向上</translation>
    </message>
    <message>
        <source>Milk and tea</source>
        <translation>牛奶與茶</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>The next glass</source>
        <translation>下一杯</translation>
    </message>
    <message>
        <source>Fineness</source>
        <translation>精細度</translation>
    </message>
    <message>
        <source>Parts that each side of the next glass is divided into: twice as many take sixteen times as long; balls rise from 64 on</source>
        <translation>下一杯每邊分成的份數：加倍時所需時間為十六倍；64 起奶球才會上升</translation>
    </message>
</context>
<context>
    <name>pastoso::help::AboutDialog</name>
    <message>
        <source>About Pastoso</source>
        <translation>關於 Pastoso</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程式</translation>
    </message>
    <message>
        <source>This machine</source>
        <translation>這部電腦</translation>
    </message>
    <message>
        <source>Folders</source>
        <translation>資料夾</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>程式庫</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>授權</translation>
    </message>
</context>
<context>
    <name>pastoso::help::HelpView</name>
    <message>
        <source>Page of the manual</source>
        <translation>使用手冊的頁面</translation>
    </message>
</context>
<context>
    <name>pastoso::help::HelpWindow</name>
    <message>
        <source>Manual</source>
        <translation>使用手冊</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>搜尋使用手冊</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>使用手冊的各頁</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>搜尋結果</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>上一頁</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>下一頁</translation>
    </message>
    <message>
        <source>Nothing is found.</source>
        <translation>找不到任何內容。</translation>
    </message>
</context>
<context>
    <name>pastoso::help::TourBubble</name>
    <message>
        <source>Skip the tour</source>
        <translation>略過導覽</translation>
    </message>
    <message>
        <source>Go on with the tour</source>
        <translation>繼續導覽</translation>
    </message>
    <message>
        <source>Leave the tour, as Escape does; &quot;Show me round&quot; in the &quot;Help&quot; menu brings it back</source>
        <translation>離開導覽（按 Esc 亦可）；「說明」選單的「帶我看看」可再次開啟</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
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
        <translation>無</translation>
    </message>
    <message>
        <source>Graphics</source>
        <translation>圖形處理器</translation>
    </message>
    <message>
        <source>%1 (the processor draws, no graphics card)</source>
        <translation>%1（由處理器繪製，沒有使用顯示卡）</translation>
    </message>
    <message>
        <source>Its maker</source>
        <translation>製造商</translation>
    </message>
    <message>
        <source>Shading language</source>
        <translation>著色語言</translation>
    </message>
    <message>
        <source>Largest texture</source>
        <translation>最大材質</translation>
    </message>
    <message>
        <source>%1 pixels a side</source>
        <translation>每邊 %1 像素</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, %3 for one of the layout</source>
        <translation>%1 × %2 像素，版面每像素為 %3 像素</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程式</translation>
    </message>
    <message>
        <source>System</source>
        <translation>系統</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>處理器</translation>
    </message>
    <message>
        <source>%1 at once, %2, kernels for %3</source>
        <translation>可同時執行 %1 個執行緒，%2，運算程式碼採用 %3</translation>
    </message>
    <message>
        <source>Free memory</source>
        <translation>可用記憶體</translation>
    </message>
    <message>
        <source>Windows by</source>
        <translation>視窗系統</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>螢幕</translation>
    </message>
    <message>
        <source>Top up</source>
        <translation>補沾</translation>
    </message>
    <message>
        <source>Blot</source>
        <translation>吸除</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>交換</translation>
    </message>
    <message>
        <source>Pick paint</source>
        <translation>沾取顏料</translation>
    </message>
    <message>
        <source>Pick colour</source>
        <translation>取色</translation>
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
        <translation>選擇...</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Below the paint</source>
        <translation>在顏料下方</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>符合大小</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>轉正</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>鏡像</translation>
    </message>
    <message>
        <source>Watch it grow...</source>
        <translation>觀看作畫過程...</translation>
    </message>
    <message>
        <source>Make a time-lapse...</source>
        <translation>製作縮時影片...</translation>
    </message>
    <message>
        <source>Save the recording...</source>
        <translation>儲存錄製檔...</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>顏色</translation>
    </message>
    <message>
        <source>Physics</source>
        <translation>物理</translation>
    </message>
    <message>
        <source>Guides</source>
        <translation>輔助線</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>光線</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>圖層</translation>
    </message>
    <message>
        <source>Tracing</source>
        <translation>描圖</translation>
    </message>
    <message>
        <source>History</source>
        <translation>步驟記錄</translation>
    </message>
    <message>
        <source>Navigator</source>
        <translation>導覽器</translation>
    </message>
    <message>
        <source>Recorder</source>
        <translation>錄製</translation>
    </message>
    <message>
        <source>As it was painted</source>
        <translation>原本的速度</translation>
    </message>
    <message>
        <source>4 times as fast</source>
        <translation>4 倍速</translation>
    </message>
    <message>
        <source>16 times as fast</source>
        <translation>16 倍速</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>盡可能快</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開啟</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>儲存</translation>
    </message>
    <message>
        <source>Stir</source>
        <translation>攪拌</translation>
    </message>
    <message>
        <source>Other way round</source>
        <translation>反方向</translation>
    </message>
    <message>
        <source>Render a picture...</source>
        <translation>算繪圖片...</translation>
    </message>
    <message>
        <source>Export the surface...</source>
        <translation>匯出表面...</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>重新開始</translation>
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
        <translation>匯出所有時刻...</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>圖片</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>訊息</translation>
    </message>
    <message>
        <source>Pour</source>
        <translation>倒入</translation>
    </message>
    <message>
        <source>Paint it again, finer...</source>
        <translation>重新繪製...</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>筆刷</translation>
    </message>
    <message>
        <source>Paints</source>
        <translation>顏料</translation>
    </message>
    <message>
        <source>Easel</source>
        <translation>畫架</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>貼齊</translation>
    </message>
    <message>
        <source>Add...</source>
        <translation>加入...</translation>
    </message>
    <message>
        <source>Own window</source>
        <translation>獨立視窗</translation>
    </message>
    <message>
        <source>References</source>
        <translation>參考圖片</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>A recording is being played; the paint is yours when it has ended.</source>
        <translation>正在播放錄製內容；結束後就能使用顏料。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BackgroundExport</name>
    <message>
        <source>A file is being written already. Try again in a moment.</source>
        <translation>已有檔案正在寫入。請稍後再試。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BrushBundles</name>
    <message>
        <source>Import tools</source>
        <translation>匯入工具</translation>
    </message>
    <message>
        <source>Bundles of tools (*.zip)</source>
        <translation>工具套件 (*.zip)</translation>
    </message>
    <message>
        <source>You have all tools of that bundle already.</source>
        <translation>您已有該套件中的所有工具。</translation>
    </message>
    <message numerus="yes">
        <source>%n tool(s) added to your own.</source>
        <translation>
            <numerusform>已將 %n 個工具加入您自己的工具。</numerusform>
        </translation>
    </message>
    <message>
        <source>You have no tools of your own yet; save the one in hand first.</source>
        <translation>您還沒有自己的工具；請先儲存手上的工具。</translation>
    </message>
    <message>
        <source>Export my tools</source>
        <translation>匯出我的工具</translation>
    </message>
    <message>
        <source>my-tools.zip</source>
        <translation>my-tools.zip</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>已儲存 %1。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BrushJar</name>
    <message>
        <source>%1 was read again; the next stroke is painted with it.</source>
        <translation>已重新讀取 %1；下一筆就會使用它。</translation>
    </message>
    <message>
        <source>Name of the tool:</source>
        <translation>工具的名稱：</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>My %1</source>
        <translation>我的 %1</translation>
    </message>
    <message>
        <source>Save as my own</source>
        <translation>存為自己的工具</translation>
    </message>
    <message>
        <source>There is already a tool of your own named &quot;%1&quot;.</source>
        <translation>自己的工具中已有「%1」。</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>覆寫</translation>
    </message>
    <message>
        <source>Kept &quot;%1&quot; among your own.</source>
        <translation>已將「%1」存入自己的工具。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重新命名</translation>
    </message>
    <message>
        <source>Throw your tool &quot;%1&quot; away? Its file is deleted.</source>
        <translation>要丟掉你的工具「%1」嗎？它的檔案會被刪除。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>刪除</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is thrown away; what you have in hand stays.</source>
        <translation>已丟掉「%1」；手上的工具維持不變。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BrushShelving</name>
    <message>
        <source>A tag needs a name.</source>
        <translation>標籤需要名稱。</translation>
    </message>
    <message>
        <source>New tag</source>
        <translation>新增標籤</translation>
    </message>
    <message>
        <source>Name of the tag:</source>
        <translation>標籤的名稱：</translation>
    </message>
</context>
<context>
    <name>pastoso::main::CanvasSizing</name>
    <message>
        <source>A recording is being played; the canvas is yours when it has ended.</source>
        <translation>正在播放錄製內容；結束後就能變更畫布。</translation>
    </message>
    <message>
        <source>The selection reaches over the whole canvas: there is nothing to cut.</source>
        <translation>選取範圍涵蓋整張畫布，沒有可裁切的部分。</translation>
    </message>
    <message>
        <source>The canvas is %1 × %2 mm now; Undo brings back what it was.</source>
        <translation>畫布現在是 %1 × %2 mm；用「復原」可回到原來的樣子。</translation>
    </message>
    <message>
        <source>Making the canvas</source>
        <translation>正在製作畫布</translation>
    </message>
    <message>
        <source>Meanwhile the canvas has become another one; that keeps its size.</source>
        <translation>畫布在此期間已換成另一張，其大小保持不變。</translation>
    </message>
    <message>
        <source>The selection is too soft to crop to: nothing is outlined.</source>
        <translation>選取範圍過於柔和，無法依此裁切：沒有任何部分有輪廓。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Clipboard</name>
    <message>
        <source>There is no paint to copy here.</source>
        <translation>這裡沒有可複製的顏料。</translation>
    </message>
    <message>
        <source>Copied; paste it as a layer, or as a picture in another program.</source>
        <translation>已複製；可貼上為圖層，或在其他程式中貼上為圖片。</translation>
    </message>
    <message>
        <source>Pasted</source>
        <translation>貼上</translation>
    </message>
    <message>
        <source>There is nothing to paste: no paint and no picture has been copied.</source>
        <translation>沒有可貼上的內容：尚未複製顏料或圖片。</translation>
    </message>
    <message>
        <source>The copied paint is too large to go to another painting as paint (at most %1 MB); a picture of it goes.</source>
        <translation>複製的顏料太大，無法以顏料的形式帶到另一幅畫（最多 %1 MB），改為貼上它的圖片。</translation>
    </message>
    <message>
        <source>The clipboard</source>
        <translation>剪貼簿</translation>
    </message>
    <message>
        <source>What was dragged here</source>
        <translation>拖到這裡的內容</translation>
    </message>
</context>
<context>
    <name>pastoso::main::DroppedFiles</name>
    <message>
        <source>%1 is no painting and no picture that can be opened.</source>
        <translation>%1 不是能開啟的畫作或圖片。</translation>
    </message>
    <message>
        <source>Put it on a &amp;layer, as dry paint</source>
        <translation>放到圖層上，成為乾顏料(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Trace it, below the paint</source>
        <translation>墊在顏料下方，用來描圖(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;New canvas made of it</source>
        <translation>用它建立新畫布(&amp;N)</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>保持原狀</translation>
    </message>
    <message>
        <source>&amp;Keep it beside the canvas, as a reference</source>
        <translation>放在畫布旁作為參考(&amp;K)</translation>
    </message>
    <message>
        <source>Put each on a &amp;layer, as dry paint</source>
        <translation>各放到一個圖層上，成為乾顏料(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Keep them beside the canvas, as references</source>
        <translation>都放在畫布旁作為參考(&amp;K)</translation>
    </message>
    <message>
        <source>Leave them</source>
        <translation>保持原狀</translation>
    </message>
    <message>
        <source>There is no picture in it that can be read.</source>
        <translation>其中沒有可讀取的圖片。</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>Each of the other files opens in a window of its own. Open %1 more windows?</source>
        <translation>其他檔案會各自在獨立的視窗中開啟。要再開啟 %1 個視窗嗎？</translation>
    </message>
    <message>
        <source>Open them</source>
        <translation>開啟</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>圖片</translation>
    </message>
</context>
<context>
    <name>pastoso::main::DryAdjusting</name>
    <message>
        <source>The layer that you paint on has no dry paint.</source>
        <translation>正在畫的圖層上沒有乾顏料。</translation>
    </message>
    <message>
        <source>The layer that you paint on has no dry paint where it is selected.</source>
        <translation>正在畫的圖層的選取範圍內沒有乾顏料。</translation>
    </message>
    <message>
        <source>The glaze lies over the dry paint.</source>
        <translation>罩染已鋪在乾顏料上。</translation>
    </message>
    <message>
        <source>The dry paint has other pigments in it.</source>
        <translation>乾顏料裡已換成其他色料。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Exporting</name>
    <message>
        <source>Exported %1 and %2 more; heights from %3 mm (black) to %4 mm (white).</source>
        <translation>已匯出 %1 和另外 %2 個檔案；高度從 %3 mm（黑）到 %4 mm（白）。</translation>
    </message>
    <message>
        <source>Exported %1: %2 × %3 pixels.</source>
        <translation>已匯出 %1：%2 × %3 像素。</translation>
    </message>
    <message>
        <source>Stopped; %1 holds the pictures that are complete.</source>
        <translation>已停止；%1 裡是已完成的圖片。</translation>
    </message>
    <message>
        <source>Stopped; %1 was not written.</source>
        <translation>已停止；未寫入 %1。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>畫作</translation>
    </message>
    <message>
        <source>%1 is still being written; wait for it, or stop it.</source>
        <translation>%1 還在寫入；請等它完成，或停止匯出。</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>正在匯出 %1</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>%1 is still being written.</source>
        <translation>%1 還在寫入。</translation>
    </message>
    <message>
        <source>Close when it is done</source>
        <translation>完成後關閉</translation>
    </message>
    <message>
        <source>Stop it</source>
        <translation>停止匯出</translation>
    </message>
    <message>
        <source>The window closes as soon as %1 is written.</source>
        <translation>%1 寫入完成後，視窗就會關閉。</translation>
    </message>
    <message>
        <source>Export recording</source>
        <translation>匯出錄製檔</translation>
    </message>
    <message>
        <source>painting.json</source>
        <translation>畫作.json</translation>
    </message>
    <message>
        <source>Recordings (*.json)</source>
        <translation>錄製檔 (*.json)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>已儲存 %1。</translation>
    </message>
    <message numerus="yes">
        <source>Exported %1: %n triangle(s), %2 × %3 mm.</source>
        <translation>
            <numerusform>已匯出 %1：%n 個三角形，%2 × %3 mm。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Exported %1: %n frame(s) of %2 × %3 pixels.</source>
        <translation>
            <numerusform>已匯出 %1：%n 個影格，%2 × %3 像素。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Nothing was exported: make room or choose another place.</source>
        <translation>%1 沒有匯出任何檔案：請清出空間，或選擇別的位置。</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>匯出...</translation>
    </message>
    <message numerus="yes">
        <source>Saved %1: %n layer(s) of %2 × %3 pixels.</source>
        <translation>
            <numerusform>已儲存 %1：%n 個圖層，%2 × %3 像素。</numerusform>
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
        <translation>儲存副本</translation>
    </message>
</context>
<context>
    <name>pastoso::main::FillCommands</name>
    <message>
        <source>Nothing was poured. Esc again goes back to painting.</source>
        <translation>沒有倒上任何顏料。再按一次 Esc 就回到作畫。</translation>
    </message>
    <message>
        <source>Drag a line from the paint in hand to the second paint; Shift keeps it level, upright or halfway. Esc, or taking a tool, goes back to painting.</source>
        <translation>從手上的顏料拖曳一條線到第二種顏料；Shift 讓線保持水平、垂直或 45 度。按 Esc 或拿起工具，就回到作畫。</translation>
    </message>
    <message>
        <source>The brush paints again.</source>
        <translation>筆刷可以繼續畫了。</translation>
    </message>
    <message>
        <source>%1 mm of paint are poured over the whole canvas.</source>
        <translation>在整張畫布上倒上 %1 mm 的顏料。</translation>
    </message>
    <message>
        <source>%1 mm of paint are poured over what is selected.</source>
        <translation>在選取範圍倒上 %1 mm 的顏料。</translation>
    </message>
    <message>
        <source>Thickness of fills</source>
        <translation>填滿的厚度</translation>
    </message>
    <message>
        <source>Fills and gradients pour an even film of wet paint, as thick as this: 0.05 mm shows what lies below, 0.2 mm covers, 1 mm stands as a paste.</source>
        <translation>填滿與漸層會倒上這麼厚的一層均勻濕顏料：0.05 mm 透出底下，0.2 mm 蓋住，1 mm 厚如膏狀。</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Toned ground</source>
        <translation>有色底</translation>
    </message>
    <message>
        <source>An even coat of the paint in hand covers the whole canvas, dry at once, on a layer below all others: 0.02 mm tints the canvas, 0.1 mm covers it.</source>
        <translation>用手上的顏料均勻鋪滿整張畫布並立即乾燥，位於所有圖層之下：0.02 mm 微微上色，0.1 mm 完全覆蓋。</translation>
    </message>
    <message>
        <source>Tone the ground</source>
        <translation>鋪底色</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>底色</translation>
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
        <translation>環繞中心的筆觸份數：%1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::KeepingUp</name>
    <message>
        <source>Real time</source>
        <translation>實際時間</translation>
    </message>
    <message>
        <source>Thin less</source>
        <translation>少稀釋</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暫停</translation>
    </message>
    <message>
        <source>Dry</source>
        <translation>乾燥</translation>
    </message>
</context>
<context>
    <name>pastoso::main::LayerCommands</name>
    <message>
        <source>Layer %1</source>
        <translation>圖層 %1</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>群組 %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::LayerTransform</name>
    <message>
        <source>A recording is being played; the layers are yours when it has ended.</source>
        <translation>正在播放錄製內容；結束後就能變更圖層。</translation>
    </message>
    <message>
        <source>There is no paint on this layer.</source>
        <translation>這個圖層上沒有顏料。</translation>
    </message>
    <message>
        <source>There is no paint of this layer in the selection.</source>
        <translation>選取範圍內沒有這個圖層的顏料。</translation>
    </message>
    <message>
        <source>The paint stays as it is.</source>
        <translation>顏料維持原樣。</translation>
    </message>
    <message>
        <source>Drag inside to move, a handle to scale, outside to turn (Shift: in steps), with Ctrl a corner or a side alone. Enter applies, Esc gives up.</source>
        <translation>在框內拖曳可移動，拖曳控制點可縮放，在框外拖曳可旋轉（Shift：依固定角度），按住 Ctrl 可單獨移動一角或一邊。Enter 套用，Esc 放棄。</translation>
    </message>
    <message>
        <source>No corner is chosen</source>
        <translation>沒有選擇任何角</translation>
    </message>
    <message>
        <source>Upper left corner</source>
        <translation>左上角</translation>
    </message>
    <message>
        <source>Upper right corner</source>
        <translation>右上角</translation>
    </message>
    <message>
        <source>Lower right corner</source>
        <translation>右下角</translation>
    </message>
    <message>
        <source>Lower left corner</source>
        <translation>左下角</translation>
    </message>
    <message>
        <source>%1 at %2, %3 mm</source>
        <translation>%1：%2, %3 mm</translation>
    </message>
</context>
<context>
    <name>pastoso::main::LightChoice</name>
    <message>
        <source>Light from a file</source>
        <translation>從檔案載入光源</translation>
    </message>
    <message>
        <source>Spectra (*.csv)</source>
        <translation>光譜 (*.csv)</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Loading</name>
    <message>
        <source>%1: given up; all is as it was.</source>
        <translation>%1：已放棄；一切維持原狀。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>%1: wait for it, or cancel it.</source>
        <translation>%1：請等它完成，或取消。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::MaskingCommands</name>
    <message>
        <source>Paint masking fluid, as wide as the tool in hand: no paint gets below it. Alt peels it off again; Esc, or taking a tool, goes back to painting.</source>
        <translation>塗上遮蓋液，和手上的工具一樣寬：顏料滲不進底下。Alt 可再撕掉；按 Esc 或拿起工具，就回到作畫。</translation>
    </message>
    <message>
        <source>Drag a strip of masking tape, as wide as the tool in hand; Shift keeps it level, upright or halfway. Alt peels it off again; Esc, or taking a tool, goes back to painting.</source>
        <translation>拖曳貼上一條遮蓋膠帶，和手上的工具一樣寬；Shift 讓它保持水平、垂直或 45 度。Alt 可再撕掉；按 Esc 或拿起工具，就回到作畫。</translation>
    </message>
    <message>
        <source>Nothing was masked. Esc again goes back to painting.</source>
        <translation>沒有遮蓋任何部分。再按一次 Esc 就回到作畫。</translation>
    </message>
    <message>
        <source>Peels the masking off there.</source>
        <translation>撕掉那裡的遮蓋。</translation>
    </message>
    <message>
        <source>Masks the canvas there.</source>
        <translation>遮蓋那裡的畫布。</translation>
    </message>
    <message>
        <source>The brush paints again.</source>
        <translation>筆刷可以繼續畫了。</translation>
    </message>
    <message>
        <source>The masking is peeled off.</source>
        <translation>遮蓋已撕掉。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::NewWindow</name>
    <message>
        <source>%1 cannot be started: there is no other window.</source>
        <translation>無法啟動 %1：沒有另一個視窗。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintPicking</name>
    <message>
        <source>Picked up wet paint: %1</source>
        <translation>已沾取濕顏料：%1</translation>
    </message>
    <message>
        <source>Picked up dry paint: %1</source>
        <translation>已取用乾顏料的配方：%1</translation>
    </message>
    <message>
        <source>There is no colour to pick beside the canvas.</source>
        <translation>畫布以外沒有顏色可取。</translation>
    </message>
    <message>
        <source>Picked the colour seen: %1</source>
        <translation>已取用看到的顏色：%1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintSettings</name>
    <message>
        <source>Open a palette</source>
        <translation>開啟調色盤</translation>
    </message>
    <message>
        <source>Palettes (*.gpl)</source>
        <translation>調色盤 (*.gpl)</translation>
    </message>
    <message>
        <source>Colours of a picture</source>
        <translation>圖片的顏色</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>圖片 (%1)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在讀取 %1</translation>
    </message>
    <message>
        <source>Save the palette</source>
        <translation>儲存調色盤</translation>
    </message>
    <message>
        <source>my-palette.gpl</source>
        <translation>my-palette.gpl</translation>
    </message>
    <message>
        <source>Export my paints</source>
        <translation>匯出我的顏料</translation>
    </message>
    <message>
        <source>my-paints.json</source>
        <translation>my-paints.json</translation>
    </message>
    <message>
        <source>Sets of paints (*.json)</source>
        <translation>顏料組 (*.json)</translation>
    </message>
    <message>
        <source>Import paints</source>
        <translation>匯入顏料</translation>
    </message>
    <message>
        <source>You have all paints of that set already.</source>
        <translation>你已有該組的所有顏料。</translation>
    </message>
    <message numerus="yes">
        <source>%n paint(s) added to your own.</source>
        <translation>
            <numerusform>已將 %n 種顏料加入你自己的顏料。</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>已儲存 %1。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintTime</name>
    <message>
        <source>%1 × time</source>
        <translation>%1 × 時間</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintingAgain</name>
    <message>
        <source>painting</source>
        <translation>畫作</translation>
    </message>
    <message>
        <source>Nothing has been painted yet that could be painted again.</source>
        <translation>還沒有可以重新繪製的內容。</translation>
    </message>
    <message>
        <source>The painting</source>
        <translation>這幅畫</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>儲存</translation>
    </message>
    <message>
        <source>Paintings and pictures (%1)</source>
        <translation>畫作與圖片 (%1)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>已儲存 %1。</translation>
    </message>
    <message>
        <source>Saved %1: %2 × %3 pixels.</source>
        <translation>已儲存 %1：%2 × %3 像素。</translation>
    </message>
    <message>
        <source>Another question is open; answer it first.</source>
        <translation>還有其他問題未回答，請先回答。</translation>
    </message>
    <message>
        <source>The finer painting is still being written.</source>
        <translation>更精細的畫仍在寫入。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PictureLayers</name>
    <message>
        <source>Layer from a picture</source>
        <translation>從圖片新增圖層</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>圖片 (%1);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在讀取 %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PopupCommands</name>
    <message>
        <source>Mirror</source>
        <translation>鏡像</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>符合大小</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ProjectFiles</name>
    <message>
        <source>Open re&amp;cent</source>
        <translation>開啟最近的檔案(&amp;C)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>已儲存 %1。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>儲存</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>還沒有</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>畫布</translation>
    </message>
    <message>
        <source>%1[*] %2 × %3 mm</source>
        <translation>%1[*] %2 × %3 mm</translation>
    </message>
    <message>
        <source>Saving %1...</source>
        <translation>正在儲存 %1...</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開啟</translation>
    </message>
    <message>
        <source>Paintings and pictures (*.pastoso *.ora %1);;All files (*)</source>
        <translation>畫作與圖片 (*.pastoso *.ora %1);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>painting.pastoso</source>
        <translation>畫作.pastoso</translation>
    </message>
    <message>
        <source>Paintings (*.pastoso)</source>
        <translation>畫作 (*.pastoso)</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>The painting on the easel has changes that are not saved.</source>
        <translation>畫架上的畫作有尚未儲存的變更。</translation>
    </message>
    <message>
        <source>Discard them</source>
        <translation>捨棄變更</translation>
    </message>
    <message>
        <source>Painted from its strokes; the brush is yours when it is done.</source>
        <translation>正在依筆觸重新畫出；完成後就能繼續作畫。</translation>
    </message>
    <message>
        <source>What you paint is kept again.</source>
        <translation>你畫的內容又開始保留了。</translation>
    </message>
    <message>
        <source>Should the program fail, this painting would come back slowly, from its strokes alone: %1 %2 are free there. Make room; you can paint on.</source>
        <translation>萬一程式出問題，這幅畫只能靠筆觸慢慢救回：%1 那裡剩下 %2。請清出空間；你可以繼續畫。</translation>
    </message>
    <message>
        <source>The disk is full: what you paint now would be lost if the program failed. It is kept in %1, where %2 are free and %3 wait to be written. Make room there, or save the painting to another disk. You can paint on; as soon as there is room, all of it is kept again.</source>
        <translation>磁碟已滿：萬一程式出問題，你現在畫的內容會遺失。這些內容保留在 %1，那裡剩下 %2，還有 %3 等著寫入。請在那裡清出空間，或把畫作存到別的磁碟。你可以繼續畫；一有空間，全部內容就會再次保留。</translation>
    </message>
    <message>
        <source>What you paint now would be lost if the program failed: %1 %2 are free there. Make room, or save the painting to another disk. You can paint on; as soon as it can be, all of it is kept again.</source>
        <translation>萬一程式出問題，你現在畫的內容會遺失：%1 那裡剩下 %2。請清出空間，或把畫作存到別的磁碟。你可以繼續畫；一旦可以寫入，全部內容就會再次保留。</translation>
    </message>
    <message>
        <source>The painting</source>
        <translation>畫作</translation>
    </message>
    <message>
        <source>%1 The painting is not saved: make room or choose another place, and save again.</source>
        <translation>%1 畫作尚未儲存：請清出空間或選擇別的位置，再儲存一次。</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>另存新檔...</translation>
    </message>
    <message>
        <source>Another program has changed %1 since you opened or saved it here. Replacing it loses what was changed there.</source>
        <translation>你在這裡開啟或儲存之後，別的程式改過 %1。取代它會失去那些更動。</translation>
    </message>
    <message>
        <source>%1 is protected against being written to.</source>
        <translation>%1 受到寫入保護。</translation>
    </message>
    <message>
        <source>%1 The painting was not saved by itself.</source>
        <translation>%1 畫作沒有自動儲存。</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>儲存...</translation>
    </message>
    <message>
        <source>%1 - %2</source>
        <translation>%1 - %2</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>正在開啟 %1</translation>
    </message>
    <message>
        <source>Making the canvas</source>
        <translation>正在製作畫布</translation>
    </message>
    <message>
        <source>Putting it on the easel</source>
        <translation>正在放上畫架</translation>
    </message>
    <message>
        <source>Recovering the painting</source>
        <translation>正在復原畫作</translation>
    </message>
    <message>
        <source>Save a version</source>
        <translation>儲存版本</translation>
    </message>
</context>
<context>
    <name>pastoso::main::RangeSelection</name>
    <message>
        <source>Wet paint of this layer is up to %1 mm thick, %2 mm on average.</source>
        <translation>這個圖層的濕顏料最厚 %1 mm，平均 %2 mm。</translation>
    </message>
    <message>
        <source>Paint, wet and dry, stands up to %1 mm above the canvas, %2 mm on average.</source>
        <translation>濕的和乾的顏料最高高出畫布 %1 mm，平均 %2 mm。</translation>
    </message>
    <message>
        <source>Select by wetness</source>
        <translation>依濕潤度選取</translation>
    </message>
    <message>
        <source>Select by height</source>
        <translation>依高度選取</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Recorder</name>
    <message>
        <source>Nothing has been painted yet that could be shown again.</source>
        <translation>還沒有畫任何東西可以重播。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ReferenceCommands</name>
    <message>
        <source>Add reference pictures</source>
        <translation>加入參考圖片</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>圖片 (%1);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>圖片</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>圖片</translation>
    </message>
    <message>
        <source>There is no picture in it; save it as a file, and drag that here.</source>
        <translation>其中沒有圖片；請先存成檔案，再把檔案拖到這裡。</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在讀取 %1</translation>
    </message>
    <message>
        <source>Picked from the reference: %1</source>
        <translation>已從參考圖片取用：%1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::RepaintWindow</name>
    <message>
        <source>Paused</source>
        <translation>已暫停</translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation>約剩 %1</translation>
    </message>
    <message>
        <source>How much is painted</source>
        <translation>已繪製的比例</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暫停</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>儲存...</translation>
    </message>
    <message>
        <source>As a painting, or as a picture</source>
        <translation>存成畫作或圖片</translation>
    </message>
    <message>
        <source>Put it on the easel</source>
        <translation>放上畫架</translation>
    </message>
    <message>
        <source>It cannot be painted any further</source>
        <translation>無法繼續繪製</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>繼續</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>關閉</translation>
    </message>
    <message>
        <source>It is not painted to its end yet. Give it up?</source>
        <translation>尚未繪製完成。要放棄嗎？</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Painted again at %1 px/mm</source>
        <translation>以 %1 px/mm 重新繪製</translation>
    </message>
    <message>
        <source>The finer painting is in no file yet. Throw it away?</source>
        <translation>更精細的畫尚未存入任何檔案。要捨棄嗎？</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ReplayWindow</name>
    <message>
        <source>How it was painted</source>
        <translation>作畫過程</translation>
    </message>
    <message>
        <source>Play, or stop for a moment (Space)</source>
        <translation>播放，或暫時停下（空白鍵）</translation>
    </message>
    <message>
        <source>Moment of the painting</source>
        <translation>作畫的時間點</translation>
    </message>
    <message>
        <source>Drag to any moment of the painting</source>
        <translation>拖曳到作畫過程的任何時間點</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暫停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>It cannot be shown any further</source>
        <translation>之後的內容無法顯示</translation>
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
        <translation>在選取範圍之外：不會畫上任何東西。</translation>
    </message>
    <message>
        <source>Nothing was selected. Esc again goes back to painting.</source>
        <translation>沒有選到任何部分。再按一次 Esc 就回到作畫。</translation>
    </message>
    <message>
        <source>Tools keep to the outline. Esc, or taking a tool, goes back to painting.</source>
        <translation>工具只作用於外框線內。按 Esc 或拿起工具，就回到作畫。</translation>
    </message>
    <message>
        <source>Drag around what tools shall keep to. Shift adds, Alt takes away, both keep what is in both; a click ends the selection.</source>
        <translation>圈出工具可作用的範圍。Shift 增加，Alt 減去，兩鍵同按保留重疊的部分；按一下則取消選取。</translation>
    </message>
    <message>
        <source>The brush paints again.</source>
        <translation>筆刷可以繼續畫了。</translation>
    </message>
    <message>
        <source>Selects what is inside.</source>
        <translation>選取框內的部分。</translation>
    </message>
    <message>
        <source>Adds what is inside to the selection.</source>
        <translation>將框內的部分加入選取範圍。</translation>
    </message>
    <message>
        <source>Takes what is inside out of the selection.</source>
        <translation>從選取範圍減去框內的部分。</translation>
    </message>
    <message>
        <source>Keeps what is inside and was selected before.</source>
        <translation>保留框內原本已選取的部分。</translation>
    </message>
    <message>
        <source>A recording is being played; the brush is yours when it has ended.</source>
        <translation>正在播放錄製內容；結束後就能使用筆刷。</translation>
    </message>
    <message>
        <source>Nothing is selected: tools work on all of the canvas.</source>
        <translation>目前沒有選取範圍：工具可作用於整張畫布。</translation>
    </message>
    <message>
        <source>lasso</source>
        <translation>套索</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>ellipse</source>
        <translation>橢圓</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>多邊形</translation>
    </message>
    <message>
        <source>contiguous colour</source>
        <translation>相連的顏色</translation>
    </message>
    <message>
        <source>similar colour</source>
        <translation>相似的顏色</translation>
    </message>
    <message>
        <source>Click the colour that tools shall keep to; drag to the right for more, to the left for less of it. Shift adds, Alt takes away, both keep what is in both.</source>
        <translation>按一下工具可作用的顏色；向右拖曳增加，向左拖曳減少。Shift 增加，Alt 減去，兩鍵同按保留重疊的部分。</translation>
    </message>
    <message>
        <source>Click the corners of what tools shall keep to. Enter or a double click closes it, Backspace takes the last corner back, Esc gives it up.</source>
        <translation>按一下工具可作用範圍的各個角。Enter 或按兩下即可封閉，Backspace 收回最後一個角，Esc 放棄。</translation>
    </message>
    <message>
        <source>Colours that differ by up to %1. Drag to the right for more, to the left for less.</source>
        <translation>色差在 %1 以內的顏色。向右拖曳增加，向左拖曳減少。</translation>
    </message>
    <message>
        <source>Tools keep to colours that differ by up to %1 from the one there. Esc, or taking a tool, goes back to painting.</source>
        <translation>工具只作用於與該處色差在 %1 以內的顏色。按 Esc 或拿起工具，就回到作畫。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::SelectionMargins</name>
    <message>
        <source>Grow the selection</source>
        <translation>擴張選取範圍</translation>
    </message>
    <message>
        <source>The selection becomes so much wider on all sides.</source>
        <translation>選取範圍會向四周變寬這麼多。</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>擴張</translation>
    </message>
    <message>
        <source>Shrink the selection</source>
        <translation>縮減選取範圍</translation>
    </message>
    <message>
        <source>The selection becomes so much narrower on all sides, but not along the edges of the canvas.</source>
        <translation>選取範圍會從四周變窄這麼多，但沿著畫布邊緣處不變。</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>縮減</translation>
    </message>
    <message>
        <source>Border of the selection</source>
        <translation>選取範圍的邊框</translation>
    </message>
    <message>
        <source>Selects a band so wide along the outline, half of it on either side.</source>
        <translation>選取沿著外框線這麼寬的帶狀區域，兩側各一半。</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>選取</translation>
    </message>
    <message>
        <source>Feather the selection</source>
        <translation>羽化選取範圍</translation>
    </message>
    <message>
        <source>The edge becomes soft: paint fades out so far on either side of the outline.</source>
        <translation>邊緣會變柔：顏料在外框線兩側這麼寬的範圍內漸漸淡出。</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半徑</translation>
    </message>
    <message>
        <source>Feather</source>
        <translation>羽化</translation>
    </message>
    <message>
        <source>Nothing would be left of the selection.</source>
        <translation>選取範圍將不剩任何部分。</translation>
    </message>
    <message>
        <source>The selection would stay as it is.</source>
        <translation>選取範圍不會有任何改變。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Studio</name>
    <message numerus="yes">
        <source>%1 is open, and %n note(s) tell what is not as it was in the file.</source>
        <translation>
            <numerusform>已開啟 %1；有 %n 則訊息說明哪些地方與檔案裡不同。</numerusform>
        </translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>顯示</translation>
    </message>
    <message>
        <source>%1 From now on the processor draws the canvas, which is slower.</source>
        <translation>%1 從現在起由處理器繪製畫布，速度較慢。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TankMode</name>
    <message>
        <source>Open a tank</source>
        <translation>開啟水槽</translation>
    </message>
    <message>
        <source>Scenes of a tank (*.json);;All files (*)</source>
        <translation>水槽場景 (*.json);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Export the liquid&apos;s surface</source>
        <translation>匯出液體表面</translation>
    </message>
    <message>
        <source>A folder for all moments</source>
        <translation>存放所有時刻的資料夾</translation>
    </message>
    <message>
        <source>The liquid&apos;s surface is in %1.</source>
        <translation>液體表面在 %1。</translation>
    </message>
    <message>
        <source>All surfaces are in %1.</source>
        <translation>所有表面都在 %1。</translation>
    </message>
    <message>
        <source>Picture of the tank</source>
        <translation>水槽的圖片</translation>
    </message>
    <message>
        <source>The tank as it is seen in the window, traced along the light&apos;s ways through glass and liquid. Choose a size and press Render.</source>
        <translation>依視窗中所見的水槽，沿光線穿過玻璃與液體的路徑追蹤。選擇大小並按「算繪」。</translation>
    </message>
    <message>
        <source>Glass tank</source>
        <translation>玻璃水槽</translation>
    </message>
    <message>
        <source>A folder for pictures of every step</source>
        <translation>存放每一步圖片的資料夾</translation>
    </message>
    <message>
        <source>A folder for surfaces of every step</source>
        <translation>存放每一步表面的資料夾</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s) written</source>
        <translation>
            <numerusform>已寫入 %n 張圖片</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n surface(s) written</source>
        <translation>
            <numerusform>已寫入 %n 個表面</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pastoso::main::TankRecorder</name>
    <message numerus="yes">
        <source>%n picture(s) are in %1.</source>
        <translation>
            <numerusform>%n 張圖片在 %1。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n surface(s) are in %1.</source>
        <translation>
            <numerusform>%n 個表面在 %1。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pastoso::main::TeaMode</name>
    <message>
        <source>Open a scene of milk tea</source>
        <translation>開啟奶茶場景</translation>
    </message>
    <message>
        <source>Scenes of milk tea (*.json);;All files (*)</source>
        <translation>奶茶場景 (*.json);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>儲存場景</translation>
    </message>
    <message>
        <source>Scenes of milk tea (*.json)</source>
        <translation>奶茶場景 (*.json)</translation>
    </message>
    <message>
        <source>Export the milk&apos;s surface</source>
        <translation>匯出牛奶的表面</translation>
    </message>
    <message>
        <source>The milk&apos;s surface is in %1.</source>
        <translation>牛奶的表面已存入 %1。</translation>
    </message>
    <message>
        <source>Milk tea</source>
        <translation>奶茶</translation>
    </message>
    <message>
        <source>Picture of the glass</source>
        <translation>杯子的圖片</translation>
    </message>
    <message>
        <source>The glass as it is seen in the window, traced along the light&apos;s ways through glass, tea and milk. Choose a size and press Render.</source>
        <translation>依視窗中所見的杯子，沿光線穿過玻璃、茶與牛奶的路徑追蹤。選擇大小並按「算繪」。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TextureCommands</name>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>圖片 (%1);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在讀取 %1</translation>
    </message>
    <message>
        <source>The paste lies on the whole canvas, dry.</source>
        <translation>肌理膏已乾，鋪滿整張畫布。</translation>
    </message>
    <message>
        <source>The paste lies where it is selected, dry.</source>
        <translation>肌理膏已乾，鋪在選取範圍。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TracingCommands</name>
    <message>
        <source>Picked the colour of the picture: %1</source>
        <translation>已取用底圖的顏色：%1</translation>
    </message>
    <message>
        <source>Trace a picture</source>
        <translation>描圖</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>圖片 (%1);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在讀取 %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TubeCommands</name>
    <message>
        <source>Save the tubes as a set</source>
        <translation>將管裝顏料存成一組</translation>
    </message>
    <message>
        <source>Rename the set</source>
        <translation>重新命名此組</translation>
    </message>
    <message>
        <source>Name of the set:</source>
        <translation>此組的名稱：</translation>
    </message>
    <message>
        <source>A set needs a name.</source>
        <translation>組需要名稱。</translation>
    </message>
    <message>
        <source>Type another name: that one is empty, or another set&apos;s.</source>
        <translation>請輸入其他名稱：該名稱為空，或屬於另一組。</translation>
    </message>
    <message>
        <source>Export my sets of tubes</source>
        <translation>匯出我的管裝顏料組</translation>
    </message>
    <message>
        <source>my-tubes.json</source>
        <translation>my-tubes.json</translation>
    </message>
    <message>
        <source>Sets of tubes (*.json)</source>
        <translation>管裝顏料組 (*.json)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>已儲存 %1。</translation>
    </message>
    <message>
        <source>Import sets of tubes</source>
        <translation>匯入管裝顏料組</translation>
    </message>
    <message>
        <source>You have all sets of that file already.</source>
        <translation>你已有該檔案中的所有組。</translation>
    </message>
    <message numerus="yes">
        <source>%n set(s) added to your own.</source>
        <translation>
            <numerusform>已將 %n 組加入你自己的組。</numerusform>
        </translation>
    </message>
    <message>
        <source>No paint was squeezed out beside an earlier painting yet.</source>
        <translation>在先前的畫旁還沒有擠出過顏料。</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ViewCommands</name>
    <message>
        <source>Canvas %1 × %2 mm, %3 pixels per millimetre</source>
        <translation>畫布 %1 × %2 mm，每公釐 %3 像素</translation>
    </message>
</context>
<context>
    <name>pastoso::main::WorkspaceCommands</name>
    <message>
        <source>There is a workspace &quot;%1&quot; already.</source>
        <translation>已有名為「%1」的工作區。</translation>
    </message>
    <message>
        <source>The workspace &quot;%1&quot; comes with the program: choose another name.</source>
        <translation>工作區「%1」為程式內建：請選擇其他名稱。</translation>
    </message>
    <message>
        <source>Save the workspace</source>
        <translation>儲存工作區</translation>
    </message>
    <message>
        <source>Name of the workspace; one of your own with this name is replaced:</source>
        <translation>工作區的名稱；同名的自訂工作區會被取代：</translation>
    </message>
    <message>
        <source>Rename the workspace</source>
        <translation>重新命名工作區</translation>
    </message>
    <message>
        <source>Name of the workspace:</source>
        <translation>工作區的名稱：</translation>
    </message>
</context>
<context>
    <name>pastoso::panels</name>
    <message>
        <source>never</source>
        <translation>不會乾</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>實際時間</translation>
    </message>
    <message>
        <source>10 times</source>
        <translation>10 倍速</translation>
    </message>
    <message>
        <source>a minute a second</source>
        <translation>每秒一分鐘</translation>
    </message>
    <message>
        <source>10 min a second</source>
        <translation>每秒 10 分鐘</translation>
    </message>
    <message>
        <source>an hour a second</source>
        <translation>每秒一小時</translation>
    </message>
    <message>
        <source>a day a second</source>
        <translation>每秒一天</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>黏度</translation>
    </message>
    <message>
        <source>How slowly it flows: water 1, ink 100, cream 3000, oil from the tube 300000</source>
        <translation>流動有多慢：水 1，墨水 100，鮮奶油 3000，管裝油畫顏料 300000</translation>
    </message>
    <message>
        <source> mm²/s</source>
        <translation> mm²/s</translation>
    </message>
    <message>
        <source>Yield stress</source>
        <translation>降伏應力</translation>
    </message>
    <message>
        <source>What it stands up to before it moves at all: at 0 it runs for ever, at 80 it keeps every bristle mark, at 200 it stands in peaks</source>
        <translation>受力多大才開始流動：0 會一直流，80 能留住每道筆毛痕跡，200 可以堆出尖峰</translation>
    </message>
    <message>
        <source> Pa</source>
        <translation> Pa</translation>
    </message>
    <message>
        <source>Flow index</source>
        <translation>流動指數</translation>
    </message>
    <message>
        <source>Below 1 it thins where it is sheared: a brush or a fast run finds it thinner</source>
        <translation>小於 1 時，受剪切會變稀：筆刷刷過或流得快時，顏料會比較稀</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Heavy paint runs faster down a tilted canvas</source>
        <translation>重的顏料在傾斜的畫布上流得比較快</translation>
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
        <translation>讓垂流和邊緣變圓，也讓細線收縮成珠滴</translation>
    </message>
    <message>
        <source> mN/m</source>
        <translation> mN/m</translation>
    </message>
    <message>
        <source>Spreads at</source>
        <translation>擴展角度</translation>
    </message>
    <message>
        <source>The edge moves out where it is steeper than this: low numbers wet the canvas easily, high ones stand in beads</source>
        <translation>邊緣比這個角度陡時就向外擴展：數值小容易潤濕畫布，數值大則凝成珠狀</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Draws back at</source>
        <translation>回縮角度</translation>
    </message>
    <message>
        <source>The edge draws back where it is flatter than this; 0: it stays where it was</source>
        <translation>邊緣比這個角度平緩時就向內回縮；0：停在原處不回縮</translation>
    </message>
    <message>
        <source>Slip</source>
        <translation>滑移</translation>
    </message>
    <message>
        <source>Dry after</source>
        <translation>乾燥時間</translation>
    </message>
    <message>
        <source>Until a film of the usual thickness can be touched, in still air</source>
        <translation>在靜止的空氣中，一般厚度的顏料層乾到可以觸摸所需的時間</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分鐘</translation>
    </message>
    <message>
        <source>Usual thickness</source>
        <translation>一般厚度</translation>
    </message>
    <message>
        <source>The film that dries in that time; thicker ones take longer</source>
        <translation>在上述時間內會乾的顏料層厚度；越厚越慢乾</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Stays when dry</source>
        <translation>乾後保留</translation>
    </message>
    <message>
        <source>How much of the wet thickness is left: oil keeps all, watery paint sinks in</source>
        <translation>濕的厚度會留下多少：油畫顏料全部保留，水性的稀顏料會滲下去</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>流動</translation>
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
        <translation>無</translation>
    </message>
    <message>
        <source>Matte</source>
        <translation>消光</translation>
    </message>
    <message>
        <source>Satin</source>
        <translation>半光</translation>
    </message>
    <message>
        <source>Gloss</source>
        <translation>亮光</translation>
    </message>
    <message>
        <source>half</source>
        <translation>一半</translation>
    </message>
    <message>
        <source>a third</source>
        <translation>三分之一</translation>
    </message>
    <message>
        <source>a quarter</source>
        <translation>四分之一</translation>
    </message>
    <message>
        <source>a fifth</source>
        <translation>五分之一</translation>
    </message>
    <message>
        <source>a tenth</source>
        <translation>十分之一</translation>
    </message>
    <message>
        <source>less than a tenth</source>
        <translation>不到十分之一</translation>
    </message>
    <message>
        <source>stiff</source>
        <translation>硬</translation>
    </message>
    <message>
        <source>runny</source>
        <translation>稀流</translation>
    </message>
    <message>
        <source>From paint that stands in peaks to paint that runs like ink: viscosity and yield stress</source>
        <translation>由能立起尖角的顏料到如墨水般流動的顏料：黏度與屈服應力</translation>
    </message>
    <message>
        <source>short</source>
        <translation>短</translation>
    </message>
    <message>
        <source>long</source>
        <translation>長</translation>
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
        <translation>由遮蓋下層的顏料到罩染：所含色料的多寡</translation>
    </message>
    <message>
        <source>Pigment</source>
        <translation>色料</translation>
    </message>
    <message>
        <source>How much of full-strength paint is in it: paint from the tube 100, a glaze 3 to 6</source>
        <translation>含有多少足濃度顏料：原管顏料為 100，罩染為 3 到 6</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>顏色</translation>
    </message>
    <message>
        <source>Loosens by</source>
        <translation>鬆化比例</translation>
    </message>
    <message>
        <source>Thixotropy: how much of its stiffness is gone where a tool or a run works it; brush marks level a little, and then stand</source>
        <translation>觸變性：被工具或流動攪動之處失去多少稠度；筆痕先略為流平，然後定住</translation>
    </message>
    <message>
        <source>Stiffens in</source>
        <translation>回稠時間</translation>
    </message>
    <message>
        <source>How long it rests until two thirds of what it lost have come back</source>
        <translation>靜置多久之後，失去的稠度恢復三分之二</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>Loosens after</source>
        <translation>鬆化所需流動</translation>
    </message>
    <message>
        <source>How far it has to run before it is loosened, in times its own thickness</source>
        <translation>需流動多遠才會鬆化，以自身厚度的倍數計</translation>
    </message>
    <message>
        <source>round</source>
        <translation>圓形</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>平筆</translation>
    </message>
    <message>
        <source>filbert</source>
        <translation>榛形</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>扇形</translation>
    </message>
    <message>
        <source>knife</source>
        <translation>畫刀</translation>
    </message>
    <message>
        <source>comb</source>
        <translation>梳形</translation>
    </message>
    <message>
        <source>soft pad</source>
        <translation>軟墊</translation>
    </message>
    <message>
        <source>used as it is</source>
        <translation>直接使用</translation>
    </message>
    <message>
        <source>dipped in paint</source>
        <translation>蘸顏料</translation>
    </message>
    <message>
        <source>stays on the tool</source>
        <translation>留在工具上</translation>
    </message>
    <message>
        <source>is thrown away</source>
        <translation>丟棄</translation>
    </message>
    <message>
        <source>another in each stroke</source>
        <translation>每筆不同</translation>
    </message>
    <message>
        <source>always the same</source>
        <translation>永遠相同</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形狀</translation>
    </message>
    <message>
        <source>How the elements of the tip are arranged.</source>
        <translation>筆尖單元的排列方式。</translation>
    </message>
    <message>
        <source>Before use</source>
        <translation>使用前</translation>
    </message>
    <message>
        <source>A brush is dipped; a rag or a comb is used as it is.</source>
        <translation>筆刷要蘸顏料；擦布或梳子直接使用。</translation>
    </message>
    <message>
        <source>What it takes</source>
        <translation>帶起之物</translation>
    </message>
    <message>
        <source>A rag throws away what it takes up; it never comes back.</source>
        <translation>擦布會丟棄帶起的顏料，不再回來。</translation>
    </message>
    <message>
        <source>Chance</source>
        <translation>隨機</translation>
    </message>
    <message>
        <source>Small random differences, such as where drops fall.</source>
        <translation>小的隨機差異，例如液滴落在何處。</translation>
    </message>
    <message>
        <source>%1 From %2 to %3%4.</source>
        <translation>%1從 %2 到 %3%4。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>寬度</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Hair length</source>
        <translation>筆毛長度</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>尖度</translation>
    </message>
    <message>
        <source>Bristles</source>
        <translation>鬃毛</translation>
    </message>
    <message>
        <source>Hairs in each</source>
        <translation>每束筆毛</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>個體</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>彎曲</translation>
    </message>
    <message>
        <source>Splay</source>
        <translation>散開</translation>
    </message>
    <message>
        <source>Trail</source>
        <translation>拖曳</translation>
    </message>
    <message>
        <source>Press depth</source>
        <translation>下壓深度</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>傾斜</translation>
    </message>
    <message>
        <source>Into the weave</source>
        <translation>深入布紋</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>硬度</translation>
    </message>
    <message>
        <source>Ride</source>
        <translation>浮行</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>膜</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>持續</translation>
    </message>
    <message>
        <source>Grooves</source>
        <translation>紋溝</translation>
    </message>
    <message>
        <source>Hair streaks</source>
        <translation>毛紋</translation>
    </message>
    <message>
        <source>Uneven load</source>
        <translation>蘸量不均</translation>
    </message>
    <message>
        <source>Gathering</source>
        <translation>聚攏</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>邊緣</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起點</translation>
    </message>
    <message>
        <source>Stays behind</source>
        <translation>留下</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>觸及深度</translation>
    </message>
    <message>
        <source>Pickup</source>
        <translation>帶起</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>混合</translation>
    </message>
    <message>
        <source>Wicking</source>
        <translation>滲傳</translation>
    </message>
    <message>
        <source> /mm</source>
        <translation> /mm</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>拖動</translation>
    </message>
    <message>
        <source>Overflow</source>
        <translation>溢出</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步長</translation>
    </message>
    <message>
        <source>Least step</source>
        <translation>最小步長</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> 毫秒</translation>
    </message>
    <message>
        <source>String</source>
        <translation>繩子</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>液滴</translation>
    </message>
    <message>
        <source> mm³</source>
        <translation> mm³</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>變化</translation>
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
        <translation>第一滴</translation>
    </message>
    <message>
        <source>Bottle</source>
        <translation>瓶子</translation>
    </message>
    <message>
        <source>Steepness</source>
        <translation>陡度</translation>
    </message>
    <message>
        <source>Centring</source>
        <translation>集中</translation>
    </message>
    <message>
        <source>Throw</source>
        <translation>拋灑</translation>
    </message>
    <message>
        <source>Air pressure</source>
        <translation>氣壓</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>筆尖</translation>
    </message>
    <message>
        <source>Hairs</source>
        <translation>筆毛</translation>
    </message>
    <message>
        <source>Paint it leaves</source>
        <translation>留下的顏料</translation>
    </message>
    <message>
        <source>Paint it takes</source>
        <translation>帶走的顏料</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>筆觸</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>液滴</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>空氣</translation>
    </message>
    <message>
        <source>nib</source>
        <translation>筆尖</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>梳齒</translation>
    </message>
    <message>
        <source>Pores</source>
        <translation>孔洞</translation>
    </message>
    <message>
        <source>Girth</source>
        <translation>周長</translation>
    </message>
    <message>
        <source>On the grain</source>
        <translation>紋理上</translation>
    </message>
    <message>
        <source>%1: %2 to %3%4</source>
        <translation>%1：%2 到 %3%4</translation>
    </message>
    <message>
        <source>Middle, from the left</source>
        <translation>中心距左側</translation>
    </message>
    <message>
        <source>Middle, from above</source>
        <translation>中心距上方</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>斜度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>旋轉角度</translation>
    </message>
    <message>
        <source>First point, from the left</source>
        <translation>第一點距左側</translation>
    </message>
    <message>
        <source>First point, from above</source>
        <translation>第一點距上方</translation>
    </message>
    <message>
        <source>Second point, from the left</source>
        <translation>第二點距左側</translation>
    </message>
    <message>
        <source>Second point, from above</source>
        <translation>第二點距上方</translation>
    </message>
    <message>
        <source>Third point, from the left</source>
        <translation>第三點距左側</translation>
    </message>
    <message>
        <source>Third point, from above</source>
        <translation>第三點距上方</translation>
    </message>
    <message>
        <source>Slope of the horizon</source>
        <translation>地平線的斜度</translation>
    </message>
    <message>
        <source>Crossing, from the left</source>
        <translation>交點距左側</translation>
    </message>
    <message>
        <source>Crossing, from above</source>
        <translation>交點距上方</translation>
    </message>
    <message>
        <source>Slope of the first lines</source>
        <translation>第一組線的斜度</translation>
    </message>
    <message>
        <source>Spacing of the first lines</source>
        <translation>第一組線的間距</translation>
    </message>
    <message>
        <source>Slope of the others</source>
        <translation>另一組的斜度</translation>
    </message>
    <message>
        <source>Spacing of the others</source>
        <translation>另一組的間距</translation>
    </message>
    <message>
        <source>Snaps within</source>
        <translation>貼齊範圍</translation>
    </message>
    <message>
        <source>From paint that breaks off sharply to paint that flows out at its edges and in long runs: the angle at which it spreads, the front and tail of drips, and the flow index</source>
        <translation>由俐落斷開的顏料到邊緣攤開、拖長流下的顏料：擴散角、垂流前端與尾端、流動指數</translation>
    </message>
    <message>
        <source>How easily it slides over the canvas, in pixels of the painting: more lets edges run on</source>
        <translation>在畫布上滑動的難易，以畫作的像素為單位：數值越大，邊緣越能繼續流動</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Front of drips</source>
        <translation>垂流前端</translation>
    </message>
    <message>
        <source>How fast a drip goes at its front, where surface tension holds it back: less makes it thicker and rounder there</source>
        <translation>垂流前端受表面張力拉住時的前進速度：越小，前端越厚越圓</translation>
    </message>
    <message>
        <source>Tail of drips</source>
        <translation>垂流尾端</translation>
    </message>
    <message>
        <source>How fast a drip follows at its tail, where surface tension draws it along: more makes it thinner there</source>
        <translation>垂流尾端受表面張力帶動時的跟隨速度：越大，尾端越薄</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::AidsPart</name>
    <message>
        <source>Harmony and gamut mask</source>
        <translation>色彩調和與色域遮罩</translation>
    </message>
    <message>
        <source>Marks for hues that go together, and a shape on the wheel to choose within</source>
        <translation>標示相配的色相，以及色環上供選色的形狀</translation>
    </message>
    <message>
        <source>Harmony</source>
        <translation>色彩調和</translation>
    </message>
    <message>
        <source>None</source>
        <translation>無</translation>
    </message>
    <message>
        <source>Complementary</source>
        <translation>互補色</translation>
    </message>
    <message>
        <source>Split complementary</source>
        <translation>分裂互補色</translation>
    </message>
    <message>
        <source>Analogous</source>
        <translation>類似色</translation>
    </message>
    <message>
        <source>Triad</source>
        <translation>三等分</translation>
    </message>
    <message>
        <source>Tetrad</source>
        <translation>四等分</translation>
    </message>
    <message>
        <source>The hues that go with yours are marked on the ring: a click takes one</source>
        <translation>與目前色相相配的色相標示在環上：按一下即可選用</translation>
    </message>
    <message>
        <source>Gamut mask</source>
        <translation>色域遮罩</translation>
    </message>
    <message>
        <source>Atmospheric triad</source>
        <translation>氛圍三色</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>圓形</translation>
    </message>
    <message>
        <source>The colours of one lightness on a disc, and a shape that the wheel keeps to</source>
        <translation>以圓盤顯示同一明度的顏色，選色限於其中的形狀</translation>
    </message>
    <message>
        <source>Turn of the gamut mask</source>
        <translation>色域遮罩的旋轉</translation>
    </message>
    <message>
        <source>Turns the gamut mask</source>
        <translation>旋轉色域遮罩</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushEditor</name>
    <message>
        <source>Brush editor</source>
        <translation>筆刷編輯器</translation>
    </message>
    <message>
        <source>A stroke of the tool in hand, pressed hardest in its middle</source>
        <translation>手上工具的一筆，中段壓得最重</translation>
    </message>
    <message>
        <source>The same stroke of the tool as it is saved</source>
        <translation>已儲存工具的同一筆</translation>
    </message>
    <message>
        <source>As saved</source>
        <translation>已儲存</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Shows below the stroke of the tool as it is saved</source>
        <translation>在下方顯示已儲存工具的筆觸</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>還原</translation>
    </message>
    <message>
        <source>Takes back all changes of the tool in hand</source>
        <translation>取消對手上工具的所有變更</translation>
    </message>
    <message>
        <source>In hand</source>
        <translation>手上</translation>
    </message>
    <message>
        <source>Parts of the tool</source>
        <translation>工具的各部分</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1（已變更）</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushFinder</name>
    <message>
        <source>Which tools are listed</source>
        <translation>清單顯示哪些工具</translation>
    </message>
    <message>
        <source>Find a tool</source>
        <translation>尋找工具</translation>
    </message>
    <message>
        <source>A few letters of its name or of its family; Return takes the first</source>
        <translation>名稱或類別的幾個字；按 Return 拿起第一個</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>最愛</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近使用</translation>
    </message>
    <message>
        <source>My own</source>
        <translation>自己的</translation>
    </message>
    <message>
        <source>No tool has such a name.</source>
        <translation>沒有這個名稱的工具。</translation>
    </message>
    <message>
        <source>Tools that you mark with a star are listed here.</source>
        <translation>標上星號的工具會列在這裡。</translation>
    </message>
    <message>
        <source>Tools that you have taken are listed here, the latest first.</source>
        <translation>拿過的工具會列在這裡，最近的在最前面。</translation>
    </message>
    <message>
        <source>Tools that you save as your own are listed here.</source>
        <translation>存為自己的工具會列在這裡。</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushList</name>
    <message>
        <source>%1, your own</source>
        <translation>%1（自己的）</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushPanel</name>
    <message>
        <source>Brush</source>
        <translation>筆刷</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Width of the brush&apos;s tip  ([ and ])</source>
        <translation>筆尖的寬度（[ 和 ]）</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>穩定</translation>
    </message>
    <message>
        <source>How the hand is steadied</source>
        <translation>手部穩定的方式</translation>
    </message>
    <message>
        <source>off</source>
        <translation>關閉</translation>
    </message>
    <message>
        <source>lags behind</source>
        <translation>延遲跟隨</translation>
    </message>
    <message>
        <source>pulled on a string</source>
        <translation>拉繩</translation>
    </message>
    <message>
        <source>How much the hand is steadied</source>
        <translation>手部穩定的強度</translation>
    </message>
    <message>
        <source>Length of the string: wide curves without a tremor</source>
        <translation>繩子的長度：畫大弧線也不抖</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>How far the brush lags behind the hand</source>
        <translation>筆刷落後手的時間</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Width of the brush&apos;s tip</source>
        <translation>筆尖寬度</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>標籤</translation>
    </message>
    <message>
        <source>New tag...</source>
        <translation>新增標籤...</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ColourPanel</name>
    <message>
        <source>Mix a colour</source>
        <translation>調出顏色</translation>
    </message>
    <message>
        <source>Nearest from the tubes</source>
        <translation>用管裝顏料調出的最接近色</translation>
    </message>
    <message>
        <source>Use the recipe</source>
        <translation>使用配方</translation>
    </message>
    <message>
        <source>Dip the brush in this mixture from the tubes instead</source>
        <translation>讓筆刷改沾用管裝顏料調成的這個混色</translation>
    </message>
    <message>
        <source>Used before</source>
        <translation>用過的顏色</translation>
    </message>
    <message>
        <source>Your palette</source>
        <translation>你的調色盤</translation>
    </message>
    <message>
        <source>Paints that you keep stay here.</source>
        <translation>你保留的顏料會放在這裡。</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Lay the paint in hand out on your palette</source>
        <translation>將手上的顏料放到你的調色盤</translation>
    </message>
    <message>
        <source>The colour itself, as a paint of its own: %1</source>
        <translation>這個顏色本身，當作一種獨立的顏料：%1</translation>
    </message>
    <message>
        <source>Your palette is full: the right button takes a paint away.</source>
        <translation>調色盤滿了：按右鍵可以移除顏料。</translation>
    </message>
    <message>
        <source>%1
The right button, or Delete, takes it away.</source>
        <translation>%1
按右鍵或 Delete 可移除。</translation>
    </message>
    <message>
        <source>%1
ΔE %2, %3; %4</source>
        <translation>%1
ΔE %2，%3；%4</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>儲存...</translation>
    </message>
    <message>
        <source>The colours of your palette for GIMP, Krita or Inkscape, as a .gpl file</source>
        <translation>將你的調色盤顏色存成 GIMP、Krita 或 Inkscape 用的 .gpl 檔案</translation>
    </message>
    <message>
        <source>There is no room for more mixes; take one away first.</source>
        <translation>沒有空間再放混色了；請先移除一個。</translation>
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
        <translation>肉眼感受的明度、彩度和色相</translation>
    </message>
    <message>
        <source>HSV</source>
        <translation>HSV</translation>
    </message>
    <message>
        <source>Hue, saturation and value</source>
        <translation>色相、飽和度和明度</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>Red, green and blue of the screen</source>
        <translation>螢幕的紅、綠、藍</translation>
    </message>
    <message>
        <source>The colour as it is written, for example #c03020</source>
        <translation>用色碼表示的顏色，例如 #c03020</translation>
    </message>
    <message>
        <source>Colour as written</source>
        <translation>色碼</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; write it for example as #c03020.</source>
        <translation>「%1」不是顏色；請寫成像 #c03020 這樣。</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ColourWheel</name>
    <message>
        <source>Colour wheel</source>
        <translation>色環</translation>
    </message>
    <message>
        <source>The ring is the hue. Inside, lightness goes up and chroma to the right, as far as the
screen has it. Keys: arrows, Page Up and Page Down for the hue, with Ctrl finely.</source>
        <translation>外環是色相。內側往上明度增加，往右彩度增加，
範圍到螢幕能顯示的為止。按鍵：方向鍵；Page Up 和 Page Down 調色相，加 Ctrl 可微調。</translation>
    </message>
    <message>
        <source>Lightness %1 %, chroma %2, hue %3°</source>
        <translation>明度 %1 %，彩度 %2，色相 %3°</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::CurveEditor</name>
    <message>
        <source>Curve</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>Drag a point, click beside one to add another, right click to take one away.
Keys: Page Up and Page Down choose, arrows move, Insert adds, Delete takes away.</source>
        <translation>拖曳控制點；在旁邊按一下可新增，按右鍵可移除。
按鍵：Page Up 和 Page Down 選取，方向鍵移動，Insert 新增，Delete 移除。</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n 個點</numerusform>
        </translation>
    </message>
    <message>
        <source>Point %1 of %2: %3 % across, %4 % up</source>
        <translation>第 %1 點，共 %2 點：橫向 %3 %，縱向 %4 %</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::CurvesPanel</name>
    <message>
        <source>Add</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>Another curve: what of the hand sets what of the tool</source>
        <translation>再加一條曲線：手的哪種動作控制工具的哪種特性</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Takes this curve away</source>
        <translation>移除這條曲線</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重設</translation>
    </message>
    <message>
        <source>The curve as the tool was kept with</source>
        <translation>恢復工具儲存時的曲線</translation>
    </message>
    <message>
        <source>How it answers to the hand</source>
        <translation>如何隨手的動作變化</translation>
    </message>
    <message>
        <source>What of the hand sets what of the tool</source>
        <translation>手的哪種動作控制工具的哪種特性</translation>
    </message>
    <message>
        <source>This tool has no curves.</source>
        <translation>這個工具沒有曲線。</translation>
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
        <translation>傾斜</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>光線</translation>
    </message>
    <message>
        <source>Drying</source>
        <translation>乾燥</translation>
    </message>
    <message>
        <source>How fast wet paint dries; D dries it at once</source>
        <translation>濕顏料乾得多快；按 D 可讓它立刻變乾</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>平放</translation>
    </message>
    <message>
        <source>How steeply the canvas stands</source>
        <translation>畫布傾斜的角度</translation>
    </message>
    <message>
        <source>Where down is: 0 right, 90 bottom</source>
        <translation>下方的方向：0 為右，90 為下</translation>
    </message>
    <message>
        <source>How high the lamp stands</source>
        <translation>燈的高度角</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 right, 90 top</source>
        <translation>光線來自的方向：0 為右，90 為上</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::FeelRow</name>
    <message>
        <source>From %1 to %2</source>
        <translation>由%1到%2</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::GuidesPanel</name>
    <message>
        <source>Mirrors and copies</source>
        <translation>鏡像與環繞份數</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>份數</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>距左側</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>距上方</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸線</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::HistoryModel</name>
    <message>
        <source>As far back as is kept</source>
        <translation>保留的最早狀態</translation>
    </message>
    <message>
        <source>Click: do again up to here</source>
        <translation>按一下：重做到這一步</translation>
    </message>
    <message>
        <source>Click: go back to this moment</source>
        <translation>按一下：回到這一步</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::HistoryPanel</name>
    <message>
        <source>What was done</source>
        <translation>做過的步驟</translation>
    </message>
    <message>
        <source>What the steps take; &quot;Memory for undo&quot; in the Edit menu says how much they may</source>
        <translation>步驟占用的記憶體；上限可在「編輯」選單的「復原記憶體」設定</translation>
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
        <translation>照在畫架上的光；顏料本身不會改變</translation>
    </message>
    <message>
        <source>Daylight (D65)</source>
        <translation>日光 (D65)</translation>
    </message>
    <message>
        <source>Print booth (D50)</source>
        <translation>看樣燈箱 (D50)</translation>
    </message>
    <message>
        <source>Light bulb (A)</source>
        <translation>燈泡 (A)</translation>
    </message>
    <message>
        <source>LED lamp</source>
        <translation>LED 燈</translation>
    </message>
    <message>
        <source>From a file...</source>
        <translation>從檔案...</translation>
    </message>
    <message>
        <source>Seen in</source>
        <translation>觀看光源</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LaidGuidePart</name>
    <message>
        <source>Guide</source>
        <translation>輔助線</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Snapping strength</source>
        <translation>貼齊強度</translation>
    </message>
    <message>
        <source>How far the guide draws the brush from where your hand is: 0 not at all, 100 all the way</source>
        <translation>輔助線把畫筆從手的位置拉過去多少：0 完全不拉，100 完全拉到線上</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>What guides your strokes</source>
        <translation>引導筆觸的輔助線</translation>
    </message>
    <message>
        <source>none</source>
        <translation>無</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>直尺</translation>
    </message>
    <message>
        <source>Parallel ruler</source>
        <translation>平行直尺</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>橢圓</translation>
    </message>
    <message>
        <source>Concentric ellipse</source>
        <translation>同心橢圓</translation>
    </message>
    <message>
        <source>1 point perspective</source>
        <translation>一點透視</translation>
    </message>
    <message>
        <source>2 point perspective</source>
        <translation>兩點透視</translation>
    </message>
    <message>
        <source>3 point perspective</source>
        <translation>三點透視</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>格線</translation>
    </message>
    <message>
        <source>Lies on the canvas</source>
        <translation>放在畫布上</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LayerModel</name>
    <message>
        <source>a group of %1</source>
        <translation>含 %1 個圖層的群組</translation>
    </message>
    <message>
        <source>the layer that you paint on</source>
        <translation>正在作畫的圖層</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>已隱藏</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>已鎖定</translation>
    </message>
    <message>
        <source>opacity %1 %</source>
        <translation>不透明度 %1 %</translation>
    </message>
    <message>
        <source>what is bare is locked</source>
        <translation>空白處已鎖定</translation>
    </message>
    <message>
        <source>clipped to the layer below</source>
        <translation>已剪裁至下方圖層</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LayerPanel</name>
    <message>
        <source>Layers</source>
        <translation>圖層</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Fades what its paint does to light; its relief stays</source>
        <translation>讓顏料的顏色變淡；起伏不變</translation>
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
        <translation>拖曳燈的位置：靠近邊緣時，斜光會掃出起伏。按兩下可恢復原位。
按鍵：方向鍵移動燈，Home 恢復原位。</translation>
    </message>
    <message>
        <source>%1° high, from %2°</source>
        <translation>高 %1°，來自 %2°</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LightPanel</name>
    <message>
        <source>Seen in</source>
        <translation>觀看光源</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>燈</translation>
    </message>
    <message>
        <source>From</source>
        <translation>從</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 right, 90 above, 180 left, 270 below</source>
        <translation>光線的來向：0 右方，90 上方，180 左方，270 下方</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Low light rakes over the relief, 90 is overhead</source>
        <translation>低角度的光會掃出起伏，90 是正上方</translation>
    </message>
    <message>
        <source>Even light</source>
        <translation>環境光</translation>
    </message>
    <message>
        <source>The part of the light that comes from all sides; the lamp gives the rest. More of it softens the relief</source>
        <translation>從四面八方來的光所占的比例，其餘來自燈。比例越高，起伏越柔和</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Varnish</source>
        <translation>凡尼斯</translation>
    </message>
    <message>
        <source>A clear coat to look through, here and in exports; it changes no paint, and can be taken off again</source>
        <translation>隔著看畫的一層透明塗層，匯出時也有；不會改變顏料，隨時可以除去</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>用量</translation>
    </message>
    <message>
        <source>A thin coat evens the gloss only in part</source>
        <translation>塗得薄時，光澤只會部分變均勻</translation>
    </message>
    <message>
        <source>Aged</source>
        <translation>老化</translation>
    </message>
    <message>
        <source>Old varnish turns yellow: 100 % is about a century</source>
        <translation>老凡尼斯會泛黃：100 % 約為一百年</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LoadBar</name>
    <message>
        <source>The paint in the brush, across its width: how full it is, and of which colour</source>
        <translation>筆刷上的顏料，依筆寬分布：沾了多少、是什麼顏色</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LoadPanel</name>
    <message>
        <source>On the brush</source>
        <translation>筆刷上的顏料</translation>
    </message>
    <message>
        <source>How the brush is dipped, from the next time on</source>
        <translation>筆刷沾顏料的方式，從下一次開始生效</translation>
    </message>
    <message>
        <source>Full, in one paint</source>
        <translation>沾滿單一顏料</translation>
    </message>
    <message>
        <source>Only the tip</source>
        <translation>只沾筆尖</translation>
    </message>
    <message>
        <source>One paint on each side</source>
        <translation>兩側各沾一種顏料</translation>
    </message>
    <message>
        <source>Half mixed from two</source>
        <translation>兩種顏料半混</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>沾取量</translation>
    </message>
    <message>
        <source>How full the brush is dipped; little leaves a dry brush</source>
        <translation>筆刷沾多少顏料；沾得少就成為乾筆</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>第二種</translation>
    </message>
    <message>
        <source>The second paint&apos;s share of a half-mixed load</source>
        <translation>半混時第二種顏料所占的比例</translation>
    </message>
    <message>
        <source>In hand: %1</source>
        <translation>手上的顏料：%1</translation>
    </message>
    <message>
        <source>The second paint of the load: %1</source>
        <translation>筆刷所沾的第二種顏料：%1</translation>
    </message>
    <message>
        <source>The second paint, laid out for later: %1</source>
        <translation>第二種顏料，備著待用：%1</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空的</translation>
    </message>
    <message>
        <source>all but empty</source>
        <translation>幾乎空了</translation>
    </message>
    <message>
        <source>%1 % full</source>
        <translation>沾了 %1 %</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MediumPanel</name>
    <message>
        <source>As it comes</source>
        <translation>原樣</translation>
    </message>
    <message>
        <source>Kind of paint</source>
        <translation>顏料的種類</translation>
    </message>
    <message>
        <source>The brush is cleaned, and dipped in paint of this kind</source>
        <translation>清潔筆刷，再沾這種顏料</translation>
    </message>
    <message>
        <source>Takes back what was changed below</source>
        <translation>還原下方所做的變更</translation>
    </message>
    <message>
        <source>What it is like</source>
        <translation>顏料的性格</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>數值</translation>
    </message>
    <message>
        <source>Each number of the paint</source>
        <translation>顏料的各項數值</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MessageBar</name>
    <message>
        <source>What needs your attention</source>
        <translation>需要你留意的事</translation>
    </message>
    <message>
        <source>Put away</source>
        <translation>收起</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MessagePanel</name>
    <message>
        <source>Messages</source>
        <translation>訊息</translation>
    </message>
    <message>
        <source>Nothing has been told yet.</source>
        <translation>還沒有訊息。</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>全部複製</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>All messages, to be pasted elsewhere</source>
        <translation>複製所有訊息，以便貼到別處</translation>
    </message>
    <message>
        <source>Take all messages off the list</source>
        <translation>清除清單中的所有訊息</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MixesPart</name>
    <message>
        <source>Your mixes</source>
        <translation>你的混色</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重新命名</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Keep as a mix</source>
        <translation>保留為混色</translation>
    </message>
    <message>
        <source>Keep the paint in hand as a recipe of tubes, under a name of your own</source>
        <translation>將手上的顏料以管裝顏料配方保留，並自行命名</translation>
    </message>
    <message>
        <source>Take the chosen mix away</source>
        <translation>移除所選的混色</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>匯出...</translation>
    </message>
    <message>
        <source>Save your mixes and your palette as a file for others</source>
        <translation>將你的混色與調色盤存成檔案供他人使用</translation>
    </message>
    <message>
        <source>Import...</source>
        <translation>匯入...</translation>
    </message>
    <message>
        <source>Add the mixes and the palette of such a file</source>
        <translation>加入這種檔案中的混色與調色盤</translation>
    </message>
    <message>
        <source>Paints that you keep are listed here, under names of your own.</source>
        <translation>保留下來的顏料會以你取的名稱列在這裡。</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MousePart</name>
    <message>
        <source>Pressure</source>
        <translation>筆壓</translation>
    </message>
    <message>
        <source>How hard the brush is pressed</source>
        <translation>筆刷下壓的力道</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Lighter the faster it goes</source>
        <translation>畫得越快，下筆越輕</translation>
    </message>
    <message>
        <source>A slow line is pressed as set above, a fast one down to a quarter of it</source>
        <translation>慢慢畫時照上方設定的力道，快速畫時最輕減到四分之一</translation>
    </message>
    <message>
        <source>A mouse, or a finger on the screen, does not tell how hard it presses.</source>
        <translation>滑鼠或在螢幕上的手指無法提供下壓的力道。</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::NavigatorMap</name>
    <message>
        <source>The middle of the window is %1 % from the left and %2 % from the top</source>
        <translation>視窗中心位於左起 %1 %、上起 %2 %</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::NavigatorPanel</name>
    <message>
        <source>The whole canvas</source>
        <translation>整張畫布</translation>
    </message>
    <message>
        <source>Drag the frame, or click, to go there
Wheel: closer, farther</source>
        <translation>拖曳外框或按一下，前往該處
滾輪：靠近、退遠</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>縮放</translation>
    </message>
    <message>
        <source>Screen pixels for a pixel of the saved picture</source>
        <translation>儲存圖片的一個像素對應多少螢幕像素</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>旋轉</translation>
    </message>
    <message>
        <source>How far the canvas is turned, clockwise</source>
        <translation>畫布順時針旋轉的角度</translation>
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
        <translation>尚未開啟</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>開啟...</translation>
    </message>
    <message>
        <source>Colours of GIMP, Krita or Inkscape, from a .gpl file</source>
        <translation>GIMP、Krita 或 Inkscape 的顏色，來自 .gpl 檔案</translation>
    </message>
    <message>
        <source>From a picture...</source>
        <translation>從圖片...</translation>
    </message>
    <message>
        <source>Finds the colours that a picture is made of</source>
        <translation>找出構成圖片的顏色</translation>
    </message>
    <message>
        <source>Colours of the picture</source>
        <translation>圖片的顏色</translation>
    </message>
    <message>
        <source>How many colours are looked for</source>
        <translation>要找出幾種顏色</translation>
    </message>
    <message>
        <source>As recipes of the tubes</source>
        <translation>以管裝顏料配方</translation>
    </message>
    <message>
        <source>A click dips the brush in the nearest mixture of tubes, not in the colour itself</source>
        <translation>按一下會讓筆刷沾最接近的管裝顏料混色，而非該顏色本身</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>從檔案載入</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PaceNotice</name>
    <message>
        <source>The paint runs at %1 of its pace.</source>
        <translation>顏料以原本速度的%1流動。</translation>
    </message>
    <message>
        <source>Time runs at %1 of %2 ×.</source>
        <translation>時間以 %2 × 的%1進行。</translation>
    </message>
    <message>
        <source>What helps</source>
        <translation>可以怎麼做</translation>
    </message>
    <message>
        <source>What lets the paint keep up again</source>
        <translation>讓顏料跟上的方法</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PaintPanel</name>
    <message>
        <source>The medium without pigment, for example thinner</source>
        <translation>不含色料的媒介劑，例如稀釋劑</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>顏料</translation>
    </message>
    <message>
        <source>%1 (%2), %3
As the tool in hand lays it (%4 mm), thinned over white and over black, and with white</source>
        <translation>%1 (%2)，%3
手上工具塗出的厚度（%4 mm）、在白底與黑底上推薄的顏色，以及加白調淡的顏色</translation>
    </message>
    <message>
        <source>Put into a set</source>
        <translation>放入一組</translation>
    </message>
    <message>
        <source>Take out of this set</source>
        <translation>從此組取出</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PenButtons</name>
    <message>
        <source>Ends and buttons of pens</source>
        <translation>筆的兩端與按鈕</translation>
    </message>
    <message>
        <source>Eraser end</source>
        <translation>橡皮擦端</translation>
    </message>
    <message>
        <source>Lower button</source>
        <translation>下方按鈕</translation>
    </message>
    <message>
        <source>Upper button</source>
        <translation>上方按鈕</translation>
    </message>
    <message>
        <source>picks up paint</source>
        <translation>沾取顏料</translation>
    </message>
    <message>
        <source>picks the colour seen</source>
        <translation>取用看到的顏色</translation>
    </message>
    <message>
        <source>moves the canvas</source>
        <translation>移動畫布</translation>
    </message>
    <message>
        <source>opens the palette</source>
        <translation>開啟快顯調色盤</translation>
    </message>
    <message>
        <source>does nothing</source>
        <translation>沒有作用</translation>
    </message>
    <message>
        <source>takes %1</source>
        <translation>換成 %1</translation>
    </message>
    <message>
        <source>paints like the tip</source>
        <translation>與筆尖一樣作畫</translation>
    </message>
    <message>
        <source>Third button</source>
        <translation>第三個按鈕</translation>
    </message>
    <message>
        <source>Wheel forward</source>
        <translation>滾輪向前</translation>
    </message>
    <message>
        <source>Wheel back</source>
        <translation>滾輪向後</translation>
    </message>
    <message>
        <source>Fingers paint</source>
        <translation>用手指繪畫</translation>
    </message>
    <message>
        <source>Otherwise one finger moves the canvas, as two always do</source>
        <translation>否則一根手指移動畫布，兩根手指則總是移動畫布</translation>
    </message>
    <message>
        <source>Wet mark</source>
        <translation>濕痕</translation>
    </message>
    <message>
        <source>Shows paint under the pen at once, until the paint itself is on the screen</source>
        <translation>在顏料本身出現於畫面之前，立即在筆下顯示顏料</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PenDialog</name>
    <message>
        <source>Pen and tablet</source>
        <translation>筆與數位板</translation>
    </message>
    <message>
        <source>Pens and mouse</source>
        <translation>筆與滑鼠</translation>
    </message>
    <message>
        <source>A pen that is not listed comes here when it touches the sheet below.</source>
        <translation>沒有列出的筆，碰一下下方的試畫區就會出現在這裡。</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>柔軟</translation>
    </message>
    <message>
        <source>A light hand already presses hard</source>
        <translation>輕輕下筆就很重</translation>
    </message>
    <message>
        <source>As it comes</source>
        <translation>原樣</translation>
    </message>
    <message>
        <source>The pressure as the pen tells it, without a curve</source>
        <translation>筆所提供的筆壓，不套用曲線</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>硬實</translation>
    </message>
    <message>
        <source>Only a heavy hand presses hard</source>
        <translation>用力下筆才會重</translation>
    </message>
    <message>
        <source>From left to right what the pen tells, upwards what the brush is pressed with.</source>
        <translation>由左到右是筆所提供的筆壓，由下到上是筆刷實際的下壓力道。</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>擦掉</translation>
    </message>
    <message>
        <source>Try it here</source>
        <translation>在這裡試畫</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>滑鼠</translation>
    </message>
    <message>
        <source>Pressure of %1</source>
        <translation>%1 的筆壓</translation>
    </message>
    <message>
        <source>Pressure of the mouse</source>
        <translation>滑鼠的筆壓</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PenPad</name>
    <message>
        <source>Sheet to try the pen on</source>
        <translation>試筆區</translation>
    </message>
    <message>
        <source>Scribble here with a pen or the mouse</source>
        <translation>用筆或滑鼠在這裡隨意塗畫</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PictureBoard</name>
    <message>
        <source>no picture</source>
        <translation>沒有圖片</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 像素</translation>
    </message>
    <message>
        <source>A picture that you choose to trace lies here, to look at and to pick colours from, and below the paint.</source>
        <translation>您選擇用來描圖的圖片會放在這裡，可供觀看與取色，也會顯示在顏料下方。</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PopupPalette</name>
    <message>
        <source>Pop-up palette</source>
        <translation>快顯調色盤</translation>
    </message>
    <message>
        <source>A narrower brush</source>
        <translation>較窄的筆刷</translation>
    </message>
    <message>
        <source>A wider brush</source>
        <translation>較寬的筆刷</translation>
    </message>
    <message>
        <source>%1: take this one, and put the other here</source>
        <translation>%1：改用這種顏料，並將手上的放到這裡</translation>
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
        <translation>%1：還原為已儲存工具的值</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::RecorderPanel</name>
    <message>
        <source>Strokes</source>
        <translation>筆觸數</translation>
    </message>
    <message>
        <source>Painting time</source>
        <translation>作畫時間</translation>
    </message>
    <message>
        <source>Recorded so far</source>
        <translation>目前已錄製</translation>
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
        <translation>所選圖片顯示的濃淡</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>上移</translation>
    </message>
    <message>
        <source>Above the next picture (PgUp)</source>
        <translation>移到上一張圖片之上 (PgUp)</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>下移</translation>
    </message>
    <message>
        <source>Below the picture under it (PgDown)</source>
        <translation>移到下方圖片之下 (PgDown)</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>鏡像</translation>
    </message>
    <message>
        <source>Left and right change sides</source>
        <translation>左右對調</translation>
    </message>
    <message>
        <source>Greys</source>
        <translation>灰階</translation>
    </message>
    <message>
        <source>Shown in greys as light as its colours</source>
        <translation>以與顏色同樣明亮的灰階顯示</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Take the chosen picture off the board (Del)</source>
        <translation>把所選圖片從圖板上移除 (Del)</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ReferenceView</name>
    <message>
        <source>Board of references</source>
        <translation>參考圖板</translation>
    </message>
    <message>
        <source>Drag: move a picture, scale it by a corner, turn it by the ring
Control and click: paint of that colour
Wheel: closer, farther; with Shift it turns the picture
Double click, 0: all of it</source>
        <translation>拖曳：移動圖片；拖角可縮放，拖圓圈可旋轉
Ctrl＋按一下：調出該顏色的顏料
滾輪：靠近、退遠；按住 Shift 則旋轉圖片
按兩下、0：顯示全部</translation>
    </message>
    <message>
        <source>pictures: %1</source>
        <translation>圖片：%1</translation>
    </message>
    <message>
        <source>pictures: %1; chosen: %2</source>
        <translation>圖片：%1；已選：%2</translation>
    </message>
    <message>
        <source>Drag pictures here, to look at them and pick their colours while you paint.</source>
        <translation>把圖片拖到這裡，作畫時可以觀察並取用其中的顏色。</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::StatusReadings</name>
    <message>
        <source>The pen&apos;s place on the canvas, from its upper left corner</source>
        <translation>筆在畫布上的位置，從左上角算起</translation>
    </message>
    <message>
        <source>Tools keep to what is outlined; Ctrl+A ends the selection, Esc goes back to painting</source>
        <translation>工具只作用於框選的範圍；Ctrl+A 取消選取，Esc 回到作畫</translation>
    </message>
    <message>
        <source>Memory that the program holds: the painting, its history and its pictures</source>
        <translation>程式占用的記憶體：畫作、步驟記錄和圖片</translation>
    </message>
    <message>
        <source>Size of the canvas and of its saved picture</source>
        <translation>畫布的尺寸和儲存圖片的大小</translation>
    </message>
    <message>
        <source>What the canvas shows; Alt+1 shows it in its light again</source>
        <translation>畫布顯示的內容；按 Alt+1 恢復燈光下的樣子</translation>
    </message>
    <message>
        <source>How the canvas stands on the screen; 5 puts it upright, M mirrors it</source>
        <translation>畫布在螢幕上的方向；按 5 轉正，按 M 鏡像</translation>
    </message>
    <message>
        <source>Screen pixels for a pixel of the saved picture</source>
        <translation>儲存圖片的一個像素對應多少螢幕像素</translation>
    </message>
    <message>
        <source>%1 × %2 mm   %3 × %4 px</source>
        <translation>%1 × %2 mm   %3 × %4 px</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>已鏡像</translation>
    </message>
    <message>
        <source>turned %1°</source>
        <translation>已旋轉 %1°</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>已暫停</translation>
    </message>
    <message>
        <source>paint at rest</source>
        <translation>顏料靜止</translation>
    </message>
    <message>
        <source>%1 × time</source>
        <translation>%1 × 時間</translation>
    </message>
    <message>
        <source>%1 % selected</source>
        <translation>已選取 %1 %</translation>
    </message>
    <message>
        <source>Paint time against the clock: less than you set where there is more wet paint than this computer can move in time</source>
        <translation>顏料時間與實際時間的比例：濕顏料太多，電腦來不及計算時，會低於你的設定</translation>
    </message>
    <message>
        <source>Whether paint still moves, and how much of its time this computer works on it</source>
        <translation>顏料是否還在流動，以及這台電腦花多少時間計算</translation>
    </message>
    <message>
        <source>paint moving, %1 % busy</source>
        <translation>顏料流動中，忙碌 %1 %</translation>
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
        <translation>顏料 : 媒介，由膏狀到染色。越往右越稀：更易流動，並透出下層</translation>
    </message>
    <message>
        <source>Paint : medium</source>
        <translation>顏料 : 媒介</translation>
    </message>
    <message>
        <source>Paint : medium, from paste to stain. Upwards the paint is thinned: it runs sooner, and lets through what lies below</source>
        <translation>顏料 : 媒介，由膏狀到染色。越往上越稀：更易流動，並透出下層</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TiltDial</name>
    <message>
        <source>Drag to tilt the canvas: the paint runs towards the knob. Double-click lays it flat.
Keys: arrows tilt it, Home lays it flat.</source>
        <translation>拖曳可傾斜畫布：顏料流向旋鈕。按兩下可放平。
按鍵：方向鍵傾斜畫布，Home 放平。</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>平放</translation>
    </message>
    <message>
        <source>%1° steep, down is at %2°</source>
        <translation>傾斜 %1°，向下為 %2°</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TracingPanel</name>
    <message>
        <source>Picture to trace</source>
        <translation>描圖底圖</translation>
    </message>
    <message>
        <source>Click: paint of that colour
Wheel: closer, farther
Drag: move the picture
0: all of it</source>
        <translation>按一下：調出該顏色的顏料
滾輪：靠近、退遠
拖曳：移動圖片
0：顯示全部</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>How strongly it shows below the paint</source>
        <translation>在顏料下方顯示的濃淡</translation>
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
        <translation>距左側</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>距上方</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>寬度</translation>
    </message>
    <message>
        <source>Its height follows in proportion</source>
        <translation>高度依比例調整</translation>
    </message>
    <message>
        <source>Where its left edge lies on the canvas</source>
        <translation>其左緣在畫布上的位置</translation>
    </message>
    <message>
        <source>Where its upper edge lies on the canvas</source>
        <translation>其上緣在畫布上的位置</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TubeMenu</name>
    <message>
        <source>Which tubes are shown: all of them, or a set of yours</source>
        <translation>顯示哪些管裝顏料：全部，或你的一組</translation>
    </message>
    <message>
        <source>All tubes</source>
        <translation>所有顏料</translation>
    </message>
    <message>
        <source>Save as a set...</source>
        <translation>存成一組...</translation>
    </message>
    <message>
        <source>Rename the set...</source>
        <translation>重新命名此組...</translation>
    </message>
    <message>
        <source>Remove the set</source>
        <translation>移除此組</translation>
    </message>
    <message>
        <source>Squeeze these onto the mixing well</source>
        <translation>將這些擠到調色槽上</translation>
    </message>
    <message>
        <source>Import sets...</source>
        <translation>匯入組...</translation>
    </message>
    <message>
        <source>Export my sets...</source>
        <translation>匯出我的組...</translation>
    </message>
    <message>
        <source>Squeeze out the last painting&apos;s palette</source>
        <translation>擠出上一幅畫的調色盤</translation>
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
        <translation>已沒有可用來繪製畫布的 OpenGL。</translation>
    </message>
</context>
<context>
    <name>pastoso::screens</name>
    <message>
        <source>All commands and their keys</source>
        <translation>所有指令與快速鍵</translation>
    </message>
    <message>
        <source>In the order of the menus. &quot;Keys&quot; in the &quot;Settings&quot; menu changes them ([how](settings.md#keys)). This page is printed by the program; `packaging/screens.sh --manual` prints it anew.</source>
        <translation>依選單的順序排列。可用「設定」選單中的「快速鍵」變更（[做法](settings.md#keys)）。此頁由程式輸出；`packaging/screens.sh --manual` 會重新輸出。</translation>
    </message>
    <message>
        <source>command</source>
        <translation>指令</translation>
    </message>
    <message>
        <source>like Krita</source>
        <translation>Krita 風格</translation>
    </message>
    <message>
        <source>like Photoshop</source>
        <translation>Photoshop 風格</translation>
    </message>
    <message>
        <source>does</source>
        <translation>作用</translation>
    </message>
</context>
<context>
    <name>pastoso::start::ExamplesSection</name>
    <message>
        <source>Examples, painted before your eyes</source>
        <translation>範例，在你眼前一筆一筆畫出</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>範例</translation>
    </message>
    <message>
        <source>Watch how it is painted, stroke by stroke, and paint on</source>
        <translation>一筆一筆看它如何畫成，再接著畫下去</translation>
    </message>
</context>
<context>
    <name>pastoso::start::NewCanvasSection</name>
    <message>
        <source>New canvas</source>
        <translation>新增畫布</translation>
    </message>
    <message>
        <source>Sizes of a new canvas</source>
        <translation>新畫布的尺寸</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>橫向</translation>
    </message>
    <message>
        <source>Wider than high</source>
        <translation>寬大於高</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>直向</translation>
    </message>
    <message>
        <source>Higher than wide</source>
        <translation>高大於寬</translation>
    </message>
    <message>
        <source>More...</source>
        <translation>更多...</translation>
    </message>
    <message>
        <source>Any size</source>
        <translation>任意尺寸</translation>
    </message>
    <message>
        <source>Choose width, height, resolution and support yourself</source>
        <translation>自行決定寬度、高度、解析度和基底材</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, %4 px/mm</source>
        <translation>%1，%2 × %3 像素，%4 px/mm</translation>
    </message>
</context>
<context>
    <name>pastoso::start::PaintingReader</name>
    <message>
        <source>This file is not there any more.</source>
        <translation>這個檔案已經不在了。</translation>
    </message>
    <message>
        <source>This file cannot be read.</source>
        <translation>無法讀取這個檔案。</translation>
    </message>
</context>
<context>
    <name>pastoso::start::RecentSection</name>
    <message>
        <source>Today, %1</source>
        <translation>今天 %1</translation>
    </message>
    <message>
        <source>Yesterday, %1</source>
        <translation>昨天 %1</translation>
    </message>
    <message>
        <source>Recent paintings</source>
        <translation>最近的畫作</translation>
    </message>
    <message>
        <source>Open a file...</source>
        <translation>開啟檔案...</translation>
    </message>
    <message>
        <source>Paintings that you save will stand here.</source>
        <translation>儲存的畫作會出現在這裡。</translation>
    </message>
</context>
<context>
    <name>pastoso::start::StartPage</name>
    <message>
        <source>Show this page at start</source>
        <translation>啟動時顯示此頁</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>起始頁</translation>
    </message>
    <message>
        <source>Esc closes it; &quot;Start page&quot; in the &quot;File&quot; menu brings it back.</source>
        <translation>按 Esc 關閉；從「檔案」選單的「起始頁」可再開啟。</translation>
    </message>
    <message>
        <source>Back to the painting</source>
        <translation>回到畫作</translation>
    </message>
    <message>
        <source>Start painting</source>
        <translation>開始作畫</translation>
    </message>
    <message>
        <source>The painting stands on the easel as you left it.</source>
        <translation>畫作還在畫架上，和你離開時一樣。</translation>
    </message>
    <message>
        <source>A canvas of %1, %2, is ready. You can also just paint on it.</source>
        <translation>畫布（%1，%2）已經備妥，你也可以直接開始畫。</translation>
    </message>
</context>
<context>
    <name>pastoso::start::UnfinishedSection</name>
    <message>
        <source>Not closed last time</source>
        <translation>上次未正常關閉</translation>
    </message>
    <message>
        <source>Choose or discard...</source>
        <translation>選擇或捨棄...</translation>
    </message>
    <message>
        <source>All paintings that were left unfinished</source>
        <translation>所有未完成的畫作</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>救回</translation>
    </message>
</context>
<context>
    <name>pastoso::tools</name>
    <message>
        <source>PNG, 8 bits</source>
        <translation>PNG，8 位元</translation>
    </message>
    <message>
        <source>PNG, 16 bits</source>
        <translation>PNG，16 位元</translation>
    </message>
    <message>
        <source>JPEG</source>
        <translation>JPEG</translation>
    </message>
    <message>
        <source>TIFF, 8 bits</source>
        <translation>TIFF，8 位元</translation>
    </message>
    <message>
        <source>TIFF, 16 bits</source>
        <translation>TIFF，16 位元</translation>
    </message>
    <message>
        <source>TIFF, 32 bits of linear light</source>
        <translation>TIFF，32 位元線性光</translation>
    </message>
    <message>
        <source>WebP</source>
        <translation>WebP</translation>
    </message>
    <message>
        <source>OpenEXR, linear light</source>
        <translation>OpenEXR，線性光</translation>
    </message>
    <message>
        <source>PNG, 8 bits, heights in 16</source>
        <translation>PNG，8 位元，高度為 16 位元</translation>
    </message>
    <message>
        <source>TIFF, 32 bits, heights in mm</source>
        <translation>TIFF，32 位元，高度以 mm 為單位</translation>
    </message>
    <message>
        <source>OpenEXR, heights in mm</source>
        <translation>OpenEXR，高度以 mm 為單位</translation>
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
        <translation>連號圖片，8 位元 PNG</translation>
    </message>
    <message>
        <source>Numbered pictures, PNG of 16 bits</source>
        <translation>連號圖片，16 位元 PNG</translation>
    </message>
    <message>
        <source>Video, MP4</source>
        <translation>影片，MP4</translation>
    </message>
    <message>
        <source>Video, Matroska</source>
        <translation>影片，Matroska</translation>
    </message>
    <message>
        <source>Video, WebM</source>
        <translation>影片，WebM</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>紅</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>綠</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>藍</translation>
    </message>
    <message>
        <source>Hue, degrees</source>
        <translation>色相（度）</translation>
    </message>
    <message>
        <source>Saturation, %</source>
        <translation>飽和度（%）</translation>
    </message>
    <message>
        <source>Value, %</source>
        <translation>明度（%）</translation>
    </message>
    <message>
        <source>Lightness as it is seen, %</source>
        <translation>視覺明度（%）</translation>
    </message>
    <message>
        <source>Chroma: how far from grey</source>
        <translation>彩度：與灰色的距離</translation>
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
        <translation>濕顏料</translation>
    </message>
    <message>
        <source>Height of the paint</source>
        <translation>顏料的高度</translation>
    </message>
    <message>
        <source>Slopes of the surface</source>
        <translation>表面的斜度</translation>
    </message>
    <message>
        <source>Flat colour</source>
        <translation>只看顏色</translation>
    </message>
</context>
<context>
    <name>std</name>
    <message>
        <source>Stroke in the mixing well</source>
        <translation>調色槽裡的筆觸</translation>
    </message>
    <message>
        <source>Canvas mirrored</source>
        <translation>畫布已鏡射</translation>
    </message>
    <message>
        <source>Canvas turned</source>
        <translation>畫布已旋轉</translation>
    </message>
    <message>
        <source>Masking tape</source>
        <translation>遮蓋膠帶</translation>
    </message>
    <message>
        <source>Masking peeled off</source>
        <translation>撕掉遮蓋</translation>
    </message>
</context>
</TS>
