<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>Painting with thick wet paint</source>
        <translation>Painting with thick wet paint</translation>
    </message>
    <message>
        <source>The Pastoso authors</source>
        <translation>The Pastoso authors</translation>
    </message>
    <message>
        <source>Free software: you may use, study, share and change it under the GNU General Public License, version 3 or later. It comes without any warranty.</source>
        <translation>Free software: you may use, study, share and change it under the GNU General Public License, version 3 or later. It comes without any warranty.</translation>
    </message>
</context>
<context>
    <name>CanvasChoices</name>
    <message>
        <source>Small study</source>
        <translation>Small study</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Square</translation>
    </message>
    <message>
        <source>Small canvas</source>
        <translation>Small canvas</translation>
    </message>
    <message>
        <source>Large canvas</source>
        <translation>Large canvas</translation>
    </message>
    <message>
        <source>Screen, HD</source>
        <translation>Screen, HD</translation>
    </message>
    <message>
        <source>Screen, QHD</source>
        <translation>Screen, QHD</translation>
    </message>
    <message>
        <source>Linen</source>
        <translation>Linen</translation>
    </message>
    <message>
        <source>coarse weave</source>
        <translation>coarse weave</translation>
    </message>
    <message>
        <source>Cotton duck</source>
        <translation>Cotton duck</translation>
    </message>
    <message>
        <source>fine weave</source>
        <translation>fine weave</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>smooth gesso</source>
        <translation>smooth gesso</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>an image</source>
        <translation>an image</translation>
    </message>
    <message>
        <source>Medium linen</source>
        <translation>Medium linen</translation>
    </message>
    <message>
        <source>lively weave with slubs</source>
        <translation>lively weave with slubs</translation>
    </message>
    <message>
        <source>Fine portrait linen</source>
        <translation>Fine portrait linen</translation>
    </message>
    <message>
        <source>Rough jute</source>
        <translation>Rough jute</translation>
    </message>
    <message>
        <source>fine even weave</source>
        <translation>fine even weave</translation>
    </message>
    <message>
        <source>Gesso panel</source>
        <translation>Gesso panel</translation>
    </message>
    <message>
        <source>brushed gesso</source>
        <translation>brushed gesso</translation>
    </message>
</context>
<context>
    <name>Engine</name>
    <message>
        <source>&quot;%1&quot; holds no picture and is left out.</source>
        <translation>&quot;%1&quot; holds no picture and is left out.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2, but must lie between %3 and %4.</source>
        <translation>&quot;%1&quot; is %2, but must lie between %3 and %4.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is known in millimetres only; in cells describe a &quot;weave&quot;.</source>
        <translation>&quot;%1&quot; is known in millimetres only; in cells describe a &quot;weave&quot;.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is needed on the canvas itself.</source>
        <translation>&quot;%1&quot; is needed on the canvas itself.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither &quot;once&quot; nor &quot;reflected&quot;.</source>
        <translation>&quot;%1&quot; is neither &quot;once&quot; nor &quot;reflected&quot;.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither K nor S.</source>
        <translation>&quot;%1&quot; is neither K nor S.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no form of a shape; there are %2.</source>
        <translation>&quot;%1&quot; is no form of a shape; there are %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tool that an eraser end can take.</source>
        <translation>&quot;%1&quot; is no tool that an eraser end can take.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none of &quot;particles&quot;, &quot;level_set&quot;, &quot;upwind_level_set&quot; and &quot;particle_level_set&quot;.</source>
        <translation>&quot;%1&quot; is none of &quot;particles&quot;, &quot;level_set&quot;, &quot;upwind_level_set&quot; and &quot;particle_level_set&quot;.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none of %2.</source>
        <translation>&quot;%1&quot; is none of %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a colour such as #783c14.</source>
        <translation>&quot;%1&quot; is not a colour such as #783c14.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a colour; a colour is # and six hexadecimal digits, for example #c03020.</source>
        <translation>&quot;%1&quot; is not a colour; a colour is # and six hexadecimal digits, for example #c03020.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a finite number.</source>
        <translation>&quot;%1&quot; is not a finite number.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a key such as Ctrl+Shift+Z.</source>
        <translation>&quot;%1&quot; is not a key such as Ctrl+Shift+Z.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number.</source>
        <translation>&quot;%1&quot; is not a number.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a wavelength in nm and a power with one comma.</source>
        <translation>&quot;%1&quot; is not a wavelength in nm and a power with one comma.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not one of %2.</source>
        <translation>&quot;%1&quot; is not one of %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the key of %2 already.</source>
        <translation>&quot;%1&quot; is the key of %2 already.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the name of no command.</source>
        <translation>&quot;%1&quot; is the name of no command.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands here twice.</source>
        <translation>&quot;%1&quot; stands here twice.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands once for the whole file.</source>
        <translation>&quot;%1&quot; stands once for the whole file.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was laid over the others by %2 and is laid over them as paint.</source>
        <translation>&quot;%1&quot; was laid over the others by %2 and is laid over them as paint.</translation>
    </message>
    <message>
        <source>&quot;endloop&quot; is missing before %1.</source>
        <translation>&quot;endloop&quot; is missing before %1.</translation>
    </message>
    <message>
        <source>&quot;tilt&quot; and &quot;gravity&quot; say the same; give one of them.</source>
        <translation>&quot;tilt&quot; and &quot;gravity&quot; say the same; give one of them.</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; is not a finite number.</source>
        <translation>%1 &quot;%2&quot; is not a finite number.</translation>
    </message>
    <message>
        <source>%1 (&quot;%2&quot;)</source>
        <translation>%1 (&quot;%2&quot;)</translation>
    </message>
    <message>
        <source>%1 (&quot;%2&quot;): the field &quot;family&quot; is missing.</source>
        <translation>%1 (&quot;%2&quot;): the field &quot;family&quot; is missing.</translation>
    </message>
    <message>
        <source>%1 (&quot;%2&quot;): thinned_with is &quot;%3&quot;, it must be the name of another medium here.</source>
        <translation>%1 (&quot;%2&quot;): thinned_with is &quot;%3&quot;, it must be the name of another medium here.</translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation>%1 (%2).</translation>
    </message>
    <message>
        <source>%1 Not read: %2</source>
        <translation>%1 Not read: %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 and %2</translation>
    </message>
    <message>
        <source>%1 does not belong in an STL file.</source>
        <translation>%1 does not belong in an STL file.</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which cannot set &quot;%3&quot;.</source>
        <translation>%1 is &quot;%2&quot;, which cannot set &quot;%3&quot;.</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which is none of: %3.</source>
        <translation>%1 is &quot;%2&quot;, which is none of: %3.</translation>
    </message>
    <message>
        <source>%1 is %2 in cell (%3, %4), but must lie between 0 and %5 (cells count from 0 at the upper left).</source>
        <translation>%1 is %2 in cell (%3, %4), but must lie between 0 and %5 (cells count from 0 at the upper left).</translation>
    </message>
    <message>
        <source>%1 is %2, it must be a number from %3 to %4.</source>
        <translation>%1 is %2, it must be a number from %3 to %4.</translation>
    </message>
    <message>
        <source>%1 is %2, it must be a text.</source>
        <translation>%1 is %2, it must be a text.</translation>
    </message>
    <message>
        <source>%1 is %2, more than the length, %3.</source>
        <translation>%1 is %2, more than the length, %3.</translation>
    </message>
    <message>
        <source>%1 is %2, not between %3 and %4.</source>
        <translation>%1 is %2, not between %3 and %4.</translation>
    </message>
    <message>
        <source>%1 is %2, outside %3 to %4.</source>
        <translation>%1 is %2, outside %3 to %4.</translation>
    </message>
    <message>
        <source>%1 is %2, so that more than 100000 drops a second would fall.</source>
        <translation>%1 is %2, so that more than 100000 drops a second would fall.</translation>
    </message>
    <message>
        <source>%1 is %2, whose input is not above that of the point before it.</source>
        <translation>%1 is %2, whose input is not above that of the point before it.</translation>
    </message>
    <message>
        <source>%1 is a file; numbered pictures go into a folder.</source>
        <translation>%1 is a file; numbered pictures go into a folder.</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1 is empty.</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1 is missing.</translation>
    </message>
    <message>
        <source>%1 is no corner of a face.</source>
        <translation>%1 is no corner of a face.</translation>
    </message>
    <message>
        <source>%1 is no number.</source>
        <translation>%1 is no number.</translation>
    </message>
    <message>
        <source>%1 is not a field of a brush preset (value %2).</source>
        <translation>%1 is not a field of a brush preset (value %2).</translation>
    </message>
    <message>
        <source>%1 is not a list of %2 numbers.</source>
        <translation>%1 is not a list of %2 numbers.</translation>
    </message>
    <message>
        <source>%1 is not above 0 and at most %2.</source>
        <translation>%1 is not above 0 and at most %2.</translation>
    </message>
    <message>
        <source>%1 is not between %2 and %3.</source>
        <translation>%1 is not between %2 and %3.</translation>
    </message>
    <message>
        <source>%1 is not finite in single precision.</source>
        <translation>%1 is not finite in single precision.</translation>
    </message>
    <message>
        <source>%1 is not from %2 to %3.</source>
        <translation>%1 is not from %2 to %3.</translation>
    </message>
    <message>
        <source>%1 must be a list, not %2.</source>
        <translation>%1 must be a list, not %2.</translation>
    </message>
    <message>
        <source>%1 must be a number, not %2.</source>
        <translation>%1 must be a number, not %2.</translation>
    </message>
    <message>
        <source>%1 must be a text, not %2.</source>
        <translation>%1 must be a text, not %2.</translation>
    </message>
    <message>
        <source>%1 must be a whole number, not %2.</source>
        <translation>%1 must be a whole number, not %2.</translation>
    </message>
    <message>
        <source>%1 must be an object, not %2.</source>
        <translation>%1 must be an object, not %2.</translation>
    </message>
    <message>
        <source>%1 must be true or false, not %2.</source>
        <translation>%1 must be true or false, not %2.</translation>
    </message>
    <message>
        <source>%1 must be two numbers, not %2.</source>
        <translation>%1 must be two numbers, not %2.</translation>
    </message>
    <message>
        <source>%1 must have 1 to %2 points, not %3.</source>
        <translation>%1 must have 1 to %2 points, not %3.</translation>
    </message>
    <message>
        <source>%1 names %2 %3, but %4 were given until here.</source>
        <translation>%1 names %2 %3, but %4 were given until here.</translation>
    </message>
    <message>
        <source>%1 needs about %2; %3 of memory are free.</source>
        <translation>%1 needs about %2; %3 of memory are free.</translation>
    </message>
    <message>
        <source>%1 normal</source>
        <translation>%1 normal</translation>
    </message>
    <message>
        <source>%1 of the pigment &quot;%2&quot; is given twice.</source>
        <translation>%1 of the pigment &quot;%2&quot; is given twice.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 or %2</translation>
    </message>
    <message>
        <source>%1 per mm is negative.</source>
        <translation>%1 per mm is negative.</translation>
    </message>
    <message>
        <source>%1 position</source>
        <translation>%1 position</translation>
    </message>
    <message>
        <source>%1 triangles take %2 bytes, but the file has %3.</source>
        <translation>%1 triangles take %2 bytes, but the file has %3.</translation>
    </message>
    <message>
        <source>%1 x %2 cells need about %3; %4 of memory are free.</source>
        <translation>%1 x %2 cells need about %3; %4 of memory are free.</translation>
    </message>
    <message>
        <source>%1, %2 nm: %3 is not a number.</source>
        <translation>%1, %2 nm: %3 is not a number.</translation>
    </message>
    <message>
        <source>%1, %2 nm: the weight %3 is negative.</source>
        <translation>%1, %2 nm: the weight %3 is negative.</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>%1, byte %2</source>
        <translation>%1, byte %2</translation>
    </message>
    <message>
        <source>%1, byte %2: %3</source>
        <translation>%1, byte %2: %3</translation>
    </message>
    <message>
        <source>%1, entry %2</source>
        <translation>%1, entry %2</translation>
    </message>
    <message>
        <source>%1, event %2: %3</source>
        <translation>%1, event %2: %3</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, line %2: %3</translation>
    </message>
    <message>
        <source>%1, line %2: this is not JSON, or it is cut off here.</source>
        <translation>%1, line %2: this is not JSON, or it is cut off here.</translation>
    </message>
    <message>
        <source>%1, line %2: this is not valid JSON.</source>
        <translation>%1, line %2: this is not valid JSON.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a list of %3 bands.</source>
        <translation>%1: &quot;%2&quot; is not a list of %3 bands.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; stands there twice.</source>
        <translation>%1: &quot;%2&quot; stands there twice.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 files do not hold %3-bit pictures.</source>
        <translation>%1: %2 files do not hold %3-bit pictures.</translation>
    </message>
    <message>
        <source>%1: %2 files do not hold %3.</source>
        <translation>%1: %2 files do not hold %3.</translation>
    </message>
    <message>
        <source>%1: %2 files hold at most %3 pixels a side; this picture has %4 x %5.</source>
        <translation>%1: %2 files hold at most %3 pixels a side; this picture has %4 x %5.</translation>
    </message>
    <message>
        <source>%1: %2 of the pigment &quot;%3&quot; is %4 per mm in band %5 of %6, above the %7 that paint can have; give the pigment in a weaker paint.</source>
        <translation>%1: %2 of the pigment &quot;%3&quot; is %4 per mm in band %5 of %6, above the %7 that paint can have; give the pigment in a weaker paint.</translation>
    </message>
    <message>
        <source>%1: %2 x %3 pixels are more than the %4 a side that a PSD file holds.</source>
        <translation>%1: %2 x %3 pixels are more than the %4 a side that a PSD file holds.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1: 32 bits a channel hold linear light, which needs no ICC profile.</source>
        <translation>%1: 32 bits a channel hold linear light, which needs no ICC profile.</translation>
    </message>
    <message>
        <source>%1: a PSD file of these layers would be larger than 2 GB.</source>
        <translation>%1: a PSD file of these layers would be larger than 2 GB.</translation>
    </message>
    <message>
        <source>%1: a batch begins at an action or tick that cannot be.</source>
        <translation>%1: a batch begins at an action or tick that cannot be.</translation>
    </message>
    <message>
        <source>%1: a batch is too short.</source>
        <translation>%1: a batch is too short.</translation>
    </message>
    <message>
        <source>%1: a copy in layers is saved as .ora or .psd; this name ends in neither.</source>
        <translation>%1: a copy in layers is saved as .ora or .psd; this name ends in neither.</translation>
    </message>
    <message>
        <source>%1: a mesh is read from .obj or .stl; this name ends otherwise.</source>
        <translation>%1: a mesh is read from .obj or .stl; this name ends otherwise.</translation>
    </message>
    <message>
        <source>%1: a picture is saved as .png, .tif, .jpg, .webp or .exr; this name ends in none of them.</source>
        <translation>%1: a picture is saved as .png, .tif, .jpg, .webp or .exr; this name ends in none of them.</translation>
    </message>
    <message>
        <source>%1: a relief is saved as .stl, .ply or .obj; this name ends in none of them.</source>
        <translation>%1: a relief is saved as .stl, .ply or .obj; this name ends in none of them.</translation>
    </message>
    <message>
        <source>%1: a relief is saved as .stl, .ply or .obj; this name ends otherwise.</source>
        <translation>%1: a relief is saved as .stl, .ply or .obj; this name ends otherwise.</translation>
    </message>
    <message>
        <source>%1: a scene is saved as .pbrt; this name ends otherwise.</source>
        <translation>%1: a scene is saved as .pbrt; this name ends otherwise.</translation>
    </message>
    <message>
        <source>%1: a surface is saved as .obj, .ply, .stl or .pbrt; this name ends otherwise.</source>
        <translation>%1: a surface is saved as .obj, .ply, .stl or .pbrt; this name ends otherwise.</translation>
    </message>
    <message>
        <source>%1: a video is made by the program ffmpeg, which is not installed; a folder&apos;s name instead gives numbered pictures.</source>
        <translation>%1: a video is made by the program ffmpeg, which is not installed; a folder&apos;s name instead gives numbered pictures.</translation>
    </message>
    <message>
        <source>%1: a video is saved as .mp4, .mkv or .webm, and a folder&apos;s name has no ending.</source>
        <translation>%1: a video is saved as .mp4, .mkv or .webm, and a folder&apos;s name has no ending.</translation>
    </message>
    <message>
        <source>%1: a volume is saved as .vdb; this name ends otherwise.</source>
        <translation>%1: a volume is saved as .vdb; this name ends otherwise.</translation>
    </message>
    <message>
        <source>%1: another program is at it.</source>
        <translation>%1: another program is at it.</translation>
    </message>
    <message>
        <source>%1: band %2 of &quot;%3&quot;</source>
        <translation>%1: band %2 of &quot;%3&quot;</translation>
    </message>
    <message>
        <source>%1: cannot be created (%2).</source>
        <translation>%1: cannot be created (%2).</translation>
    </message>
    <message>
        <source>%1: cannot be opened (%2).</source>
        <translation>%1: cannot be opened (%2).</translation>
    </message>
    <message>
        <source>%1: cannot be read (%2).</source>
        <translation>%1: cannot be read (%2).</translation>
    </message>
    <message>
        <source>%1: cannot be read to its end.</source>
        <translation>%1: cannot be read to its end.</translation>
    </message>
    <message>
        <source>%1: cannot be removed (%2).</source>
        <translation>%1: cannot be removed (%2).</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2).</source>
        <translation>%1: cannot be written (%2).</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2); what is painted now can be saved, but not recovered.</source>
        <translation>%1: cannot be written (%2); what is painted now can be saved, but not recovered.</translation>
    </message>
    <message>
        <source>%1: cannot be written, since this program was built without OpenVDB.</source>
        <translation>%1: cannot be written, since this program was built without OpenVDB.</translation>
    </message>
    <message>
        <source>%1: does not say what was painted on.</source>
        <translation>%1: does not say what was painted on.</translation>
    </message>
    <message>
        <source>%1: expected the name of a pigment.</source>
        <translation>%1: expected the name of a pigment.</translation>
    </message>
    <message>
        <source>%1: ffmpeg cannot be started (%2).</source>
        <translation>%1: ffmpeg cannot be started (%2).</translation>
    </message>
    <message>
        <source>%1: ffmpeg cannot make the video (%2).</source>
        <translation>%1: ffmpeg cannot make the video (%2).</translation>
    </message>
    <message>
        <source>%1: holds a number that is too large (%2).</source>
        <translation>%1: holds a number that is too large (%2).</translation>
    </message>
    <message>
        <source>%1: holds a number that is too large.</source>
        <translation>%1: holds a number that is too large.</translation>
    </message>
    <message>
        <source>%1: holds an ICC profile for %2, but the picture&apos;s values are red, green and blue.</source>
        <translation>%1: holds an ICC profile for %2, but the picture&apos;s values are red, green and blue.</translation>
    </message>
    <message>
        <source>%1: holds an ICC profile that cannot be applied (%2).</source>
        <translation>%1: holds an ICC profile that cannot be applied (%2).</translation>
    </message>
    <message>
        <source>%1: holds an ICC profile that is none (%2).</source>
        <translation>%1: holds an ICC profile that is none (%2).</translation>
    </message>
    <message>
        <source>%1: holds frames of another time-lapse; name another folder, or remove them.</source>
        <translation>%1: holds frames of another time-lapse; name another folder, or remove them.</translation>
    </message>
    <message>
        <source>%1: holds no actions of a painting.</source>
        <translation>%1: holds no actions of a painting.</translation>
    </message>
    <message>
        <source>%1: holds no stroke; expected lines &quot;seconds x y pressure&quot;, some with a pressure above 0.</source>
        <translation>%1: holds no stroke; expected lines &quot;seconds x y pressure&quot;, some with a pressure above 0.</translation>
    </message>
    <message>
        <source>%1: holds no strokes that could be painted again.</source>
        <translation>%1: holds no strokes that could be painted again.</translation>
    </message>
    <message>
        <source>%1: is %2, not a file.</source>
        <translation>%1: is %2, not a file.</translation>
    </message>
    <message>
        <source>%1: is an ICC profile for %2, but a picture is written in red, green and blue.</source>
        <translation>%1: is an ICC profile for %2, but a picture is written in red, green and blue.</translation>
    </message>
    <message>
        <source>%1: is an ICC profile for %2, but a screen shows red, green and blue.</source>
        <translation>%1: is an ICC profile for %2, but a screen shows red, green and blue.</translation>
    </message>
    <message>
        <source>%1: is an ICC profile that no colour can be shown with (%2).</source>
        <translation>%1: is an ICC profile that no colour can be shown with (%2).</translation>
    </message>
    <message>
        <source>%1: is an ICC profile that no picture can be written in (%2).</source>
        <translation>%1: is an ICC profile that no picture can be written in (%2).</translation>
    </message>
    <message>
        <source>%1: is an ICC profile that no print can be shown with (%2).</source>
        <translation>%1: is an ICC profile that no print can be shown with (%2).</translation>
    </message>
    <message>
        <source>%1: is an OpenRaster picture of another program; it holds no wet paint.</source>
        <translation>%1: is an OpenRaster picture of another program; it holds no wet paint.</translation>
    </message>
    <message>
        <source>%1: is damaged; %2 actions after it are lost.</source>
        <translation>%1: is damaged; %2 actions after it are lost.</translation>
    </message>
    <message>
        <source>%1: is damaged; 1 action after it is lost.</source>
        <translation>%1: is damaged; 1 action after it is lost.</translation>
    </message>
    <message>
        <source>%1: is damaged; the painting is there, but some of its strokes are missing, so that they cannot be replayed.</source>
        <translation>%1: is damaged; the painting is there, but some of its strokes are missing, so that they cannot be replayed.</translation>
    </message>
    <message>
        <source>%1: is larger than the %2 bytes that are read at most.</source>
        <translation>%1: is larger than the %2 bytes that are read at most.</translation>
    </message>
    <message>
        <source>%1: is no ICC profile (%2).</source>
        <translation>%1: is no ICC profile (%2).</translation>
    </message>
    <message>
        <source>%1: is no OpenRaster file, which would hold %2.</source>
        <translation>%1: is no OpenRaster file, which would hold %2.</translation>
    </message>
    <message>
        <source>%1: is no painting of Pastoso, or its end is missing (%2).</source>
        <translation>%1: is no painting of Pastoso, or its end is missing (%2).</translation>
    </message>
    <message>
        <source>%1: is no painting of Pastoso.</source>
        <translation>%1: is no painting of Pastoso.</translation>
    </message>
    <message>
        <source>%1: is not a list of media in square brackets.</source>
        <translation>%1: is not a list of media in square brackets.</translation>
    </message>
    <message>
        <source>%1: is not an object in braces.</source>
        <translation>%1: is not an object in braces.</translation>
    </message>
    <message>
        <source>%1: is of another moment.</source>
        <translation>%1: is of another moment.</translation>
    </message>
    <message>
        <source>%1: is write-protected; allow writing to it, or choose another name.</source>
        <translation>%1: is write-protected; allow writing to it, or choose another name.</translation>
    </message>
    <message>
        <source>%1: is written, but may be lost in a power cut (%2).</source>
        <translation>%1: is written, but may be lost in a power cut (%2).</translation>
    </message>
    <message>
        <source>%1: keeps frames of %2; choose another folder.</source>
        <translation>%1: keeps frames of %2; choose another folder.</translation>
    </message>
    <message>
        <source>%1: lists and objects are nested more than %2 deep.</source>
        <translation>%1: lists and objects are nested more than %2 deep.</translation>
    </message>
    <message>
        <source>%1: lists and objects stand more than %2 deep in each other.</source>
        <translation>%1: lists and objects stand more than %2 deep in each other.</translation>
    </message>
    <message>
        <source>%1: maps are saved as .png, .tif or .exr; %2 files do not hold heights.</source>
        <translation>%1: maps are saved as .png, .tif or .exr; %2 files do not hold heights.</translation>
    </message>
    <message>
        <source>%1: name is &quot;%2&quot;, which another preset of yours has already.</source>
        <translation>%1: name is &quot;%2&quot;, which another preset of yours has already.</translation>
    </message>
    <message>
        <source>%1: only .exr files hold layers.</source>
        <translation>%1: only .exr files hold layers.</translation>
    </message>
    <message>
        <source>%1: only .exr files hold the layers&apos; heights and normals.</source>
        <translation>%1: only .exr files hold the layers&apos; heights and normals.</translation>
    </message>
    <message>
        <source>%1: the %2 of vertex %3 is not finite; nothing was written.</source>
        <translation>%1: the %2 of vertex %3 is not finite; nothing was written.</translation>
    </message>
    <message>
        <source>%1: the disk is full.</source>
        <translation>%1: the disk is full.</translation>
    </message>
    <message>
        <source>%1: the entry &quot;%2&quot; is missing.</source>
        <translation>%1: the entry &quot;%2&quot; is missing.</translation>
    </message>
    <message>
        <source>%1: the list &quot;%2&quot; of paints is missing.</source>
        <translation>%1: the list &quot;%2&quot; of paints is missing.</translation>
    </message>
    <message>
        <source>%1: the name &quot;%2&quot; begins with #, as only colours do.</source>
        <translation>%1: the name &quot;%2&quot; begins with #, as only colours do.</translation>
    </message>
    <message>
        <source>%1: the name must end in .pbrt, .obj, .ply or .stl. Choose one of them.</source>
        <translation>%1: the name must end in .pbrt, .obj, .ply or .stl. Choose one of them.</translation>
    </message>
    <message>
        <source>%1: the pigment &quot;%2&quot; has no line for %3.</source>
        <translation>%1: the pigment &quot;%2&quot; has no line for %3.</translation>
    </message>
    <message>
        <source>%1: the readings go from %2 to %3 nm; a light is needed from 400 to 700 nm.</source>
        <translation>%1: the readings go from %2 to %3 nm; a light is needed from 400 to 700 nm.</translation>
    </message>
    <message>
        <source>%1: the system refuses this (%2).</source>
        <translation>%1: the system refuses this (%2).</translation>
    </message>
    <message>
        <source>%1: the weights add up to %2 instead of 1.</source>
        <translation>%1: the weights add up to %2 instead of 1.</translation>
    </message>
    <message>
        <source>%1: there are more than %2 triangles.</source>
        <translation>%1: there are more than %2 triangles.</translation>
    </message>
    <message>
        <source>%1: there is already a pigment &quot;%2&quot;; give yours another name.</source>
        <translation>%1: there is already a pigment &quot;%2&quot;; give yours another name.</translation>
    </message>
    <message>
        <source>%1: there is no colour in this palette.</source>
        <translation>%1: there is no colour in this palette.</translation>
    </message>
    <message>
        <source>%1: there is no pigment &quot;%2&quot;.</source>
        <translation>%1: there is no pigment &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>%1: there is no pigment in this file.</source>
        <translation>%1: there is no pigment in this file.</translation>
    </message>
    <message>
        <source>%1: there is no reading of a light in this file.</source>
        <translation>%1: there is no reading of a light in this file.</translation>
    </message>
    <message>
        <source>%1: this file of the program itself is missing; reinstall it or set PASTOSO_RESOURCES to the folder that holds it.</source>
        <translation>%1: this file of the program itself is missing; reinstall it or set PASTOSO_RESOURCES to the folder that holds it.</translation>
    </message>
    <message>
        <source>%1: this folder cannot be made (%2).</source>
        <translation>%1: this folder cannot be made (%2).</translation>
    </message>
    <message>
        <source>%1: this format holds linear light, which needs no ICC profile.</source>
        <translation>%1: this format holds linear light, which needs no ICC profile.</translation>
    </message>
    <message>
        <source>%1: this is not valid JSON.</source>
        <translation>%1: this is not valid JSON.</translation>
    </message>
    <message>
        <source>%1: this light has no power that is seen.</source>
        <translation>%1: this light has no power that is seen.</translation>
    </message>
    <message>
        <source>%1: this light is so nearly a pure colour that nothing looks white in it.</source>
        <translation>%1: this light is so nearly a pure colour that nothing looks white in it.</translation>
    </message>
    <message>
        <source>%1: this part of the program cannot be loaded (%2).</source>
        <translation>%1: this part of the program cannot be loaded (%2).</translation>
    </message>
    <message>
        <source>%1: this part of the program is of another version; reinstall it.</source>
        <translation>%1: this part of the program is of another version; reinstall it.</translation>
    </message>
    <message>
        <source>%1: was saved by Pastoso with another form of %2; where nothing is painted, the canvas looks different.</source>
        <translation>%1: was saved by Pastoso with another form of %2; where nothing is painted, the canvas looks different.</translation>
    </message>
    <message>
        <source>16-bit pictures</source>
        <translation>16-bit pictures</translation>
    </message>
    <message>
        <source>8-bit pictures</source>
        <translation>8-bit pictures</translation>
    </message>
    <message>
        <source>&lt;%1&gt; is left out.</source>
        <translation>&lt;%1&gt; is left out.</translation>
    </message>
    <message>
        <source>A brush needs a name.</source>
        <translation>A brush needs a name.</translation>
    </message>
    <message>
        <source>A canvas of %1 x %2 mm at %3 px/mm</source>
        <translation>A canvas of %1 x %2 mm at %3 px/mm</translation>
    </message>
    <message>
        <source>A diffusivity of %1 m2/s over %2 s; both must be 0 or more.</source>
        <translation>A diffusivity of %1 m2/s over %2 s; both must be 0 or more.</translation>
    </message>
    <message>
        <source>A diffusivity or viscosity of %1 m2/s is too large for a step of %2 s.</source>
        <translation>A diffusivity or viscosity of %1 m2/s is too large for a step of %2 s.</translation>
    </message>
    <message>
        <source>A parcel&apos;s ball</source>
        <translation>A parcel&apos;s ball</translation>
    </message>
    <message>
        <source>A parcel&apos;s coldness</source>
        <translation>A parcel&apos;s coldness</translation>
    </message>
    <message>
        <source>A parcel&apos;s place</source>
        <translation>A parcel&apos;s place</translation>
    </message>
    <message>
        <source>A parcel&apos;s shape is none.</source>
        <translation>A parcel&apos;s shape is none.</translation>
    </message>
    <message>
        <source>A parcel&apos;s volume</source>
        <translation>A parcel&apos;s volume</translation>
    </message>
    <message>
        <source>A particle of this state is not within the tank.</source>
        <translation>A particle of this state is not within the tank.</translation>
    </message>
    <message>
        <source>A picture</source>
        <translation>A picture</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels is larger than the 268 million that can be rendered.</source>
        <translation>A picture of %1 x %2 pixels is larger than the 268 million that can be rendered.</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels is larger than the 32768 a side that can be made.</source>
        <translation>A picture of %1 x %2 pixels is larger than the 32768 a side that can be made.</translation>
    </message>
    <message>
        <source>A relief of %1 x %2 points is more than the 25 million that can be made; a coarser resolution takes fewer.</source>
        <translation>A relief of %1 x %2 points is more than the 25 million that can be made; a coarser resolution takes fewer.</translation>
    </message>
    <message>
        <source>Cannot make the folder %1: %2.</source>
        <translation>Cannot make the folder %1: %2.</translation>
    </message>
    <message>
        <source>Cannot write </source>
        <translation>Cannot write </translation>
    </message>
    <message>
        <source>Cup, box, cells, time step, seed and the recipe&apos;s milk cannot change while the tea runs.</source>
        <translation>Cup, box, cells, time step, seed and the recipe&apos;s milk cannot change while the tea runs.</translation>
    </message>
    <message>
        <source>Nothing has been painted yet that a film could show.</source>
        <translation>Nothing has been painted yet that a film could show.</translation>
    </message>
    <message>
        <source>OpenGL reports error %1</source>
        <translation>OpenGL reports error %1</translation>
    </message>
    <message>
        <source>PASTOSO_ISA is &quot;%1&quot;, but there are baseline, avx2 and avx512.</source>
        <translation>PASTOSO_ISA is &quot;%1&quot;, but there are baseline, avx2 and avx512.</translation>
    </message>
    <message>
        <source>The %1 of the canvas is %2 %3, but must lie between %4 and %5.</source>
        <translation>The %1 of the canvas is %2 %3, but must lie between %4 and %5.</translation>
    </message>
    <message>
        <source>The box of liquid has %1 x %2 x %3 cells; each side may have 2 to %4.</source>
        <translation>The box of liquid has %1 x %2 x %3 cells; each side may have 2 to %4.</translation>
    </message>
    <message>
        <source>The cells of the box of liquid are %1 m wide, which is no size.</source>
        <translation>The cells of the box of liquid are %1 m wide, which is no size.</translation>
    </message>
    <message>
        <source>The cup&apos;s radius at its level</source>
        <translation>The cup&apos;s radius at its level</translation>
    </message>
    <message>
        <source>The diffusivity or viscosity is %1 m2/s; it must be 0 or more.</source>
        <translation>The diffusivity or viscosity is %1 m2/s; it must be 0 or more.</translation>
    </message>
    <message>
        <source>The file needs a name.</source>
        <translation>The file needs a name.</translation>
    </message>
    <message>
        <source>The film is of %1 media, but may be of %2 at most.</source>
        <translation>The film is of %1 media, but may be of %2 at most.</translation>
    </message>
    <message>
        <source>The folder %1 holds the frames of another time-lapse; name another one.</source>
        <translation>The folder %1 holds the frames of another time-lapse; name another one.</translation>
    </message>
    <message>
        <source>The graphics card cannot draw the canvas: %1.</source>
        <translation>The graphics card cannot draw the canvas: %1.</translation>
    </message>
    <message>
        <source>The graphics driver refuses a program that pictures are drawn with: %1</source>
        <translation>The graphics driver refuses a program that pictures are drawn with: %1</translation>
    </message>
    <message>
        <source>The height of the support</source>
        <translation>The height of the support</translation>
    </message>
    <message>
        <source>The latest strokes %1</source>
        <translation>The latest strokes %1</translation>
    </message>
    <message>
        <source>The light&apos;s %1 is %2, outside the range from %3 to %4.</source>
        <translation>The light&apos;s %1 is %2, outside the range from %3 to %4.</translation>
    </message>
    <message>
        <source>The milk that was poured</source>
        <translation>The milk that was poured</translation>
    </message>
    <message>
        <source>The next ball&apos;s time</source>
        <translation>The next ball&apos;s time</translation>
    </message>
    <message>
        <source>The number of balls</source>
        <translation>The number of balls</translation>
    </message>
    <message>
        <source>The number of parcels</source>
        <translation>The number of parcels</translation>
    </message>
    <message>
        <source>The painting is as it was saved, but its strokes %1</source>
        <translation>The painting is as it was saved, but its strokes %1</translation>
    </message>
    <message>
        <source>The painting is recovered up to an action that cannot be repeated: %1</source>
        <translation>The painting is recovered up to an action that cannot be repeated: %1</translation>
    </message>
    <message>
        <source>The painting is whole, but its strokes cannot be replayed: %1</source>
        <translation>The painting is whole, but its strokes cannot be replayed: %1</translation>
    </message>
    <message>
        <source>The part of the canvas to render is empty or reaches beyond the canvas.</source>
        <translation>The part of the canvas to render is empty or reaches beyond the canvas.</translation>
    </message>
    <message>
        <source>The picture&apos;s scale is %1 pixels per cell, outside the range from 1/64 to 64.</source>
        <translation>The picture&apos;s scale is %1 pixels per cell, outside the range from 1/64 to 64.</translation>
    </message>
    <message>
        <source>The pressure is allowed %1 iterations; it needs at least 1.</source>
        <translation>The pressure is allowed %1 iterations; it needs at least 1.</translation>
    </message>
    <message>
        <source>The pressure&apos;s tolerance is %1; it may be 1e-7 to 1.</source>
        <translation>The pressure&apos;s tolerance is %1; it may be 1e-7 to 1.</translation>
    </message>
    <message>
        <source>The relief&apos;s %1 is %2, outside the range from %3 to %4.</source>
        <translation>The relief&apos;s %1 is %2, outside the range from %3 to %4.</translation>
    </message>
    <message>
        <source>The state is that of another box of cells.</source>
        <translation>The state is that of another box of cells.</translation>
    </message>
    <message>
        <source>The step</source>
        <translation>The step</translation>
    </message>
    <message>
        <source>The stream&apos;s end</source>
        <translation>The stream&apos;s end</translation>
    </message>
    <message>
        <source>The stream&apos;s parcels</source>
        <translation>The stream&apos;s parcels</translation>
    </message>
    <message>
        <source>The stream&apos;s place</source>
        <translation>The stream&apos;s place</translation>
    </message>
    <message>
        <source>The stream&apos;s time</source>
        <translation>The stream&apos;s time</translation>
    </message>
    <message>
        <source>The support &quot;image&quot; needs a height image; none is named.</source>
        <translation>The support &quot;image&quot; needs a height image; none is named.</translation>
    </message>
    <message>
        <source>The thickness of the film</source>
        <translation>The thickness of the film</translation>
    </message>
    <message>
        <source>The time of this state is not one of a tank.</source>
        <translation>The time of this state is not one of a tank.</translation>
    </message>
    <message>
        <source>The time step is %1 s; it must be 0 or more.</source>
        <translation>The time step is %1 s; it must be 0 or more.</translation>
    </message>
    <message>
        <source>The varnish&apos;s %1 is %2, outside the range from 0 to 1.</source>
        <translation>The varnish&apos;s %1 is %2, outside the range from 0 to 1.</translation>
    </message>
    <message>
        <source>The viscosity is %1 m2/s; it must be 0 or more.</source>
        <translation>The viscosity is %1 m2/s; it must be 0 or more.</translation>
    </message>
    <message>
        <source>The vorticity confinement is %1; it may be 0 to 0.3.</source>
        <translation>The vorticity confinement is %1; it may be 0 to 0.3.</translation>
    </message>
    <message>
        <source>The wall&apos;s distance at (%1, %2, %3) m is not a number.</source>
        <translation>The wall&apos;s distance at (%1, %2, %3) m is not a number.</translation>
    </message>
    <message>
        <source>There are %1 values for the %2 x %3 cells of the canvas.</source>
        <translation>There are %1 values for the %2 x %3 cells of the canvas.</translation>
    </message>
    <message>
        <source>There is already a brush &quot;%1&quot;.</source>
        <translation>There is already a brush &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>There is already a file %1.</source>
        <translation>There is already a file %1.</translation>
    </message>
    <message>
        <source>There is no brush &quot;%1&quot;; the brushes are %2.</source>
        <translation>There is no brush &quot;%1&quot;; the brushes are %2.</translation>
    </message>
    <message>
        <source>There is no case &quot;%1&quot;, only %2.</source>
        <translation>There is no case &quot;%1&quot;, only %2.</translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation>There is no folder %1.</translation>
    </message>
    <message>
        <source>There is no light &quot;%1&quot;; there are D65, D50, A and LED, or give the path of a CSV file.</source>
        <translation>There is no light &quot;%1&quot;; there are D65, D50, A and LED, or give the path of a CSV file.</translation>
    </message>
    <message>
        <source>There is no medium &quot;%1&quot;; the media are: %2.</source>
        <translation>There is no medium &quot;%1&quot;; the media are: %2.</translation>
    </message>
    <message>
        <source>There is no picture yet that could be saved.</source>
        <translation>There is no picture yet that could be saved.</translation>
    </message>
    <message>
        <source>There is no pigment &quot;%1&quot;; %2</source>
        <translation>There is no pigment &quot;%1&quot;; %2</translation>
    </message>
    <message>
        <source>There is no pigment &quot;%1&quot;; did you mean %2; %3</source>
        <translation>There is no pigment &quot;%1&quot;; did you mean %2; %3</translation>
    </message>
    <message>
        <source>There is no scene &quot;%1&quot;; give a file ending in .json, or one of: %2.</source>
        <translation>There is no scene &quot;%1&quot;; give a file ending in .json, or one of: %2.</translation>
    </message>
    <message>
        <source>There is no support &quot;%1&quot;; the supports are: %2.</source>
        <translation>There is no support &quot;%1&quot;; the supports are: %2.</translation>
    </message>
    <message>
        <source>This is the state of a level set, not of particles.</source>
        <translation>This is the state of a level set, not of particles.</translation>
    </message>
    <message>
        <source>This is the state of a tank that is followed in another way.</source>
        <translation>This is the state of a tank that is followed in another way.</translation>
    </message>
    <message>
        <source>This is the state of another tank.</source>
        <translation>This is the state of another tank.</translation>
    </message>
    <message>
        <source>a bristle holds what none can.</source>
        <translation>a bristle holds what none can.</translation>
    </message>
    <message>
        <source>a cap is at most a half sphere: its thickness %1 must lie above 0 and not above its radius %2.</source>
        <translation>a cap is at most a half sphere: its thickness %1 must lie above 0 and not above its radius %2.</translation>
    </message>
    <message>
        <source>a cell holds more of its media than it holds paint.</source>
        <translation>a cell holds more of its media than it holds paint.</translation>
    </message>
    <message>
        <source>a combination has no parts.</source>
        <translation>a combination has no parts.</translation>
    </message>
    <message>
        <source>a corner of triangle %1 is not finite (%2).</source>
        <translation>a corner of triangle %1 is not finite (%2).</translation>
    </message>
    <message>
        <source>a corner stands outside of a loop.</source>
        <translation>a corner stands outside of a loop.</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>a device</translation>
    </message>
    <message>
        <source>a document type is not read here.</source>
        <translation>a document type is not read here.</translation>
    </message>
    <message>
        <source>a face has %1 corners, not three or more.</source>
        <translation>a face has %1 corners, not three or more.</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>a file</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>a folder</translation>
    </message>
    <message>
        <source>a glass of milk tea</source>
        <translation>a glass of milk tea</translation>
    </message>
    <message>
        <source>a group needs a layer.</source>
        <translation>a group needs a layer.</translation>
    </message>
    <message>
        <source>a height of the support</source>
        <translation>a height of the support</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>a list</translation>
    </message>
    <message>
        <source>a loop begins within another one.</source>
        <translation>a loop begins within another one.</translation>
    </message>
    <message>
        <source>a loop ends that has no three corners.</source>
        <translation>a loop ends that has no three corners.</translation>
    </message>
    <message>
        <source>a mixture</source>
        <translation>a mixture</translation>
    </message>
    <message>
        <source>a named pipe</source>
        <translation>a named pipe</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>a number</translation>
    </message>
    <message>
        <source>a number is missing.</source>
        <translation>a number is missing.</translation>
    </message>
    <message>
        <source>a painting has 1 to %1 layers, not %2.</source>
        <translation>a painting has 1 to %1 layers, not %2.</translation>
    </message>
    <message>
        <source>a painting has at most %1 layers.</source>
        <translation>a painting has at most %1 layers.</translation>
    </message>
    <message>
        <source>a painting keeps its last layer.</source>
        <translation>a painting keeps its last layer.</translation>
    </message>
    <message>
        <source>a picture on it has no strokes, and comes no finer than it is.</source>
        <translation>a picture on it has no strokes, and comes no finer than it is.</translation>
    </message>
    <message>
        <source>a point of an outline has two numbers, x and y.</source>
        <translation>a point of an outline has two numbers, x and y.</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>a pressure</translation>
    </message>
    <message>
        <source>a pressure curve leads from 0 to 1 and never falls.</source>
        <translation>a pressure curve leads from 0 to 1 and never falls.</translation>
    </message>
    <message>
        <source>a reflectance</source>
        <translation>a reflectance</translation>
    </message>
    <message>
        <source>a run is named by up to 64 small letters, digits and hyphens.</source>
        <translation>a run is named by up to 64 small letters, digits and hyphens.</translation>
    </message>
    <message>
        <source>a scene</source>
        <translation>a scene</translation>
    </message>
    <message>
        <source>a scene of a glass tank</source>
        <translation>a scene of a glass tank</translation>
    </message>
    <message>
        <source>a shape is an object with one entry, its form, which is one of %1.</source>
        <translation>a shape is an object with one entry, its form, which is one of %1.</translation>
    </message>
    <message>
        <source>a socket</source>
        <translation>a socket</translation>
    </message>
    <message>
        <source>a stroke needs at least one sample.</source>
        <translation>a stroke needs at least one sample.</translation>
    </message>
    <message>
        <source>a stroke recording</source>
        <translation>a stroke recording</translation>
    </message>
    <message>
        <source>a stroke that goes on stays on its surface.</source>
        <translation>a stroke that goes on stays on its surface.</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>a text</translation>
    </message>
    <message>
        <source>a thickness</source>
        <translation>a thickness</translation>
    </message>
    <message>
        <source>a thickness of dry paint</source>
        <translation>a thickness of dry paint</translation>
    </message>
    <message>
        <source>a tilt needs millimetres; in cells give &quot;gravity&quot;.</source>
        <translation>a tilt needs millimetres; in cells give &quot;gravity&quot;.</translation>
    </message>
    <message>
        <source>a triangle has more than three corners.</source>
        <translation>a triangle has more than three corners.</translation>
    </message>
    <message>
        <source>a velocity</source>
        <translation>a velocity</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>a whole number</translation>
    </message>
    <message>
        <source>alpha_min is %1, it must not be larger than alpha_max, %2.</source>
        <translation>alpha_min is %1, it must not be larger than alpha_max, %2.</translation>
    </message>
    <message>
        <source>ambient share</source>
        <translation>ambient share</translation>
    </message>
    <message>
        <source>amount</source>
        <translation>amount</translation>
    </message>
    <message>
        <source>an amount of a medium</source>
        <translation>an amount of a medium</translation>
    </message>
    <message>
        <source>an amount of dry pigment</source>
        <translation>an amount of dry pigment</translation>
    </message>
    <message>
        <source>an amount of paint</source>
        <translation>an amount of paint</translation>
    </message>
    <message>
        <source>an exception of an unknown kind</source>
        <translation>an exception of an unknown kind</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>an object</translation>
    </message>
    <message>
        <source>aside</source>
        <translation>aside</translation>
    </message>
    <message>
        <source>at least one run is needed.</source>
        <translation>at least one run is needed.</translation>
    </message>
    <message>
        <source>axis of the symmetry</source>
        <translation>axis of the symmetry</translation>
    </message>
    <message>
        <source>azimuth in degrees</source>
        <translation>azimuth in degrees</translation>
    </message>
    <message>
        <source>bare support</source>
        <translation>bare support</translation>
    </message>
    <message>
        <source>base in mm</source>
        <translation>base in mm</translation>
    </message>
    <message>
        <source>belongs to another scene.</source>
        <translation>belongs to another scene.</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>blue</translation>
    </message>
    <message>
        <source>camera eye</source>
        <translation>camera eye</translation>
    </message>
    <message>
        <source>camera target</source>
        <translation>camera target</translation>
    </message>
    <message>
        <source>cannot be read (%1).</source>
        <translation>cannot be read (%1).</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>cannot be read to its end</translation>
    </message>
    <message>
        <source>canvas</source>
        <translation>canvas</translation>
    </message>
    <message>
        <source>cell (%1, %2) holds %3 that cannot be.</source>
        <translation>cell (%1, %2) holds %3 that cannot be.</translation>
    </message>
    <message>
        <source>cell (%1, %2) holds a lower stratum that is no part of its paint.</source>
        <translation>cell (%1, %2) holds a lower stratum that is no part of its paint.</translation>
    </message>
    <message>
        <source>checkpoint of a tank</source>
        <translation>checkpoint of a tank</translation>
    </message>
    <message>
        <source>checkpoint of tea</source>
        <translation>checkpoint of tea</translation>
    </message>
    <message>
        <source>column %1 (%2): %3</source>
        <translation>column %1 (%2): %3</translation>
    </message>
    <message>
        <source>cup axis</source>
        <translation>cup axis</translation>
    </message>
    <message>
        <source>cup floor</source>
        <translation>cup floor</translation>
    </message>
    <message>
        <source>cup foot</source>
        <translation>cup foot</translation>
    </message>
    <message>
        <source>cup level</source>
        <translation>cup level</translation>
    </message>
    <message>
        <source>cup radius at the foot</source>
        <translation>cup radius at the foot</translation>
    </message>
    <message>
        <source>cup radius at the rim</source>
        <translation>cup radius at the rim</translation>
    </message>
    <message>
        <source>cup rim</source>
        <translation>cup rim</translation>
    </message>
    <message>
        <source>cup slope</source>
        <translation>cup slope</translation>
    </message>
    <message>
        <source>cup wall</source>
        <translation>cup wall</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>degrees</translation>
    </message>
    <message>
        <source>dent</source>
        <translation>dent</translation>
    </message>
    <message>
        <source>dent depth</source>
        <translation>dent depth</translation>
    </message>
    <message>
        <source>dent radius</source>
        <translation>dent radius</translation>
    </message>
    <message>
        <source>direction of the tilt</source>
        <translation>direction of the tilt</translation>
    </message>
    <message>
        <source>distance from eye to target</source>
        <translation>distance from eye to target</translation>
    </message>
    <message>
        <source>distance of the ruler&apos;s points</source>
        <translation>distance of the ruler&apos;s points</translation>
    </message>
    <message>
        <source>elevation in degrees</source>
        <translation>elevation in degrees</translation>
    </message>
    <message>
        <source>ellipse&apos;s centre</source>
        <translation>ellipse&apos;s centre</translation>
    </message>
    <message>
        <source>event %1: %2</source>
        <translation>event %1: %2</translation>
    </message>
    <message>
        <source>exaggeration</source>
        <translation>exaggeration</translation>
    </message>
    <message>
        <source>expected &quot;%1&quot;.</source>
        <translation>expected &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>expected &quot;levels&quot; or &quot;fine&quot;.</source>
        <translation>expected &quot;levels&quot; or &quot;fine&quot;.</translation>
    </message>
    <message>
        <source>expected &quot;none&quot;, &quot;several&quot; or the numbers of one.</source>
        <translation>expected &quot;none&quot;, &quot;several&quot; or the numbers of one.</translation>
    </message>
    <message>
        <source>expected %1 media at most.</source>
        <translation>expected %1 media at most.</translation>
    </message>
    <message>
        <source>expected %1 numbers, one for each tile.</source>
        <translation>expected %1 numbers, one for each tile.</translation>
    </message>
    <message>
        <source>expected %1 numbers.</source>
        <translation>expected %1 numbers.</translation>
    </message>
    <message>
        <source>expected %1, found %2.</source>
        <translation>expected %1, found %2.</translation>
    </message>
    <message>
        <source>expected 0 or more.</source>
        <translation>expected 0 or more.</translation>
    </message>
    <message>
        <source>expected 0 to 10000.</source>
        <translation>expected 0 to 10000.</translation>
    </message>
    <message>
        <source>expected 0 to 10000000.</source>
        <translation>expected 0 to 10000000.</translation>
    </message>
    <message>
        <source>expected 0 to a million seconds.</source>
        <translation>expected 0 to a million seconds.</translation>
    </message>
    <message>
        <source>expected 1 to %1 layers.</source>
        <translation>expected 1 to %1 layers.</translation>
    </message>
    <message>
        <source>expected 4 numbers, seconds x y pressure, found %1.</source>
        <translation>expected 4 numbers, seconds x y pressure, found %1.</translation>
    </message>
    <message>
        <source>expected a colour and its name, for example [&quot;#783c14&quot;, &quot;Umber&quot;].</source>
        <translation>expected a colour and its name, for example [&quot;#783c14&quot;, &quot;Umber&quot;].</translation>
    </message>
    <message>
        <source>expected a name that begins with pastoso/.</source>
        <translation>expected a name that begins with pastoso/.</translation>
    </message>
    <message>
        <source>expected a number for &quot;%1&quot;.</source>
        <translation>expected a number for &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>expected a number from 1 to 1000.</source>
        <translation>expected a number from 1 to 1000.</translation>
    </message>
    <message>
        <source>expected a pigment and its parts, for example [&quot;PB29&quot;, 1].</source>
        <translation>expected a pigment and its parts, for example [&quot;PB29&quot;, 1].</translation>
    </message>
    <message>
        <source>expected a width and a height.</source>
        <translation>expected a width and a height.</translation>
    </message>
    <message>
        <source>expected an amount of paint up to 1e18.</source>
        <translation>expected an amount of paint up to 1e18.</translation>
    </message>
    <message>
        <source>expected four numbers, [left, top, right, bottom].</source>
        <translation>expected four numbers, [left, top, right, bottom].</translation>
    </message>
    <message>
        <source>expected four whole numbers, [left, top, right, bottom].</source>
        <translation>expected four whole numbers, [left, top, right, bottom].</translation>
    </message>
    <message>
        <source>expected one number for each medium.</source>
        <translation>expected one number for each medium.</translation>
    </message>
    <message>
        <source>expected one of %1 beside the tick.</source>
        <translation>expected one of %1 beside the tick.</translation>
    </message>
    <message>
        <source>expected sixteen hexadecimal digits.</source>
        <translation>expected sixteen hexadecimal digits.</translation>
    </message>
    <message>
        <source>expected the first tile and how many there are.</source>
        <translation>expected the first tile and how many there are.</translation>
    </message>
    <message>
        <source>expected the name of a file in the journal&apos;s folder.</source>
        <translation>expected the name of a file in the journal&apos;s folder.</translation>
    </message>
    <message>
        <source>expected three numbers, found %1.</source>
        <translation>expected three numbers, found %1.</translation>
    </message>
    <message>
        <source>expected three whole numbers, found %1.</source>
        <translation>expected three whole numbers, found %1.</translation>
    </message>
    <message>
        <source>expected two numbers, [width, height].</source>
        <translation>expected two numbers, [width, height].</translation>
    </message>
    <message>
        <source>expected two numbers, [x, y].</source>
        <translation>expected two numbers, [x, y].</translation>
    </message>
    <message>
        <source>expected two numbers, for example [0.5, 0.7].</source>
        <translation>expected two numbers, for example [0.5, 0.7].</translation>
    </message>
    <message>
        <source>expected two numbers, for example [20, 30].</source>
        <translation>expected two numbers, for example [20, 30].</translation>
    </message>
    <message>
        <source>fill of the brush</source>
        <translation>fill of the brush</translation>
    </message>
    <message>
        <source>frame of tea</source>
        <translation>frame of tea</translation>
    </message>
    <message>
        <source>green</source>
        <translation>green</translation>
    </message>
    <message>
        <source>group of the layer</source>
        <translation>group of the layer</translation>
    </message>
    <message>
        <source>grouping layers that do not lie next to each other would tear a group of layers apart.</source>
        <translation>grouping layers that do not lie next to each other would tear a group of layers apart.</translation>
    </message>
    <message>
        <source>half height of the ellipse</source>
        <translation>half height of the ellipse</translation>
    </message>
    <message>
        <source>half width of the ellipse</source>
        <translation>half width of the ellipse</translation>
    </message>
    <message>
        <source>has %1 x %2 pixels, but at most 32768 a side and 100 million in all are read.</source>
        <translation>has %1 x %2 pixels, but at most 32768 a side and 100 million in all are read.</translation>
    </message>
    <message>
        <source>height</source>
        <translation>height</translation>
    </message>
    <message>
        <source>height of the new canvas</source>
        <translation>height of the new canvas</translation>
    </message>
    <message>
        <source>height of the picture</source>
        <translation>height of the picture</translation>
    </message>
    <message>
        <source>holds %1 bytes, but at most %2 are possible here.</source>
        <translation>holds %1 bytes, but at most %2 are possible here.</translation>
    </message>
    <message>
        <source>holds a parcel (number %1) whose shape is none.</source>
        <translation>holds a parcel (number %1) whose shape is none.</translation>
    </message>
    <message>
        <source>holds a parcel (number %1) whose values are not finite.</source>
        <translation>holds a parcel (number %1) whose values are not finite.</translation>
    </message>
    <message>
        <source>holds a particle whose numbers are not finite.</source>
        <translation>holds a particle whose numbers are not finite.</translation>
    </message>
    <message>
        <source>holds a value of a cell that is not finite.</source>
        <translation>holds a value of a cell that is not finite.</translation>
    </message>
    <message>
        <source>holds a value that is not a finite number.</source>
        <translation>holds a value that is not a finite number.</translation>
    </message>
    <message>
        <source>holds an ICC profile that is none (it is damaged).</source>
        <translation>holds an ICC profile that is none (it is damaged).</translation>
    </message>
    <message>
        <source>holds sizes or numbers that no tank has.</source>
        <translation>holds sizes or numbers that no tank has.</translation>
    </message>
    <message>
        <source>holds sizes or numbers that no tea has.</source>
        <translation>holds sizes or numbers that no tea has.</translation>
    </message>
    <message>
        <source>holds sizes or times that no frame has.</source>
        <translation>holds sizes or times that no frame has.</translation>
    </message>
    <message>
        <source>holds the paint of another brush than the one %1, which has %2 bristles.</source>
        <translation>holds the paint of another brush than the one %1, which has %2 bristles.</translation>
    </message>
    <message>
        <source>in hand</source>
        <translation>in hand</translation>
    </message>
    <message>
        <source>is cut off: the end of the JPEG picture is missing.</source>
        <translation>is cut off: the end of the JPEG picture is missing.</translation>
    </message>
    <message>
        <source>is damaged (%1).</source>
        <translation>is damaged (%1).</translation>
    </message>
    <message>
        <source>is damaged (it cannot be decompressed, or its checksum is another).</source>
        <translation>is damaged (it cannot be decompressed, or its checksum is another).</translation>
    </message>
    <message>
        <source>is damaged (it ends within its first %1 bytes).</source>
        <translation>is damaged (it ends within its first %1 bytes).</translation>
    </message>
    <message>
        <source>is damaged (it is longer than it says).</source>
        <translation>is damaged (it is longer than it says).</translation>
    </message>
    <message>
        <source>is damaged (it is shorter than it says).</source>
        <translation>is damaged (it is shorter than it says).</translation>
    </message>
    <message>
        <source>is damaged (its checksum is another).</source>
        <translation>is damaged (its checksum is another).</translation>
    </message>
    <message>
        <source>is damaged (its header reaches beyond the end).</source>
        <translation>is damaged (its header reaches beyond the end).</translation>
    </message>
    <message>
        <source>is damaged (its length is not the one that is noted).</source>
        <translation>is damaged (its length is not the one that is noted).</translation>
    </message>
    <message>
        <source>is larger than the %1 bytes that are read of a WebP picture at most.</source>
        <translation>is larger than the %1 bytes that are read of a WebP picture at most.</translation>
    </message>
    <message>
        <source>is missing.</source>
        <translation>is missing.</translation>
    </message>
    <message>
        <source>is no %1.</source>
        <translation>is no %1.</translation>
    </message>
    <message>
        <source>is no PNG picture</source>
        <translation>is no PNG picture</translation>
    </message>
    <message>
        <source>is not an image that can be read (it is none of %1).</source>
        <translation>is not an image that can be read (it is none of %1).</translation>
    </message>
    <message>
        <source>is of version %1, this program reads %2.</source>
        <translation>is of version %1, this program reads %2.</translation>
    </message>
    <message>
        <source>is stored in tiles of %1 x %2 pixels, but 8 a side are the least that are read.</source>
        <translation>is stored in tiles of %1 x %2 pixels, but 8 a side are the least that are read.</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>it is damaged</translation>
    </message>
    <message>
        <source>it was reset</source>
        <translation>it was reset</translation>
    </message>
    <message>
        <source>its end is missing</source>
        <translation>its end is missing</translation>
    </message>
    <message>
        <source>its memory does not suffice</source>
        <translation>its memory does not suffice</translation>
    </message>
    <message>
        <source>its strokes %1</source>
        <translation>its strokes %1</translation>
    </message>
    <message>
        <source>its support is a picture, and comes no finer than that.</source>
        <translation>its support is a picture, and comes no finer than that.</translation>
    </message>
    <message>
        <source>lamp radiance</source>
        <translation>lamp radiance</translation>
    </message>
    <message>
        <source>lamp radius</source>
        <translation>lamp radius</translation>
    </message>
    <message>
        <source>lamp towards</source>
        <translation>lamp towards</translation>
    </message>
    <message>
        <source>least height</source>
        <translation>least height</translation>
    </message>
    <message>
        <source>least thickness of wet paint</source>
        <translation>least thickness of wet paint</translation>
    </message>
    <message>
        <source>linear pictures</source>
        <translation>linear pictures</translation>
    </message>
    <message>
        <source>memory ran out: what was asked for last is not done, or not whole.</source>
        <translation>memory ran out: what was asked for last is not done, or not whole.</translation>
    </message>
    <message>
        <source>mesh: &quot;%1&quot; was not read.</source>
        <translation>mesh: &quot;%1&quot; was not read.</translation>
    </message>
    <message>
        <source>mesh: it is not closed: the edge from %1 to %2 is not shared by exactly two triangles that run along it in opposite directions.</source>
        <translation>mesh: it is not closed: the edge from %1 to %2 is not shared by exactly two triangles that run along it in opposite directions.</translation>
    </message>
    <message>
        <source>mesh: there are no triangles.</source>
        <translation>mesh: there are no triangles.</translation>
    </message>
    <message>
        <source>mesh: triangle %1 names vertex %2 of %3.</source>
        <translation>mesh: triangle %1 names vertex %2 of %3.</translation>
    </message>
    <message>
        <source>mesh: vertex %1 lies at %2, which is no place.</source>
        <translation>mesh: vertex %1 lies at %2, which is no place.</translation>
    </message>
    <message>
        <source>milk share</source>
        <translation>milk share</translation>
    </message>
    <message>
        <source>milk share&apos;s cell</source>
        <translation>milk share&apos;s cell</translation>
    </message>
    <message>
        <source>missing; %1</source>
        <translation>missing; %1</translation>
    </message>
    <message>
        <source>mixing well</source>
        <translation>mixing well</translation>
    </message>
    <message>
        <source>most height</source>
        <translation>most height</translation>
    </message>
    <message>
        <source>most thickness of wet paint</source>
        <translation>most thickness of wet paint</translation>
    </message>
    <message>
        <source>moving the group there would tear a group of layers apart.</source>
        <translation>moving the group there would tear a group of layers apart.</translation>
    </message>
    <message>
        <source>moving the layer there would tear a group of layers apart.</source>
        <translation>moving the layer there would tear a group of layers apart.</translation>
    </message>
    <message>
        <source>name of a group</source>
        <translation>name of a group</translation>
    </message>
    <message>
        <source>name of a layer</source>
        <translation>name of a layer</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>no reason given</translation>
    </message>
    <message>
        <source>no reason was given</source>
        <translation>no reason was given</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>number of parts of %1</source>
        <translation>number of parts of %1</translation>
    </message>
    <message>
        <source>number of the group</source>
        <translation>number of the group</translation>
    </message>
    <message>
        <source>number of the layer</source>
        <translation>number of the layer</translation>
    </message>
    <message>
        <source>number of the outline&apos;s points</source>
        <translation>number of the outline&apos;s points</translation>
    </message>
    <message>
        <source>number of the picture&apos;s pixels</source>
        <translation>number of the picture&apos;s pixels</translation>
    </message>
    <message>
        <source>number of the symmetry&apos;s copies</source>
        <translation>number of the symmetry&apos;s copies</translation>
    </message>
    <message>
        <source>opacity of the layer</source>
        <translation>opacity of the layer</translation>
    </message>
    <message>
        <source>opacity of the tracing picture</source>
        <translation>opacity of the tracing picture</translation>
    </message>
    <message>
        <source>other tea</source>
        <translation>other tea</translation>
    </message>
    <message>
        <source>pictures of %1 million pixels are too large; choose a &quot;picture_scale&quot; for at most 100 million.</source>
        <translation>pictures of %1 million pixels are too large; choose a &quot;picture_scale&quot; for at most 100 million.</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pixels</translation>
    </message>
    <message>
        <source>place on the cloth in x</source>
        <translation>place on the cloth in x</translation>
    </message>
    <message>
        <source>place on the cloth in y</source>
        <translation>place on the cloth in y</translation>
    </message>
    <message>
        <source>position</source>
        <translation>position</translation>
    </message>
    <message>
        <source>position of the group</source>
        <translation>position of the group</translation>
    </message>
    <message>
        <source>position of the layer</source>
        <translation>position of the layer</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>pressure</translation>
    </message>
    <message>
        <source>pressure of the pen</source>
        <translation>pressure of the pen</translation>
    </message>
    <message>
        <source>radius of the fan</source>
        <translation>radius of the fan</translation>
    </message>
    <message>
        <source>reach of the guide</source>
        <translation>reach of the guide</translation>
    </message>
    <message>
        <source>receding_angle_deg is %1, it must not be larger than advancing_angle_deg, %2.</source>
        <translation>receding_angle_deg is %1, it must not be larger than advancing_angle_deg, %2.</translation>
    </message>
    <message>
        <source>red</source>
        <translation>red</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>resolution</translation>
    </message>
    <message>
        <source>resolution in mm</source>
        <translation>resolution in mm</translation>
    </message>
    <message>
        <source>rotation of the pen</source>
        <translation>rotation of the pen</translation>
    </message>
    <message>
        <source>roughness on the dry support</source>
        <translation>roughness on the dry support</translation>
    </message>
    <message>
        <source>roughness on wet paint</source>
        <translation>roughness on wet paint</translation>
    </message>
    <message>
        <source>ruler&apos;s first point</source>
        <translation>ruler&apos;s first point</translation>
    </message>
    <message>
        <source>ruler&apos;s second point</source>
        <translation>ruler&apos;s second point</translation>
    </message>
    <message>
        <source>scale of the transform along %1, without its sign,</source>
        <translation>scale of the transform along %1, without its sign,</translation>
    </message>
    <message>
        <source>scene format</source>
        <translation>scene format</translation>
    </message>
    <message>
        <source>scene: %1 is %2, but must be from %3 to %4.</source>
        <translation>scene: %1 is %2, but must be from %3 to %4.</translation>
    </message>
    <message>
        <source>scene: %1 is 0, but must be a direction.</source>
        <translation>scene: %1 is 0, but must be a direction.</translation>
    </message>
    <message>
        <source>scene: %1&apos;s corner is %2, but must be the number of a position.</source>
        <translation>scene: %1&apos;s corner is %2, but must be the number of a position.</translation>
    </message>
    <message>
        <source>scene: %1&apos;s number of normals is %2, but must be 0 or that of its positions.</source>
        <translation>scene: %1&apos;s number of normals is %2, but must be 0 or that of its positions.</translation>
    </message>
    <message>
        <source>scene: there is not enough memory to trace a mesh of %1 triangles.</source>
        <translation>scene: there is not enough memory to trace a mesh of %1 triangles.</translation>
    </message>
    <message>
        <source>seed of the brush</source>
        <translation>seed of the brush</translation>
    </message>
    <message>
        <source>shadow softness in mm</source>
        <translation>shadow softness in mm</translation>
    </message>
    <message>
        <source>share of paint</source>
        <translation>share of paint</translation>
    </message>
    <message>
        <source>share of the second paint</source>
        <translation>share of the second paint</translation>
    </message>
    <message>
        <source>share that is wiped off the brush</source>
        <translation>share that is wiped off the brush</translation>
    </message>
    <message>
        <source>single-precision pictures</source>
        <translation>single-precision pictures</translation>
    </message>
    <message>
        <source>sky above</source>
        <translation>sky above</translation>
    </message>
    <message>
        <source>sky below</source>
        <translation>sky below</translation>
    </message>
    <message>
        <source>smoothing of the stabiliser</source>
        <translation>smoothing of the stabiliser</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>something else</translation>
    </message>
    <message>
        <source>something went wrong within the program (%1).</source>
        <translation>something went wrong within the program (%1).</translation>
    </message>
    <message>
        <source>speed of drying</source>
        <translation>speed of drying</translation>
    </message>
    <message>
        <source>strata that give more light than they get</source>
        <translation>strata that give more light than they get</translation>
    </message>
    <message>
        <source>strength of the fan</source>
        <translation>strength of the fan</translation>
    </message>
    <message>
        <source>strength of the paint</source>
        <translation>strength of the paint</translation>
    </message>
    <message>
        <source>string of the stabiliser</source>
        <translation>string of the stabiliser</translation>
    </message>
    <message>
        <source>stroke format</source>
        <translation>stroke format</translation>
    </message>
    <message>
        <source>support relief</source>
        <translation>support relief</translation>
    </message>
    <message>
        <source>table fading</source>
        <translation>table fading</translation>
    </message>
    <message>
        <source>table height</source>
        <translation>table height</translation>
    </message>
    <message>
        <source>table radius</source>
        <translation>table radius</translation>
    </message>
    <message>
        <source>table reflectance</source>
        <translation>table reflectance</translation>
    </message>
    <message>
        <source>tank format</source>
        <translation>tank format</translation>
    </message>
    <message>
        <source>tank wall</source>
        <translation>tank wall</translation>
    </message>
    <message>
        <source>tea format</source>
        <translation>tea format</translation>
    </message>
    <message>
        <source>tells of strokes that are later than the painting.</source>
        <translation>tells of strokes that are later than the painting.</translation>
    </message>
    <message>
        <source>the %1 &quot;%2&quot; is not a whole number from 0 to 255.</source>
        <translation>the %1 &quot;%2&quot; is not a whole number from 0 to 255.</translation>
    </message>
    <message>
        <source>the %1 %2 is not a number.</source>
        <translation>the %1 %2 is not a number.</translation>
    </message>
    <message>
        <source>the %1 %2 is not between -1e7 and 1e7.</source>
        <translation>the %1 %2 is not between -1e7 and 1e7.</translation>
    </message>
    <message>
        <source>the %1 has %2 bytes, but at most %3 are kept.</source>
        <translation>the %1 has %2 bytes, but at most %3 are kept.</translation>
    </message>
    <message>
        <source>the %1 has %2 x %3 cells, but %4 x %5 of another size are expected.</source>
        <translation>the %1 has %2 x %3 cells, but %4 x %5 of another size are expected.</translation>
    </message>
    <message>
        <source>the %1 in %2 is %3, but must lie between %4 and %5.</source>
        <translation>the %1 in %2 is %3, but must lie between %4 and %5.</translation>
    </message>
    <message>
        <source>the %1 is %2, but must lie between %3 and %4.</source>
        <translation>the %1 is %2, but must lie between %3 and %4.</translation>
    </message>
    <message>
        <source>the %1 is missing.</source>
        <translation>the %1 is missing.</translation>
    </message>
    <message>
        <source>the active layer is none.</source>
        <translation>the active layer is none.</translation>
    </message>
    <message>
        <source>the area is empty.</source>
        <translation>the area is empty.</translation>
    </message>
    <message>
        <source>the brush &quot;%1&quot;</source>
        <translation>the brush &quot;%1&quot;</translation>
    </message>
    <message>
        <source>the brush %1 is told of only in part.</source>
        <translation>the brush %1 is told of only in part.</translation>
    </message>
    <message>
        <source>the disk is full; make room on it, or choose another place</source>
        <translation>the disk is full; make room on it, or choose another place</translation>
    </message>
    <message>
        <source>the elements are nested too deep.</source>
        <translation>the elements are nested too deep.</translation>
    </message>
    <message>
        <source>the entry &quot;%1&quot; is missing.</source>
        <translation>the entry &quot;%1&quot; is missing.</translation>
    </message>
    <message>
        <source>the field &quot;%1&quot; is missing.</source>
        <translation>the field &quot;%1&quot; is missing.</translation>
    </message>
    <message>
        <source>the file ends here, before &quot;endsolid&quot;.</source>
        <translation>the file ends here, before &quot;endsolid&quot;.</translation>
    </message>
    <message>
        <source>the file ends here, within the head of an STL file.</source>
        <translation>the file ends here, within the head of an STL file.</translation>
    </message>
    <message>
        <source>the groups within &quot;%1&quot; become part of it.</source>
        <translation>the groups within &quot;%1&quot; become part of it.</translation>
    </message>
    <message>
        <source>the heading is &quot;%1&quot; instead of &quot;%2&quot;.</source>
        <translation>the heading is &quot;%1&quot; instead of &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is hidden.</source>
        <translation>the layer &quot;%1&quot; is hidden.</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is in a group already.</source>
        <translation>the layer &quot;%1&quot; is in a group already.</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is locked.</source>
        <translation>the layer &quot;%1&quot; is locked.</translation>
    </message>
    <message>
        <source>the layers are too large in all.</source>
        <translation>the layers are too large in all.</translation>
    </message>
    <message>
        <source>the layers of a group do not lie next to each other.</source>
        <translation>the layers of a group do not lie next to each other.</translation>
    </message>
    <message>
        <source>the medium</source>
        <translation>the medium</translation>
    </message>
    <message>
        <source>the palette has %1, yours %2.</source>
        <translation>the palette has %1, yours %2.</translation>
    </message>
    <message>
        <source>the palette has %1.</source>
        <translation>the palette has %1.</translation>
    </message>
    <message>
        <source>the pen touches the canvas with no brush in hand.</source>
        <translation>the pen touches the canvas with no brush in hand.</translation>
    </message>
    <message>
        <source>the pen touches the mixing well with no brush in hand.</source>
        <translation>the pen touches the mixing well with no brush in hand.</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>the picture</translation>
    </message>
    <message>
        <source>the picture %1</source>
        <translation>the picture %1</translation>
    </message>
    <message>
        <source>the picture is no base64.</source>
        <translation>the picture is no base64.</translation>
    </message>
    <message>
        <source>the pictures of this recording are too large; at most 500 million pixels in all are read.</source>
        <translation>the pictures of this recording are too large; at most 500 million pixels in all are read.</translation>
    </message>
    <message>
        <source>the pigment has no name.</source>
        <translation>the pigment has no name.</translation>
    </message>
    <message>
        <source>the power</source>
        <translation>the power</translation>
    </message>
    <message>
        <source>the power %1 is negative.</source>
        <translation>the power %1 is negative.</translation>
    </message>
    <message>
        <source>the preset</source>
        <translation>the preset</translation>
    </message>
    <message>
        <source>the pressure %1 is not between 0 and 1.</source>
        <translation>the pressure %1 is not between 0 and 1.</translation>
    </message>
    <message>
        <source>the size of the picture is missing.</source>
        <translation>the size of the picture is missing.</translation>
    </message>
    <message>
        <source>the system refuses this (%1).</source>
        <translation>the system refuses this (%1).</translation>
    </message>
    <message>
        <source>the tick %1 is earlier than %2 before it.</source>
        <translation>the tick %1 is earlier than %2 before it.</translation>
    </message>
    <message>
        <source>the tiles hold %1 bytes, which has to be the size and at most %2.</source>
        <translation>the tiles hold %1 bytes, which has to be the size and at most %2.</translation>
    </message>
    <message>
        <source>the time %1 s is earlier than %2 s before it.</source>
        <translation>the time %1 s is earlier than %2 s before it.</translation>
    </message>
    <message>
        <source>the time %1 s is not between 0 and 86400 s.</source>
        <translation>the time %1 s is not between 0 and 86400 s.</translation>
    </message>
    <message>
        <source>the wavelength</source>
        <translation>the wavelength</translation>
    </message>
    <message>
        <source>the wavelength %1 nm is not greater than that of the line before.</source>
        <translation>the wavelength %1 nm is not greater than that of the line before.</translation>
    </message>
    <message>
        <source>their paint adds up to more than any canvas holds.</source>
        <translation>their paint adds up to more than any canvas holds.</translation>
    </message>
    <message>
        <source>there are %1 columns instead of %2.</source>
        <translation>there are %1 columns instead of %2.</translation>
    </message>
    <message>
        <source>there are %1 paints, but only %2 have room.</source>
        <translation>there are %1 paints, but only %2 have room.</translation>
    </message>
    <message>
        <source>there are %1 ticks for %2 samples.</source>
        <translation>there are %1 ticks for %2 samples.</translation>
    </message>
    <message>
        <source>there are %1 tools instead of %2.</source>
        <translation>there are %1 tools instead of %2.</translation>
    </message>
    <message>
        <source>there are more than %1 layers.</source>
        <translation>there are more than %1 layers.</translation>
    </message>
    <message>
        <source>there are more than %1 triangles.</source>
        <translation>there are more than %1 triangles.</translation>
    </message>
    <message>
        <source>there are more than %1 vertices.</source>
        <translation>there are more than %1 vertices.</translation>
    </message>
    <message>
        <source>there cannot be a group %1.</source>
        <translation>there cannot be a group %1.</translation>
    </message>
    <message>
        <source>there cannot be a layer %1.</source>
        <translation>there cannot be a layer %1.</translation>
    </message>
    <message>
        <source>there is another run &quot;%1&quot;.</source>
        <translation>there is another run &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>there is no brush in hand to take paint with.</source>
        <translation>there is no brush in hand to take paint with.</translation>
    </message>
    <message>
        <source>there is no field %1.</source>
        <translation>there is no field %1.</translation>
    </message>
    <message>
        <source>there is no form &quot;%1&quot;; the forms are slab, box, disc, cap, gaussian, cosine, noise and image.</source>
        <translation>there is no form &quot;%1&quot;; the forms are slab, box, disc, cap, gaussian, cosine, noise and image.</translation>
    </message>
    <message>
        <source>there is no group %1 of layers.</source>
        <translation>there is no group %1 of layers.</translation>
    </message>
    <message>
        <source>there is no group %1.</source>
        <translation>there is no group %1.</translation>
    </message>
    <message>
        <source>there is no kind of frame %1.</source>
        <translation>there is no kind of frame %1.</translation>
    </message>
    <message>
        <source>there is no layer %1.</source>
        <translation>there is no layer %1.</translation>
    </message>
    <message>
        <source>there is no layer below &quot;%1&quot; to merge it onto.</source>
        <translation>there is no layer below &quot;%1&quot; to merge it onto.</translation>
    </message>
    <message>
        <source>there is no medium in hand.</source>
        <translation>there is no medium in hand.</translation>
    </message>
    <message>
        <source>there is no place %1 for a layer; the highest is %2.</source>
        <translation>there is no place %1 for a layer; the highest is %2.</translation>
    </message>
    <message>
        <source>there is no such entry as &quot;%1&quot; here.</source>
        <translation>there is no such entry as &quot;%1&quot; here.</translation>
    </message>
    <message>
        <source>there is no such kind of tiles as &quot;%1&quot;.</source>
        <translation>there is no such kind of tiles as &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>there is no support &quot;%1&quot;; the supports are flat, %2, weave, image, ramp and bump.</source>
        <translation>there is no support &quot;%1&quot;; the supports are flat, %2, weave, image, ramp and bump.</translation>
    </message>
    <message>
        <source>there is no surface &quot;%1&quot;; a stroke is on the &quot;canvas&quot; or the &quot;well&quot;.</source>
        <translation>there is no surface &quot;%1&quot;; a stroke is on the &quot;canvas&quot; or the &quot;well&quot;.</translation>
    </message>
    <message>
        <source>there is no visible layer to flatten.</source>
        <translation>there is no visible layer to flatten.</translation>
    </message>
    <message>
        <source>there is no way &quot;%1&quot; to select; they are replace, add, subtract and intersect.</source>
        <translation>there is no way &quot;%1&quot; to select; they are replace, add, subtract and intersect.</translation>
    </message>
    <message>
        <source>this is no journal of a painting.</source>
        <translation>this is no journal of a painting.</translation>
    </message>
    <message>
        <source>this is no list of layers; it would begin with &lt;image&gt;.</source>
        <translation>this is no list of layers; it would begin with &lt;image&gt;.</translation>
    </message>
    <message>
        <source>this is no painting of Pastoso; it would begin with &quot;format&quot;: &quot;pastoso-project&quot;.</source>
        <translation>this is no painting of Pastoso; it would begin with &quot;format&quot;: &quot;pastoso-project&quot;.</translation>
    </message>
    <message>
        <source>this is not %1; it would begin with &quot;format&quot;: &quot;%2&quot;.</source>
        <translation>this is not %1; it would begin with &quot;format&quot;: &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>this is not a GIMP palette; it would begin with &quot;GIMP Palette&quot;.</source>
        <translation>this is not a GIMP palette; it would begin with &quot;GIMP Palette&quot;.</translation>
    </message>
    <message>
        <source>this is not valid JSON: %1.</source>
        <translation>this is not valid JSON: %1.</translation>
    </message>
    <message>
        <source>this is not valid XML (%1).</source>
        <translation>this is not valid XML (%1).</translation>
    </message>
    <message>
        <source>this makes %1 cells; 1 to %2 are possible.</source>
        <translation>this makes %1 cells; 1 to %2 are possible.</translation>
    </message>
    <message>
        <source>this must be an object in braces.</source>
        <translation>this must be an object in braces.</translation>
    </message>
    <message>
        <source>this paint</source>
        <translation>this paint</translation>
    </message>
    <message>
        <source>this was written by a newer Pastoso (%1 %2; this program reads up to %3).</source>
        <translation>this was written by a newer Pastoso (%1 %2; this program reads up to %3).</translation>
    </message>
    <message>
        <source>this was written by a newer Pastoso (journal format %1; this program reads up to %2).</source>
        <translation>this was written by a newer Pastoso (journal format %1; this program reads up to %2).</translation>
    </message>
    <message>
        <source>this was written by a newer Pastoso (project format %1; this program reads up to %2).</source>
        <translation>this was written by a newer Pastoso (project format %1; this program reads up to %2).</translation>
    </message>
    <message>
        <source>tile %1 comes twice.</source>
        <translation>tile %1 comes twice.</translation>
    </message>
    <message>
        <source>tile %1 moves as no paint can.</source>
        <translation>tile %1 moves as no paint can.</translation>
    </message>
    <message>
        <source>tile %1 moves, but there is no &quot;window&quot; that it started from.</source>
        <translation>tile %1 moves, but there is no &quot;window&quot; that it started from.</translation>
    </message>
    <message>
        <source>tile %1 sleeps, and yet its motion is followed.</source>
        <translation>tile %1 sleeps, and yet its motion is followed.</translation>
    </message>
    <message>
        <source>tilt of the canvas</source>
        <translation>tilt of the canvas</translation>
    </message>
    <message>
        <source>time</source>
        <translation>time</translation>
    </message>
    <message>
        <source>time of the pen</source>
        <translation>time of the pen</translation>
    </message>
    <message>
        <source>touch_dry_s is %1, it must not be larger than typical_thickness_mm times %2.</source>
        <translation>touch_dry_s is %1, it must not be larger than typical_thickness_mm times %2.</translation>
    </message>
    <message>
        <source>trace settings: a side of the picture is %1, but must be from 1 to 16384 pixels.</source>
        <translation>trace settings: a side of the picture is %1, but must be from 1 to 16384 pixels.</translation>
    </message>
    <message>
        <source>trace settings: brightest is %1, but must be above 0 and finite.</source>
        <translation>trace settings: brightest is %1, but must be above 0 and finite.</translation>
    </message>
    <message>
        <source>trace settings: most_events is %1, but must be at least 1.</source>
        <translation>trace settings: most_events is %1, but must be at least 1.</translation>
    </message>
    <message>
        <source>transform&apos;s centre</source>
        <translation>transform&apos;s centre</translation>
    </message>
    <message>
        <source>transform&apos;s move</source>
        <translation>transform&apos;s move</translation>
    </message>
    <message>
        <source>transform&apos;s scale</source>
        <translation>transform&apos;s scale</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true or false</translation>
    </message>
    <message>
        <source>turn of the ellipse</source>
        <translation>turn of the ellipse</translation>
    </message>
    <message>
        <source>turn of the transform</source>
        <translation>turn of the transform</translation>
    </message>
    <message>
        <source>variation of the share</source>
        <translation>variation of the share</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>version %1</translation>
    </message>
    <message>
        <source>versions %1 to %2</source>
        <translation>versions %1 to %2</translation>
    </message>
    <message>
        <source>volume of the squeezed paint</source>
        <translation>volume of the squeezed paint</translation>
    </message>
    <message>
        <source>were painted with an earlier version of the program (arithmetic %1, now %2): replayed, they come out a little differently.</source>
        <translation>were painted with an earlier version of the program (arithmetic %1, now %2): replayed, they come out a little differently.</translation>
    </message>
    <message>
        <source>width</source>
        <translation>width</translation>
    </message>
    <message>
        <source>width of the brush</source>
        <translation>width of the brush</translation>
    </message>
    <message>
        <source>width of the new canvas</source>
        <translation>width of the new canvas</translation>
    </message>
    <message>
        <source>width of the picture</source>
        <translation>width of the picture</translation>
    </message>
    <message>
        <source>window radiance</source>
        <translation>window radiance</translation>
    </message>
    <message>
        <source>window radius</source>
        <translation>window radius</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x of the %1</source>
        <translation>x of the %1</translation>
    </message>
    <message>
        <source>x of the centre of the symmetry</source>
        <translation>x of the centre of the symmetry</translation>
    </message>
    <message>
        <source>x of the fan</source>
        <translation>x of the fan</translation>
    </message>
    <message>
        <source>x of the new canvas</source>
        <translation>x of the new canvas</translation>
    </message>
    <message>
        <source>x of the pen</source>
        <translation>x of the pen</translation>
    </message>
    <message>
        <source>x of the picture</source>
        <translation>x of the picture</translation>
    </message>
    <message>
        <source>x of the squeezed paint</source>
        <translation>x of the squeezed paint</translation>
    </message>
    <message>
        <source>x tilt of the pen</source>
        <translation>x tilt of the pen</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>y of the %1</source>
        <translation>y of the %1</translation>
    </message>
    <message>
        <source>y of the centre of the symmetry</source>
        <translation>y of the centre of the symmetry</translation>
    </message>
    <message>
        <source>y of the fan</source>
        <translation>y of the fan</translation>
    </message>
    <message>
        <source>y of the new canvas</source>
        <translation>y of the new canvas</translation>
    </message>
    <message>
        <source>y of the pen</source>
        <translation>y of the pen</translation>
    </message>
    <message>
        <source>y of the picture</source>
        <translation>y of the picture</translation>
    </message>
    <message>
        <source>y of the squeezed paint</source>
        <translation>y of the squeezed paint</translation>
    </message>
    <message>
        <source>y tilt of the pen</source>
        <translation>y tilt of the pen</translation>
    </message>
    <message>
        <source>yellowing</source>
        <translation>yellowing</translation>
    </message>
    <message>
        <source>your share of the disk is used up; make room on it, or choose another place</source>
        <translation>your share of the disk is used up; make room on it, or choose another place</translation>
    </message>
    <message>
        <source>difference of the colour</source>
        <translation>difference of the colour</translation>
    </message>
    <message>
        <source>gradient&apos;s point</source>
        <translation>gradient&apos;s point</translation>
    </message>
    <message>
        <source>length of the gradient&apos;s line</source>
        <translation>length of the gradient&apos;s line</translation>
    </message>
    <message>
        <source>no paint has been copied that could be pasted.</source>
        <translation>no paint has been copied that could be pasted.</translation>
    </message>
    <message>
        <source>number of points of the gradient&apos;s line</source>
        <translation>number of points of the gradient&apos;s line</translation>
    </message>
    <message>
        <source>number of quarter turns</source>
        <translation>number of quarter turns</translation>
    </message>
    <message>
        <source>outline&apos;s point</source>
        <translation>outline&apos;s point</translation>
    </message>
    <message>
        <source>there is no visible layer to copy.</source>
        <translation>there is no visible layer to copy.</translation>
    </message>
    <message>
        <source>thickness of the film</source>
        <translation>thickness of the film</translation>
    </message>
    <message>
        <source>way from where it was copied</source>
        <translation>way from where it was copied</translation>
    </message>
    <message>
        <source>width of the margin</source>
        <translation>width of the margin</translation>
    </message>
    <message>
        <source>x of the colour&apos;s place</source>
        <translation>x of the colour&apos;s place</translation>
    </message>
    <message>
        <source>y of the colour&apos;s place</source>
        <translation>y of the colour&apos;s place</translation>
    </message>
    <message>
        <source>%1: is no bundle of tools; it has no %2.</source>
        <translation>%1: is no bundle of tools; it has no %2.</translation>
    </message>
    <message>
        <source>name is &quot;%1&quot;, which another tool of the bundle has already.</source>
        <translation>name is &quot;%1&quot;, which another tool of the bundle has already.</translation>
    </message>
    <message>
        <source>there are %1 tools, more than %2.</source>
        <translation>there are %1 tools, more than %2.</translation>
    </message>
    <message>
        <source>copied paint</source>
        <translation>copied paint</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there twice.</source>
        <translation>&quot;%1&quot; is there twice.</translation>
    </message>
    <message>
        <source>a mix needs a name.</source>
        <translation>a mix needs a name.</translation>
    </message>
    <message>
        <source>a sample has 4 to 8 numbers, time, x, y, pressure, tilt_x, tilt_y, rotation, wheel; here are %1.</source>
        <translation>a sample has 4 to 8 numbers, time, x, y, pressure, tilt_x, tilt_y, rotation, wheel; here are %1.</translation>
    </message>
    <message>
        <source>a set needs a name.</source>
        <translation>a set needs a name.</translation>
    </message>
    <message>
        <source>change of the resolution</source>
        <translation>change of the resolution</translation>
    </message>
    <message>
        <source>scale of the height</source>
        <translation>scale of the height</translation>
    </message>
    <message>
        <source>scale of the width</source>
        <translation>scale of the width</translation>
    </message>
    <message>
        <source>the panel %1 stands there twice.</source>
        <translation>the panel %1 stands there twice.</translation>
    </message>
    <message>
        <source>there are %1 mixes, but only %2 have room.</source>
        <translation>there are %1 mixes, but only %2 have room.</translation>
    </message>
    <message>
        <source>there is no &quot;%1&quot;.</source>
        <translation>there is no &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>there is no panel.</source>
        <translation>there is no panel.</translation>
    </message>
    <message>
        <source>wheel of the pen</source>
        <translation>wheel of the pen</translation>
    </message>
    <message>
        <source>a tag needs a name.</source>
        <translation>a tag needs a name.</translation>
    </message>
    <message>
        <source>corner that is distorted</source>
        <translation>corner that is distorted</translation>
    </message>
    <message>
        <source>diameter of the grains</source>
        <translation>diameter of the grains</translation>
    </message>
    <message>
        <source>direction of the grid&apos;s first lines</source>
        <translation>direction of the grid&apos;s first lines</translation>
    </message>
    <message>
        <source>direction of the grid&apos;s other lines</source>
        <translation>direction of the grid&apos;s other lines</translation>
    </message>
    <message>
        <source>direction of the horizon</source>
        <translation>direction of the horizon</translation>
    </message>
    <message>
        <source>direction of the knife</source>
        <translation>direction of the knife</translation>
    </message>
    <message>
        <source>direction of uprights</source>
        <translation>direction of uprights</translation>
    </message>
    <message>
        <source>expected at most %1 references.</source>
        <translation>expected at most %1 references.</translation>
    </message>
    <message>
        <source>first vanishing point</source>
        <translation>first vanishing point</translation>
    </message>
    <message>
        <source>grid&apos;s point</source>
        <translation>grid&apos;s point</translation>
    </message>
    <message>
        <source>height of the texture</source>
        <translation>height of the texture</translation>
    </message>
    <message>
        <source>holds cells of another canvas than this one.</source>
        <translation>holds cells of another canvas than this one.</translation>
    </message>
    <message>
        <source>holds no cell.</source>
        <translation>holds no cell.</translation>
    </message>
    <message>
        <source>length of a side of the distortion, times what it was,</source>
        <translation>length of a side of the distortion, times what it was,</translation>
    </message>
    <message>
        <source>lower left corner of the distortion</source>
        <translation>lower left corner of the distortion</translation>
    </message>
    <message>
        <source>lower right corner of the distortion</source>
        <translation>lower right corner of the distortion</translation>
    </message>
    <message>
        <source>makes the references larger than any board holds.</source>
        <translation>makes the references larger than any board holds.</translation>
    </message>
    <message>
        <source>masking&apos;s point</source>
        <translation>masking&apos;s point</translation>
    </message>
    <message>
        <source>name of a reference</source>
        <translation>name of a reference</translation>
    </message>
    <message>
        <source>number of the masking&apos;s points</source>
        <translation>number of the masking&apos;s points</translation>
    </message>
    <message>
        <source>number of the reference</source>
        <translation>number of the reference</translation>
    </message>
    <message>
        <source>number of vanishing points</source>
        <translation>number of vanishing points</translation>
    </message>
    <message>
        <source>opacity of the reference</source>
        <translation>opacity of the reference</translation>
    </message>
    <message>
        <source>position of the reference</source>
        <translation>position of the reference</translation>
    </message>
    <message>
        <source>second vanishing point</source>
        <translation>second vanishing point</translation>
    </message>
    <message>
        <source>seed of the texture</source>
        <translation>seed of the texture</translation>
    </message>
    <message>
        <source>size of what is distorted</source>
        <translation>size of what is distorted</translation>
    </message>
    <message>
        <source>spacing of the grid&apos;s first lines</source>
        <translation>spacing of the grid&apos;s first lines</translation>
    </message>
    <message>
        <source>spacing of the grid&apos;s other lines</source>
        <translation>spacing of the grid&apos;s other lines</translation>
    </message>
    <message>
        <source>spacing of the ridges</source>
        <translation>spacing of the ridges</translation>
    </message>
    <message>
        <source>strength of the guide</source>
        <translation>strength of the guide</translation>
    </message>
    <message>
        <source>the board holds %1 references, and no more are kept.</source>
        <translation>the board holds %1 references, and no more are kept.</translation>
    </message>
    <message>
        <source>the corners of the distortion have to go round an area that bends outwards at each of them, by %1 degree or more.</source>
        <translation>the corners of the distortion have to go round an area that bends outwards at each of them, by %1 degree or more.</translation>
    </message>
    <message>
        <source>the name of a reference has %1 bytes, but at most %2 are kept.</source>
        <translation>the name of a reference has %1 bytes, but at most %2 are kept.</translation>
    </message>
    <message>
        <source>the number %1 has not been given yet.</source>
        <translation>the number %1 has not been given yet.</translation>
    </message>
    <message>
        <source>the references on the board are too large; at most %1 million pixels in all are kept.</source>
        <translation>the references on the board are too large; at most %1 million pixels in all are kept.</translation>
    </message>
    <message>
        <source>there are two references %1.</source>
        <translation>there are two references %1.</translation>
    </message>
    <message>
        <source>these are no corners of that mask.</source>
        <translation>these are no corners of that mask.</translation>
    </message>
    <message>
        <source>third vanishing point</source>
        <translation>third vanishing point</translation>
    </message>
    <message>
        <source>turn of the canvas</source>
        <translation>turn of the canvas</translation>
    </message>
    <message>
        <source>turn of the reference</source>
        <translation>turn of the reference</translation>
    </message>
    <message>
        <source>upper left corner of the distortion</source>
        <translation>upper left corner of the distortion</translation>
    </message>
    <message>
        <source>upper right corner of the distortion</source>
        <translation>upper right corner of the distortion</translation>
    </message>
    <message>
        <source>width of the masking</source>
        <translation>width of the masking</translation>
    </message>
    <message>
        <source>width of the reference</source>
        <translation>width of the reference</translation>
    </message>
    <message>
        <source>x of the reference</source>
        <translation>x of the reference</translation>
    </message>
    <message>
        <source>y of the reference</source>
        <translation>y of the reference</translation>
    </message>
    <message>
        <source>a group of layers cannot be clipped; its layers can.</source>
        <translation>a group of layers cannot be clipped; its layers can.</translation>
    </message>
    <message>
        <source>a map has 4 numbers; here are %1.</source>
        <translation>a map has 4 numbers; here are %1.</translation>
    </message>
    <message>
        <source>a stroke that goes on says nothing of where it began.</source>
        <translation>a stroke that goes on says nothing of where it began.</translation>
    </message>
    <message>
        <source>holds a cell that is not masked.</source>
        <translation>holds a cell that is not masked.</translation>
    </message>
    <message>
        <source>radius of the feather</source>
        <translation>radius of the feather</translation>
    </message>
    <message>
        <source>share of the dry paint</source>
        <translation>share of the dry paint</translation>
    </message>
    <message>
        <source>the medium in hand leaves next to nothing when it dries.</source>
        <translation>the medium in hand leaves next to nothing when it dries.</translation>
    </message>
    <message>
        <source>there is no dry paint on &quot;%1&quot; to adjust.</source>
        <translation>there is no dry paint on &quot;%1&quot; to adjust.</translation>
    </message>
    <message>
        <source>thickness of the glaze</source>
        <translation>thickness of the glaze</translation>
    </message>
    <message>
        <source>width of the cloth&apos;s threads</source>
        <translation>width of the cloth&apos;s threads</translation>
    </message>
    <message>
        <source>The cloth has been drawn out too unevenly: for a canvas of %1 x %2 cells, %3 x %4 would have to be woven.</source>
        <translation>The cloth has been drawn out too unevenly: for a canvas of %1 x %2 cells, %3 x %4 would have to be woven.</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is clipped to &quot;%2&quot;, which is hidden.</source>
        <translation>the layer &quot;%1&quot; is clipped to &quot;%2&quot;, which is hidden.</translation>
    </message>
    <message>
        <source>%1 bytes of paint follow, but there should be %2.</source>
        <translation>%1 bytes of paint follow, but there should be %2.</translation>
    </message>
    <message>
        <source>%1: is no paint that was copied in Pastoso.</source>
        <translation>%1: is no paint that was copied in Pastoso.</translation>
    </message>
    <message>
        <source>format of copied paint</source>
        <translation>format of copied paint</translation>
    </message>
    <message>
        <source>no canvas holds so much paint.</source>
        <translation>no canvas holds so much paint.</translation>
    </message>
    <message>
        <source>no painting has cells of this size.</source>
        <translation>no painting has cells of this size.</translation>
    </message>
    <message>
        <source>paint that was copied in another painting has no strokes here, and comes no finer than it is.</source>
        <translation>paint that was copied in another painting has no strokes here, and comes no finer than it is.</translation>
    </message>
    <message>
        <source>the copied paint has cells of a size that no painting has.</source>
        <translation>the copied paint has cells of a size that no painting has.</translation>
    </message>
    <message>
        <source>the copied paint is no base64.</source>
        <translation>the copied paint is no base64.</translation>
    </message>
    <message>
        <source>the paint of other paintings in this recording is too large; at most 16 GB are read.</source>
        <translation>the paint of other paintings in this recording is too large; at most 16 GB are read.</translation>
    </message>
    <message>
        <source>there are %1 puddles, but only %2 have room.</source>
        <translation>there are %1 puddles, but only %2 have room.</translation>
    </message>
    <message>
        <source>there is more paint than is read, 4 GB.</source>
        <translation>there is more paint than is read, 4 GB.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not one of pastoso, krita and photoshop.</source>
        <translation>&quot;%1&quot; is not one of pastoso, krita and photoshop.</translation>
    </message>
    <message>
        <source>%1 would have %2 x %3 pixels; at most %4 a side are possible.</source>
        <translation>%1 would have %2 x %3 pixels; at most %4 a side are possible.</translation>
    </message>
    <message>
        <source>The canvas is %1 x %2 pixels, more than this graphics driver can show.</source>
        <translation>The canvas is %1 x %2 pixels, more than this graphics driver can show.</translation>
    </message>
</context>
<context>
    <name>ExamplePaintings</name>
    <message>
        <source>Still life</source>
        <translation>Still life</translation>
    </message>
    <message>
        <source>Oil, wet in wet</source>
        <translation>Oil, wet in wet</translation>
    </message>
    <message>
        <source>Surf</source>
        <translation>Surf</translation>
    </message>
    <message>
        <source>Oil, in thick impasto</source>
        <translation>Oil, in thick impasto</translation>
    </message>
    <message>
        <source>Poppies</source>
        <translation>Poppies</translation>
    </message>
    <message>
        <source>Oil over a dry ground</source>
        <translation>Oil over a dry ground</translation>
    </message>
    <message>
        <source>Evening by a river</source>
        <translation>Evening by a river</translation>
    </message>
    <message>
        <source>Oil, from ground to glaze</source>
        <translation>Oil, from ground to glaze</translation>
    </message>
</context>
<context>
    <name>FactList</name>
    <message>
        <source>Copy</source>
        <translation>Copy</translation>
    </message>
</context>
<context>
    <name>Findable</name>
    <message>
        <source>Take this tool in hand</source>
        <translation>Take this tool in hand</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Paint</translation>
    </message>
    <message>
        <source>Choose this paint</source>
        <translation>Choose this paint</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Medium</translation>
    </message>
    <message>
        <source>Your mix</source>
        <translation>Your mix</translation>
    </message>
</context>
<context>
    <name>FindableControls</name>
    <message>
        <source>Harmony</source>
        <translation>Harmony</translation>
    </message>
    <message>
        <source>Marks for hues that go together, on the colour wheel</source>
        <translation>Marks for hues that go together, on the colour wheel</translation>
    </message>
    <message>
        <source>complementary, analogous, triad, tetrad, colour scheme, color scheme</source>
        <translation>complementary, analogous, triad, tetrad, colour scheme, color scheme</translation>
    </message>
    <message>
        <source>Gamut mask</source>
        <translation>Gamut mask</translation>
    </message>
    <message>
        <source>A shape on the colour wheel to choose within</source>
        <translation>A shape on the colour wheel to choose within</translation>
    </message>
    <message>
        <source>limited palette, color mask</source>
        <translation>limited palette, color mask</translation>
    </message>
    <message>
        <source>Keep on your palette</source>
        <translation>Keep on your palette</translation>
    </message>
    <message>
        <source>Lay the paint in hand out on your palette</source>
        <translation>Lay the paint in hand out on your palette</translation>
    </message>
    <message>
        <source>swatch, add colour, add color</source>
        <translation>swatch, add colour, add color</translation>
    </message>
    <message>
        <source>Save the palette</source>
        <translation>Save the palette</translation>
    </message>
    <message>
        <source>The colours of your palette for GIMP, Krita or Inkscape, as a .gpl file</source>
        <translation>The colours of your palette for GIMP, Krita or Inkscape, as a .gpl file</translation>
    </message>
    <message>
        <source>gpl, swatches, export palette</source>
        <translation>gpl, swatches, export palette</translation>
    </message>
    <message>
        <source>Open a palette</source>
        <translation>Open a palette</translation>
    </message>
    <message>
        <source>Colours of GIMP, Krita or Inkscape, from a .gpl file</source>
        <translation>Colours of GIMP, Krita or Inkscape, from a .gpl file</translation>
    </message>
    <message>
        <source>gpl, swatches, import palette</source>
        <translation>gpl, swatches, import palette</translation>
    </message>
    <message>
        <source>Palette from a picture</source>
        <translation>Palette from a picture</translation>
    </message>
    <message>
        <source>Finds the colours that a picture is made of</source>
        <translation>Finds the colours that a picture is made of</translation>
    </message>
    <message>
        <source>extract, palette from image</source>
        <translation>extract, palette from image</translation>
    </message>
    <message>
        <source>Keep as a mix</source>
        <translation>Keep as a mix</translation>
    </message>
    <message>
        <source>Keep the paint in hand as a recipe of tubes, under a name of your own</source>
        <translation>Keep the paint in hand as a recipe of tubes, under a name of your own</translation>
    </message>
    <message>
        <source>recipe, save colour, save color</source>
        <translation>recipe, save colour, save color</translation>
    </message>
    <message>
        <source>Sets of tubes</source>
        <translation>Sets of tubes</translation>
    </message>
    <message>
        <source>Which tubes are shown: all of them, or a set of yours</source>
        <translation>Which tubes are shown: all of them, or a set of yours</translation>
    </message>
    <message>
        <source>tube sets, palette of tubes</source>
        <translation>tube sets, palette of tubes</translation>
    </message>
    <message>
        <source>Tags of tools</source>
        <translation>Tags of tools</translation>
    </message>
    <message>
        <source>Which tools are listed: a family, favourites or a tag</source>
        <translation>Which tools are listed: a family, favourites or a tag</translation>
    </message>
    <message>
        <source>tagged, collections, brush sets</source>
        <translation>tagged, collections, brush sets</translation>
    </message>
    <message>
        <source>Snapping strength</source>
        <translation>Snapping strength</translation>
    </message>
    <message>
        <source>How far the guide draws the brush from where your hand is</source>
        <translation>How far the guide draws the brush from where your hand is</translation>
    </message>
    <message>
        <source>magnetic, assistant strength</source>
        <translation>magnetic, assistant strength</translation>
    </message>
    <message>
        <source>Squeeze out the last painting&apos;s palette</source>
        <translation>Squeeze out the last painting&apos;s palette</translation>
    </message>
    <message>
        <source>The paints and mixtures of the earlier well, onto the mixing well</source>
        <translation>The paints and mixtures of the earlier well, onto the mixing well</translation>
    </message>
    <message>
        <source>restore palette, palette of before</source>
        <translation>restore palette, palette of before</translation>
    </message>
    <message>
        <source>New tag for the tool in hand</source>
        <translation>New tag for the tool in hand</translation>
    </message>
    <message>
        <source>A word of your own under which the tool is listed</source>
        <translation>A word of your own under which the tool is listed</translation>
    </message>
    <message>
        <source>add tag, label</source>
        <translation>add tag, label</translation>
    </message>
</context>
<context>
    <name>FolderFacts</name>
    <message>
        <source>none</source>
        <translation>none</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Settings</translation>
    </message>
    <message>
        <source>Your tools, paints and lamps</source>
        <translation>Your tools, paints and lamps</translation>
    </message>
    <message>
        <source>Paintings that are not saved</source>
        <translation>Paintings that are not saved</translation>
    </message>
    <message>
        <source>What the program brings along</source>
        <translation>What the program brings along</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Like Krita</source>
        <translation>Like Krita</translation>
    </message>
    <message>
        <source>The keys of Krita, where it has the same command</source>
        <translation>The keys of Krita, where it has the same command</translation>
    </message>
    <message>
        <source>Like Photoshop</source>
        <translation>Like Photoshop</translation>
    </message>
    <message>
        <source>The keys of Photoshop, where it has the same command</source>
        <translation>The keys of Photoshop, where it has the same command</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>Krita&apos;s keys, but for short ones of what only wet paint has</source>
        <translation>Krita&apos;s keys, but for short ones of what only wet paint has</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Drops and sprays</source>
        <translation>Drops and sprays</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Air</translation>
    </message>
    <message>
        <source>Knives and combs</source>
        <translation>Knives and combs</translation>
    </message>
    <message>
        <source>Rags and fingers</source>
        <translation>Rags and fingers</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>Brushes</translation>
    </message>
    <message>
        <source>Cannot be read</source>
        <translation>Cannot be read</translation>
    </message>
    <message>
        <source>Clear medium</source>
        <translation>Clear medium</translation>
    </message>
    <message>
        <source>How the next paint flows; what lies on the canvas keeps its own way</source>
        <translation>How the next paint flows; what lies on the canvas keeps its own way</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Tools</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Undo</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Redo</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Reload</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>Clean</translation>
    </message>
    <message>
        <source>Medium </source>
        <translation>Medium </translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Mixing well</source>
        <translation>Mixing well</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Save</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Rename</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Squeeze</translation>
    </message>
    <message>
        <source>Wipe the well</source>
        <translation>Wipe the well</translation>
    </message>
    <message>
        <source>the same to the eye</source>
        <translation>the same to the eye</translation>
    </message>
    <message>
        <source>close</source>
        <translation>close</translation>
    </message>
    <message>
        <source>a little off</source>
        <translation>a little off</translation>
    </message>
    <message>
        <source>beyond these tubes</source>
        <translation>beyond these tubes</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Pressure</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Tilt</translation>
    </message>
    <message>
        <source>Barrel</source>
        <translation>Barrel</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Speed</translation>
    </message>
    <message>
        <source>how far it is pressed</source>
        <translation>how far it is pressed</translation>
    </message>
    <message>
        <source>how far it leans</source>
        <translation>how far it leans</translation>
    </message>
    <message>
        <source>how it is turned</source>
        <translation>how it is turned</translation>
    </message>
    <message>
        <source>reach into hollows</source>
        <translation>reach into hollows</translation>
    </message>
    <message>
        <source>film that it leaves</source>
        <translation>film that it leaves</translation>
    </message>
    <message>
        <source>paint taken up</source>
        <translation>paint taken up</translation>
    </message>
    <message>
        <source>flow</source>
        <translation>flow</translation>
    </message>
    <message>
        <source>width of the spread</source>
        <translation>width of the spread</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 % pressure</source>
        <translation>%1 % pressure</translation>
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
        <translation>wet, inactive</translation>
    </message>
    <message>
        <source>A group: its eye, its lock and its opacity hold for all of its layers</source>
        <translation>A group: its eye, its lock and its opacity hold for all of its layers</translation>
    </message>
    <message>
        <source>You paint on this layer; its wet paint flows and dries</source>
        <translation>You paint on this layer; its wet paint flows and dries</translation>
    </message>
    <message>
        <source>Its wet paint keeps still: it neither flows nor dries, and stays as wet as it is until you choose this layer</source>
        <translation>Its wet paint keeps still: it neither flows nor dries, and stays as wet as it is until you choose this layer</translation>
    </message>
    <message>
        <source>Click to paint on this layer; a double click names it, dragging moves it</source>
        <translation>Click to paint on this layer; a double click names it, dragging moves it</translation>
    </message>
    <message>
        <source>Seen; click to hide it. Its relief goes with it</source>
        <translation>Seen; click to hide it. Its relief goes with it</translation>
    </message>
    <message>
        <source>Hidden, and not painted on; click to show it</source>
        <translation>Hidden, and not painted on; click to show it</translation>
    </message>
    <message>
        <source>Locked: nothing is painted on it, cleared or merged. Click to unlock</source>
        <translation>Locked: nothing is painted on it, cleared or merged. Click to unlock</translation>
    </message>
    <message>
        <source>Click to lock it against painting, clearing and merging</source>
        <translation>Click to lock it against painting, clearing and merging</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>tip</translation>
    </message>
    <message>
        <source>left</source>
        <translation>left</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>lower</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>middle</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>upper</translation>
    </message>
    <message>
        <source>right</source>
        <translation>right</translation>
    </message>
    <message>
        <source>none</source>
        <translation>none</translation>
    </message>
    <message>
        <source>not told</source>
        <comment>rotation</comment>
        <translation>not told</translation>
    </message>
    <message>
        <source>Tilt %1 across, %2 along; rotation %3; buttons: %4</source>
        <translation>Tilt %1 across, %2 along; rotation %3; buttons: %4</translation>
    </message>
    <message>
        <source>%1, eraser end</source>
        <translation>%1, eraser end</translation>
    </message>
    <message>
        <source>%1, puck</source>
        <translation>%1, puck</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Mouse</translation>
    </message>
    <message>
        <source>pressure %1 → %2</source>
        <translation>pressure %1 → %2</translation>
    </message>
    <message>
        <source>pressure %1</source>
        <translation>pressure %1</translation>
    </message>
    <message>
        <source>%1: %2, %3 events a second</source>
        <translation>%1: %2, %3 events a second</translation>
    </message>
    <message>
        <source>Buttons: %1</source>
        <translation>Buttons: %1</translation>
    </message>
    <message>
        <source>clear medium</source>
        <translation>clear medium</translation>
    </message>
    <message>
        <source>thinned to %1</source>
        <translation>thinned to %1</translation>
    </message>
    <message>
        <source>Dry now</source>
        <translation>Dry now</translation>
    </message>
    <message>
        <source>How fast time passes for the paint: 10 × is ten seconds in one. While you draw a stroke it passes as usual</source>
        <translation>How fast time passes for the paint: 10 × is ten seconds in one. While you draw a stroke it passes as usual</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>transparent</translation>
    </message>
    <message>
        <source>semi-transparent</source>
        <translation>semi-transparent</translation>
    </message>
    <message>
        <source>semi-opaque</source>
        <translation>semi-opaque</translation>
    </message>
    <message>
        <source>opaque</source>
        <translation>opaque</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>ride on wet paint</source>
        <translation>ride on wet paint</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>Wash</translation>
    </message>
    <message>
        <source>paste</source>
        <translation>paste</translation>
    </message>
    <message>
        <source>cream</source>
        <translation>cream</translation>
    </message>
    <message>
        <source>milk</source>
        <translation>milk</translation>
    </message>
    <message>
        <source>wash</source>
        <translation>wash</translation>
    </message>
    <message>
        <source>stain</source>
        <translation>stain</translation>
    </message>
    <message>
        <source>Each stroke</source>
        <translation>Each stroke</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Turns</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>What is new</source>
        <translation>What is new</translation>
    </message>
    <message>
        <source>About Pastoso</source>
        <translation>About Pastoso</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Edit</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favourite</translation>
    </message>
    <message>
        <source>The brush is not over it</source>
        <translation>The brush is not over it</translation>
    </message>
    <message>
        <source>Brush at %1, %2 mm</source>
        <translation>Brush at %1, %2 mm</translation>
    </message>
    <message>
        <source>Kind of paint</source>
        <translation>Kind of paint</translation>
    </message>
    <message>
        <source>Charcoal and pastels</source>
        <translation>Charcoal and pastels</translation>
    </message>
    <message>
        <source>Pens</source>
        <translation>Pens</translation>
    </message>
    <message>
        <source>Sponges and rollers</source>
        <translation>Sponges and rollers</translation>
    </message>
    <message>
        <source>Direction of the stroke</source>
        <translation>Direction of the stroke</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>Distance travelled</translation>
    </message>
    <message>
        <source>Time since the touch</source>
        <translation>Time since the touch</translation>
    </message>
    <message>
        <source>Distance in brush widths</source>
        <translation>Distance in brush widths</translation>
    </message>
    <message>
        <source>Chance, each stroke</source>
        <translation>Chance, each stroke</translation>
    </message>
    <message>
        <source>Chance along the stroke</source>
        <translation>Chance along the stroke</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Wheel</translation>
    </message>
    <message>
        <source>Paint left on the tool</source>
        <translation>Paint left on the tool</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 widths</source>
        <translation>%1 widths</translation>
    </message>
    <message>
        <source>What is bare is locked: tools change only what has paint. Click to unlock</source>
        <translation>What is bare is locked: tools change only what has paint. Click to unlock</translation>
    </message>
    <message>
        <source>Click to lock what is bare: tools change only what has paint</source>
        <translation>Click to lock what is bare: tools change only what has paint</translation>
    </message>
    <message>
        <source>Clipped to the layer below: of its paint, only what lies over paint of that layer shows. The rest is hidden, and kept</source>
        <translation>Clipped to the layer below: of its paint, only what lies over paint of that layer shows. The rest is hidden, and kept</translation>
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
        <translation>Save</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Open</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Yes</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;No</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Close</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancel</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Discard</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Help</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Apply</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Reset</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Restore Defaults</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Retry</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignore</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>Abort</translation>
    </message>
</context>
<context>
    <name>SelectionMargins</name>
    <message>
        <source>Width</source>
        <translation>Width</translation>
    </message>
</context>
<context>
    <name>TourCommands</name>
    <message>
        <source>Paint</source>
        <translation>Paint</translation>
    </message>
    <message>
        <source>Press on the canvas and drag: the brush lays wet paint, and drags along what is wet already. A pen that presses harder bends the hairs further.</source>
        <translation>Press on the canvas and drag: the brush lays wet paint, and drags along what is wet already. A pen that presses harder bends the hairs further.</translation>
    </message>
    <message>
        <source>Move the canvas, and pick paint from it</source>
        <translation>Move the canvas, and pick paint from it</translation>
    </message>
    <message>
        <source>Hold Space and drag to move the canvas; the wheel goes nearer. Ctrl and a click put the paint under the pointer on your brush.</source>
        <translation>Hold Space and drag to move the canvas; the wheel goes nearer. Ctrl and a click put the paint under the pointer on your brush.</translation>
    </message>
    <message>
        <source>Take another paint, and take a stroke back</source>
        <translation>Take another paint, and take a stroke back</translation>
    </message>
    <message>
        <source>Choose a paint here. %1 loads the brush anew, %2 takes the last stroke back.</source>
        <translation>Choose a paint here. %1 loads the brush anew, %2 takes the last stroke back.</translation>
    </message>
</context>
<context>
    <name>pastoso::appearance</name>
    <message>
        <source>Air blower 40</source>
        <translation>Air blower 40</translation>
    </message>
    <message>
        <source>Airbrush 7</source>
        <translation>Airbrush 7</translation>
    </message>
    <message>
        <source>Blender 28</source>
        <translation>Blender 28</translation>
    </message>
    <message>
        <source>Blotting pad 40</source>
        <translation>Blotting pad 40</translation>
    </message>
    <message>
        <source>Bright 12</source>
        <translation>Bright 12</translation>
    </message>
    <message>
        <source>Comb 25</source>
        <translation>Comb 25</translation>
    </message>
    <message>
        <source>Cotton bud 6</source>
        <translation>Cotton bud 6</translation>
    </message>
    <message>
        <source>Detail round 3</source>
        <translation>Detail round 3</translation>
    </message>
    <message>
        <source>Diamond knife 9</source>
        <translation>Diamond knife 9</translation>
    </message>
    <message>
        <source>Dropper</source>
        <translation>Dropper</translation>
    </message>
    <message>
        <source>Dry scumbler 22</source>
        <translation>Dry scumbler 22</translation>
    </message>
    <message>
        <source>Eraser 15</source>
        <translation>Eraser 15</translation>
    </message>
    <message>
        <source>Fan 26</source>
        <translation>Fan 26</translation>
    </message>
    <message>
        <source>Filbert 14</source>
        <translation>Filbert 14</translation>
    </message>
    <message>
        <source>Fine comb 18</source>
        <translation>Fine comb 18</translation>
    </message>
    <message>
        <source>Fingertip 12</source>
        <translation>Fingertip 12</translation>
    </message>
    <message>
        <source>Flat bristle 20</source>
        <translation>Flat bristle 20</translation>
    </message>
    <message>
        <source>Impasto flat 18</source>
        <translation>Impasto flat 18</translation>
    </message>
    <message>
        <source>Large filbert 26</source>
        <translation>Large filbert 26</translation>
    </message>
    <message>
        <source>Large flat 40</source>
        <translation>Large flat 40</translation>
    </message>
    <message>
        <source>Lifting knife 14</source>
        <translation>Lifting knife 14</translation>
    </message>
    <message>
        <source>Mop 30</source>
        <translation>Mop 30</translation>
    </message>
    <message>
        <source>Palette knife 17</source>
        <translation>Palette knife 17</translation>
    </message>
    <message>
        <source>Pouring bottle</source>
        <translation>Pouring bottle</translation>
    </message>
    <message>
        <source>Rag 35</source>
        <translation>Rag 35</translation>
    </message>
    <message>
        <source>Rigger 2</source>
        <translation>Rigger 2</translation>
    </message>
    <message>
        <source>Round bristle 12</source>
        <translation>Round bristle 12</translation>
    </message>
    <message>
        <source>Round sable 9</source>
        <translation>Round sable 9</translation>
    </message>
    <message>
        <source>Scraper 30</source>
        <translation>Scraper 30</translation>
    </message>
    <message>
        <source>Soft glazing flat 16</source>
        <translation>Soft glazing flat 16</translation>
    </message>
    <message>
        <source>Spatter 45</source>
        <translation>Spatter 45</translation>
    </message>
    <message>
        <source>Spray can 35</source>
        <translation>Spray can 35</translation>
    </message>
    <message>
        <source>Spreading knife 40</source>
        <translation>Spreading knife 40</translation>
    </message>
    <message>
        <source>Stippler 15</source>
        <translation>Stippler 15</translation>
    </message>
    <message>
        <source>Straw 8</source>
        <translation>Straw 8</translation>
    </message>
    <message>
        <source>Thinner brush 16</source>
        <translation>Thinner brush 16</translation>
    </message>
    <message>
        <source>Titanium white</source>
        <translation>Titanium white</translation>
    </message>
    <message>
        <source>Zinc white</source>
        <translation>Zinc white</translation>
    </message>
    <message>
        <source>Cadmium yellow</source>
        <translation>Cadmium yellow</translation>
    </message>
    <message>
        <source>Hansa yellow medium</source>
        <translation>Hansa yellow medium</translation>
    </message>
    <message>
        <source>Diarylide (Indian) yellow</source>
        <translation>Diarylide (Indian) yellow</translation>
    </message>
    <message>
        <source>Yellow ochre</source>
        <translation>Yellow ochre</translation>
    </message>
    <message>
        <source>Cadmium orange</source>
        <translation>Cadmium orange</translation>
    </message>
    <message>
        <source>Pyrrole orange</source>
        <translation>Pyrrole orange</translation>
    </message>
    <message>
        <source>Cadmium red light</source>
        <translation>Cadmium red light</translation>
    </message>
    <message>
        <source>Pyrrole red</source>
        <translation>Pyrrole red</translation>
    </message>
    <message>
        <source>Red oxide (Venetian red)</source>
        <translation>Red oxide (Venetian red)</translation>
    </message>
    <message>
        <source>Alizarin crimson</source>
        <translation>Alizarin crimson</translation>
    </message>
    <message>
        <source>Quinacridone rose</source>
        <translation>Quinacridone rose</translation>
    </message>
    <message>
        <source>Quinacridone magenta</source>
        <translation>Quinacridone magenta</translation>
    </message>
    <message>
        <source>Dioxazine violet</source>
        <translation>Dioxazine violet</translation>
    </message>
    <message>
        <source>Ultramarine blue</source>
        <translation>Ultramarine blue</translation>
    </message>
    <message>
        <source>Cobalt blue</source>
        <translation>Cobalt blue</translation>
    </message>
    <message>
        <source>Cerulean blue</source>
        <translation>Cerulean blue</translation>
    </message>
    <message>
        <source>Phthalo blue GS</source>
        <translation>Phthalo blue GS</translation>
    </message>
    <message>
        <source>Prussian blue</source>
        <translation>Prussian blue</translation>
    </message>
    <message>
        <source>Phthalo green BS</source>
        <translation>Phthalo green BS</translation>
    </message>
    <message>
        <source>Phthalo green YS</source>
        <translation>Phthalo green YS</translation>
    </message>
    <message>
        <source>Viridian</source>
        <translation>Viridian</translation>
    </message>
    <message>
        <source>Chromium oxide green</source>
        <translation>Chromium oxide green</translation>
    </message>
    <message>
        <source>Burnt sienna</source>
        <translation>Burnt sienna</translation>
    </message>
    <message>
        <source>Raw umber</source>
        <translation>Raw umber</translation>
    </message>
    <message>
        <source>Burnt umber</source>
        <translation>Burnt umber</translation>
    </message>
    <message>
        <source>Ivory (bone) black</source>
        <translation>Ivory (bone) black</translation>
    </message>
    <message>
        <source>Carbon black</source>
        <translation>Carbon black</translation>
    </message>
    <message>
        <source>heavy-body oil</source>
        <translation>heavy-body oil</translation>
    </message>
    <message>
        <source>Stiff, buttery oil straight from the tube: every bristle mark and every peak stays where you put it.</source>
        <translation>Stiff, buttery oil straight from the tube: every bristle mark and every peak stays where you put it.</translation>
    </message>
    <message>
        <source>soft-body acrylic</source>
        <translation>soft-body acrylic</translation>
    </message>
    <message>
        <source>Creamy paint that keeps soft brush marks, and slumps slowly where you lay it on thick.</source>
        <translation>Creamy paint that keeps soft brush marks, and slumps slowly where you lay it on thick.</translation>
    </message>
    <message>
        <source>fluid acrylic</source>
        <translation>fluid acrylic</translation>
    </message>
    <message>
        <source>Pours like cream: brush marks level out, and thick passages sag and run on a tilted canvas.</source>
        <translation>Pours like cream: brush marks level out, and thick passages sag and run on a tilted canvas.</translation>
    </message>
    <message>
        <source>house paint</source>
        <translation>house paint</translation>
    </message>
    <message>
        <source>Glossy enamel from the tin: it levels at once, drips freely and leaves long rounded tears.</source>
        <translation>Glossy enamel from the tin: it levels at once, drips freely and leaves long rounded tears.</translation>
    </message>
    <message>
        <source>ink glaze</source>
        <translation>ink glaze</translation>
    </message>
    <message>
        <source>Thin as ink: a transparent film that settles into the weave and runs wherever the canvas leans.</source>
        <translation>Thin as ink: a transparent film that settles into the weave and runs wherever the canvas leans.</translation>
    </message>
    <message>
        <source>thinner</source>
        <translation>thinner</translation>
    </message>
    <message>
        <source>Clear thinner: loosens wet paint that it meets, lifts dried ink, and leaves nothing behind.</source>
        <translation>Clear thinner: loosens wet paint that it meets, lifts dried ink, and leaves nothing behind.</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Paint</translation>
    </message>
    <message>
        <source>Oils</source>
        <translation>Oils</translation>
    </message>
    <message>
        <source>Acrylics and others</source>
        <translation>Acrylics and others</translation>
    </message>
    <message>
        <source>wax paste</source>
        <translation>wax paste</translation>
    </message>
    <message>
        <source>Oil with cold wax, short and dull: it breaks off sharply at the edge and keeps every cut of the knife.</source>
        <translation>Oil with cold wax, short and dull: it breaks off sharply at the edge and keeps every cut of the knife.</translation>
    </message>
    <message>
        <source>alkyd gel</source>
        <translation>alkyd gel</translation>
    </message>
    <message>
        <source>A clear gel with a little paint: transparent, stands as the brush left it, and dries overnight.</source>
        <translation>A clear gel with a little paint: transparent, stands as the brush left it, and dries overnight.</translation>
    </message>
    <message>
        <source>linseed oil</source>
        <translation>linseed oil</translation>
    </message>
    <message>
        <source>Paint let down with linseed oil, long and buttery: brush marks soften, and thick passages sag slowly.</source>
        <translation>Paint let down with linseed oil, long and buttery: brush marks soften, and thick passages sag slowly.</translation>
    </message>
    <message>
        <source>stand oil</source>
        <translation>stand oil</translation>
    </message>
    <message>
        <source>Paint in thickened oil, smooth as enamel: brush marks flow out, and it runs in slow, round tears.</source>
        <translation>Paint in thickened oil, smooth as enamel: brush marks flow out, and it runs in slow, round tears.</translation>
    </message>
    <message>
        <source>thin oil</source>
        <translation>thin oil</translation>
    </message>
    <message>
        <source>Oil thinned with turpentine for the first lay-in: streaky, it settles into the weave and runs when tilted.</source>
        <translation>Oil thinned with turpentine for the first lay-in: streaky, it settles into the weave and runs when tilted.</translation>
    </message>
    <message>
        <source>Width of the tip.</source>
        <translation>Width of the tip.</translation>
    </message>
    <message>
        <source>Thickness of the tip; a round one is as thick as it is wide.</source>
        <translation>Thickness of the tip; a round one is as thick as it is wide.</translation>
    </message>
    <message>
        <source>Length of the free hairs.</source>
        <translation>Length of the free hairs.</translation>
    </message>
    <message>
        <source>How much shorter the outermost hairs are; at most the length.</source>
        <translation>How much shorter the outermost hairs are; at most the length.</translation>
    </message>
    <message>
        <source>Elements that the tip is made of.</source>
        <translation>Elements that the tip is made of.</translation>
    </message>
    <message>
        <source>Fine streaks within one element.</source>
        <translation>Fine streaks within one element.</translation>
    </message>
    <message>
        <source>Makes one piece differ from the next.</source>
        <translation>Makes one piece differ from the next.</translation>
    </message>
    <message>
        <source>How far a bent hair trails behind the hand.</source>
        <translation>How far a bent hair trails behind the hand.</translation>
    </message>
    <message>
        <source>How far the hairs spread at full pressure.</source>
        <translation>How far the hairs spread at full pressure.</translation>
    </message>
    <message>
        <source>How long the hairs trail after a turn.</source>
        <translation>How long the hairs trail after a turn.</translation>
    </message>
    <message>
        <source>Way of the ferrule at full pressure, in hair lengths.</source>
        <translation>Way of the ferrule at full pressure, in hair lengths.</translation>
    </message>
    <message>
        <source>How much a lean lowers one side.</source>
        <translation>How much a lean lowers one side.</translation>
    </message>
    <message>
        <source>How steeply hairs follow the weave down: little gives dry brush.</source>
        <translation>How steeply hairs follow the weave down: little gives dry brush.</translation>
    </message>
    <message>
        <source>0: every hair for itself, 1: one stiff edge.</source>
        <translation>0: every hair for itself, 1: one stiff edge.</translation>
    </message>
    <message>
        <source>How far wet paint carries it in a light hand, off the ground.</source>
        <translation>How far wet paint carries it in a light hand, off the ground.</translation>
    </message>
    <message>
        <source>Wet film that a full brush leaves.</source>
        <translation>Wet film that a full brush leaves.</translation>
    </message>
    <message>
        <source>Stroke that a full load lasts.</source>
        <translation>Stroke that a full load lasts.</translation>
    </message>
    <message>
        <source>Ridges between bristles, in films.</source>
        <translation>Ridges between bristles, in films.</translation>
    </message>
    <message>
        <source>Streaks of single hairs, in films.</source>
        <translation>Streaks of single hairs, in films.</translation>
    </message>
    <message>
        <source>Difference from bristle to bristle.</source>
        <translation>Difference from bristle to bristle.</translation>
    </message>
    <message>
        <source>How far each dip gathers the hairs anew; 0: never.</source>
        <translation>How far each dip gathers the hairs anew; 0: never.</translation>
    </message>
    <message>
        <source>Extra film along the edges, in films.</source>
        <translation>Extra film along the edges, in films.</translation>
    </message>
    <message>
        <source>Extra film where the stroke starts.</source>
        <translation>Extra film where the stroke starts.</translation>
    </message>
    <message>
        <source>Share of the load that stays on lifting.</source>
        <translation>Share of the load that stays on lifting.</translation>
    </message>
    <message>
        <source>Depth that hanging paint bridges, in films.</source>
        <translation>Depth that hanging paint bridges, in films.</translation>
    </message>
    <message>
        <source>Share of the paint in the way that is taken up.</source>
        <translation>Share of the paint in the way that is taken up.</translation>
    </message>
    <message>
        <source>How fast it mixes with the paint below.</source>
        <translation>How fast it mixes with the paint below.</translation>
    </message>
    <message>
        <source>Exchange between neighbouring hairs.</source>
        <translation>Exchange between neighbouring hairs.</translation>
    </message>
    <message>
        <source>How far a fast stroke drags paint along and ploughs it aside.</source>
        <translation>How far a fast stroke drags paint along and ploughs it aside.</translation>
    </message>
    <message>
        <source>Fill above which paint is pushed out sideways.</source>
        <translation>Fill above which paint is pushed out sideways.</translation>
    </message>
    <message>
        <source>Step, in radii of an element.</source>
        <translation>Step, in radii of an element.</translation>
    </message>
    <message>
        <source>Least step.</source>
        <translation>Least step.</translation>
    </message>
    <message>
        <source>Time over which the hand is steadied.</source>
        <translation>Time over which the hand is steadied.</translation>
    </message>
    <message>
        <source>Length of the string that pulls the tip.</source>
        <translation>Length of the string that pulls the tip.</translation>
    </message>
    <message>
        <source>Mean volume of a drop.</source>
        <translation>Mean volume of a drop.</translation>
    </message>
    <message>
        <source>How much drops differ.</source>
        <translation>How much drops differ.</translation>
    </message>
    <message>
        <source>Paint let go while the pen is down.</source>
        <translation>Paint let go while the pen is down.</translation>
    </message>
    <message>
        <source>A drop let go when the pen comes down.</source>
        <translation>A drop let go when the pen comes down.</translation>
    </message>
    <message>
        <source>What the bottle holds.</source>
        <translation>What the bottle holds.</translation>
    </message>
    <message>
        <source>Height over radius of a drop that has landed.</source>
        <translation>Height over radius of a drop that has landed.</translation>
    </message>
    <message>
        <source>0: evenly over the width, 1: thickest in the middle.</source>
        <translation>0: evenly over the width, 1: thickest in the middle.</translation>
    </message>
    <message>
        <source>Time that drops fly on with the speed of the tip.</source>
        <translation>Time that drops fly on with the speed of the tip.</translation>
    </message>
    <message>
        <source>Pressure in the middle of the jet.</source>
        <translation>Pressure in the middle of the jet.</translation>
    </message>
    <message>
        <source>Calligraphy nib 3</source>
        <translation>Calligraphy nib 3</translation>
    </message>
    <message>
        <source>Charcoal 8</source>
        <translation>Charcoal 8</translation>
    </message>
    <message>
        <source>Marbling comb 80</source>
        <translation>Marbling comb 80</translation>
    </message>
    <message>
        <source>Oil pastel 10</source>
        <translation>Oil pastel 10</translation>
    </message>
    <message>
        <source>Roller 50</source>
        <translation>Roller 50</translation>
    </message>
    <message>
        <source>Ruling pen 1</source>
        <translation>Ruling pen 1</translation>
    </message>
    <message>
        <source>Sponge 45</source>
        <translation>Sponge 45</translation>
    </message>
    <message>
        <source>Squeegee 120</source>
        <translation>Squeegee 120</translation>
    </message>
    <message>
        <source>Width of a comb&apos;s tooth, in distances of its teeth.</source>
        <translation>Width of a comb&apos;s tooth, in distances of its teeth.</translation>
    </message>
    <message>
        <source>Depth of a sponge&apos;s pores.</source>
        <translation>Depth of a sponge&apos;s pores.</translation>
    </message>
    <message>
        <source>Way round a roller, after which its mark comes again; 0: it does not roll.</source>
        <translation>Way round a roller, after which its mark comes again; 0: it does not roll.</translation>
    </message>
    <message>
        <source>0: levels the hollows that it reaches, 1: coats the grain alone.</source>
        <translation>0: levels the hollows that it reaches, 1: coats the grain alone.</translation>
    </message>
    <message>
        <source>How many squares of the paint&apos;s grid lie side by side in a millimetre, and pixels in the saved picture: more show finer hairs, and need more memory and time</source>
        <translation>How many squares of the paint&apos;s grid lie side by side in a millimetre, and pixels in the saved picture: more show finer hairs, and need more memory and time</translation>
    </message>
    <message>
        <source>What paint lies on, bare: linen, jute, cotton duck, a panel or a height image</source>
        <translation>What paint lies on, bare: linen, jute, cotton duck, a panel or a height image</translation>
    </message>
    <message>
        <source>How steeply the canvas stands, and where down is: wet paint runs there</source>
        <translation>How steeply the canvas stands, and where down is: wet paint runs there</translation>
    </message>
    <message>
        <source>Where the lamp stands that lights the painting: a low one shows the relief, the heights of paint and canvas</source>
        <translation>Where the lamp stands that lights the painting: a low one shows the relief, the heights of paint and canvas</translation>
    </message>
    <message>
        <source>How many times as fast as by the clock wet paint becomes dry paint</source>
        <translation>How many times as fast as by the clock wet paint becomes dry paint</translation>
    </message>
    <message>
        <source>What the brush holds from side to side of its tip, and how full it is of what it can hold</source>
        <translation>What the brush holds from side to side of its tip, and how full it is of what it can hold</translation>
    </message>
    <message>
        <source>What pigment is mixed with: it decides how stiff the paint is, how far it levels and how soon it dries</source>
        <translation>What pigment is mixed with: it decides how stiff the paint is, how far it levels and how soon it dries</translation>
    </message>
    <message>
        <source>How a trembling hand is steadied, besides the brush&apos;s own smoothing</source>
        <translation>How a trembling hand is steadied, besides the brush&apos;s own smoothing</translation>
    </message>
    <message>
        <source>Hues that go together by their places on the wheel</source>
        <translation>Hues that go together by their places on the wheel</translation>
    </message>
    <message>
        <source>A shape on the disc of hues that choosing on the wheel keeps to</source>
        <translation>A shape on the disc of hues that choosing on the wheel keeps to</translation>
    </message>
    <message>
        <source>The light that the painting is seen in: the same paint has other colours in another one</source>
        <translation>The light that the painting is seen in: the same paint has other colours in another one</translation>
    </message>
    <message>
        <source>A clear coat over the whole painting that is looked through, and changes no paint</source>
        <translation>A clear coat over the whole painting that is looked through, and changes no paint</translation>
    </message>
    <message>
        <source>ΔE is how far two colours differ to the eye: 1 is seen side by side, 2 to 3 at a second look</source>
        <translation>ΔE is how far two colours differ to the eye: 1 is seen side by side, 2 to 3 at a second look</translation>
    </message>
    <message>
        <source>D65, D50 and A are the lights that colours are measured in everywhere: daylight, the light of print booths, and a light bulb</source>
        <translation>D65, D50 and A are the lights that colours are measured in everywhere: daylight, the light of print booths, and a light bulb</translation>
    </message>
    <message>
        <source>A soft proof shows on the screen how the painting would be printed; the gamut warning shows what this printer cannot print</source>
        <translation>A soft proof shows on the screen how the painting would be printed; the gamut warning shows what this printer cannot print</translation>
    </message>
</context>
<context>
    <name>pastoso::appearance::UnitBox</name>
    <message>
        <source>&quot;%1&quot; is not understood here; the number stays as it was.</source>
        <translation>&quot;%1&quot; is not understood here; the number stays as it was.</translation>
    </message>
</context>
<context>
    <name>pastoso::commands</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;File</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edit</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Brush</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>&amp;Paint</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>&amp;Layer</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Select</translation>
    </message>
    <message>
        <source>&amp;Guides</source>
        <translation>&amp;Guides</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;View</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Light</translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation>&amp;Settings</translation>
    </message>
    <message>
        <source>&amp;New canvas...</source>
        <translation>&amp;New canvas...</translation>
    </message>
    <message>
        <source>Put a fresh canvas on the easel</source>
        <translation>Put a fresh canvas on the easel</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Open...</translation>
    </message>
    <message>
        <source>Go on with a painting that was saved, wet as it was</source>
        <translation>Go on with a painting that was saved, wet as it was</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Save</translation>
    </message>
    <message>
        <source>Save the painting with all its wet paint</source>
        <translation>Save the painting with all its wet paint</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Save &amp;as...</translation>
    </message>
    <message>
        <source>Save the painting in another file</source>
        <translation>Save the painting in another file</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Export...</translation>
    </message>
    <message>
        <source>Make a picture, layers, maps, a relief to print or a time-lapse of the painting</source>
        <translation>Make a picture, layers, maps, a relief to print or a time-lapse of the painting</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Export a&amp;gain</translation>
    </message>
    <message>
        <source>The same export of the painting as it is now, into the same file</source>
        <translation>The same export of the painting as it is now, into the same file</translation>
    </message>
    <message>
        <source>S&amp;top the export</source>
        <translation>S&amp;top the export</translation>
    </message>
    <message>
        <source>Give up the export that is being written; its file stays as it was</source>
        <translation>Give up the export that is being written; its file stays as it was</translation>
    </message>
    <message>
        <source>Export &amp;recording...</source>
        <translation>Export &amp;recording...</translation>
    </message>
    <message>
        <source>Save all strokes, to be replayed at any resolution</source>
        <translation>Save all strokes, to be replayed at any resolution</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quit</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Close the window</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Undo</translation>
    </message>
    <message>
        <source>Take the last stroke back</source>
        <translation>Take the last stroke back</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Redo</translation>
    </message>
    <message>
        <source>Put the last stroke back</source>
        <translation>Put the last stroke back</translation>
    </message>
    <message>
        <source>&amp;Memory for undo...</source>
        <translation>&amp;Memory for undo...</translation>
    </message>
    <message>
        <source>How much memory the steps may take that you can return to</source>
        <translation>How much memory the steps may take that you can return to</translation>
    </message>
    <message>
        <source>&amp;Canvas size...</source>
        <translation>&amp;Canvas size...</translation>
    </message>
    <message>
        <source>Make the canvas larger, or cut it, on any side</source>
        <translation>Make the canvas larger, or cut it, on any side</translation>
    </message>
    <message>
        <source>Crop to the &amp;selection</source>
        <translation>Crop to the &amp;selection</translation>
    </message>
    <message>
        <source>Cut the canvas to the smallest one that holds what is selected</source>
        <translation>Cut the canvas to the smallest one that holds what is selected</translation>
    </message>
    <message>
        <source>&amp;Narrower</source>
        <translation>&amp;Narrower</translation>
    </message>
    <message>
        <source>A narrower brush</source>
        <translation>A narrower brush</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>&amp;Wider</translation>
    </message>
    <message>
        <source>A wider brush</source>
        <translation>A wider brush</translation>
    </message>
    <message>
        <source>Next &amp;brush</source>
        <translation>Next &amp;brush</translation>
    </message>
    <message>
        <source>Take the next brush of the list</source>
        <translation>Take the next brush of the list</translation>
    </message>
    <message>
        <source>&amp;Previous brush</source>
        <translation>&amp;Previous brush</translation>
    </message>
    <message>
        <source>Take the brush before in the list</source>
        <translation>Take the brush before in the list</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Reload</translation>
    </message>
    <message>
        <source>Clean the brush and fill it with the paint</source>
        <translation>Clean the brush and fill it with the paint</translation>
    </message>
    <message>
        <source>&amp;Top up</source>
        <translation>&amp;Top up</translation>
    </message>
    <message>
        <source>Dip the brush without cleaning it: what it holds stays on it</source>
        <translation>Dip the brush without cleaning it: what it holds stays on it</translation>
    </message>
    <message>
        <source>B&amp;lot</source>
        <translation>B&amp;lot</translation>
    </message>
    <message>
        <source>Press the brush into a cloth: a quarter of its paint stays on it</source>
        <translation>Press the brush into a cloth: a quarter of its paint stays on it</translation>
    </message>
    <message>
        <source>&amp;Clean</source>
        <translation>&amp;Clean</translation>
    </message>
    <message>
        <source>Wipe the brush: an empty one moves the paint that lies there</source>
        <translation>Wipe the brush: an empty one moves the paint that lies there</translation>
    </message>
    <message>
        <source>S&amp;wap the two paints</source>
        <translation>S&amp;wap the two paints</translation>
    </message>
    <message>
        <source>Dip the brush in the second paint; the first takes its place</source>
        <translation>Dip the brush in the second paint; the first takes its place</translation>
    </message>
    <message>
        <source>P&amp;ick up the paint there</source>
        <translation>P&amp;ick up the paint there</translation>
    </message>
    <message>
        <source>The next click dips the brush in the mixture of pigments that lies there; so does Ctrl and a click</source>
        <translation>The next click dips the brush in the mixture of pigments that lies there; so does Ctrl and a click</translation>
    </message>
    <message>
        <source>Pick the c&amp;olour seen there</source>
        <translation>Pick the c&amp;olour seen there</translation>
    </message>
    <message>
        <source>The next click makes paint of the colour that is seen there; so does Alt and a click</source>
        <translation>The next click makes paint of the colour that is seen there; so does Alt and a click</translation>
    </message>
    <message>
        <source>Reload before &amp;each stroke</source>
        <translation>Reload before &amp;each stroke</translation>
    </message>
    <message>
        <source>Every stroke starts with a clean, full brush</source>
        <translation>Every stroke starts with a clean, full brush</translation>
    </message>
    <message>
        <source>&amp;Turn with the stroke</source>
        <translation>&amp;Turn with the stroke</translation>
    </message>
    <message>
        <source>Flat brushes stand across their path, where the pen does not tell its rotation</source>
        <translation>Flat brushes stand across their path, where the pen does not tell its rotation</translation>
    </message>
    <message>
        <source>&amp;Save as my own...</source>
        <translation>&amp;Save as my own...</translation>
    </message>
    <message>
        <source>Keep the tool in hand, with its curves, among your own</source>
        <translation>Keep the tool in hand, with its curves, among your own</translation>
    </message>
    <message>
        <source>Re&amp;name...</source>
        <translation>Re&amp;name...</translation>
    </message>
    <message>
        <source>Give your own tool another name</source>
        <translation>Give your own tool another name</translation>
    </message>
    <message>
        <source>&amp;Delete...</source>
        <translation>&amp;Delete...</translation>
    </message>
    <message>
        <source>Throw your own tool away</source>
        <translation>Throw your own tool away</translation>
    </message>
    <message>
        <source>&amp;Pause the paint</source>
        <translation>&amp;Pause the paint</translation>
    </message>
    <message>
        <source>Wet paint stands still until you go on</source>
        <translation>Wet paint stands still until you go on</translation>
    </message>
    <message>
        <source>&amp;Dry now</source>
        <translation>&amp;Dry now</translation>
    </message>
    <message>
        <source>All wet paint dries at once: paint over it without stirring it up</source>
        <translation>All wet paint dries at once: paint over it without stirring it up</translation>
    </message>
    <message>
        <source>Mixing &amp;well</source>
        <translation>Mixing &amp;well</translation>
    </message>
    <message>
        <source>A palette of wet paint: mix there with any tool, and carry it to the canvas</source>
        <translation>A palette of wet paint: mix there with any tool, and carry it to the canvas</translation>
    </message>
    <message>
        <source>&amp;Squeeze onto the well</source>
        <translation>&amp;Squeeze onto the well</translation>
    </message>
    <message>
        <source>Squeeze the paint that you chose onto the mixing well; Control and click says where</source>
        <translation>Squeeze the paint that you chose onto the mixing well; Control and click says where</translation>
    </message>
    <message>
        <source>&amp;Clean the well</source>
        <translation>&amp;Clean the well</translation>
    </message>
    <message>
        <source>Wipe the mixing well bare</source>
        <translation>Wipe the mixing well bare</translation>
    </message>
    <message>
        <source>&amp;New layer</source>
        <translation>&amp;New layer</translation>
    </message>
    <message>
        <source>A bare layer above the one that you paint on</source>
        <translation>A bare layer above the one that you paint on</translation>
    </message>
    <message>
        <source>From a &amp;picture...</source>
        <translation>From a &amp;picture...</translation>
    </message>
    <message>
        <source>Put a picture onto the canvas as a layer of dry paint</source>
        <translation>Put a picture onto the canvas as a layer of dry paint</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplicate</translation>
    </message>
    <message>
        <source>The same paint once more, on a layer above</source>
        <translation>The same paint once more, on a layer above</translation>
    </message>
    <message>
        <source>Na&amp;me...</source>
        <translation>Na&amp;me...</translation>
    </message>
    <message>
        <source>Give the layer or the group another name</source>
        <translation>Give the layer or the group another name</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Remove</translation>
    </message>
    <message>
        <source>Take the layer away with all its paint</source>
        <translation>Take the layer away with all its paint</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>&amp;Clear</translation>
    </message>
    <message>
        <source>Wipe all paint off the layer</source>
        <translation>Wipe all paint off the layer</translation>
    </message>
    <message>
        <source>&amp;Transform</source>
        <translation>&amp;Transform</translation>
    </message>
    <message>
        <source>Move, scale, turn and mirror the layer&apos;s paint, or what is selected of it, by a frame</source>
        <translation>Move, scale, turn and mirror the layer&apos;s paint, or what is selected of it, by a frame</translation>
    </message>
    <message>
        <source>M&amp;erge down</source>
        <translation>M&amp;erge down</translation>
    </message>
    <message>
        <source>Put the layer&apos;s paint on the layer below, and make them one</source>
        <translation>Put the layer&apos;s paint on the layer below, and make them one</translation>
    </message>
    <message>
        <source>&amp;Flatten what is visible</source>
        <translation>&amp;Flatten what is visible</translation>
    </message>
    <message>
        <source>Make one layer of all that are visible; hidden ones stay</source>
        <translation>Make one layer of all that are visible; hidden ones stay</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>&amp;Group</translation>
    </message>
    <message>
        <source>Put the chosen layers into a group, which is hidden, locked and faded as one</source>
        <translation>Put the chosen layers into a group, which is hidden, locked and faded as one</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>&amp;Ungroup</translation>
    </message>
    <message>
        <source>Dissolve the group; its layers stay where they are</source>
        <translation>Dissolve the group; its layers stay where they are</translation>
    </message>
    <message>
        <source>&amp;Visible</source>
        <translation>&amp;Visible</translation>
    </message>
    <message>
        <source>Show or hide the layer or the group</source>
        <translation>Show or hide the layer or the group</translation>
    </message>
    <message>
        <source>&amp;Locked</source>
        <translation>&amp;Locked</translation>
    </message>
    <message>
        <source>Keep the layer or the group from being painted on, cleared and merged</source>
        <translation>Keep the layer or the group from being painted on, cleared and merged</translation>
    </message>
    <message>
        <source>Choose the one &amp;above</source>
        <translation>Choose the one &amp;above</translation>
    </message>
    <message>
        <source>Paint on the layer above</source>
        <translation>Paint on the layer above</translation>
    </message>
    <message>
        <source>Choose the one &amp;below</source>
        <translation>Choose the one &amp;below</translation>
    </message>
    <message>
        <source>Paint on the layer below</source>
        <translation>Paint on the layer below</translation>
    </message>
    <message>
        <source>Move u&amp;p</source>
        <translation>Move u&amp;p</translation>
    </message>
    <message>
        <source>Move the layer or the group one place up, into and out of groups</source>
        <translation>Move the layer or the group one place up, into and out of groups</translation>
    </message>
    <message>
        <source>Move d&amp;own</source>
        <translation>Move d&amp;own</translation>
    </message>
    <message>
        <source>Move the layer or the group one place down, into and out of groups</source>
        <translation>Move the layer or the group one place down, into and out of groups</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>&amp;Rectangle</translation>
    </message>
    <message>
        <source>Drag a rectangle that tools keep to; Shift adds, Alt takes away, Ctrl makes a square</source>
        <translation>Drag a rectangle that tools keep to; Shift adds, Alt takes away, Ctrl makes a square</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>&amp;Lasso</translation>
    </message>
    <message>
        <source>Draw around what tools keep to; Shift adds, Alt takes away</source>
        <translation>Draw around what tools keep to; Shift adds, Alt takes away</translation>
    </message>
    <message>
        <source>End the selection: tools work on all of the canvas</source>
        <translation>End the selection: tools work on all of the canvas</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>&amp;Invert</translation>
    </message>
    <message>
        <source>Select what is not selected</source>
        <translation>Select what is not selected</translation>
    </message>
    <message>
        <source>By &amp;height...</source>
        <translation>By &amp;height...</translation>
    </message>
    <message>
        <source>Select where the paint stands so high above the bare canvas</source>
        <translation>Select where the paint stands so high above the bare canvas</translation>
    </message>
    <message>
        <source>By &amp;wetness...</source>
        <translation>By &amp;wetness...</translation>
    </message>
    <message>
        <source>Select where the wet paint of the layer is so thick</source>
        <translation>Select where the wet paint of the layer is so thick</translation>
    </message>
    <message>
        <source>Show the &amp;outline</source>
        <translation>Show the &amp;outline</translation>
    </message>
    <message>
        <source>Hidden, it is out of the way of what you paint; tools keep to it as before</source>
        <translation>Hidden, it is out of the way of what you paint; tools keep to it as before</translation>
    </message>
    <message>
        <source>&amp;Mirror left and right</source>
        <translation>&amp;Mirror left and right</translation>
    </message>
    <message>
        <source>Every stroke is painted on both sides of the upright line</source>
        <translation>Every stroke is painted on both sides of the upright line</translation>
    </message>
    <message>
        <source>Mirror a&amp;bove and below</source>
        <translation>Mirror a&amp;bove and below</translation>
    </message>
    <message>
        <source>Every stroke is painted on both sides of the level line</source>
        <translation>Every stroke is painted on both sides of the level line</translation>
    </message>
    <message>
        <source>M&amp;ore copies around the middle</source>
        <translation>M&amp;ore copies around the middle</translation>
    </message>
    <message>
        <source>Every stroke is painted once more around the middle of the canvas</source>
        <translation>Every stroke is painted once more around the middle of the canvas</translation>
    </message>
    <message>
        <source>&amp;Fewer copies around the middle</source>
        <translation>&amp;Fewer copies around the middle</translation>
    </message>
    <message>
        <source>Every stroke is painted once less around the middle of the canvas</source>
        <translation>Every stroke is painted once less around the middle of the canvas</translation>
    </message>
    <message>
        <source>&amp;Ruler along the last stroke</source>
        <translation>&amp;Ruler along the last stroke</translation>
    </message>
    <message>
        <source>Strokes run along the ruler, or parallel to it; Shift and drag draw a straight line</source>
        <translation>Strokes run along the ruler, or parallel to it; Shift and drag draw a straight line</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>&amp;Ellipse</translation>
    </message>
    <message>
        <source>Strokes run along the ellipse, or along another of the same shape</source>
        <translation>Strokes run along the ellipse, or along another of the same shape</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>&amp;Handles</translation>
    </message>
    <message>
        <source>Points by which guides are dragged; Shift keeps to steps and proportions</source>
        <translation>Points by which guides are dragged; Shift keeps to steps and proportions</translation>
    </message>
    <message>
        <source>&amp;No guides</source>
        <translation>&amp;No guides</translation>
    </message>
    <message>
        <source>&amp;Trace a picture...</source>
        <translation>&amp;Trace a picture...</translation>
    </message>
    <message>
        <source>Lay a picture below the paint, and beside the canvas; it is in no picture that you save</source>
        <translation>Lay a picture below the paint, and beside the canvas; it is in no picture that you save</translation>
    </message>
    <message>
        <source>&amp;Show it below the paint</source>
        <translation>&amp;Show it below the paint</translation>
    </message>
    <message>
        <source>Show or hide the picture that you trace</source>
        <translation>Show or hide the picture that you trace</translation>
    </message>
    <message>
        <source>F&amp;it it to the canvas</source>
        <translation>F&amp;it it to the canvas</translation>
    </message>
    <message>
        <source>In the middle of the canvas, as large as it fits</source>
        <translation>In the middle of the canvas, as large as it fits</translation>
    </message>
    <message>
        <source>Ta&amp;ke it away</source>
        <translation>Ta&amp;ke it away</translation>
    </message>
    <message>
        <source>Take the picture that you trace away</source>
        <translation>Take the picture that you trace away</translation>
    </message>
    <message>
        <source>&amp;Fit the canvas</source>
        <translation>&amp;Fit the canvas</translation>
    </message>
    <message>
        <source>Show the whole canvas</source>
        <translation>Show the whole canvas</translation>
    </message>
    <message>
        <source>&amp;Actual pixels</source>
        <translation>&amp;Actual pixels</translation>
    </message>
    <message>
        <source>One screen pixel for every pixel of the saved picture</source>
        <translation>One screen pixel for every pixel of the saved picture</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Zoom &amp;in</translation>
    </message>
    <message>
        <source>Closer</source>
        <translation>Closer</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Zoom &amp;out</translation>
    </message>
    <message>
        <source>Farther</source>
        <translation>Farther</translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation>Turn &amp;left</translation>
    </message>
    <message>
        <source>Turn the canvas a little to the left on the screen; so does Shift+Space and a drag</source>
        <translation>Turn the canvas a little to the left on the screen; so does Shift+Space and a drag</translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation>&amp;Upright</translation>
    </message>
    <message>
        <source>The canvas stands again as it is saved</source>
        <translation>The canvas stands again as it is saved</translation>
    </message>
    <message>
        <source>Turn &amp;right</source>
        <translation>Turn &amp;right</translation>
    </message>
    <message>
        <source>Turn the canvas a little to the right on the screen; so does Shift+Space and a drag</source>
        <translation>Turn the canvas a little to the right on the screen; so does Shift+Space and a drag</translation>
    </message>
    <message>
        <source>&amp;Mirror the view</source>
        <translation>&amp;Mirror the view</translation>
    </message>
    <message>
        <source>See the painting as in a mirror, and paint on it so; it is saved as it is</source>
        <translation>See the painting as in a mirror, and paint on it so; it is saved as it is</translation>
    </message>
    <message>
        <source>Canvas &amp;only</source>
        <translation>Canvas &amp;only</translation>
    </message>
    <message>
        <source>Nothing but the canvas; Tab or Escape brings the panels back</source>
        <translation>Nothing but the canvas; Tab or Escape brings the panels back</translation>
    </message>
    <message>
        <source>In its l&amp;ight</source>
        <translation>In its l&amp;ight</translation>
    </message>
    <message>
        <source>The paint as it hangs in its light</source>
        <translation>The paint as it hangs in its light</translation>
    </message>
    <message>
        <source>Show &amp;wet</source>
        <translation>Show &amp;wet</translation>
    </message>
    <message>
        <source>Tints what is still wet, the more the thicker it is</source>
        <translation>Tints what is still wet, the more the thicker it is</translation>
    </message>
    <message>
        <source>Show &amp;height</source>
        <translation>Show &amp;height</translation>
    </message>
    <message>
        <source>How high the paint stands above the bare canvas, in steps of colour</source>
        <translation>How high the paint stands above the bare canvas, in steps of colour</translation>
    </message>
    <message>
        <source>Show &amp;normals</source>
        <translation>Show &amp;normals</translation>
    </message>
    <message>
        <source>Where the surface faces: red to the right, green up, blue towards you</source>
        <translation>Where the surface faces: red to the right, green up, blue towards you</translation>
    </message>
    <message>
        <source>&amp;Flat colour</source>
        <translation>&amp;Flat colour</translation>
    </message>
    <message>
        <source>The paint&apos;s colours alone, without light and relief</source>
        <translation>The paint&apos;s colours alone, without light and relief</translation>
    </message>
    <message>
        <source>&amp;Tool panel</source>
        <translation>&amp;Tool panel</translation>
    </message>
    <message>
        <source>What the brush holds, and how it answers to the hand</source>
        <translation>What the brush holds, and how it answers to the hand</translation>
    </message>
    <message>
        <source>&amp;Colour panel</source>
        <translation>&amp;Colour panel</translation>
    </message>
    <message>
        <source>A paint of any colour, and its recipe from the tubes</source>
        <translation>A paint of any colour, and its recipe from the tubes</translation>
    </message>
    <message>
        <source>P&amp;hysics panel</source>
        <translation>P&amp;hysics panel</translation>
    </message>
    <message>
        <source>What the paint is like: how it flows, holds and dries</source>
        <translation>What the paint is like: how it flows, holds and dries</translation>
    </message>
    <message>
        <source>&amp;Guides panel</source>
        <translation>&amp;Guides panel</translation>
    </message>
    <message>
        <source>&amp;Layers panel</source>
        <translation>&amp;Layers panel</translation>
    </message>
    <message>
        <source>The layers of the painting: seen, locked, faded, in what order</source>
        <translation>The layers of the painting: seen, locked, faded, in what order</translation>
    </message>
    <message>
        <source>Tr&amp;acing panel</source>
        <translation>Tr&amp;acing panel</translation>
    </message>
    <message>
        <source>The picture that you trace, to look at and to pick colours from</source>
        <translation>The picture that you trace, to look at and to pick colours from</translation>
    </message>
    <message>
        <source>&amp;History panel</source>
        <translation>&amp;History panel</translation>
    </message>
    <message>
        <source>What was done, to go back to any of it</source>
        <translation>What was done, to go back to any of it</translation>
    </message>
    <message>
        <source>&amp;Reset the panels</source>
        <translation>&amp;Reset the panels</translation>
    </message>
    <message>
        <source>Panels and mixing well as they stood at the first start</source>
        <translation>Panels and mixing well as they stood at the first start</translation>
    </message>
    <message>
        <source>Colours for s&amp;RGB</source>
        <translation>Colours for s&amp;RGB</translation>
    </message>
    <message>
        <source>Shows the painting for common screens</source>
        <translation>Shows the painting for common screens</translation>
    </message>
    <message>
        <source>Colours for Display &amp;P3</source>
        <translation>Colours for Display &amp;P3</translation>
    </message>
    <message>
        <source>Shows the painting for a screen of wide gamut</source>
        <translation>Shows the painting for a screen of wide gamut</translation>
    </message>
    <message>
        <source>&amp;Daylight (D65)</source>
        <translation>&amp;Daylight (D65)</translation>
    </message>
    <message>
        <source>The light that screens are made for</source>
        <translation>The light that screens are made for</translation>
    </message>
    <message>
        <source>&amp;Print booth (D50)</source>
        <translation>&amp;Print booth (D50)</translation>
    </message>
    <message>
        <source>The light that prints are judged in</source>
        <translation>The light that prints are judged in</translation>
    </message>
    <message>
        <source>Light &amp;bulb (A)</source>
        <translation>Light &amp;bulb (A)</translation>
    </message>
    <message>
        <source>Incandescent lamplight</source>
        <translation>Incandescent lamplight</translation>
    </message>
    <message>
        <source>&amp;LED lamp</source>
        <translation>&amp;LED lamp</translation>
    </message>
    <message>
        <source>A white LED with its blue peak</source>
        <translation>A white LED with its blue peak</translation>
    </message>
    <message>
        <source>From a &amp;file...</source>
        <translation>From a &amp;file...</translation>
    </message>
    <message>
        <source>A lamp that you have measured, as a CSV file</source>
        <translation>A lamp that you have measured, as a CSV file</translation>
    </message>
    <message>
        <source>&amp;Move the light</source>
        <translation>&amp;Move the light</translation>
    </message>
    <message>
        <source>Drag the lamp over the canvas: towards the rim it rakes over the relief</source>
        <translation>Drag the lamp over the canvas: towards the rim it rakes over the relief</translation>
    </message>
    <message>
        <source>&amp;Find a command...</source>
        <translation>&amp;Find a command...</translation>
    </message>
    <message>
        <source>Type a few letters of what you want to do</source>
        <translation>Type a few letters of what you want to do</translation>
    </message>
    <message>
        <source>&amp;Keys...</source>
        <translation>&amp;Keys...</translation>
    </message>
    <message>
        <source>Choose a set of keys, and give any command keys of your own</source>
        <translation>Choose a set of keys, and give any command keys of your own</translation>
    </message>
    <message>
        <source>&amp;Settings...</source>
        <translation>&amp;Settings...</translation>
    </message>
    <message>
        <source>The look of the window, what is kept, and how much of the machine is used</source>
        <translation>The look of the window, what is kept, and how much of the machine is used</translation>
    </message>
    <message>
        <source>Start &amp;page</source>
        <translation>Start &amp;page</translation>
    </message>
    <message>
        <source>New canvases, recent paintings and examples at a glance</source>
        <translation>New canvases, recent paintings and examples at a glance</translation>
    </message>
    <message>
        <source>&amp;Watch it grow...</source>
        <translation>&amp;Watch it grow...</translation>
    </message>
    <message>
        <source>See how the painting came about, in a window of its own; the painting stays as it is</source>
        <translation>See how the painting came about, in a window of its own; the painting stays as it is</translation>
    </message>
    <message>
        <source>&amp;Make a time-lapse...</source>
        <translation>&amp;Make a time-lapse...</translation>
    </message>
    <message>
        <source>A film, or numbered pictures, of how the painting came about</source>
        <translation>A film, or numbered pictures, of how the painting came about</translation>
    </message>
    <message>
        <source>Pop-&amp;up palette</source>
        <translation>Pop-&amp;up palette</translation>
    </message>
    <message>
        <source>Tools and paints around the pointer; so does a right click on the canvas</source>
        <translation>Tools and paints around the pointer; so does a right click on the canvas</translation>
    </message>
    <message>
        <source>&amp;Navigator</source>
        <translation>&amp;Navigator</translation>
    </message>
    <message>
        <source>The whole canvas, to see where the window is and to go elsewhere</source>
        <translation>The whole canvas, to see where the window is and to go elsewhere</translation>
    </message>
    <message>
        <source>Li&amp;ghts panel</source>
        <translation>Li&amp;ghts panel</translation>
    </message>
    <message>
        <source>The lamp, its light, and a coat of varnish to look through</source>
        <translation>The lamp, its light, and a coat of varnish to look through</translation>
    </message>
    <message>
        <source>Recor&amp;der panel</source>
        <translation>Recor&amp;der panel</translation>
    </message>
    <message>
        <source>What is recorded of the painting: watch it grow again, or make a time-lapse</source>
        <translation>What is recorded of the painting: watch it grow again, or make a time-lapse</translation>
    </message>
    <message>
        <source>&amp;Pen and tablet...</source>
        <translation>&amp;Pen and tablet...</translation>
    </message>
    <message>
        <source>How pens and mouse press, what their buttons do, and a sheet to try them on</source>
        <translation>How pens and mouse press, what their buttons do, and a sheet to try them on</translation>
    </message>
    <message>
        <source>&amp;Milk tea</source>
        <translation>&amp;Milk tea</translation>
    </message>
    <message>
        <source>A glass of tea in place of the canvas, to pour milk into; the painting waits as it is</source>
        <translation>A glass of tea in place of the canvas, to pour milk into; the painting waits as it is</translation>
    </message>
    <message>
        <source>&amp;New glass</source>
        <translation>&amp;New glass</translation>
    </message>
    <message>
        <source>Begin again with clear tea</source>
        <translation>Begin again with clear tea</translation>
    </message>
    <message>
        <source>&amp;Open a scene...</source>
        <translation>&amp;Open a scene...</translation>
    </message>
    <message>
        <source>Begin again with the numbers of a file</source>
        <translation>Begin again with the numbers of a file</translation>
    </message>
    <message>
        <source>&amp;Save the scene...</source>
        <translation>&amp;Save the scene...</translation>
    </message>
    <message>
        <source>Keep all numbers of the glass in a file</source>
        <translation>Keep all numbers of the glass in a file</translation>
    </message>
    <message>
        <source>&amp;Export the surface...</source>
        <translation>&amp;Export the surface...</translation>
    </message>
    <message>
        <source>&amp;Render a picture...</source>
        <translation>&amp;Render a picture...</translation>
    </message>
    <message>
        <source>A picture by the light&apos;s true ways, to be saved or painted on</source>
        <translation>A picture by the light&apos;s true ways, to be saved or painted on</translation>
    </message>
    <message>
        <source>As &amp;fast as it can</source>
        <translation>As &amp;fast as it can</translation>
    </message>
    <message>
        <source>Time in the glass passes as fast as it is computed</source>
        <translation>Time in the glass passes as fast as it is computed</translation>
    </message>
    <message>
        <source>S&amp;tir</source>
        <translation>S&amp;tir</translation>
    </message>
    <message>
        <source>A force around an upright axis stirs the tea</source>
        <translation>A force around an upright axis stirs the tea</translation>
    </message>
    <message>
        <source>Axis to the &amp;middle</source>
        <translation>Axis to the &amp;middle</translation>
    </message>
    <message>
        <source>The axis of the force stands in the middle of the glass again</source>
        <translation>The axis of the force stands in the middle of the glass again</translation>
    </message>
    <message>
        <source>The other &amp;way round</source>
        <translation>The other &amp;way round</translation>
    </message>
    <message>
        <source>Stir the other way round</source>
        <translation>Stir the other way round</translation>
    </message>
    <message>
        <source>Axis to the &amp;left</source>
        <translation>Axis to the &amp;left</translation>
    </message>
    <message>
        <source>Move the axis of the force to the left</source>
        <translation>Move the axis of the force to the left</translation>
    </message>
    <message>
        <source>Axis to the r&amp;ight</source>
        <translation>Axis to the r&amp;ight</translation>
    </message>
    <message>
        <source>Move the axis of the force to the right</source>
        <translation>Move the axis of the force to the right</translation>
    </message>
    <message>
        <source>Axis &amp;away</source>
        <translation>Axis &amp;away</translation>
    </message>
    <message>
        <source>Move the axis of the force away from you</source>
        <translation>Move the axis of the force away from you</translation>
    </message>
    <message>
        <source>Axis n&amp;ear</source>
        <translation>Axis n&amp;ear</translation>
    </message>
    <message>
        <source>Move the axis of the force towards you</source>
        <translation>Move the axis of the force towards you</translation>
    </message>
    <message>
        <source>Look from the fr&amp;ont</source>
        <translation>Look from the fr&amp;ont</translation>
    </message>
    <message>
        <source>See the whole glass from the front again</source>
        <translation>See the whole glass from the front again</translation>
    </message>
    <message>
        <source>Liqui&amp;ds</source>
        <translation>Liqui&amp;ds</translation>
    </message>
    <message>
        <source>&amp;Glass tank</source>
        <translation>&amp;Glass tank</translation>
    </message>
    <message>
        <source>A tank of liquid in place of the canvas, with balls that fall, a drain and wind; the painting waits as it is</source>
        <translation>A tank of liquid in place of the canvas, with balls that fall, a drain and wind; the painting waits as it is</translation>
    </message>
    <message>
        <source>The liquid&apos;s surface as triangles, for PBRT and other programs</source>
        <translation>The liquid&apos;s surface as triangles, for PBRT and other programs</translation>
    </message>
    <message>
        <source>&amp;Pause the liquid</source>
        <translation>&amp;Pause the liquid</translation>
    </message>
    <message>
        <source>The liquid stands still until you go on</source>
        <translation>The liquid stands still until you go on</translation>
    </message>
    <message>
        <source>A tank where liquid &amp;falls</source>
        <translation>A tank where liquid &amp;falls</translation>
    </message>
    <message>
        <source>A ball of liquid falls into a glass tank</source>
        <translation>A ball of liquid falls into a glass tank</translation>
    </message>
    <message>
        <source>A tank where t&amp;wo liquids meet</source>
        <translation>A tank where t&amp;wo liquids meet</translation>
    </message>
    <message>
        <source>Liquid breaks over a solid and meets another liquid</source>
        <translation>Liquid breaks over a solid and meets another liquid</translation>
    </message>
    <message>
        <source>&amp;Open a tank...</source>
        <translation>&amp;Open a tank...</translation>
    </message>
    <message>
        <source>Begin with the tank of a file</source>
        <translation>Begin with the tank of a file</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>&amp;Start again</translation>
    </message>
    <message>
        <source>Export &amp;all moments...</source>
        <translation>Export &amp;all moments...</translation>
    </message>
    <message>
        <source>The liquid&apos;s surface at every moment that is kept, each in a file of its own</source>
        <translation>The liquid&apos;s surface at every moment that is kept, each in a file of its own</translation>
    </message>
    <message>
        <source>Add a &amp;ball of liquid</source>
        <translation>Add a &amp;ball of liquid</translation>
    </message>
    <message>
        <source>A ball of liquid falls from above; press on the liquid to say where</source>
        <translation>A ball of liquid falls from above; press on the liquid to say where</translation>
    </message>
    <message>
        <source>Open the &amp;drain</source>
        <translation>Open the &amp;drain</translation>
    </message>
    <message>
        <source>Liquid runs out through the floor until you shut it again</source>
        <translation>Liquid runs out through the floor until you shut it again</translation>
    </message>
    <message>
        <source>W&amp;ind</source>
        <translation>W&amp;ind</translation>
    </message>
    <message>
        <source>Wind over the tank drags the liquid&apos;s surface along</source>
        <translation>Wind over the tank drags the liquid&apos;s surface along</translation>
    </message>
    <message>
        <source>Turn the wind to the &amp;left</source>
        <translation>Turn the wind to the &amp;left</translation>
    </message>
    <message>
        <source>Turn the wind by 15 degrees to the left</source>
        <translation>Turn the wind by 15 degrees to the left</translation>
    </message>
    <message>
        <source>Turn the wind to the &amp;right</source>
        <translation>Turn the wind to the &amp;right</translation>
    </message>
    <message>
        <source>Turn the wind by 15 degrees to the right</source>
        <translation>Turn the wind by 15 degrees to the right</translation>
    </message>
    <message>
        <source>Stron&amp;ger wind</source>
        <translation>Stron&amp;ger wind</translation>
    </message>
    <message>
        <source>The wind blows faster by half a metre a second</source>
        <translation>The wind blows faster by half a metre a second</translation>
    </message>
    <message>
        <source>W&amp;eaker wind</source>
        <translation>W&amp;eaker wind</translation>
    </message>
    <message>
        <source>The wind blows slower by half a metre a second</source>
        <translation>The wind blows slower by half a metre a second</translation>
    </message>
    <message>
        <source>Show &amp;velocities</source>
        <translation>Show &amp;velocities</translation>
    </message>
    <message>
        <source>Arrows show where the liquid flows, and how fast</source>
        <translation>Arrows show where the liquid flows, and how fast</translation>
    </message>
    <message>
        <source>Render a pic&amp;ture...</source>
        <translation>Render a pic&amp;ture...</translation>
    </message>
    <message>
        <source>Pi&amp;ctures of every step...</source>
        <translation>Pi&amp;ctures of every step...</translation>
    </message>
    <message>
        <source>While the liquid moves, a picture of every moment, as you see the tank, goes into a folder</source>
        <translation>While the liquid moves, a picture of every moment, as you see the tank, goes into a folder</translation>
    </message>
    <message>
        <source>S&amp;urfaces of every step...</source>
        <translation>S&amp;urfaces of every step...</translation>
    </message>
    <message>
        <source>While the liquid moves, its surface at every moment goes into a folder</source>
        <translation>While the liquid moves, its surface at every moment goes into a folder</translation>
    </message>
    <message>
        <source>M&amp;essages</source>
        <translation>M&amp;essages</translation>
    </message>
    <message>
        <source>What you were told last, to be read again and copied</source>
        <translation>What you were told last, to be read again and copied</translation>
    </message>
    <message>
        <source>Time runs &amp;faster</source>
        <translation>Time runs &amp;faster</translation>
    </message>
    <message>
        <source>Watch slow paint run, level and dry: up to 20 times as fast</source>
        <translation>Watch slow paint run, level and dry: up to 20 times as fast</translation>
    </message>
    <message>
        <source>Time runs s&amp;lower</source>
        <translation>Time runs s&amp;lower</translation>
    </message>
    <message>
        <source>A step back towards real time</source>
        <translation>A step back towards real time</translation>
    </message>
    <message>
        <source>&amp;Real time</source>
        <translation>&amp;Real time</translation>
    </message>
    <message>
        <source>A second of the paint takes a second again</source>
        <translation>A second of the paint takes a second again</translation>
    </message>
    <message>
        <source>&amp;Hold it tilted</source>
        <translation>&amp;Hold it tilted</translation>
    </message>
    <message>
        <source>A mouse holds the tool aslant: a knife then scrapes with its edge</source>
        <translation>A mouse holds the tool aslant: a knife then scrapes with its edge</translation>
    </message>
    <message>
        <source>More &amp;medium</source>
        <translation>More &amp;medium</translation>
    </message>
    <message>
        <source>Thin the paint in hand by a quarter, from paste towards a stain</source>
        <translation>Thin the paint in hand by a quarter, from paste towards a stain</translation>
    </message>
    <message>
        <source>More p&amp;aint</source>
        <translation>More p&amp;aint</translation>
    </message>
    <message>
        <source>Take a step back towards paint from the tube</source>
        <translation>Take a step back towards paint from the tube</translation>
    </message>
    <message>
        <source>Thin was&amp;h</source>
        <translation>Thin was&amp;h</translation>
    </message>
    <message>
        <source>Thin the paint in hand to a wash for a first lay-in, and back</source>
        <translation>Thin the paint in hand to a wash for a first lay-in, and back</translation>
    </message>
    <message>
        <source>Po&amp;ur</source>
        <translation>Po&amp;ur</translation>
    </message>
    <message>
        <source>Pour the recipe&apos;s milk into the middle, or stop pouring it; press on the tea to pour where you point</source>
        <translation>Pour the recipe&apos;s milk into the middle, or stop pouring it; press on the tea to pour where you point</translation>
    </message>
    <message>
        <source>The tank as it stood at the beginning; wind and drain stay as they are</source>
        <translation>The tank as it stood at the beginning; wind and drain stay as they are</translation>
    </message>
    <message>
        <source>Pa&amp;int it again, finer...</source>
        <translation>Pa&amp;int it again, finer...</translation>
    </message>
    <message>
        <source>Soft &amp;proof</source>
        <translation>Soft &amp;proof</translation>
    </message>
    <message>
        <source>Shows the painting as the printer chosen in the settings would print it</source>
        <translation>Shows the painting as the printer chosen in the settings would print it</translation>
    </message>
    <message>
        <source>Gamut &amp;warning</source>
        <translation>Gamut &amp;warning</translation>
    </message>
    <message>
        <source>Colours that this printer has not are grey</source>
        <translation>Colours that this printer has not are grey</translation>
    </message>
    <message>
        <source>Cance&amp;l opening</source>
        <translation>Cance&amp;l opening</translation>
    </message>
    <message>
        <source>Give up what is being opened or made; the painting on the easel stays</source>
        <translation>Give up what is being opened or made; the painting on the easel stays</translation>
    </message>
    <message>
        <source>&amp;Value check</source>
        <translation>&amp;Value check</translation>
    </message>
    <message>
        <source>The painting in greys as light as its colours: darks and lights by themselves</source>
        <translation>The painting in greys as light as its colours: darks and lights by themselves</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Help</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manual</translation>
    </message>
    <message>
        <source>Read about what is under the pointer</source>
        <translation>Read about what is under the pointer</translation>
    </message>
    <message>
        <source>What is &amp;new</source>
        <translation>What is &amp;new</translation>
    </message>
    <message>
        <source>What has changed, version by version</source>
        <translation>What has changed, version by version</translation>
    </message>
    <message>
        <source>&amp;About Pastoso</source>
        <translation>&amp;About Pastoso</translation>
    </message>
    <message>
        <source>Its version and licence, what it is made of, this machine, its folders</source>
        <translation>Its version and licence, what it is made of, this machine, its folders</translation>
    </message>
    <message>
        <source>Save a &amp;copy...</source>
        <translation>Save a &amp;copy...</translation>
    </message>
    <message>
        <source>The layers as pictures for other programs, in OpenRaster or PSD</source>
        <translation>The layers as pictures for other programs, in OpenRaster or PSD</translation>
    </message>
    <message>
        <source>&amp;Image</source>
        <translation>&amp;Image</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cu&amp;t</translation>
    </message>
    <message>
        <source>Copy the layer&apos;s paint, or what is selected of it, and wipe it off</source>
        <translation>Copy the layer&apos;s paint, or what is selected of it, and wipe it off</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copy</translation>
    </message>
    <message>
        <source>Keep the layer&apos;s paint, or what is selected of it, to be pasted: wet as it is, and as a picture for other programs</source>
        <translation>Keep the layer&apos;s paint, or what is selected of it, to be pasted: wet as it is, and as a picture for other programs</translation>
    </message>
    <message>
        <source>Cop&amp;y merged</source>
        <translation>Cop&amp;y merged</translation>
    </message>
    <message>
        <source>The same of all layers that are visible, as if they were one</source>
        <translation>The same of all layers that are visible, as if they were one</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Paste</translation>
    </message>
    <message>
        <source>What was copied as a new layer: paint where it was, or a picture of another program as dry paint</source>
        <translation>What was copied as a new layer: paint where it was, or a picture of another program as dry paint</translation>
    </message>
    <message>
        <source>Paste &amp;at cursor</source>
        <translation>Paste &amp;at cursor</translation>
    </message>
    <message>
        <source>The same, with the middle of the copied paint where the pointer is</source>
        <translation>The same, with the middle of the copied paint where the pointer is</translation>
    </message>
    <message>
        <source>Mirror image &amp;horizontally</source>
        <translation>Mirror image &amp;horizontally</translation>
    </message>
    <message>
        <source>Left and right of the whole painting change places, canvas and all</source>
        <translation>Left and right of the whole painting change places, canvas and all</translation>
    </message>
    <message>
        <source>Mirror image &amp;vertically</source>
        <translation>Mirror image &amp;vertically</translation>
    </message>
    <message>
        <source>Top and bottom of the whole painting change places, canvas and all</source>
        <translation>Top and bottom of the whole painting change places, canvas and all</translation>
    </message>
    <message>
        <source>Rotate image 90° to the &amp;right</source>
        <translation>Rotate image 90° to the &amp;right</translation>
    </message>
    <message>
        <source>The whole painting stands on its right side</source>
        <translation>The whole painting stands on its right side</translation>
    </message>
    <message>
        <source>Rotate image 90° to the &amp;left</source>
        <translation>Rotate image 90° to the &amp;left</translation>
    </message>
    <message>
        <source>The whole painting stands on its left side</source>
        <translation>The whole painting stands on its left side</translation>
    </message>
    <message>
        <source>Rotate image &amp;180°</source>
        <translation>Rotate image &amp;180°</translation>
    </message>
    <message>
        <source>The whole painting stands on its head</source>
        <translation>The whole painting stands on its head</translation>
    </message>
    <message>
        <source>F&amp;ill with the paint in hand</source>
        <translation>F&amp;ill with the paint in hand</translation>
    </message>
    <message>
        <source>Pour an even film of wet paint over what is selected, or over the whole canvas</source>
        <translation>Pour an even film of wet paint over what is selected, or over the whole canvas</translation>
    </message>
    <message>
        <source>Fill with the s&amp;econd paint</source>
        <translation>Fill with the s&amp;econd paint</translation>
    </message>
    <message>
        <source>Pour an even film of the second paint over what is selected</source>
        <translation>Pour an even film of the second paint over what is selected</translation>
    </message>
    <message>
        <source>&amp;Gradient of the two paints</source>
        <translation>&amp;Gradient of the two paints</translation>
    </message>
    <message>
        <source>Drag a line: the film goes from the paint in hand to the second one along it</source>
        <translation>Drag a line: the film goes from the paint in hand to the second one along it</translation>
    </message>
    <message>
        <source>&amp;Thickness of fills...</source>
        <translation>&amp;Thickness of fills...</translation>
    </message>
    <message>
        <source>How thick a film of paint fills and gradients pour</source>
        <translation>How thick a film of paint fills and gradients pour</translation>
    </message>
    <message>
        <source>Elli&amp;pse</source>
        <translation>Elli&amp;pse</translation>
    </message>
    <message>
        <source>Drag an ellipse that tools keep to; Shift adds, Alt takes away, Ctrl makes a circle</source>
        <translation>Drag an ellipse that tools keep to; Shift adds, Alt takes away, Ctrl makes a circle</translation>
    </message>
    <message>
        <source>Pol&amp;ygon</source>
        <translation>Pol&amp;ygon</translation>
    </message>
    <message>
        <source>Click the corners of what tools keep to; Enter or a double click closes it</source>
        <translation>Click the corners of what tools keep to; Enter or a double click closes it</translation>
    </message>
    <message>
        <source>&amp;Contiguous colour</source>
        <translation>&amp;Contiguous colour</translation>
    </message>
    <message>
        <source>Click a colour: what hangs together there is selected; drag for more or less of it</source>
        <translation>Click a colour: what hangs together there is selected; drag for more or less of it</translation>
    </message>
    <message>
        <source>&amp;Similar colour</source>
        <translation>&amp;Similar colour</translation>
    </message>
    <message>
        <source>Click a colour: it is selected wherever it is; drag for more or less of it</source>
        <translation>Click a colour: it is selected wherever it is; drag for more or less of it</translation>
    </message>
    <message>
        <source>&amp;Grow...</source>
        <translation>&amp;Grow...</translation>
    </message>
    <message>
        <source>Make the selection wider on all sides</source>
        <translation>Make the selection wider on all sides</translation>
    </message>
    <message>
        <source>Shri&amp;nk...</source>
        <translation>Shri&amp;nk...</translation>
    </message>
    <message>
        <source>Make the selection narrower on all sides</source>
        <translation>Make the selection narrower on all sides</translation>
    </message>
    <message>
        <source>&amp;Border...</source>
        <translation>&amp;Border...</translation>
    </message>
    <message>
        <source>Select a band along the outline of the selection</source>
        <translation>Select a band along the outline of the selection</translation>
    </message>
    <message>
        <source>&amp;From the layer</source>
        <translation>&amp;From the layer</translation>
    </message>
    <message>
        <source>Select where the layer has paint, wet or dry</source>
        <translation>Select where the layer has paint, wet or dry</translation>
    </message>
    <message>
        <source>Brush e&amp;ditor...</source>
        <translation>Brush e&amp;ditor...</translation>
    </message>
    <message>
        <source>Every number of the tool in hand, and the stroke that it paints</source>
        <translation>Every number of the tool in hand, and the stroke that it paints</translation>
    </message>
    <message>
        <source>&amp;Favourite</source>
        <translation>&amp;Favourite</translation>
    </message>
    <message>
        <source>Keep the tool in hand among your favourites, which the list can show alone</source>
        <translation>Keep the tool in hand among your favourites, which the list can show alone</translation>
    </message>
    <message>
        <source>&amp;Import tools...</source>
        <translation>&amp;Import tools...</translation>
    </message>
    <message>
        <source>Add the tools of a bundle to your own</source>
        <translation>Add the tools of a bundle to your own</translation>
    </message>
    <message>
        <source>E&amp;xport my tools...</source>
        <translation>E&amp;xport my tools...</translation>
    </message>
    <message>
        <source>Write all tools of your own into a bundle, a file to keep or to give away</source>
        <translation>Write all tools of your own into a bundle, a file to keep or to give away</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Window</translation>
    </message>
    <message>
        <source>Save a &amp;version</source>
        <translation>Save a &amp;version</translation>
    </message>
    <message>
        <source>Go on in a file of the next number beside this one, which stays as it is</source>
        <translation>Go on in a file of the next number beside this one, which stays as it is</translation>
    </message>
    <message>
        <source>Close the pain&amp;ting</source>
        <translation>Close the pain&amp;ting</translation>
    </message>
    <message>
        <source>Put the painting away; the start page says what there is to go on with</source>
        <translation>Put the painting away; the start page says what there is to go on with</translation>
    </message>
    <message>
        <source>Scale image to &amp;new size...</source>
        <translation>Scale image to &amp;new size...</translation>
    </message>
    <message>
        <source>Draw the whole painting out, or make it of finer or coarser pixels</source>
        <translation>Draw the whole painting out, or make it of finer or coarser pixels</translation>
    </message>
    <message>
        <source>Toned g&amp;round...</source>
        <translation>Toned g&amp;round...</translation>
    </message>
    <message>
        <source>Cover the whole canvas with a dry coat of the paint in hand, below all layers</source>
        <translation>Cover the whole canvas with a dry coat of the paint in hand, below all layers</translation>
    </message>
    <message>
        <source>Full scr&amp;een</source>
        <translation>Full scr&amp;een</translation>
    </message>
    <message>
        <source>The window on the whole screen, without the bars of the desktop</source>
        <translation>The window on the whole screen, without the bars of the desktop</translation>
    </message>
    <message>
        <source>S&amp;quint</source>
        <translation>S&amp;quint</translation>
    </message>
    <message>
        <source>The painting as with half-closed eyes: large shapes without their details</source>
        <translation>The painting as with half-closed eyes: large shapes without their details</translation>
    </message>
    <message>
        <source>&amp;Brushes panel</source>
        <translation>&amp;Brushes panel</translation>
    </message>
    <message>
        <source>The tools to paint with, how wide they are and how steady they keep</source>
        <translation>The tools to paint with, how wide they are and how steady they keep</translation>
    </message>
    <message>
        <source>&amp;Paints panel</source>
        <translation>&amp;Paints panel</translation>
    </message>
    <message>
        <source>The tubes of paint</source>
        <translation>The tubes of paint</translation>
    </message>
    <message>
        <source>&amp;Easel panel</source>
        <translation>&amp;Easel panel</translation>
    </message>
    <message>
        <source>How the canvas stands, where the lamp is, and how fast paint dries</source>
        <translation>How the canvas stands, where the lamp is, and how fast paint dries</translation>
    </message>
    <message>
        <source>T&amp;ool bar</source>
        <translation>T&amp;ool bar</translation>
    </message>
    <message>
        <source>The bar of buttons; drag it by its end to another side, or off the window</source>
        <translation>The bar of buttons; drag it by its end to another side, or off the window</translation>
    </message>
    <message>
        <source>&amp;New window</source>
        <translation>&amp;New window</translation>
    </message>
    <message>
        <source>Another window, with an easel of its own</source>
        <translation>Another window, with an easel of its own</translation>
    </message>
    <message>
        <source>S&amp;ketch</source>
        <translation>S&amp;ketch</translation>
    </message>
    <message>
        <source>Brushes and paints beside a large canvas, and nothing else</source>
        <translation>Brushes and paints beside a large canvas, and nothing else</translation>
    </message>
    <message>
        <source>&amp;Oil</source>
        <translation>&amp;Oil</translation>
    </message>
    <message>
        <source>Brushes, paints and easel beside the tool and the layers</source>
        <translation>Brushes, paints and easel beside the tool and the layers</translation>
    </message>
    <message>
        <source>&amp;Mixing</source>
        <translation>&amp;Mixing</translation>
    </message>
    <message>
        <source>Paints, colours and what the paint is like, beside a large mixing well</source>
        <translation>Paints, colours and what the paint is like, beside a large mixing well</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Export</translation>
    </message>
    <message>
        <source>Lights, layers, the whole canvas and its recording, to finish a painting</source>
        <translation>Lights, layers, the whole canvas and its recording, to finish a painting</translation>
    </message>
    <message>
        <source>&amp;Save the workspace...</source>
        <translation>&amp;Save the workspace...</translation>
    </message>
    <message>
        <source>Keep the panels as they stand now, under a name of your own</source>
        <translation>Keep the panels as they stand now, under a name of your own</translation>
    </message>
    <message>
        <source>&amp;Rename the workspace...</source>
        <translation>&amp;Rename the workspace...</translation>
    </message>
    <message>
        <source>Give your own workspace that is in use another name</source>
        <translation>Give your own workspace that is in use another name</translation>
    </message>
    <message>
        <source>Remo&amp;ve the workspace</source>
        <translation>Remo&amp;ve the workspace</translation>
    </message>
    <message>
        <source>Forget your own workspace that is in use; the panels stay as they stand</source>
        <translation>Forget your own workspace that is in use; the panels stay as they stand</translation>
    </message>
    <message>
        <source>&amp;Left-handed</source>
        <translation>&amp;Left-handed</translation>
    </message>
    <message>
        <source>What stands on the left changes places with what stands on the right</source>
        <translation>What stands on the left changes places with what stands on the right</translation>
    </message>
    <message>
        <source>Show me &amp;round</source>
        <translation>Show me &amp;round</translation>
    </message>
    <message>
        <source>Three steps: paint, move the canvas, take other paint</source>
        <translation>Three steps: paint, move the canvas, take other paint</translation>
    </message>
    <message>
        <source>Rotate &amp;image...</source>
        <translation>Rotate &amp;image...</translation>
    </message>
    <message>
        <source>Turn the whole painting by any angle, to put a horizon straight</source>
        <translation>Turn the whole painting by any angle, to put a horizon straight</translation>
    </message>
    <message>
        <source>Te&amp;xture paste...</source>
        <translation>Te&amp;xture paste...</translation>
    </message>
    <message>
        <source>Lay a dry relief of the paint in hand: sand, modelling paste, or a picture pressed in</source>
        <translation>Lay a dry relief of the paint in hand: sand, modelling paste, or a picture pressed in</translation>
    </message>
    <message>
        <source>Lock &amp;what is bare</source>
        <translation>Lock &amp;what is bare</translation>
    </message>
    <message>
        <source>Tools change the layer only where it has paint already</source>
        <translation>Tools change the layer only where it has paint already</translation>
    </message>
    <message>
        <source>&amp;Masking fluid</source>
        <translation>&amp;Masking fluid</translation>
    </message>
    <message>
        <source>Paint a skin that no paint gets below, as wide as the tool in hand; Alt peels it off</source>
        <translation>Paint a skin that no paint gets below, as wide as the tool in hand; Alt peels it off</translation>
    </message>
    <message>
        <source>Masking &amp;tape</source>
        <translation>Masking &amp;tape</translation>
    </message>
    <message>
        <source>Drag a strip with clean edges that no paint gets below; Alt peels it off</source>
        <translation>Drag a strip with clean edges that no paint gets below; Alt peels it off</translation>
    </message>
    <message>
        <source>M&amp;ask the selection</source>
        <translation>M&amp;ask the selection</translation>
    </message>
    <message>
        <source>Keep all paint off what is selected, until the masking is peeled off</source>
        <translation>Keep all paint off what is selected, until the masking is peeled off</translation>
    </message>
    <message>
        <source>Select what is maske&amp;d</source>
        <translation>Select what is maske&amp;d</translation>
    </message>
    <message>
        <source>Select all that masking fluid and tape cover</source>
        <translation>Select all that masking fluid and tape cover</translation>
    </message>
    <message>
        <source>Peel off all mas&amp;king</source>
        <translation>Peel off all mas&amp;king</translation>
    </message>
    <message>
        <source>Take all masking fluid and tape away; the paint below is as it was</source>
        <translation>Take all masking fluid and tape away; the paint below is as it was</translation>
    </message>
    <message>
        <source>&amp;Parallel ruler</source>
        <translation>&amp;Parallel ruler</translation>
    </message>
    <message>
        <source>Strokes run parallel to the ruler from wherever they start</source>
        <translation>Strokes run parallel to the ruler from wherever they start</translation>
    </message>
    <message>
        <source>&amp;Concentric ellipse</source>
        <translation>&amp;Concentric ellipse</translation>
    </message>
    <message>
        <source>Strokes run round the same middle from wherever they start</source>
        <translation>Strokes run round the same middle from wherever they start</translation>
    </message>
    <message>
        <source>&amp;1 point perspective</source>
        <translation>&amp;1 point perspective</translation>
    </message>
    <message>
        <source>Strokes run to the vanishing point, level or upright</source>
        <translation>Strokes run to the vanishing point, level or upright</translation>
    </message>
    <message>
        <source>&amp;2 point perspective</source>
        <translation>&amp;2 point perspective</translation>
    </message>
    <message>
        <source>Strokes run to one of two vanishing points, or upright</source>
        <translation>Strokes run to one of two vanishing points, or upright</translation>
    </message>
    <message>
        <source>&amp;3 point perspective</source>
        <translation>&amp;3 point perspective</translation>
    </message>
    <message>
        <source>Strokes run to one of three vanishing points</source>
        <translation>Strokes run to one of three vanishing points</translation>
    </message>
    <message>
        <source>Gri&amp;d</source>
        <translation>Gri&amp;d</translation>
    </message>
    <message>
        <source>Strokes run along the lines of a grid, or beside them</source>
        <translation>Strokes run along the lines of a grid, or beside them</translation>
    </message>
    <message>
        <source>Snap to the &amp;guide</source>
        <translation>Snap to the &amp;guide</translation>
    </message>
    <message>
        <source>Without it your hand is free, and the guide only shows where to go</source>
        <translation>Without it your hand is free, and the guide only shows where to go</translation>
    </message>
    <message>
        <source>Take mirrors, copies and the guide away</source>
        <translation>Take mirrors, copies and the guide away</translation>
    </message>
    <message>
        <source>&amp;Add reference pictures...</source>
        <translation>&amp;Add reference pictures...</translation>
    </message>
    <message>
        <source>Lay pictures on the board of references, to look at and to pick colours from</source>
        <translation>Lay pictures on the board of references, to look at and to pick colours from</translation>
    </message>
    <message>
        <source>References in a &amp;window of their own</source>
        <translation>References in a &amp;window of their own</translation>
    </message>
    <message>
        <source>The board of references above the canvas, or among the panels</source>
        <translation>The board of references above the canvas, or among the panels</translation>
    </message>
    <message>
        <source>Mirrors, rulers, perspectives and grids in numbers</source>
        <translation>Mirrors, rulers, perspectives and grids in numbers</translation>
    </message>
    <message>
        <source>Re&amp;ferences panel</source>
        <translation>Re&amp;ferences panel</translation>
    </message>
    <message>
        <source>Pictures to look at while you paint, and to pick colours from</source>
        <translation>Pictures to look at while you paint, and to pick colours from</translation>
    </message>
    <message>
        <source>Ad&amp;just dry paint...</source>
        <translation>Ad&amp;just dry paint...</translation>
    </message>
    <message>
        <source>Colour adjustment of what is dry: a glaze over it, or another hue by other pigments</source>
        <translation>Colour adjustment of what is dry: a glaze over it, or another hue by other pigments</translation>
    </message>
    <message>
        <source>Cl&amp;ip to the layer below</source>
        <translation>Cl&amp;ip to the layer below</translation>
    </message>
    <message>
        <source>Show the layer only where the one below has paint; the rest is hidden, and kept</source>
        <translation>Show the layer only where the one below has paint; the rest is hidden, and kept</translation>
    </message>
    <message>
        <source>E&amp;verything</source>
        <translation>E&amp;verything</translation>
    </message>
    <message>
        <source>F&amp;eather...</source>
        <translation>F&amp;eather...</translation>
    </message>
    <message>
        <source>Make the edge of the selection soft, so that paint fades out there</source>
        <translation>Make the edge of the selection soft, so that paint fades out there</translation>
    </message>
    <message>
        <source>All strokes once more, finer, beside the painting on the easel</source>
        <translation>All strokes once more, finer, beside the painting on the easel</translation>
    </message>
    <message>
        <source>save incremental, iteration</source>
        <translation>save incremental, iteration</translation>
    </message>
    <message>
        <source>png, jpeg, tiff, save as a picture</source>
        <translation>png, jpeg, tiff, save as a picture</translation>
    </message>
    <message>
        <source>replay, playback</source>
        <translation>replay, playback</translation>
    </message>
    <message>
        <source>video, mp4, speed painting</source>
        <translation>video, mp4, speed painting</translation>
    </message>
    <message>
        <source>upscale, higher resolution, enlarge</source>
        <translation>upscale, higher resolution, enlarge</translation>
    </message>
    <message>
        <source>copy visible, copy flattened</source>
        <translation>copy visible, copy flattened</translation>
    </message>
    <message>
        <source>resize image, resolution, dpi</source>
        <translation>resize image, resolution, dpi</translation>
    </message>
    <message>
        <source>resize canvas, extend, expand</source>
        <translation>resize canvas, extend, expand</translation>
    </message>
    <message>
        <source>trim to selection</source>
        <translation>trim to selection</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>flip</translation>
    </message>
    <message>
        <source>straighten</source>
        <translation>straighten</translation>
    </message>
    <message>
        <source>brush size, smaller</source>
        <translation>brush size, smaller</translation>
    </message>
    <message>
        <source>brush size, larger, bigger</source>
        <translation>brush size, larger, bigger</translation>
    </message>
    <message>
        <source>dip, load</source>
        <translation>dip, load</translation>
    </message>
    <message>
        <source>rinse, wash, smudge, blend</source>
        <translation>rinse, wash, smudge, blend</translation>
    </message>
    <message>
        <source>dilute, water, thinner, solvent</source>
        <translation>dilute, water, thinner, solvent</translation>
    </message>
    <message>
        <source>quick menu, radial menu</source>
        <translation>quick menu, radial menu</translation>
    </message>
    <message>
        <source>eyedropper, colour picker, color picker, pipette</source>
        <translation>eyedropper, colour picker, color picker, pipette</translation>
    </message>
    <message>
        <source>eyedropper, color picker, pipette</source>
        <translation>eyedropper, color picker, pipette</translation>
    </message>
    <message>
        <source>brush settings, brush studio, brush engine</source>
        <translation>brush settings, brush studio, brush engine</translation>
    </message>
    <message>
        <source>bundle, brush set, resources</source>
        <translation>bundle, brush set, resources</translation>
    </message>
    <message>
        <source>dryer, fast dry, dry layer</source>
        <translation>dryer, fast dry, dry layer</translation>
    </message>
    <message>
        <source>mixing palette, mixer, scratchpad</source>
        <translation>mixing palette, mixer, scratchpad</translation>
    </message>
    <message>
        <source>bucket, flood fill</source>
        <translation>bucket, flood fill</translation>
    </message>
    <message>
        <source>bucket, background fill</source>
        <translation>bucket, background fill</translation>
    </message>
    <message>
        <source>imprimatura, background, gesso</source>
        <translation>imprimatura, background, gesso</translation>
    </message>
    <message>
        <source>import layer, insert image, place image</source>
        <translation>import layer, insert image, place image</translation>
    </message>
    <message>
        <source>delete layer</source>
        <translation>delete layer</translation>
    </message>
    <message>
        <source>free transform, scale, rotate, distort, perspective, skew, move tool</source>
        <translation>free transform, scale, rotate, distort, perspective, skew, move tool</translation>
    </message>
    <message>
        <source>saturation, hsv, colour balance, color balance</source>
        <translation>saturation, hsv, colour balance, color balance</translation>
    </message>
    <message>
        <source>merge visible, merge all</source>
        <translation>merge visible, merge all</translation>
    </message>
    <message>
        <source>folder, quick group</source>
        <translation>folder, quick group</translation>
    </message>
    <message>
        <source>alpha lock, lock transparency</source>
        <translation>alpha lock, lock transparency</translation>
    </message>
    <message>
        <source>clipping mask, clipping group, inherit alpha</source>
        <translation>clipping mask, clipping group, inherit alpha</translation>
    </message>
    <message>
        <source>marquee, rectangular selection</source>
        <translation>marquee, rectangular selection</translation>
    </message>
    <message>
        <source>marquee, elliptical selection, oval, circle</source>
        <translation>marquee, elliptical selection, oval, circle</translation>
    </message>
    <message>
        <source>freehand selection</source>
        <translation>freehand selection</translation>
    </message>
    <message>
        <source>magic wand, automatic selection</source>
        <translation>magic wand, automatic selection</translation>
    </message>
    <message>
        <source>magic wand, colour range, color range</source>
        <translation>magic wand, colour range, color range</translation>
    </message>
    <message>
        <source>deselect, select none, select all</source>
        <translation>deselect, select none, select all</translation>
    </message>
    <message>
        <source>inverse</source>
        <translation>inverse</translation>
    </message>
    <message>
        <source>expand</source>
        <translation>expand</translation>
    </message>
    <message>
        <source>contract</source>
        <translation>contract</translation>
    </message>
    <message>
        <source>soften, blur edge</source>
        <translation>soften, blur edge</translation>
    </message>
    <message>
        <source>select opaque, alpha to selection</source>
        <translation>select opaque, alpha to selection</translation>
    </message>
    <message>
        <source>frisket, liquid mask, drawing gum</source>
        <translation>frisket, liquid mask, drawing gum</translation>
    </message>
    <message>
        <source>frisket, stencil</source>
        <translation>frisket, stencil</translation>
    </message>
    <message>
        <source>frisket, stencil, protect</source>
        <translation>frisket, stencil, protect</translation>
    </message>
    <message>
        <source>remove frisket</source>
        <translation>remove frisket</translation>
    </message>
    <message>
        <source>marching ants, display selection</source>
        <translation>marching ants, display selection</translation>
    </message>
    <message>
        <source>symmetry tool, multibrush</source>
        <translation>symmetry tool, multibrush</translation>
    </message>
    <message>
        <source>radial symmetry, multibrush, mandala</source>
        <translation>radial symmetry, multibrush, mandala</translation>
    </message>
    <message>
        <source>assistant, straight line, drawing guide</source>
        <translation>assistant, straight line, drawing guide</translation>
    </message>
    <message>
        <source>assistant, drawing guide</source>
        <translation>assistant, drawing guide</translation>
    </message>
    <message>
        <source>assistant, vanishing point</source>
        <translation>assistant, vanishing point</translation>
    </message>
    <message>
        <source>assistant, snapping</source>
        <translation>assistant, snapping</translation>
    </message>
    <message>
        <source>tracing paper, light table, template</source>
        <translation>tracing paper, light table, template</translation>
    </message>
    <message>
        <source>reference image, mood board</source>
        <translation>reference image, mood board</translation>
    </message>
    <message>
        <source>flip canvas</source>
        <translation>flip canvas</translation>
    </message>
    <message>
        <source>hide panels, canvas-only mode</source>
        <translation>hide panels, canvas-only mode</translation>
    </message>
    <message>
        <source>greyscale, grayscale, black and white, desaturate</source>
        <translation>greyscale, grayscale, black and white, desaturate</translation>
    </message>
    <message>
        <source>cmyk, print preview</source>
        <translation>cmyk, print preview</translation>
    </message>
    <message>
        <source>brush library, presets</source>
        <translation>brush library, presets</translation>
    </message>
    <message>
        <source>gravity, drips, canvas tilt</source>
        <translation>gravity, drips, canvas tilt</translation>
    </message>
    <message>
        <source>color wheel, colour selector, swatches</source>
        <translation>color wheel, colour selector, swatches</translation>
    </message>
    <message>
        <source>gloss, impasto, bump</source>
        <translation>gloss, impasto, bump</translation>
    </message>
    <message>
        <source>overview</source>
        <translation>overview</translation>
    </message>
    <message>
        <source>default layout, reset workspace</source>
        <translation>default layout, reset workspace</translation>
    </message>
    <message>
        <source>search actions</source>
        <translation>search actions</translation>
    </message>
    <message>
        <source>shortcuts, hotkeys, keyboard</source>
        <translation>shortcuts, hotkeys, keyboard</translation>
    </message>
    <message>
        <source>preferences, configure, options, theme, language</source>
        <translation>preferences, configure, options, theme, language</translation>
    </message>
    <message>
        <source>stylus, pressure curve</source>
        <translation>stylus, pressure curve</translation>
    </message>
    <message>
        <source>tutorial, getting started</source>
        <translation>tutorial, getting started</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 × %2 pixels for %3 × %4 mm, which is %5 pixels per inch.</source>
        <translation>%1 × %2 pixels for %3 × %4 mm, which is %5 pixels per inch.</translation>
    </message>
    <message>
        <source>Four files of %1 × %2 pixels, %3 to %4.</source>
        <translation>Four files of %1 × %2 pixels, %3 to %4.</translation>
    </message>
    <message>
        <source>A solid of %1 × %2 mm; its front has %3 × %4 points, %5 mm apart.</source>
        <translation>A solid of %1 × %2 mm; its front has %3 × %4 points, %5 mm apart.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of painting become %2 of film: %n frame(s) of %3 × %4 pixels.</source>
        <translation>
            <numerusform>%1 of painting become %2 of film: %n frame of %3 × %4 pixels.</numerusform>
            <numerusform>%1 of painting become %2 of film: %n frames of %3 × %4 pixels.</numerusform>
        </translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Save</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Replace</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Save as...</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::AdjustDialog</name>
    <message>
        <source>The medium in hand leaves next to nothing when it dries.</source>
        <translation>The medium in hand leaves next to nothing when it dries.</translation>
    </message>
    <message>
        <source>Adjust dry paint</source>
        <translation>Adjust dry paint</translation>
    </message>
    <message>
        <source>The dry paint of the layer that you paint on takes another colour, where it is selected or all over. Wet paint stays as it is.</source>
        <translation>The dry paint of the layer that you paint on takes another colour, where it is selected or all over. Wet paint stays as it is.</translation>
    </message>
    <message>
        <source>As a glaze</source>
        <translation>As a glaze</translation>
    </message>
    <message>
        <source>As other pigments</source>
        <translation>As other pigments</translation>
    </message>
    <message>
        <source>Adjust</source>
        <translation>Adjust</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Thickness</translation>
    </message>
    <message>
        <source> µm</source>
        <translation> µm</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Share</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>The mean colour as it is</source>
        <translation>The mean colour as it is</translation>
    </message>
    <message>
        <source>The mean colour after it is adjusted</source>
        <translation>The mean colour after it is adjusted</translation>
    </message>
    <message>
        <source>Before, after</source>
        <translation>Before, after</translation>
    </message>
    <message>
        <source>A thin even coat of the paint in hand dries over it, and what lies below shows through. It is as thick as this when it is dry.</source>
        <translation>A thin even coat of the paint in hand dries over it, and what lies below shows through. It is as thick as this when it is dry.</translation>
    </message>
    <message>
        <source>So much of the dry paint is taken out and replaced by the paint in hand, which is stirred in. It stays as thick as it is.</source>
        <translation>So much of the dry paint is taken out and replaced by the paint in hand, which is stirred in. It stays as thick as it is.</translation>
    </message>
    <message>
        <source>&amp;Preview</source>
        <translation>&amp;Preview</translation>
    </message>
    <message>
        <source>Show on the canvas what comes of it</source>
        <translation>Show on the canvas what comes of it</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CanvasSizeDialog</name>
    <message>
        <source>The upper left corner stays where it is</source>
        <translation>The upper left corner stays where it is</translation>
    </message>
    <message>
        <source>The middle of the upper edge stays where it is</source>
        <translation>The middle of the upper edge stays where it is</translation>
    </message>
    <message>
        <source>The upper right corner stays where it is</source>
        <translation>The upper right corner stays where it is</translation>
    </message>
    <message>
        <source>The middle of the left edge stays where it is</source>
        <translation>The middle of the left edge stays where it is</translation>
    </message>
    <message>
        <source>The middle stays where it is</source>
        <translation>The middle stays where it is</translation>
    </message>
    <message>
        <source>The middle of the right edge stays where it is</source>
        <translation>The middle of the right edge stays where it is</translation>
    </message>
    <message>
        <source>The lower left corner stays where it is</source>
        <translation>The lower left corner stays where it is</translation>
    </message>
    <message>
        <source>The middle of the lower edge stays where it is</source>
        <translation>The middle of the lower edge stays where it is</translation>
    </message>
    <message>
        <source>The lower right corner stays where it is</source>
        <translation>The lower right corner stays where it is</translation>
    </message>
    <message>
        <source>%1 mm on the left</source>
        <translation>%1 mm on the left</translation>
    </message>
    <message>
        <source>%1 mm on the right</source>
        <translation>%1 mm on the right</translation>
    </message>
    <message>
        <source>%1 mm at the top</source>
        <translation>%1 mm at the top</translation>
    </message>
    <message>
        <source>%1 mm at the bottom</source>
        <translation>%1 mm at the bottom</translation>
    </message>
    <message>
        <source>Added: %1.</source>
        <translation>Added: %1.</translation>
    </message>
    <message>
        <source>Cut off: %1. What lies there is wiped off.</source>
        <translation>Cut off: %1. What lies there is wiped off.</translation>
    </message>
    <message>
        <source>Canvas size</source>
        <translation>Canvas size</translation>
    </message>
    <message>
        <source>Change the size</source>
        <translation>Change the size</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Width</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Height</translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation>Stays in place</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The canvas has this size.</source>
        <translation>The canvas has this size.</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels.
%3</source>
        <translation>A picture of %1 × %2 pixels.
%3</translation>
    </message>
    <message>
        <source>Other units may be typed as well: 50 cm, 20 in, 3000 px</source>
        <translation>Other units may be typed as well: 50 cm, 20 in, 3000 px</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>What do you want to do?</translation>
    </message>
    <message>
        <source>Not now: %1</source>
        <translation>Not now: %1</translation>
    </message>
    <message>
        <source>Nothing of that name. Fewer letters find more.</source>
        <translation>Nothing of that name. Fewer letters find more.</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CrashDialog</name>
    <message>
        <source>Pastoso failed the last time</source>
        <translation>Pastoso failed the last time</translation>
    </message>
    <message>
        <source>We are sorry. What you had painted was kept and is offered to you next. This report says where the program was; it tells nothing of your painting. With it the mistake can be found.</source>
        <translation>We are sorry. What you had painted was kept and is offered to you next. This report says where the program was; it tells nothing of your painting. With it the mistake can be found.</translation>
    </message>
    <message>
        <source>It is kept as %1.</source>
        <translation>It is kept as %1.</translation>
    </message>
    <message>
        <source>Copy the report</source>
        <translation>Copy the report</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Report</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::ExportDialog</name>
    <message>
        <source>Where the folder is put</source>
        <translation>Where the folder is put</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>;;All files (*)</source>
        <translation>;;All files (*)</translation>
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
        <translation>ICC profile...</translation>
    </message>
    <message>
        <source>ICC profile</source>
        <translation>ICC profile</translation>
    </message>
    <message>
        <source>ICC profiles (*.icc *.icm);;All files (*)</source>
        <translation>ICC profiles (*.icc *.icm);;All files (*)</translation>
    </message>
    <message>
        <source>What the painting looks like.</source>
        <translation>What the painting looks like.</translation>
    </message>
    <message>
        <source>The picture, and of every layer its colours, normals, heights in mm, wetness, gloss and cover, as channels of one file.</source>
        <translation>The picture, and of every layer its colours, normals, heights in mm, wetness, gloss and cover, as channels of one file.</translation>
    </message>
    <message>
        <source>Base colour, normal (OpenGL, +Y up), height and roughness, a file for each.</source>
        <translation>Base colour, normal (OpenGL, +Y up), height and roughness, a file for each.</translation>
    </message>
    <message>
        <source>The paint as it stands on the canvas: a closed solid in millimetres.</source>
        <translation>The paint as it stands on the canvas: a closed solid in millimetres.</translation>
    </message>
    <message>
        <source>How the painting came about. It is painted once more, which takes a while.</source>
        <translation>How the painting came about. It is painted once more, which takes a while.</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Folder</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Replace</translation>
    </message>
    <message>
        <source>What the file is; its name ends accordingly</source>
        <translation>What the file is; its name ends accordingly</translation>
    </message>
    <message>
        <source>What is made of the painting</source>
        <translation>What is made of the painting</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Picture</translation>
    </message>
    <message>
        <source>Layers, for compositing</source>
        <translation>Layers, for compositing</translation>
    </message>
    <message>
        <source>Maps, for 3D programs</source>
        <translation>Maps, for 3D programs</translation>
    </message>
    <message>
        <source>Relief, for 3D printing</source>
        <translation>Relief, for 3D printing</translation>
    </message>
    <message>
        <source>Time-lapse</source>
        <translation>Time-lapse</translation>
    </message>
    <message>
        <source>Where it is put; the ending of the name chooses the format</source>
        <translation>Where it is put; the ending of the name chooses the format</translation>
    </message>
    <message>
        <source>&amp;Browse...</source>
        <translation>&amp;Browse...</translation>
    </message>
    <message>
        <source>1 is a small file, 100 a fine picture</source>
        <translation>1 is a small file, 100 a fine picture</translation>
    </message>
    <message>
        <source>What the picture is of</source>
        <translation>What the picture is of</translation>
    </message>
    <message>
        <source>The canvas</source>
        <translation>The canvas</translation>
    </message>
    <message>
        <source>The mixing well</source>
        <translation>The mixing well</translation>
    </message>
    <message>
        <source>&amp;Light and shade</source>
        <translation>&amp;Light and shade</translation>
    </message>
    <message>
        <source>As the window shows the painting; otherwise the paint&apos;s own colours, as a scan would have them</source>
        <translation>As the window shows the painting; otherwise the paint&apos;s own colours, as a scan would have them</translation>
    </message>
    <message>
        <source> px wide</source>
        <translation> px wide</translation>
    </message>
    <message>
        <source>The width that the scale comes to, or the scale that gives this width</source>
        <translation>The width that the scale comes to, or the scale that gives this width</translation>
    </message>
    <message>
        <source>What the numbers in the file mean; the file says so too. sRGB is for common screens, Display P3 for screens of wide gamut, an ICC profile for a printer</source>
        <translation>What the numbers in the file mean; the file says so too. sRGB is for common screens, Display P3 for screens of wide gamut, an ICC profile for a printer</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Thickness from the flat back to the lowest level of the canvas</source>
        <translation>Thickness from the flat back to the lowest level of the canvas</translation>
    </message>
    <message>
        <source> times as high</source>
        <translation> times as high</translation>
    </message>
    <message>
        <source>1 is the relief as it is painted, 2 twice as high; width and height stay</source>
        <translation>1 is the relief as it is painted, 2 twice as high; width and height stay</translation>
    </message>
    <message>
        <source> mm apart</source>
        <translation> mm apart</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatic</translation>
    </message>
    <message>
        <source> times as fast</source>
        <translation> times as fast</translation>
    </message>
    <message>
        <source>Seconds of painting in a second of film</source>
        <translation>Seconds of painting in a second of film</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> per second</translation>
    </message>
    <message>
        <source>Frames in a second of film</source>
        <translation>Frames in a second of film</translation>
    </message>
    <message>
        <source>&amp;Make</source>
        <translation>&amp;Make</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>F&amp;ormat</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Quality</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>Sho&amp;w</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>&amp;Scale</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Colours</translation>
    </message>
    <message>
        <source>&amp;Thickness</source>
        <translation>&amp;Thickness</translation>
    </message>
    <message>
        <source>&amp;Heights</source>
        <translation>&amp;Heights</translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation>&amp;Points</translation>
    </message>
    <message>
        <source>Sp&amp;eed</source>
        <translation>Sp&amp;eed</translation>
    </message>
    <message>
        <source>F&amp;rames</source>
        <translation>F&amp;rames</translation>
    </message>
    <message>
        <source>&amp;File name</source>
        <translation>&amp;File name</translation>
    </message>
    <message>
        <source> px/mm</source>
        <translation> px/mm</translation>
    </message>
    <message>
        <source>as it was painted</source>
        <translation>as it was painted</translation>
    </message>
    <message>
        <source>Canvas of &amp;it</source>
        <translation>Canvas of &amp;it</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source>1 as the window paints it, 2 twice as wide and high: finer, not merely enlarged</source>
        <translation>1 as the window paints it, 2 twice as wide and high: finer, not merely enlarged</translation>
    </message>
    <message>
        <source>Width of the picture in pixels</source>
        <translation>Width of the picture in pixels</translation>
    </message>
    <message>
        <source>Distance between two points of the surface; 0 is as far as the pixels, or farther where the canvas is large</source>
        <translation>Distance between two points of the surface; 0 is as far as the pixels, or farther where the canvas is large</translation>
    </message>
    <message>
        <source>Pixels in a millimetre of the canvas that it is painted on once more: more show finer paint and take longer; 0 is as it was painted</source>
        <translation>Pixels in a millimetre of the canvas that it is painted on once more: more show finer paint and take longer; 0 is as it was painted</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::KeyCatcher</name>
    <message>
        <source>Press the keys... (Esc: none)</source>
        <translation>Press the keys... (Esc: none)</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>Keys</translation>
    </message>
    <message>
        <source>What the keys are to start with; keys of your own stay</source>
        <translation>What the keys are to start with; keys of your own stay</translation>
    </message>
    <message>
        <source>Find by words, or by keys such as Ctrl+J</source>
        <translation>Find by words, or by keys such as Ctrl+J</translation>
    </message>
    <message>
        <source>Click, and press other keys</source>
        <translation>Click, and press other keys</translation>
    </message>
    <message>
        <source>Add a key</source>
        <translation>Add a key</translation>
    </message>
    <message>
        <source>As the set has it</source>
        <translation>As the set has it</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>Leave it</translation>
    </message>
    <message>
        <source>Forget all my own keys</source>
        <translation>Forget all my own keys</translation>
    </message>
    <message>
        <source>Click, and press other keys in place of these</source>
        <translation>Click, and press other keys in place of these</translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation>Take %1 away</translation>
    </message>
    <message>
        <source>%1 is needed on the canvas itself: it can be given to no command. Choose another key.</source>
        <translation>%1 is needed on the canvas itself: it can be given to no command. Choose another key.</translation>
    </message>
    <message>
        <source>%1 is its key already.</source>
        <translation>%1 is its key already.</translation>
    </message>
    <message>
        <source>%1 is the key of &quot;%2&quot;.</source>
        <translation>%1 is the key of &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>Take it from there</source>
        <translation>Take it from there</translation>
    </message>
    <message>
        <source>%1 stays with &quot;%2&quot;, which you gave it to.</source>
        <translation>%1 stays with &quot;%2&quot;, which you gave it to.</translation>
    </message>
    <message>
        <source>All keys will be as the set &quot;%1&quot; has them.</source>
        <translation>All keys will be as the set &quot;%1&quot; has them.</translation>
    </message>
    <message>
        <source>Forget my own</source>
        <translation>Forget my own</translation>
    </message>
    <message>
        <source>Set of keys</source>
        <translation>Set of keys</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commands</translation>
    </message>
    <message>
        <source>No command has such words or keys.</source>
        <translation>No command has such words or keys.</translation>
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
        <translation>New canvas</translation>
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
        <translation>Height image...</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Width</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Height</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolution</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Support</translation>
    </message>
    <message>
        <source>Height image: white is high</source>
        <translation>Height image: white is high</translation>
    </message>
    <message>
        <source>Image: %1</source>
        <translation>Image: %1</translation>
    </message>
    <message>
        <source>For large forms: brush marks blur.</source>
        <translation>For large forms: brush marks blur.</translation>
    </message>
    <message>
        <source>Bristle marks of broad brushes show; close up, edges are soft.</source>
        <translation>Bristle marks of broad brushes show; close up, edges are soft.</translation>
    </message>
    <message>
        <source>Every bristle and thread shows close up, in fine brushes as well.</source>
        <translation>Every bristle and thread shows close up, in fine brushes as well.</translation>
    </message>
    <message>
        <source>This machine keeps pace with the hand.</source>
        <translation>This machine keeps pace with the hand.</translation>
    </message>
    <message>
        <source>Bristle marks and the weave show.</source>
        <translation>Bristle marks and the weave show.</translation>
    </message>
    <message>
        <source>Dots per inch may be typed as well: 127 dpi</source>
        <translation>Dots per inch may be typed as well: 127 dpi</translation>
    </message>
    <message>
        <source>This machine keeps pace with the hand up to %1 px/mm; what is painted can be painted again finer.</source>
        <translation>This machine keeps pace with the hand up to %1 px/mm; what is painted can be painted again finer.</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels, %3 dpi; up to %4 MB of memory when all of it is wet.</source>
        <translation>A picture of %1 × %2 pixels, %3 dpi; up to %4 MB of memory when all of it is wet.</translation>
    </message>
    <message>
        <source>Other units may be typed as well: 50 cm, 20 in, 3000 px</source>
        <translation>Other units may be typed as well: 50 cm, 20 in, 3000 px</translation>
    </message>
    <message>
        <source>Toned ground</source>
        <translation>Toned ground</translation>
    </message>
    <message>
        <source>A dry coat of the paint in hand covers the whole canvas, on a layer of its own</source>
        <translation>A dry coat of the paint in hand covers the whole canvas, on a layer of its own</translation>
    </message>
    <message>
        <source>0.02 mm tints the canvas, 0.1 mm covers it</source>
        <translation>0.02 mm tints the canvas, 0.1 mm covers it</translation>
    </message>
    <message>
        <source>Thickness of the toned ground</source>
        <translation>Thickness of the toned ground</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::RecoveryDialog</name>
    <message>
        <source>A painting without a name</source>
        <translation>A painting without a name</translation>
    </message>
    <message>
        <source>A painting that cannot be read
%1</source>
        <translation>A painting that cannot be read
%1</translation>
    </message>
    <message numerus="yes">
        <source>%1
%2
%3 × %4 mm, %n change(s) not saved</source>
        <translation>
            <numerusform>%1
%2
%3 × %4 mm, %n change not saved</numerusform>
            <numerusform>%1
%2
%3 × %4 mm, %n changes not saved</numerusform>
        </translation>
    </message>
    <message>
        <source>Unfinished paintings</source>
        <translation>Unfinished paintings</translation>
    </message>
    <message>
        <source>Pastoso ended before these were saved.</source>
        <translation>Pastoso ended before these were saved.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recover</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Not now</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Discard</translation>
    </message>
    <message>
        <source>Discard %1 for good? It is nowhere else.</source>
        <translation>Discard %1 for good? It is nowhere else.</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::RepaintDialog</name>
    <message>
        <source>Paint it again</source>
        <translation>Paint it again</translation>
    </message>
    <message>
        <source> px/mm</source>
        <translation> px/mm</translation>
    </message>
    <message>
        <source>&amp;Pixels per millimetre</source>
        <translation>&amp;Pixels per millimetre</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, which take about %3 GB of memory; %4 GB are free. The strokes are painted again beside the painting on the easel, which stays as it is.</source>
        <translation>%1 × %2 pixels, which take about %3 GB of memory; %4 GB are free. The strokes are painted again beside the painting on the easel, which stays as it is.</translation>
    </message>
    <message>
        <source>Dots per inch may be typed as well: 127 dpi</source>
        <translation>Dots per inch may be typed as well: 127 dpi</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::RotateDialog</name>
    <message>
        <source>&amp;Keep the size of the canvas</source>
        <translation>&amp;Keep the size of the canvas</translation>
    </message>
    <message>
        <source>Rotate the image</source>
        <translation>Rotate the image</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Clockwise, about the middle of the canvas</source>
        <translation>Clockwise, about the middle of the canvas</translation>
    </message>
    <message>
        <source>What comes beyond the canvas is wiped off</source>
        <translation>What comes beyond the canvas is wiped off</translation>
    </message>
    <message>
        <source>Put the &amp;ruler straight</source>
        <translation>Put the &amp;ruler straight</translation>
    </message>
    <message>
        <source>Turns until the ruler is level or upright, whichever is nearer</source>
        <translation>Turns until the ruler is level or upright, whichever is nearer</translation>
    </message>
    <message>
        <source>Lay a ruler along the horizon first</source>
        <translation>Lay a ruler along the horizon first</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Turn</translation>
    </message>
    <message>
        <source>The image stands like this.</source>
        <translation>The image stands like this.</translation>
    </message>
    <message>
        <source>A canvas of %1 × %2 mm.</source>
        <translation>A canvas of %1 × %2 mm.</translation>
    </message>
    <message>
        <source>What comes beyond it is wiped off.</source>
        <translation>What comes beyond it is wiped off.</translation>
    </message>
    <message>
        <source>What is new in its corners is bare.</source>
        <translation>What is new in its corners is bare.</translation>
    </message>
    <message>
        <source>The weave turns with the paint.</source>
        <translation>The weave turns with the paint.</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::ScaleDialog</name>
    <message>
        <source>Paint keeps its thickness, so that there is %1 times as much of it.</source>
        <translation>Paint keeps its thickness, so that there is %1 times as much of it.</translation>
    </message>
    <message>
        <source>Keep the &amp;proportions</source>
        <translation>Keep the &amp;proportions</translation>
    </message>
    <message>
        <source>Scale the image</source>
        <translation>Scale the image</translation>
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
        <translation>Dots per inch may be typed as well: 127 dpi</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Width</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Height</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolution</translation>
    </message>
    <message>
        <source>The image has this size and this resolution.</source>
        <translation>The image has this size and this resolution.</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels, %3 dpi; up to %4 MB of memory when all of it is wet.</source>
        <translation>A picture of %1 × %2 pixels, %3 dpi; up to %4 MB of memory when all of it is wet.</translation>
    </message>
    <message>
        <source>Other units may be typed as well: 50 cm, 20 in, 3000 px</source>
        <translation>Other units may be typed as well: 50 cm, 20 in, 3000 px</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::SelectRangeDialog</name>
    <message>
        <source>Select it</source>
        <translation>Select it</translation>
    </message>
    <message>
        <source>Add it to the selection</source>
        <translation>Add it to the selection</translation>
    </message>
    <message>
        <source>Take it out of the selection</source>
        <translation>Take it out of the selection</translation>
    </message>
    <message>
        <source>Keep what is in both</source>
        <translation>Keep what is in both</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Select</translation>
    </message>
    <message>
        <source>From</source>
        <translation>From</translation>
    </message>
    <message>
        <source>To</source>
        <translation>To</translation>
    </message>
    <message>
        <source>Do</source>
        <translation>Do</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Nothing is there to be selected.</source>
        <translation>Nothing is there to be selected.</translation>
    </message>
    <message>
        <source>Then %1 % of the canvas is selected.</source>
        <translation>Then %1 % of the canvas is selected.</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Settings</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Appearance</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Performance</translation>
    </message>
    <message>
        <source>This machine</source>
        <translation>This machine</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Theme</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dark</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Light</translation>
    </message>
    <message>
        <source>Both are neutral greys, so that nothing beside the canvas colours what you see on it.</source>
        <translation>Both are neutral greys, so that nothing beside the canvas colours what you see on it.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Language</translation>
    </message>
    <message>
        <source>As on the desktop</source>
        <translation>As on the desktop</translation>
    </message>
    <message>
        <source>Another language speaks from the next start on.</source>
        <translation>Another language speaks from the next start on.</translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation>Memory for undo</translation>
    </message>
    <message>
        <source>The steps that you can return to. The oldest are given up when it is full; 500 are kept at most.</source>
        <translation>The steps that you can return to. The oldest are given up when it is full; 500 are kept at most.</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Never</translation>
    </message>
    <message>
        <source>Save by itself every</source>
        <translation>Save by itself every</translation>
    </message>
    <message>
        <source>Into the painting&apos;s own file, once it has one. Whatever you choose, every stroke is kept aside within a second and offered to you again should the program or the machine fail.</source>
        <translation>Into the painting&apos;s own file, once it has one. Whatever you choose, every stroke is kept aside within a second and offered to you again should the program or the machine fail.</translation>
    </message>
    <message>
        <source>All of the machine (%1)</source>
        <translation>All of the machine (%1)</translation>
    </message>
    <message>
        <source>How many things the program works on at once, from the next painting on. The paint flows the same with any number.</source>
        <translation>How many things the program works on at once, from the next painting on. The paint flows the same with any number.</translation>
    </message>
    <message>
        <source>How carefully moving paint is shown follows from how fast this machine draws; what stands still is always shown in full.</source>
        <translation>How carefully moving paint is shown follows from how fast this machine draws; what stands still is always shown in full.</translation>
    </message>
    <message numerus="yes">
        <source> minute(s)</source>
        <translation>
            <numerusform> minute</numerusform>
            <numerusform> minutes</numerusform>
        </translation>
    </message>
    <message>
        <source>The canvas is drawn by</source>
        <translation>The canvas is drawn by</translation>
    </message>
    <message>
        <source>What is faster here</source>
        <translation>What is faster here</translation>
    </message>
    <message>
        <source>The graphics card (OpenGL)</source>
        <translation>The graphics card (OpenGL)</translation>
    </message>
    <message>
        <source>The processor</source>
        <translation>The processor</translation>
    </message>
    <message>
        <source>Choose the processor where a graphics driver shows the canvas wrongly.</source>
        <translation>Choose the processor where a graphics driver shows the canvas wrongly.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Colour</translation>
    </message>
    <message>
        <source>None</source>
        <translation>None</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Choose...</translation>
    </message>
    <message>
        <source>ICC profiles (*.icc *.icm);;All files (*)</source>
        <translation>ICC profiles (*.icc *.icm);;All files (*)</translation>
    </message>
    <message>
        <source>Of the system, which has none here</source>
        <translation>Of the system, which has none here</translation>
    </message>
    <message>
        <source>Of the system (%1)</source>
        <translation>Of the system (%1)</translation>
    </message>
    <message>
        <source>The screen&apos;s profile</source>
        <translation>The screen&apos;s profile</translation>
    </message>
    <message>
        <source>None (sRGB)</source>
        <translation>None (sRGB)</translation>
    </message>
    <message>
        <source>A file</source>
        <translation>A file</translation>
    </message>
    <message>
        <source>Its file</source>
        <translation>Its file</translation>
    </message>
    <message>
        <source>With the profile of your screen, canvas and swatches have the same colours as on any other that is measured. Files and exports are not changed.</source>
        <translation>With the profile of your screen, canvas and swatches have the same colours as on any other that is measured. Files and exports are not changed.</translation>
    </message>
    <message>
        <source>The printer&apos;s profile</source>
        <translation>The printer&apos;s profile</translation>
    </message>
    <message>
        <source>For &quot;Soft proof&quot; and &quot;Gamut warning&quot; in the &quot;View&quot; menu: of your printer and paper, or of your printing house.</source>
        <translation>For &quot;Soft proof&quot; and &quot;Gamut warning&quot; in the &quot;View&quot; menu: of your printer and paper, or of your printing house.</translation>
    </message>
    <message>
        <source>Undo and saving</source>
        <translation>Undo and saving</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Processors in use</source>
        <translation>Processors in use</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::TextureDialog</name>
    <message>
        <source>A&amp;nother</source>
        <translation>A&amp;nother</translation>
    </message>
    <message>
        <source>Texture paste</source>
        <translation>Texture paste</translation>
    </message>
    <message>
        <source>A dry coat of the paint in hand lies on the layer that you paint on, where it is selected or all over. Brushes then catch on it.</source>
        <translation>A dry coat of the paint in hand lies on the layer that you paint on, where it is selected or all over. Brushes then catch on it.</translation>
    </message>
    <message>
        <source>Sand</source>
        <translation>Sand</translation>
    </message>
    <message>
        <source>Modelling paste</source>
        <translation>Modelling paste</translation>
    </message>
    <message>
        <source>A picture pressed in</source>
        <translation>A picture pressed in</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Texture</translation>
    </message>
    <message>
        <source>Grains</source>
        <translation>Grains</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Height</translation>
    </message>
    <message>
        <source>Between ridges</source>
        <translation>Between ridges</translation>
    </message>
    <message>
        <source>Other grains or other passes of the knife</source>
        <translation>Other grains or other passes of the knife</translation>
    </message>
    <message>
        <source>Lay the paste</source>
        <translation>Lay the paste</translation>
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
        <translation>Which way the knife went: 0 to the right, 90 down</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Picture</translation>
    </message>
    <message>
        <source>What is &amp;dark stands up</source>
        <translation>What is &amp;dark stands up</translation>
    </message>
    <message>
        <source>Picture to press in</source>
        <translation>Picture to press in</translation>
    </message>
    <message>
        <source>Choose a picture...</source>
        <translation>Choose a picture...</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::TransformDialog</name>
    <message>
        <source>Transform</source>
        <translation>Transform</translation>
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
        <translation>Move right</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Move down</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Width</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Height</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Turn</translation>
    </message>
    <message>
        <source>Clockwise, about the middle of the frame</source>
        <translation>Clockwise, about the middle of the frame</translation>
    </message>
    <message>
        <source>Left–right</source>
        <translation>Left–right</translation>
    </message>
    <message>
        <source>Left and right of the paint change places, before it is turned</source>
        <translation>Left and right of the paint change places, before it is turned</translation>
    </message>
    <message>
        <source>Up–down</source>
        <translation>Up–down</translation>
    </message>
    <message>
        <source>Above and below change places, before the paint is turned</source>
        <translation>Above and below change places, before the paint is turned</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Mirror</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Apply</translation>
    </message>
    <message>
        <source>The paint keeps its thickness and its amount.</source>
        <translation>The paint keeps its thickness and its amount.</translation>
    </message>
    <message>
        <source>The paint keeps its thickness: %1 % of it will be there.</source>
        <translation>The paint keeps its thickness: %1 % of it will be there.</translation>
    </message>
    <message>
        <source>What comes beyond the canvas is wiped off.</source>
        <translation>What comes beyond the canvas is wiped off.</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Corners</translation>
    </message>
    <message>
        <source>Drag with Ctrl: a corner alone, or a side askew. By keys: Tab chooses a corner, arrows move it, with Shift by ten pixels.</source>
        <translation>Drag with Ctrl: a corner alone, or a side askew. By keys: Tab chooses a corner, arrows move it, with Shift by ten pixels.</translation>
    </message>
</context>
<context>
    <name>pastoso::document::Table</name>
    <message>
        <source>Dry now</source>
        <translation>Dry now</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Stroke</translation>
    </message>
    <message>
        <source>Paint squeezed out</source>
        <translation>Paint squeezed out</translation>
    </message>
    <message>
        <source>Mixing well wiped</source>
        <translation>Mixing well wiped</translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>New layer</translation>
    </message>
    <message>
        <source>Look of a layer</source>
        <translation>Look of a layer</translation>
    </message>
    <message>
        <source>Layer duplicated</source>
        <translation>Layer duplicated</translation>
    </message>
    <message>
        <source>Layer removed</source>
        <translation>Layer removed</translation>
    </message>
    <message>
        <source>Layer cleared</source>
        <translation>Layer cleared</translation>
    </message>
    <message>
        <source>Transform</source>
        <translation>Transform</translation>
    </message>
    <message>
        <source>Layer moved</source>
        <translation>Layer moved</translation>
    </message>
    <message>
        <source>Merged down</source>
        <translation>Merged down</translation>
    </message>
    <message>
        <source>Flattened</source>
        <translation>Flattened</translation>
    </message>
    <message>
        <source>Layers grouped</source>
        <translation>Layers grouped</translation>
    </message>
    <message>
        <source>Look of a group</source>
        <translation>Look of a group</translation>
    </message>
    <message>
        <source>Group moved</source>
        <translation>Group moved</translation>
    </message>
    <message>
        <source>Group dissolved</source>
        <translation>Group dissolved</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Selection</translation>
    </message>
    <message>
        <source>Size of the canvas</source>
        <translation>Size of the canvas</translation>
    </message>
    <message>
        <source>Picture as paint</source>
        <translation>Picture as paint</translation>
    </message>
    <message>
        <source>Picture to trace</source>
        <translation>Picture to trace</translation>
    </message>
    <message>
        <source>Place of the traced picture</source>
        <translation>Place of the traced picture</translation>
    </message>
    <message>
        <source>Paint pasted</source>
        <translation>Paint pasted</translation>
    </message>
    <message>
        <source>Filled with paint</source>
        <translation>Filled with paint</translation>
    </message>
    <message>
        <source>Painting scaled</source>
        <translation>Painting scaled</translation>
    </message>
    <message>
        <source>Ground toned</source>
        <translation>Ground toned</translation>
    </message>
    <message>
        <source>Painting rotated</source>
        <translation>Painting rotated</translation>
    </message>
    <message>
        <source>Masking fluid</source>
        <translation>Masking fluid</translation>
    </message>
    <message>
        <source>Selection masked</source>
        <translation>Selection masked</translation>
    </message>
    <message>
        <source>Masking peeled off</source>
        <translation>Masking peeled off</translation>
    </message>
    <message>
        <source>Reference picture</source>
        <translation>Reference picture</translation>
    </message>
    <message>
        <source>Place of a reference</source>
        <translation>Place of a reference</translation>
    </message>
    <message>
        <source>Order of the references</source>
        <translation>Order of the references</translation>
    </message>
    <message>
        <source>Reference taken away</source>
        <translation>Reference taken away</translation>
    </message>
    <message>
        <source>Texture laid</source>
        <translation>Texture laid</translation>
    </message>
    <message>
        <source>Dry paint adjusted</source>
        <translation>Dry paint adjusted</translation>
    </message>
</context>
<context>
    <name>pastoso::glass</name>
    <message>
        <source> s</source>
        <translation> s</translation>
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
        <translation>Pours for</translation>
    </message>
    <message>
        <source>How long the milk of a new glass is poured</source>
        <translation>How long the milk of a new glass is poured</translation>
    </message>
    <message>
        <source>Stream</source>
        <translation>Stream</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Speed</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Fat lifts</source>
        <translation>Fat lifts</translation>
    </message>
    <message>
        <source>How fast fat lets milk rise</source>
        <translation>How fast fat lets milk rise</translation>
    </message>
    <message>
        <source>Cold sinks</source>
        <translation>Cold sinks</translation>
    </message>
    <message>
        <source>How fast cold lets milk sink</source>
        <translation>How fast cold lets milk sink</translation>
    </message>
    <message>
        <source>Milky tea sinks</source>
        <translation>Milky tea sinks</translation>
    </message>
    <message>
        <source>How fast tea with milk in it sinks</source>
        <translation>How fast tea with milk in it sinks</translation>
    </message>
    <message>
        <source>Warms at rest in</source>
        <translation>Warms at rest in</translation>
    </message>
    <message>
        <source>Time in which milk at rest warms</source>
        <translation>Time in which milk at rest warms</translation>
    </message>
    <message>
        <source>A ball warms in</source>
        <translation>A ball warms in</translation>
    </message>
    <message>
        <source>Time in which a ball warms</source>
        <translation>Time in which a ball warms</translation>
    </message>
    <message>
        <source>Cold given on</source>
        <translation>Cold given on</translation>
    </message>
    <message>
        <source>Share of the milk&apos;s cold that the tea gets</source>
        <translation>Share of the milk&apos;s cold that the tea gets</translation>
    </message>
    <message>
        <source>First ball after</source>
        <translation>First ball after</translation>
    </message>
    <message>
        <source>When the first ball forms</source>
        <translation>When the first ball forms</translation>
    </message>
    <message>
        <source>A ball every</source>
        <translation>A ball every</translation>
    </message>
    <message>
        <source>Time between two balls, in the mean</source>
        <translation>Time between two balls, in the mean</translation>
    </message>
    <message>
        <source>Ball&apos;s radius</source>
        <translation>Ball&apos;s radius</translation>
    </message>
    <message>
        <source>Radius of a ball, in the mean</source>
        <translation>Radius of a ball, in the mean</translation>
    </message>
    <message>
        <source>Sizes differ by</source>
        <translation>Sizes differ by</translation>
    </message>
    <message>
        <source>How much balls differ in size</source>
        <translation>How much balls differ in size</translation>
    </message>
    <message>
        <source>A warm ball in</source>
        <translation>A warm ball in</translation>
    </message>
    <message>
        <source>Time in which a warm ball dissolves</source>
        <translation>Time in which a warm ball dissolves</translation>
    </message>
    <message>
        <source>On top in</source>
        <translation>On top in</translation>
    </message>
    <message>
        <source>Time in which milk under the surface dissolves</source>
        <translation>Time in which milk under the surface dissolves</translation>
    </message>
    <message>
        <source>On top is</source>
        <translation>On top is</translation>
    </message>
    <message>
        <source>How far down that is</source>
        <translation>How far down that is</translation>
    </message>
    <message>
        <source>At rest in</source>
        <translation>At rest in</translation>
    </message>
    <message>
        <source>Time in which milk at rest dissolves</source>
        <translation>Time in which milk at rest dissolves</translation>
    </message>
    <message>
        <source>All from</source>
        <translation>All from</translation>
    </message>
    <message>
        <source>When all milk begins to dissolve</source>
        <translation>When all milk begins to dissolve</translation>
    </message>
    <message>
        <source>Warm below</source>
        <translation>Warm below</translation>
    </message>
    <message>
        <source>Coldness below which a ball dissolves</source>
        <translation>Coldness below which a ball dissolves</translation>
    </message>
    <message>
        <source>Milk spreads</source>
        <translation>Milk spreads</translation>
    </message>
    <message>
        <source>How dissolved milk spreads</source>
        <translation>How dissolved milk spreads</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viscosity</translation>
    </message>
    <message>
        <source>Kinematic viscosity: water 1, oil 80, honey 5000</source>
        <translation>Kinematic viscosity: water 1, oil 80, honey 5000</translation>
    </message>
    <message>
        <source>Heat spreads</source>
        <translation>Heat spreads</translation>
    </message>
    <message>
        <source>How heat spreads</source>
        <translation>How heat spreads</translation>
    </message>
    <message>
        <source>Whirls kept</source>
        <translation>Whirls kept</translation>
    </message>
    <message>
        <source>Force that keeps small whirls alive</source>
        <translation>Force that keeps small whirls alive</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Time step</translation>
    </message>
    <message>
        <source>Length of a time step</source>
        <translation>Length of a time step</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Pressure within</source>
        <translation>Pressure within</translation>
    </message>
    <message>
        <source>How exact the pressure is solved</source>
        <translation>How exact the pressure is solved</translation>
    </message>
    <message>
        <source>Pouring</source>
        <translation>Pouring</translation>
    </message>
    <message>
        <source>Sinking and rising</source>
        <translation>Sinking and rising</translation>
    </message>
    <message>
        <source>Balls of milk</source>
        <translation>Balls of milk</translation>
    </message>
    <message>
        <source>Dissolving</source>
        <translation>Dissolving</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Flow</translation>
    </message>
    <message>
        <source>Milk</source>
        <translation>Milk</translation>
    </message>
    <message>
        <source>How much milk is poured into a new glass by itself</source>
        <translation>How much milk is poured into a new glass by itself</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>Force reaches</source>
        <translation>Force reaches</translation>
    </message>
    <message>
        <source>How far the force reaches from its axis</source>
        <translation>How far the force reaches from its axis</translation>
    </message>
    <message>
        <source>Tank: liquid falls</source>
        <translation>Tank: liquid falls</translation>
    </message>
    <message>
        <source>Tank: two liquids meet</source>
        <translation>Tank: two liquids meet</translation>
    </message>
    <message>
        <source>Back to the painting</source>
        <translation>Back to the painting</translation>
    </message>
    <message>
        <source>The glass waits as it is, and so did the painting</source>
        <translation>The glass waits as it is, and so did the painting</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Gravity</translation>
    </message>
    <message>
        <source>How fast what falls gets faster</source>
        <translation>How fast what falls gets faster</translation>
    </message>
    <message>
        <source>Lively</source>
        <translation>Lively</translation>
    </message>
    <message>
        <source>What of its own velocity a drop keeps from step to step: less is calmer</source>
        <translation>What of its own velocity a drop keeps from step to step: less is calmer</translation>
    </message>
    <message>
        <source>Volume mended</source>
        <translation>Volume mended</translation>
    </message>
    <message>
        <source>How much of a wrong density a step mends</source>
        <translation>How much of a wrong density a step mends</translation>
    </message>
    <message>
        <source>Way of a step</source>
        <translation>Way of a step</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Numbers</translation>
    </message>
    <message>
        <source>Each number of the liquid</source>
        <translation>Each number of the liquid</translation>
    </message>
    <message>
        <source>thin as water</source>
        <translation>thin as water</translation>
    </message>
    <message>
        <source>thick as honey</source>
        <translation>thick as honey</translation>
    </message>
    <message>
        <source>Its viscosity</source>
        <translation>Its viscosity</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>calm</translation>
    </message>
    <message>
        <source>lively</source>
        <translation>lively</translation>
    </message>
    <message>
        <source>How much of its own movement each drop keeps</source>
        <translation>How much of its own movement each drop keeps</translation>
    </message>
    <message>
        <source>warm milk</source>
        <translation>warm milk</translation>
    </message>
    <message>
        <source>cold milk</source>
        <translation>cold milk</translation>
    </message>
    <message>
        <source>Warm milk spreads under the surface, cold milk falls to the floor</source>
        <translation>Warm milk spreads under the surface, cold milk falls to the floor</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>thin</translation>
    </message>
    <message>
        <source>creamy</source>
        <translation>creamy</translation>
    </message>
    <message>
        <source>Thin milk stays below and mixes soon, creamy milk rises in large soft clouds</source>
        <translation>Thin milk stays below and mixes soon, creamy milk rises in large soft clouds</translation>
    </message>
    <message>
        <source>hot tea</source>
        <translation>hot tea</translation>
    </message>
    <message>
        <source>ice-cold tea</source>
        <translation>ice-cold tea</translation>
    </message>
    <message>
        <source>Hot tea warms the milk, and it rises again; in ice-cold tea it lies where it fell</source>
        <translation>Hot tea warms the milk, and it rises again; in ice-cold tea it lies where it fell</translation>
    </message>
    <message>
        <source>Cold milk</source>
        <translation>Cold milk</translation>
    </message>
    <message>
        <source>Cold milk sinks, and comes up again in soft clouds as it warms</source>
        <translation>Cold milk sinks, and comes up again in soft clouds as it warms</translation>
    </message>
    <message>
        <source>Cold brew</source>
        <translation>Cold brew</translation>
    </message>
    <message>
        <source>A thin stream into cold tea: it heaps up on the floor and stays there for long</source>
        <translation>A thin stream into cold tea: it heaps up on the floor and stays there for long</translation>
    </message>
    <message>
        <source>Cream</source>
        <translation>Cream</translation>
    </message>
    <message>
        <source>Thick cream turns round and floats on the tea</source>
        <translation>Thick cream turns round and floats on the tea</translation>
    </message>
    <message>
        <source>A drop</source>
        <translation>A drop</translation>
    </message>
    <message>
        <source>A little thin milk, drawn out to fingers and veils</source>
        <translation>A little thin milk, drawn out to fingers and veils</translation>
    </message>
    <message>
        <source>Stirred</source>
        <translation>Stirred</translation>
    </message>
    <message>
        <source>The spoon goes round while the milk is poured</source>
        <translation>The spoon goes round while the milk is poured</translation>
    </message>
    <message>
        <source>White</source>
        <translation>White</translation>
    </message>
    <message>
        <source>A wide stream of milk billows up and fills the glass</source>
        <translation>A wide stream of milk billows up and fills the glass</translation>
    </message>
    <message>
        <source>poured low</source>
        <translation>poured low</translation>
    </message>
    <message>
        <source>from high</source>
        <translation>from high</translation>
    </message>
    <message>
        <source>Poured low, milk comes to lie on the floor; from high, it stirs the whole glass</source>
        <translation>Poured low, milk comes to lie on the floor; from high, it stirs the whole glass</translation>
    </message>
    <message>
        <source>Radius of the stream at the jug</source>
        <translation>Radius of the stream at the jug</translation>
    </message>
    <message>
        <source>Speed of the stream at the jug, downwards</source>
        <translation>Speed of the stream at the jug, downwards</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Falls</translation>
    </message>
    <message>
        <source>How high above the tea the lip of the jug is</source>
        <translation>How high above the tea the lip of the jug is</translation>
    </message>
    <message>
        <source>The longest way of a step, against the finest detail of the liquid: longer is faster and coarser</source>
        <translation>The longest way of a step, against the finest detail of the liquid: longer is faster and coarser</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::GlassChooser</name>
    <message>
        <source>What is in the glass</source>
        <translation>What is in the glass</translation>
    </message>
    <message>
        <source>What is in the glass: milk tea, or a tank of liquid</source>
        <translation>What is in the glass: milk tea, or a tank of liquid</translation>
    </message>
    <message>
        <source>Milk tea</source>
        <translation>Milk tea</translation>
    </message>
    <message>
        <source>Open a tank...</source>
        <translation>Open a tank...</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::GlassPage</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 of %2 s</translation>
    </message>
    <message>
        <source>%1   paused</source>
        <translation>%1   paused</translation>
    </message>
    <message>
        <source>%1   %2 steps/s</source>
        <translation>%1   %2 steps/s</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Paused</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::LiquidPictureDialog</name>
    <message>
        <source>Pixels from left to right</source>
        <translation>Pixels from left to right</translation>
    </message>
    <message>
        <source>Pixels from top to bottom</source>
        <translation>Pixels from top to bottom</translation>
    </message>
    <message>
        <source>Ways of light for each pixel: four times as many, half the noise</source>
        <translation>Ways of light for each pixel: four times as many, half the noise</translation>
    </message>
    <message>
        <source>As a surface</source>
        <translation>As a surface</translation>
    </message>
    <message>
        <source>As a cloud</source>
        <translation>As a cloud</translation>
    </message>
    <message>
        <source>How milk that has not dissolved is seen: a cloud is softer and takes longer</source>
        <translation>How milk that has not dissolved is seen: a cloud is softer and takes longer</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Width</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Height</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Samples</translation>
    </message>
    <message>
        <source>Milk</source>
        <translation>Milk</translation>
    </message>
    <message>
        <source>Use on the canvas</source>
        <translation>Use on the canvas</translation>
    </message>
    <message>
        <source>Puts the picture onto the painting as a layer of dry paint, and goes there</source>
        <translation>Puts the picture onto the painting as a layer of dry paint, and goes there</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Save...</translation>
    </message>
    <message>
        <source>As PNG and others as it is shown, or as EXR with the light itself</source>
        <translation>As PNG and others as it is shown, or as EXR with the light itself</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Close</translation>
    </message>
    <message>
        <source>Taking the noise out...</source>
        <translation>Taking the noise out...</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>Render</translation>
    </message>
    <message>
        <source>Keep the picture as fine as it is by now</source>
        <translation>Keep the picture as fine as it is by now</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Save the picture</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Pictures (%1)</translation>
    </message>
    <message>
        <source>Finding the surface...</source>
        <translation>Finding the surface...</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) in %1 s, without noise</source>
        <translation>
            <numerusform>%n sample in %1 s, without noise</numerusform>
            <numerusform>%n samples in %1 s, without noise</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n sample(s)</source>
        <translation>
            <numerusform>%1 of %n sample</numerusform>
            <numerusform>%1 of %n samples</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) in %1 s: too few to take all noise out</source>
        <translation>
            <numerusform>%n sample in %1 s: too few to take all noise out</numerusform>
            <numerusform>%n samples in %1 s: too few to take all noise out</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pastoso::glass::TankPage</name>
    <message>
        <source>Moment of the tank</source>
        <translation>Moment of the tank</translation>
    </message>
    <message>
        <source>Drag to any moment of the tank; going on goes on from its last</source>
        <translation>Drag to any moment of the tank; going on goes on from its last</translation>
    </message>
    <message>
        <source>Liquid in the tank, and how many steps a second are computed</source>
        <translation>Liquid in the tank, and how many steps a second are computed</translation>
    </message>
    <message>
        <source>Filling the tank...</source>
        <translation>Filling the tank...</translation>
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
        <translation>Tank</translation>
    </message>
    <message>
        <source>Balls and drain</source>
        <translation>Balls and drain</translation>
    </message>
    <message>
        <source>Ball&apos;s radius</source>
        <translation>Ball&apos;s radius</translation>
    </message>
    <message>
        <source>How large the ball is that falls where you press</source>
        <translation>How large the ball is that falls where you press</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Milk in it</source>
        <translation>Milk in it</translation>
    </message>
    <message>
        <source>How much of the ball is milk</source>
        <translation>How much of the ball is milk</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Speed</translation>
    </message>
    <message>
        <source>How fast the air goes</source>
        <translation>How fast the air goes</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Blows to</source>
        <translation>Blows to</translation>
    </message>
    <message>
        <source>0 to the right along the front, 90 away from it</source>
        <translation>0 to the right along the front, 90 away from it</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Drags</source>
        <translation>Drags</translation>
    </message>
    <message>
        <source>How firmly it takes the liquid&apos;s surface along</source>
        <translation>How firmly it takes the liquid&apos;s surface along</translation>
    </message>
    <message>
        <source> /s</source>
        <translation> /s</translation>
    </message>
    <message>
        <source>Look and export</source>
        <translation>Look and export</translation>
    </message>
    <message>
        <source>Liquid</source>
        <translation>Liquid</translation>
    </message>
    <message>
        <source>Every step into a folder</source>
        <translation>Every step into a folder</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::TeaPage</name>
    <message>
        <source>Moment of the tea</source>
        <translation>Moment of the tea</translation>
    </message>
    <message>
        <source>Drag to any moment of the glass; going on goes on from its last</source>
        <translation>Drag to any moment of the glass; going on goes on from its last</translation>
    </message>
    <message>
        <source>Milk poured so far, and how many steps of 1/30 s a second are computed</source>
        <translation>Milk poured so far, and how many steps of 1/30 s a second are computed</translation>
    </message>
    <message>
        <source>Filling the glass...</source>
        <translation>Filling the glass...</translation>
    </message>
    <message>
        <source>%1 ml of milk</source>
        <translation>%1 ml of milk</translation>
    </message>
    <message>
        <source>Press on the tea to pour milk where you point</source>
        <translation>Press on the tea to pour milk where you point</translation>
    </message>
    <message>
        <source>The glass is full</source>
        <translation>The glass is full</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::TeaPanel</name>
    <message>
        <source>Pictures</source>
        <translation>Pictures</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glass</translation>
    </message>
    <message>
        <source>Drops that the next glass&apos; milk is made of</source>
        <translation>Drops that the next glass&apos; milk is made of</translation>
    </message>
    <message>
        <source>Drops of milk</source>
        <translation>Drops of milk</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>Around the axis</source>
        <translation>Around the axis</translation>
    </message>
    <message>
        <source>How fast the stirring gets faster; below 0 it goes the other way round</source>
        <translation>How fast the stirring gets faster; below 0 it goes the other way round</translation>
    </message>
    <message>
        <source> rad/s²</source>
        <translation> rad/s²</translation>
    </message>
    <message>
        <source>Downwards</source>
        <translation>Downwards</translation>
    </message>
    <message>
        <source> m/s²</source>
        <translation> m/s²</translation>
    </message>
    <message>
        <source>A push down along the axis; below 0 it goes up</source>
        <translation>A push down along the axis; below 0 it goes up</translation>
    </message>
    <message>
        <source>Milk and tea</source>
        <translation>Milk and tea</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recipes</translation>
    </message>
    <message>
        <source>The next glass</source>
        <translation>The next glass</translation>
    </message>
    <message>
        <source>Fineness</source>
        <translation>Fineness</translation>
    </message>
    <message>
        <source>Parts that each side of the next glass is divided into: twice as many take sixteen times as long; balls rise from 64 on</source>
        <translation>Parts that each side of the next glass is divided into: twice as many take sixteen times as long; balls rise from 64 on</translation>
    </message>
</context>
<context>
    <name>pastoso::help::AboutDialog</name>
    <message>
        <source>About Pastoso</source>
        <translation>About Pastoso</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <source>This machine</source>
        <translation>This machine</translation>
    </message>
    <message>
        <source>Folders</source>
        <translation>Folders</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Libraries</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Licence</translation>
    </message>
</context>
<context>
    <name>pastoso::help::HelpView</name>
    <message>
        <source>Page of the manual</source>
        <translation>Page of the manual</translation>
    </message>
</context>
<context>
    <name>pastoso::help::HelpWindow</name>
    <message>
        <source>Manual</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Search the manual</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Pages of the manual</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>What was found</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Back</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Forward</translation>
    </message>
    <message>
        <source>Nothing is found.</source>
        <translation>Nothing is found.</translation>
    </message>
</context>
<context>
    <name>pastoso::help::TourBubble</name>
    <message>
        <source>Skip the tour</source>
        <translation>Skip the tour</translation>
    </message>
    <message>
        <source>Go on with the tour</source>
        <translation>Go on with the tour</translation>
    </message>
    <message>
        <source>Leave the tour, as Escape does; &quot;Show me round&quot; in the &quot;Help&quot; menu brings it back</source>
        <translation>Leave the tour, as Escape does; &quot;Show me round&quot; in the &quot;Help&quot; menu brings it back</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 of %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Done</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Next</translation>
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
        <translation>none</translation>
    </message>
    <message>
        <source>Graphics</source>
        <translation>Graphics</translation>
    </message>
    <message>
        <source>%1 (the processor draws, no graphics card)</source>
        <translation>%1 (the processor draws, no graphics card)</translation>
    </message>
    <message>
        <source>Its maker</source>
        <translation>Its maker</translation>
    </message>
    <message>
        <source>Shading language</source>
        <translation>Shading language</translation>
    </message>
    <message>
        <source>Largest texture</source>
        <translation>Largest texture</translation>
    </message>
    <message>
        <source>%1 pixels a side</source>
        <translation>%1 pixels a side</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, %3 for one of the layout</source>
        <translation>%1 × %2 pixels, %3 for one of the layout</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <source>System</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Processor</translation>
    </message>
    <message>
        <source>%1 at once, %2, kernels for %3</source>
        <translation>%1 at once, %2, kernels for %3</translation>
    </message>
    <message>
        <source>Free memory</source>
        <translation>Free memory</translation>
    </message>
    <message>
        <source>Windows by</source>
        <translation>Windows by</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Screen</translation>
    </message>
    <message>
        <source>Top up</source>
        <translation>Top up</translation>
    </message>
    <message>
        <source>Blot</source>
        <translation>Blot</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Swap</translation>
    </message>
    <message>
        <source>Pick paint</source>
        <translation>Pick paint</translation>
    </message>
    <message>
        <source>Pick colour</source>
        <translation>Pick colour</translation>
    </message>
    <message>
        <source>Left, right</source>
        <translation>Left, right</translation>
    </message>
    <message>
        <source>Above, below</source>
        <translation>Above, below</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Choose...</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Take away</translation>
    </message>
    <message>
        <source>Below the paint</source>
        <translation>Below the paint</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Fit</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>Upright</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Mirror</translation>
    </message>
    <message>
        <source>Watch it grow...</source>
        <translation>Watch it grow...</translation>
    </message>
    <message>
        <source>Make a time-lapse...</source>
        <translation>Make a time-lapse...</translation>
    </message>
    <message>
        <source>Save the recording...</source>
        <translation>Save the recording...</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Tool</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Colour</translation>
    </message>
    <message>
        <source>Physics</source>
        <translation>Physics</translation>
    </message>
    <message>
        <source>Guides</source>
        <translation>Guides</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Lights</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Layers</translation>
    </message>
    <message>
        <source>Tracing</source>
        <translation>Tracing</translation>
    </message>
    <message>
        <source>History</source>
        <translation>History</translation>
    </message>
    <message>
        <source>Navigator</source>
        <translation>Navigator</translation>
    </message>
    <message>
        <source>Recorder</source>
        <translation>Recorder</translation>
    </message>
    <message>
        <source>As it was painted</source>
        <translation>As it was painted</translation>
    </message>
    <message>
        <source>4 times as fast</source>
        <translation>4 times as fast</translation>
    </message>
    <message>
        <source>16 times as fast</source>
        <translation>16 times as fast</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>As fast as possible</translation>
    </message>
    <message>
        <source>New</source>
        <translation>New</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Open</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Save</translation>
    </message>
    <message>
        <source>Stir</source>
        <translation>Stir</translation>
    </message>
    <message>
        <source>Other way round</source>
        <translation>Other way round</translation>
    </message>
    <message>
        <source>Render a picture...</source>
        <translation>Render a picture...</translation>
    </message>
    <message>
        <source>Export the surface...</source>
        <translation>Export the surface...</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Start again</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Ball</translation>
    </message>
    <message>
        <source>Drain</source>
        <translation>Drain</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>Velocities</translation>
    </message>
    <message>
        <source>Export all moments...</source>
        <translation>Export all moments...</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Pictures</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Surfaces</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Pour</source>
        <translation>Pour</translation>
    </message>
    <message>
        <source>Paint it again, finer...</source>
        <translation>Paint it again, finer...</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>Brushes</translation>
    </message>
    <message>
        <source>Paints</source>
        <translation>Paints</translation>
    </message>
    <message>
        <source>Easel</source>
        <translation>Easel</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Snap</translation>
    </message>
    <message>
        <source>Add...</source>
        <translation>Add...</translation>
    </message>
    <message>
        <source>Own window</source>
        <translation>Own window</translation>
    </message>
    <message>
        <source>References</source>
        <translation>References</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>A recording is being played; the paint is yours when it has ended.</source>
        <translation>A recording is being played; the paint is yours when it has ended.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BackgroundExport</name>
    <message>
        <source>A file is being written already. Try again in a moment.</source>
        <translation>A file is being written already. Try again in a moment.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BrushBundles</name>
    <message>
        <source>Import tools</source>
        <translation>Import tools</translation>
    </message>
    <message>
        <source>Bundles of tools (*.zip)</source>
        <translation>Bundles of tools (*.zip)</translation>
    </message>
    <message>
        <source>You have all tools of that bundle already.</source>
        <translation>You have all tools of that bundle already.</translation>
    </message>
    <message numerus="yes">
        <source>%n tool(s) added to your own.</source>
        <translation>
            <numerusform>%n tool added to your own.</numerusform>
            <numerusform>%n tools added to your own.</numerusform>
        </translation>
    </message>
    <message>
        <source>You have no tools of your own yet; save the one in hand first.</source>
        <translation>You have no tools of your own yet; save the one in hand first.</translation>
    </message>
    <message>
        <source>Export my tools</source>
        <translation>Export my tools</translation>
    </message>
    <message>
        <source>my-tools.zip</source>
        <translation>my-tools.zip</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Saved %1.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BrushJar</name>
    <message>
        <source>%1 was read again; the next stroke is painted with it.</source>
        <translation>%1 was read again; the next stroke is painted with it.</translation>
    </message>
    <message>
        <source>Name of the tool:</source>
        <translation>Name of the tool:</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>My %1</source>
        <translation>My %1</translation>
    </message>
    <message>
        <source>Save as my own</source>
        <translation>Save as my own</translation>
    </message>
    <message>
        <source>There is already a tool of your own named &quot;%1&quot;.</source>
        <translation>There is already a tool of your own named &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Overwrite</translation>
    </message>
    <message>
        <source>Kept &quot;%1&quot; among your own.</source>
        <translation>Kept &quot;%1&quot; among your own.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Rename</translation>
    </message>
    <message>
        <source>Throw your tool &quot;%1&quot; away? Its file is deleted.</source>
        <translation>Throw your tool &quot;%1&quot; away? Its file is deleted.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is thrown away; what you have in hand stays.</source>
        <translation>&quot;%1&quot; is thrown away; what you have in hand stays.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BrushShelving</name>
    <message>
        <source>A tag needs a name.</source>
        <translation>A tag needs a name.</translation>
    </message>
    <message>
        <source>New tag</source>
        <translation>New tag</translation>
    </message>
    <message>
        <source>Name of the tag:</source>
        <translation>Name of the tag:</translation>
    </message>
</context>
<context>
    <name>pastoso::main::CanvasSizing</name>
    <message>
        <source>A recording is being played; the canvas is yours when it has ended.</source>
        <translation>A recording is being played; the canvas is yours when it has ended.</translation>
    </message>
    <message>
        <source>The selection reaches over the whole canvas: there is nothing to cut.</source>
        <translation>The selection reaches over the whole canvas: there is nothing to cut.</translation>
    </message>
    <message>
        <source>The canvas is %1 × %2 mm now; Undo brings back what it was.</source>
        <translation>The canvas is %1 × %2 mm now; Undo brings back what it was.</translation>
    </message>
    <message>
        <source>Making the canvas</source>
        <translation>Making the canvas</translation>
    </message>
    <message>
        <source>Meanwhile the canvas has become another one; that keeps its size.</source>
        <translation>Meanwhile the canvas has become another one; that keeps its size.</translation>
    </message>
    <message>
        <source>The selection is too soft to crop to: nothing is outlined.</source>
        <translation>The selection is too soft to crop to: nothing is outlined.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Clipboard</name>
    <message>
        <source>There is no paint to copy here.</source>
        <translation>There is no paint to copy here.</translation>
    </message>
    <message>
        <source>Copied; paste it as a layer, or as a picture in another program.</source>
        <translation>Copied; paste it as a layer, or as a picture in another program.</translation>
    </message>
    <message>
        <source>Pasted</source>
        <translation>Pasted</translation>
    </message>
    <message>
        <source>There is nothing to paste: no paint and no picture has been copied.</source>
        <translation>There is nothing to paste: no paint and no picture has been copied.</translation>
    </message>
    <message>
        <source>The copied paint is too large to go to another painting as paint (at most %1 MB); a picture of it goes.</source>
        <translation>The copied paint is too large to go to another painting as paint (at most %1 MB); a picture of it goes.</translation>
    </message>
    <message>
        <source>The clipboard</source>
        <translation>The clipboard</translation>
    </message>
    <message>
        <source>What was dragged here</source>
        <translation>What was dragged here</translation>
    </message>
</context>
<context>
    <name>pastoso::main::DroppedFiles</name>
    <message>
        <source>%1 is no painting and no picture that can be opened.</source>
        <translation>%1 is no painting and no picture that can be opened.</translation>
    </message>
    <message>
        <source>Put it on a &amp;layer, as dry paint</source>
        <translation>Put it on a &amp;layer, as dry paint</translation>
    </message>
    <message>
        <source>&amp;Trace it, below the paint</source>
        <translation>&amp;Trace it, below the paint</translation>
    </message>
    <message>
        <source>&amp;New canvas made of it</source>
        <translation>&amp;New canvas made of it</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>Leave it</translation>
    </message>
    <message>
        <source>&amp;Keep it beside the canvas, as a reference</source>
        <translation>&amp;Keep it beside the canvas, as a reference</translation>
    </message>
    <message>
        <source>Put each on a &amp;layer, as dry paint</source>
        <translation>Put each on a &amp;layer, as dry paint</translation>
    </message>
    <message>
        <source>&amp;Keep them beside the canvas, as references</source>
        <translation>&amp;Keep them beside the canvas, as references</translation>
    </message>
    <message>
        <source>Leave them</source>
        <translation>Leave them</translation>
    </message>
    <message>
        <source>There is no picture in it that can be read.</source>
        <translation>There is no picture in it that can be read.</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>Each of the other files opens in a window of its own. Open %1 more windows?</source>
        <translation>Each of the other files opens in a window of its own. Open %1 more windows?</translation>
    </message>
    <message>
        <source>Open them</source>
        <translation>Open them</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Picture</translation>
    </message>
</context>
<context>
    <name>pastoso::main::DryAdjusting</name>
    <message>
        <source>The layer that you paint on has no dry paint.</source>
        <translation>The layer that you paint on has no dry paint.</translation>
    </message>
    <message>
        <source>The layer that you paint on has no dry paint where it is selected.</source>
        <translation>The layer that you paint on has no dry paint where it is selected.</translation>
    </message>
    <message>
        <source>The glaze lies over the dry paint.</source>
        <translation>The glaze lies over the dry paint.</translation>
    </message>
    <message>
        <source>The dry paint has other pigments in it.</source>
        <translation>The dry paint has other pigments in it.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Exporting</name>
    <message>
        <source>Exported %1 and %2 more; heights from %3 mm (black) to %4 mm (white).</source>
        <translation>Exported %1 and %2 more; heights from %3 mm (black) to %4 mm (white).</translation>
    </message>
    <message>
        <source>Exported %1: %2 × %3 pixels.</source>
        <translation>Exported %1: %2 × %3 pixels.</translation>
    </message>
    <message>
        <source>Stopped; %1 holds the pictures that are complete.</source>
        <translation>Stopped; %1 holds the pictures that are complete.</translation>
    </message>
    <message>
        <source>Stopped; %1 was not written.</source>
        <translation>Stopped; %1 was not written.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>painting</translation>
    </message>
    <message>
        <source>%1 is still being written; wait for it, or stop it.</source>
        <translation>%1 is still being written; wait for it, or stop it.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Exporting %1</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>%1 is still being written.</source>
        <translation>%1 is still being written.</translation>
    </message>
    <message>
        <source>Close when it is done</source>
        <translation>Close when it is done</translation>
    </message>
    <message>
        <source>Stop it</source>
        <translation>Stop it</translation>
    </message>
    <message>
        <source>The window closes as soon as %1 is written.</source>
        <translation>The window closes as soon as %1 is written.</translation>
    </message>
    <message>
        <source>Export recording</source>
        <translation>Export recording</translation>
    </message>
    <message>
        <source>painting.json</source>
        <translation>painting.json</translation>
    </message>
    <message>
        <source>Recordings (*.json)</source>
        <translation>Recordings (*.json)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Saved %1.</translation>
    </message>
    <message numerus="yes">
        <source>Exported %1: %n triangle(s), %2 × %3 mm.</source>
        <translation>
            <numerusform>Exported %1: %n triangle, %2 × %3 mm.</numerusform>
            <numerusform>Exported %1: %n triangles, %2 × %3 mm.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Exported %1: %n frame(s) of %2 × %3 pixels.</source>
        <translation>
            <numerusform>Exported %1: %n frame of %2 × %3 pixels.</numerusform>
            <numerusform>Exported %1: %n frames of %2 × %3 pixels.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Nothing was exported: make room or choose another place.</source>
        <translation>%1 Nothing was exported: make room or choose another place.</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Export...</translation>
    </message>
    <message numerus="yes">
        <source>Saved %1: %n layer(s) of %2 × %3 pixels.</source>
        <translation>
            <numerusform>Saved %1: %n layer of %2 × %3 pixels.</numerusform>
            <numerusform>Saved %1: %n layers of %2 × %3 pixels.</numerusform>
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
        <translation>Save a copy</translation>
    </message>
</context>
<context>
    <name>pastoso::main::FillCommands</name>
    <message>
        <source>Nothing was poured. Esc again goes back to painting.</source>
        <translation>Nothing was poured. Esc again goes back to painting.</translation>
    </message>
    <message>
        <source>Drag a line from the paint in hand to the second paint; Shift keeps it level, upright or halfway. Esc, or taking a tool, goes back to painting.</source>
        <translation>Drag a line from the paint in hand to the second paint; Shift keeps it level, upright or halfway. Esc, or taking a tool, goes back to painting.</translation>
    </message>
    <message>
        <source>The brush paints again.</source>
        <translation>The brush paints again.</translation>
    </message>
    <message>
        <source>%1 mm of paint are poured over the whole canvas.</source>
        <translation>%1 mm of paint are poured over the whole canvas.</translation>
    </message>
    <message>
        <source>%1 mm of paint are poured over what is selected.</source>
        <translation>%1 mm of paint are poured over what is selected.</translation>
    </message>
    <message>
        <source>Thickness of fills</source>
        <translation>Thickness of fills</translation>
    </message>
    <message>
        <source>Fills and gradients pour an even film of wet paint, as thick as this: 0.05 mm shows what lies below, 0.2 mm covers, 1 mm stands as a paste.</source>
        <translation>Fills and gradients pour an even film of wet paint, as thick as this: 0.05 mm shows what lies below, 0.2 mm covers, 1 mm stands as a paste.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Thickness</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Keep</translation>
    </message>
    <message>
        <source>Toned ground</source>
        <translation>Toned ground</translation>
    </message>
    <message>
        <source>An even coat of the paint in hand covers the whole canvas, dry at once, on a layer below all others: 0.02 mm tints the canvas, 0.1 mm covers it.</source>
        <translation>An even coat of the paint in hand covers the whole canvas, dry at once, on a layer below all others: 0.02 mm tints the canvas, 0.1 mm covers it.</translation>
    </message>
    <message>
        <source>Tone the ground</source>
        <translation>Tone the ground</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Ground</translation>
    </message>
</context>
<context>
    <name>pastoso::main::GlassMode</name>
    <message>
        <source>Surfaces (*.pbrt *.obj *.ply *.stl)</source>
        <translation>Surfaces (*.pbrt *.obj *.ply *.stl)</translation>
    </message>
</context>
<context>
    <name>pastoso::main::GuideCommands</name>
    <message>
        <source>Strokes around the middle: %1</source>
        <translation>Strokes around the middle: %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::KeepingUp</name>
    <message>
        <source>Real time</source>
        <translation>Real time</translation>
    </message>
    <message>
        <source>Thin less</source>
        <translation>Thin less</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Dry</source>
        <translation>Dry</translation>
    </message>
</context>
<context>
    <name>pastoso::main::LayerCommands</name>
    <message>
        <source>Layer %1</source>
        <translation>Layer %1</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Group %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::LayerTransform</name>
    <message>
        <source>A recording is being played; the layers are yours when it has ended.</source>
        <translation>A recording is being played; the layers are yours when it has ended.</translation>
    </message>
    <message>
        <source>There is no paint on this layer.</source>
        <translation>There is no paint on this layer.</translation>
    </message>
    <message>
        <source>There is no paint of this layer in the selection.</source>
        <translation>There is no paint of this layer in the selection.</translation>
    </message>
    <message>
        <source>The paint stays as it is.</source>
        <translation>The paint stays as it is.</translation>
    </message>
    <message>
        <source>Drag inside to move, a handle to scale, outside to turn (Shift: in steps), with Ctrl a corner or a side alone. Enter applies, Esc gives up.</source>
        <translation>Drag inside to move, a handle to scale, outside to turn (Shift: in steps), with Ctrl a corner or a side alone. Enter applies, Esc gives up.</translation>
    </message>
    <message>
        <source>No corner is chosen</source>
        <translation>No corner is chosen</translation>
    </message>
    <message>
        <source>Upper left corner</source>
        <translation>Upper left corner</translation>
    </message>
    <message>
        <source>Upper right corner</source>
        <translation>Upper right corner</translation>
    </message>
    <message>
        <source>Lower right corner</source>
        <translation>Lower right corner</translation>
    </message>
    <message>
        <source>Lower left corner</source>
        <translation>Lower left corner</translation>
    </message>
    <message>
        <source>%1 at %2, %3 mm</source>
        <translation>%1 at %2, %3 mm</translation>
    </message>
</context>
<context>
    <name>pastoso::main::LightChoice</name>
    <message>
        <source>Light from a file</source>
        <translation>Light from a file</translation>
    </message>
    <message>
        <source>Spectra (*.csv)</source>
        <translation>Spectra (*.csv)</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Loading</name>
    <message>
        <source>%1: given up; all is as it was.</source>
        <translation>%1: given up; all is as it was.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancel</translation>
    </message>
    <message>
        <source>%1: wait for it, or cancel it.</source>
        <translation>%1: wait for it, or cancel it.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::MaskingCommands</name>
    <message>
        <source>Paint masking fluid, as wide as the tool in hand: no paint gets below it. Alt peels it off again; Esc, or taking a tool, goes back to painting.</source>
        <translation>Paint masking fluid, as wide as the tool in hand: no paint gets below it. Alt peels it off again; Esc, or taking a tool, goes back to painting.</translation>
    </message>
    <message>
        <source>Drag a strip of masking tape, as wide as the tool in hand; Shift keeps it level, upright or halfway. Alt peels it off again; Esc, or taking a tool, goes back to painting.</source>
        <translation>Drag a strip of masking tape, as wide as the tool in hand; Shift keeps it level, upright or halfway. Alt peels it off again; Esc, or taking a tool, goes back to painting.</translation>
    </message>
    <message>
        <source>Nothing was masked. Esc again goes back to painting.</source>
        <translation>Nothing was masked. Esc again goes back to painting.</translation>
    </message>
    <message>
        <source>Peels the masking off there.</source>
        <translation>Peels the masking off there.</translation>
    </message>
    <message>
        <source>Masks the canvas there.</source>
        <translation>Masks the canvas there.</translation>
    </message>
    <message>
        <source>The brush paints again.</source>
        <translation>The brush paints again.</translation>
    </message>
    <message>
        <source>The masking is peeled off.</source>
        <translation>The masking is peeled off.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::NewWindow</name>
    <message>
        <source>%1 cannot be started: there is no other window.</source>
        <translation>%1 cannot be started: there is no other window.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintPicking</name>
    <message>
        <source>Picked up wet paint: %1</source>
        <translation>Picked up wet paint: %1</translation>
    </message>
    <message>
        <source>Picked up dry paint: %1</source>
        <translation>Picked up dry paint: %1</translation>
    </message>
    <message>
        <source>There is no colour to pick beside the canvas.</source>
        <translation>There is no colour to pick beside the canvas.</translation>
    </message>
    <message>
        <source>Picked the colour seen: %1</source>
        <translation>Picked the colour seen: %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintSettings</name>
    <message>
        <source>Open a palette</source>
        <translation>Open a palette</translation>
    </message>
    <message>
        <source>Palettes (*.gpl)</source>
        <translation>Palettes (*.gpl)</translation>
    </message>
    <message>
        <source>Colours of a picture</source>
        <translation>Colours of a picture</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Pictures (%1)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Reading %1</translation>
    </message>
    <message>
        <source>Save the palette</source>
        <translation>Save the palette</translation>
    </message>
    <message>
        <source>my-palette.gpl</source>
        <translation>my-palette.gpl</translation>
    </message>
    <message>
        <source>Export my paints</source>
        <translation>Export my paints</translation>
    </message>
    <message>
        <source>my-paints.json</source>
        <translation>my-paints.json</translation>
    </message>
    <message>
        <source>Sets of paints (*.json)</source>
        <translation>Sets of paints (*.json)</translation>
    </message>
    <message>
        <source>Import paints</source>
        <translation>Import paints</translation>
    </message>
    <message>
        <source>You have all paints of that set already.</source>
        <translation>You have all paints of that set already.</translation>
    </message>
    <message numerus="yes">
        <source>%n paint(s) added to your own.</source>
        <translation>
            <numerusform>%n paint added to your own.</numerusform>
            <numerusform>%n paints added to your own.</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Saved %1.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintTime</name>
    <message>
        <source>%1 × time</source>
        <translation>%1 × time</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintingAgain</name>
    <message>
        <source>painting</source>
        <translation>painting</translation>
    </message>
    <message>
        <source>Nothing has been painted yet that could be painted again.</source>
        <translation>Nothing has been painted yet that could be painted again.</translation>
    </message>
    <message>
        <source>The painting</source>
        <translation>The painting</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Save</translation>
    </message>
    <message>
        <source>Paintings and pictures (%1)</source>
        <translation>Paintings and pictures (%1)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Saved %1.</translation>
    </message>
    <message>
        <source>Saved %1: %2 × %3 pixels.</source>
        <translation>Saved %1: %2 × %3 pixels.</translation>
    </message>
    <message>
        <source>Another question is open; answer it first.</source>
        <translation>Another question is open; answer it first.</translation>
    </message>
    <message>
        <source>The finer painting is still being written.</source>
        <translation>The finer painting is still being written.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PictureLayers</name>
    <message>
        <source>Layer from a picture</source>
        <translation>Layer from a picture</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>Pictures (%1);;All files (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Reading %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PopupCommands</name>
    <message>
        <source>Mirror</source>
        <translation>Mirror</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Fit</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ProjectFiles</name>
    <message>
        <source>Open re&amp;cent</source>
        <translation>Open re&amp;cent</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Saved %1.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Save</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>None yet</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Canvas</translation>
    </message>
    <message>
        <source>%1[*] %2 × %3 mm</source>
        <translation>%1[*] %2 × %3 mm</translation>
    </message>
    <message>
        <source>Saving %1...</source>
        <translation>Saving %1...</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Open</translation>
    </message>
    <message>
        <source>Paintings and pictures (*.pastoso *.ora %1);;All files (*)</source>
        <translation>Paintings and pictures (*.pastoso *.ora %1);;All files (*)</translation>
    </message>
    <message>
        <source>painting.pastoso</source>
        <translation>painting.pastoso</translation>
    </message>
    <message>
        <source>Paintings (*.pastoso)</source>
        <translation>Paintings (*.pastoso)</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>The painting on the easel has changes that are not saved.</source>
        <translation>The painting on the easel has changes that are not saved.</translation>
    </message>
    <message>
        <source>Discard them</source>
        <translation>Discard them</translation>
    </message>
    <message>
        <source>Painted from its strokes; the brush is yours when it is done.</source>
        <translation>Painted from its strokes; the brush is yours when it is done.</translation>
    </message>
    <message>
        <source>What you paint is kept again.</source>
        <translation>What you paint is kept again.</translation>
    </message>
    <message>
        <source>Should the program fail, this painting would come back slowly, from its strokes alone: %1 %2 are free there. Make room; you can paint on.</source>
        <translation>Should the program fail, this painting would come back slowly, from its strokes alone: %1 %2 are free there. Make room; you can paint on.</translation>
    </message>
    <message>
        <source>The disk is full: what you paint now would be lost if the program failed. It is kept in %1, where %2 are free and %3 wait to be written. Make room there, or save the painting to another disk. You can paint on; as soon as there is room, all of it is kept again.</source>
        <translation>The disk is full: what you paint now would be lost if the program failed. It is kept in %1, where %2 are free and %3 wait to be written. Make room there, or save the painting to another disk. You can paint on; as soon as there is room, all of it is kept again.</translation>
    </message>
    <message>
        <source>What you paint now would be lost if the program failed: %1 %2 are free there. Make room, or save the painting to another disk. You can paint on; as soon as it can be, all of it is kept again.</source>
        <translation>What you paint now would be lost if the program failed: %1 %2 are free there. Make room, or save the painting to another disk. You can paint on; as soon as it can be, all of it is kept again.</translation>
    </message>
    <message>
        <source>The painting</source>
        <translation>The painting</translation>
    </message>
    <message>
        <source>%1 The painting is not saved: make room or choose another place, and save again.</source>
        <translation>%1 The painting is not saved: make room or choose another place, and save again.</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Save as...</translation>
    </message>
    <message>
        <source>Another program has changed %1 since you opened or saved it here. Replacing it loses what was changed there.</source>
        <translation>Another program has changed %1 since you opened or saved it here. Replacing it loses what was changed there.</translation>
    </message>
    <message>
        <source>%1 is protected against being written to.</source>
        <translation>%1 is protected against being written to.</translation>
    </message>
    <message>
        <source>%1 The painting was not saved by itself.</source>
        <translation>%1 The painting was not saved by itself.</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Save...</translation>
    </message>
    <message>
        <source>%1 - %2</source>
        <translation>%1 - %2</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Opening %1</translation>
    </message>
    <message>
        <source>Making the canvas</source>
        <translation>Making the canvas</translation>
    </message>
    <message>
        <source>Putting it on the easel</source>
        <translation>Putting it on the easel</translation>
    </message>
    <message>
        <source>Recovering the painting</source>
        <translation>Recovering the painting</translation>
    </message>
    <message>
        <source>Save a version</source>
        <translation>Save a version</translation>
    </message>
</context>
<context>
    <name>pastoso::main::RangeSelection</name>
    <message>
        <source>Wet paint of this layer is up to %1 mm thick, %2 mm on average.</source>
        <translation>Wet paint of this layer is up to %1 mm thick, %2 mm on average.</translation>
    </message>
    <message>
        <source>Paint, wet and dry, stands up to %1 mm above the canvas, %2 mm on average.</source>
        <translation>Paint, wet and dry, stands up to %1 mm above the canvas, %2 mm on average.</translation>
    </message>
    <message>
        <source>Select by wetness</source>
        <translation>Select by wetness</translation>
    </message>
    <message>
        <source>Select by height</source>
        <translation>Select by height</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Recorder</name>
    <message>
        <source>Nothing has been painted yet that could be shown again.</source>
        <translation>Nothing has been painted yet that could be shown again.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ReferenceCommands</name>
    <message>
        <source>Add reference pictures</source>
        <translation>Add reference pictures</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>Pictures (%1);;All files (*)</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>the picture</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Picture</translation>
    </message>
    <message>
        <source>There is no picture in it; save it as a file, and drag that here.</source>
        <translation>There is no picture in it; save it as a file, and drag that here.</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Reading %1</translation>
    </message>
    <message>
        <source>Picked from the reference: %1</source>
        <translation>Picked from the reference: %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::RepaintWindow</name>
    <message>
        <source>Paused</source>
        <translation>Paused</translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation>about %1 left</translation>
    </message>
    <message>
        <source>How much is painted</source>
        <translation>How much is painted</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancel</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Save...</translation>
    </message>
    <message>
        <source>As a painting, or as a picture</source>
        <translation>As a painting, or as a picture</translation>
    </message>
    <message>
        <source>Put it on the easel</source>
        <translation>Put it on the easel</translation>
    </message>
    <message>
        <source>It cannot be painted any further</source>
        <translation>It cannot be painted any further</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Go on</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Close</translation>
    </message>
    <message>
        <source>It is not painted to its end yet. Give it up?</source>
        <translation>It is not painted to its end yet. Give it up?</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Finished</translation>
    </message>
    <message>
        <source>Painted again at %1 px/mm</source>
        <translation>Painted again at %1 px/mm</translation>
    </message>
    <message>
        <source>The finer painting is in no file yet. Throw it away?</source>
        <translation>The finer painting is in no file yet. Throw it away?</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ReplayWindow</name>
    <message>
        <source>How it was painted</source>
        <translation>How it was painted</translation>
    </message>
    <message>
        <source>Play, or stop for a moment (Space)</source>
        <translation>Play, or stop for a moment (Space)</translation>
    </message>
    <message>
        <source>Moment of the painting</source>
        <translation>Moment of the painting</translation>
    </message>
    <message>
        <source>Drag to any moment of the painting</source>
        <translation>Drag to any moment of the painting</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Speed</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Play</translation>
    </message>
    <message>
        <source>It cannot be shown any further</source>
        <translation>It cannot be shown any further</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 of %2</translation>
    </message>
</context>
<context>
    <name>pastoso::main::SelectionCommands</name>
    <message>
        <source>Outside the selection: nothing is painted there.</source>
        <translation>Outside the selection: nothing is painted there.</translation>
    </message>
    <message>
        <source>Nothing was selected. Esc again goes back to painting.</source>
        <translation>Nothing was selected. Esc again goes back to painting.</translation>
    </message>
    <message>
        <source>Tools keep to the outline. Esc, or taking a tool, goes back to painting.</source>
        <translation>Tools keep to the outline. Esc, or taking a tool, goes back to painting.</translation>
    </message>
    <message>
        <source>Drag around what tools shall keep to. Shift adds, Alt takes away, both keep what is in both; a click ends the selection.</source>
        <translation>Drag around what tools shall keep to. Shift adds, Alt takes away, both keep what is in both; a click ends the selection.</translation>
    </message>
    <message>
        <source>The brush paints again.</source>
        <translation>The brush paints again.</translation>
    </message>
    <message>
        <source>Selects what is inside.</source>
        <translation>Selects what is inside.</translation>
    </message>
    <message>
        <source>Adds what is inside to the selection.</source>
        <translation>Adds what is inside to the selection.</translation>
    </message>
    <message>
        <source>Takes what is inside out of the selection.</source>
        <translation>Takes what is inside out of the selection.</translation>
    </message>
    <message>
        <source>Keeps what is inside and was selected before.</source>
        <translation>Keeps what is inside and was selected before.</translation>
    </message>
    <message>
        <source>A recording is being played; the brush is yours when it has ended.</source>
        <translation>A recording is being played; the brush is yours when it has ended.</translation>
    </message>
    <message>
        <source>Nothing is selected: tools work on all of the canvas.</source>
        <translation>Nothing is selected: tools work on all of the canvas.</translation>
    </message>
    <message>
        <source>lasso</source>
        <translation>lasso</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>rectangle</translation>
    </message>
    <message>
        <source>ellipse</source>
        <translation>ellipse</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>polygon</translation>
    </message>
    <message>
        <source>contiguous colour</source>
        <translation>contiguous colour</translation>
    </message>
    <message>
        <source>similar colour</source>
        <translation>similar colour</translation>
    </message>
    <message>
        <source>Click the colour that tools shall keep to; drag to the right for more, to the left for less of it. Shift adds, Alt takes away, both keep what is in both.</source>
        <translation>Click the colour that tools shall keep to; drag to the right for more, to the left for less of it. Shift adds, Alt takes away, both keep what is in both.</translation>
    </message>
    <message>
        <source>Click the corners of what tools shall keep to. Enter or a double click closes it, Backspace takes the last corner back, Esc gives it up.</source>
        <translation>Click the corners of what tools shall keep to. Enter or a double click closes it, Backspace takes the last corner back, Esc gives it up.</translation>
    </message>
    <message>
        <source>Colours that differ by up to %1. Drag to the right for more, to the left for less.</source>
        <translation>Colours that differ by up to %1. Drag to the right for more, to the left for less.</translation>
    </message>
    <message>
        <source>Tools keep to colours that differ by up to %1 from the one there. Esc, or taking a tool, goes back to painting.</source>
        <translation>Tools keep to colours that differ by up to %1 from the one there. Esc, or taking a tool, goes back to painting.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::SelectionMargins</name>
    <message>
        <source>Grow the selection</source>
        <translation>Grow the selection</translation>
    </message>
    <message>
        <source>The selection becomes so much wider on all sides.</source>
        <translation>The selection becomes so much wider on all sides.</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Grow</translation>
    </message>
    <message>
        <source>Shrink the selection</source>
        <translation>Shrink the selection</translation>
    </message>
    <message>
        <source>The selection becomes so much narrower on all sides, but not along the edges of the canvas.</source>
        <translation>The selection becomes so much narrower on all sides, but not along the edges of the canvas.</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Shrink</translation>
    </message>
    <message>
        <source>Border of the selection</source>
        <translation>Border of the selection</translation>
    </message>
    <message>
        <source>Selects a band so wide along the outline, half of it on either side.</source>
        <translation>Selects a band so wide along the outline, half of it on either side.</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Select</translation>
    </message>
    <message>
        <source>Feather the selection</source>
        <translation>Feather the selection</translation>
    </message>
    <message>
        <source>The edge becomes soft: paint fades out so far on either side of the outline.</source>
        <translation>The edge becomes soft: paint fades out so far on either side of the outline.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Feather</source>
        <translation>Feather</translation>
    </message>
    <message>
        <source>Nothing would be left of the selection.</source>
        <translation>Nothing would be left of the selection.</translation>
    </message>
    <message>
        <source>The selection would stay as it is.</source>
        <translation>The selection would stay as it is.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Studio</name>
    <message numerus="yes">
        <source>%1 is open, and %n note(s) tell what is not as it was in the file.</source>
        <translation>
            <numerusform>%1 is open, and %n note tells what is not as it was in the file.</numerusform>
            <numerusform>%1 is open, and %n notes tell what is not as it was in the file.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Show them</translation>
    </message>
    <message>
        <source>%1 From now on the processor draws the canvas, which is slower.</source>
        <translation>%1 From now on the processor draws the canvas, which is slower.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TankMode</name>
    <message>
        <source>Open a tank</source>
        <translation>Open a tank</translation>
    </message>
    <message>
        <source>Scenes of a tank (*.json);;All files (*)</source>
        <translation>Scenes of a tank (*.json);;All files (*)</translation>
    </message>
    <message>
        <source>Export the liquid&apos;s surface</source>
        <translation>Export the liquid&apos;s surface</translation>
    </message>
    <message>
        <source>A folder for all moments</source>
        <translation>A folder for all moments</translation>
    </message>
    <message>
        <source>The liquid&apos;s surface is in %1.</source>
        <translation>The liquid&apos;s surface is in %1.</translation>
    </message>
    <message>
        <source>All surfaces are in %1.</source>
        <translation>All surfaces are in %1.</translation>
    </message>
    <message>
        <source>Picture of the tank</source>
        <translation>Picture of the tank</translation>
    </message>
    <message>
        <source>The tank as it is seen in the window, traced along the light&apos;s ways through glass and liquid. Choose a size and press Render.</source>
        <translation>The tank as it is seen in the window, traced along the light&apos;s ways through glass and liquid. Choose a size and press Render.</translation>
    </message>
    <message>
        <source>Glass tank</source>
        <translation>Glass tank</translation>
    </message>
    <message>
        <source>A folder for pictures of every step</source>
        <translation>A folder for pictures of every step</translation>
    </message>
    <message>
        <source>A folder for surfaces of every step</source>
        <translation>A folder for surfaces of every step</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s) written</source>
        <translation>
            <numerusform>%n picture written</numerusform>
            <numerusform>%n pictures written</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n surface(s) written</source>
        <translation>
            <numerusform>%n surface written</numerusform>
            <numerusform>%n surfaces written</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pastoso::main::TankRecorder</name>
    <message numerus="yes">
        <source>%n picture(s) are in %1.</source>
        <translation>
            <numerusform>%n picture is in %1.</numerusform>
            <numerusform>%n pictures are in %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n surface(s) are in %1.</source>
        <translation>
            <numerusform>%n surface is in %1.</numerusform>
            <numerusform>%n surfaces are in %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pastoso::main::TeaMode</name>
    <message>
        <source>Open a scene of milk tea</source>
        <translation>Open a scene of milk tea</translation>
    </message>
    <message>
        <source>Scenes of milk tea (*.json);;All files (*)</source>
        <translation>Scenes of milk tea (*.json);;All files (*)</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Save the scene</translation>
    </message>
    <message>
        <source>Scenes of milk tea (*.json)</source>
        <translation>Scenes of milk tea (*.json)</translation>
    </message>
    <message>
        <source>Export the milk&apos;s surface</source>
        <translation>Export the milk&apos;s surface</translation>
    </message>
    <message>
        <source>The milk&apos;s surface is in %1.</source>
        <translation>The milk&apos;s surface is in %1.</translation>
    </message>
    <message>
        <source>Milk tea</source>
        <translation>Milk tea</translation>
    </message>
    <message>
        <source>Picture of the glass</source>
        <translation>Picture of the glass</translation>
    </message>
    <message>
        <source>The glass as it is seen in the window, traced along the light&apos;s ways through glass, tea and milk. Choose a size and press Render.</source>
        <translation>The glass as it is seen in the window, traced along the light&apos;s ways through glass, tea and milk. Choose a size and press Render.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TextureCommands</name>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>Pictures (%1);;All files (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Reading %1</translation>
    </message>
    <message>
        <source>The paste lies on the whole canvas, dry.</source>
        <translation>The paste lies on the whole canvas, dry.</translation>
    </message>
    <message>
        <source>The paste lies where it is selected, dry.</source>
        <translation>The paste lies where it is selected, dry.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TracingCommands</name>
    <message>
        <source>Picked the colour of the picture: %1</source>
        <translation>Picked the colour of the picture: %1</translation>
    </message>
    <message>
        <source>Trace a picture</source>
        <translation>Trace a picture</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>Pictures (%1);;All files (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Reading %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TubeCommands</name>
    <message>
        <source>Save the tubes as a set</source>
        <translation>Save the tubes as a set</translation>
    </message>
    <message>
        <source>Rename the set</source>
        <translation>Rename the set</translation>
    </message>
    <message>
        <source>Name of the set:</source>
        <translation>Name of the set:</translation>
    </message>
    <message>
        <source>A set needs a name.</source>
        <translation>A set needs a name.</translation>
    </message>
    <message>
        <source>Type another name: that one is empty, or another set&apos;s.</source>
        <translation>Type another name: that one is empty, or another set&apos;s.</translation>
    </message>
    <message>
        <source>Export my sets of tubes</source>
        <translation>Export my sets of tubes</translation>
    </message>
    <message>
        <source>my-tubes.json</source>
        <translation>my-tubes.json</translation>
    </message>
    <message>
        <source>Sets of tubes (*.json)</source>
        <translation>Sets of tubes (*.json)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Saved %1.</translation>
    </message>
    <message>
        <source>Import sets of tubes</source>
        <translation>Import sets of tubes</translation>
    </message>
    <message>
        <source>You have all sets of that file already.</source>
        <translation>You have all sets of that file already.</translation>
    </message>
    <message numerus="yes">
        <source>%n set(s) added to your own.</source>
        <translation>
            <numerusform>%n set added to your own.</numerusform>
            <numerusform>%n sets added to your own.</numerusform>
        </translation>
    </message>
    <message>
        <source>No paint was squeezed out beside an earlier painting yet.</source>
        <translation>No paint was squeezed out beside an earlier painting yet.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ViewCommands</name>
    <message>
        <source>Canvas %1 × %2 mm, %3 pixels per millimetre</source>
        <translation>Canvas %1 × %2 mm, %3 pixels per millimetre</translation>
    </message>
</context>
<context>
    <name>pastoso::main::WorkspaceCommands</name>
    <message>
        <source>There is a workspace &quot;%1&quot; already.</source>
        <translation>There is a workspace &quot;%1&quot; already.</translation>
    </message>
    <message>
        <source>The workspace &quot;%1&quot; comes with the program: choose another name.</source>
        <translation>The workspace &quot;%1&quot; comes with the program: choose another name.</translation>
    </message>
    <message>
        <source>Save the workspace</source>
        <translation>Save the workspace</translation>
    </message>
    <message>
        <source>Name of the workspace; one of your own with this name is replaced:</source>
        <translation>Name of the workspace; one of your own with this name is replaced:</translation>
    </message>
    <message>
        <source>Rename the workspace</source>
        <translation>Rename the workspace</translation>
    </message>
    <message>
        <source>Name of the workspace:</source>
        <translation>Name of the workspace:</translation>
    </message>
</context>
<context>
    <name>pastoso::panels</name>
    <message>
        <source>never</source>
        <translation>never</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>real time</translation>
    </message>
    <message>
        <source>10 times</source>
        <translation>10 times</translation>
    </message>
    <message>
        <source>a minute a second</source>
        <translation>a minute a second</translation>
    </message>
    <message>
        <source>10 min a second</source>
        <translation>10 min a second</translation>
    </message>
    <message>
        <source>an hour a second</source>
        <translation>an hour a second</translation>
    </message>
    <message>
        <source>a day a second</source>
        <translation>a day a second</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viscosity</translation>
    </message>
    <message>
        <source>How slowly it flows: water 1, ink 100, cream 3000, oil from the tube 300000</source>
        <translation>How slowly it flows: water 1, ink 100, cream 3000, oil from the tube 300000</translation>
    </message>
    <message>
        <source> mm²/s</source>
        <translation> mm²/s</translation>
    </message>
    <message>
        <source>Yield stress</source>
        <translation>Yield stress</translation>
    </message>
    <message>
        <source>What it stands up to before it moves at all: at 0 it runs for ever, at 80 it keeps every bristle mark, at 200 it stands in peaks</source>
        <translation>What it stands up to before it moves at all: at 0 it runs for ever, at 80 it keeps every bristle mark, at 200 it stands in peaks</translation>
    </message>
    <message>
        <source> Pa</source>
        <translation> Pa</translation>
    </message>
    <message>
        <source>Flow index</source>
        <translation>Flow index</translation>
    </message>
    <message>
        <source>Below 1 it thins where it is sheared: a brush or a fast run finds it thinner</source>
        <translation>Below 1 it thins where it is sheared: a brush or a fast run finds it thinner</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Density</translation>
    </message>
    <message>
        <source>Heavy paint runs faster down a tilted canvas</source>
        <translation>Heavy paint runs faster down a tilted canvas</translation>
    </message>
    <message>
        <source> kg/m³</source>
        <translation> kg/m³</translation>
    </message>
    <message>
        <source>Surface tension</source>
        <translation>Surface tension</translation>
    </message>
    <message>
        <source>Rounds drips and edges, and draws thin lines into drops</source>
        <translation>Rounds drips and edges, and draws thin lines into drops</translation>
    </message>
    <message>
        <source> mN/m</source>
        <translation> mN/m</translation>
    </message>
    <message>
        <source>Spreads at</source>
        <translation>Spreads at</translation>
    </message>
    <message>
        <source>The edge moves out where it is steeper than this: low numbers wet the canvas easily, high ones stand in beads</source>
        <translation>The edge moves out where it is steeper than this: low numbers wet the canvas easily, high ones stand in beads</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Draws back at</source>
        <translation>Draws back at</translation>
    </message>
    <message>
        <source>The edge draws back where it is flatter than this; 0: it stays where it was</source>
        <translation>The edge draws back where it is flatter than this; 0: it stays where it was</translation>
    </message>
    <message>
        <source>Slip</source>
        <translation>Slip</translation>
    </message>
    <message>
        <source>Dry after</source>
        <translation>Dry after</translation>
    </message>
    <message>
        <source>Until a film of the usual thickness can be touched, in still air</source>
        <translation>Until a film of the usual thickness can be touched, in still air</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Usual thickness</source>
        <translation>Usual thickness</translation>
    </message>
    <message>
        <source>The film that dries in that time; thicker ones take longer</source>
        <translation>The film that dries in that time; thicker ones take longer</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Stays when dry</source>
        <translation>Stays when dry</translation>
    </message>
    <message>
        <source>How much of the wet thickness is left: oil keeps all, watery paint sinks in</source>
        <translation>How much of the wet thickness is left: oil keeps all, watery paint sinks in</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Flow</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Drying</source>
        <translation>Drying</translation>
    </message>
    <message>
        <source>None</source>
        <translation>None</translation>
    </message>
    <message>
        <source>Matte</source>
        <translation>Matte</translation>
    </message>
    <message>
        <source>Satin</source>
        <translation>Satin</translation>
    </message>
    <message>
        <source>Gloss</source>
        <translation>Gloss</translation>
    </message>
    <message>
        <source>half</source>
        <translation>half</translation>
    </message>
    <message>
        <source>a third</source>
        <translation>a third</translation>
    </message>
    <message>
        <source>a quarter</source>
        <translation>a quarter</translation>
    </message>
    <message>
        <source>a fifth</source>
        <translation>a fifth</translation>
    </message>
    <message>
        <source>a tenth</source>
        <translation>a tenth</translation>
    </message>
    <message>
        <source>less than a tenth</source>
        <translation>less than a tenth</translation>
    </message>
    <message>
        <source>stiff</source>
        <translation>stiff</translation>
    </message>
    <message>
        <source>runny</source>
        <translation>runny</translation>
    </message>
    <message>
        <source>From paint that stands in peaks to paint that runs like ink: viscosity and yield stress</source>
        <translation>From paint that stands in peaks to paint that runs like ink: viscosity and yield stress</translation>
    </message>
    <message>
        <source>short</source>
        <translation>short</translation>
    </message>
    <message>
        <source>long</source>
        <translation>long</translation>
    </message>
    <message>
        <source>opaque</source>
        <translation>opaque</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>transparent</translation>
    </message>
    <message>
        <source>From paint that hides what lies below to a glaze: how much pigment is in it</source>
        <translation>From paint that hides what lies below to a glaze: how much pigment is in it</translation>
    </message>
    <message>
        <source>Pigment</source>
        <translation>Pigment</translation>
    </message>
    <message>
        <source>How much of full-strength paint is in it: paint from the tube 100, a glaze 3 to 6</source>
        <translation>How much of full-strength paint is in it: paint from the tube 100, a glaze 3 to 6</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Colour</translation>
    </message>
    <message>
        <source>Loosens by</source>
        <translation>Loosens by</translation>
    </message>
    <message>
        <source>Thixotropy: how much of its stiffness is gone where a tool or a run works it; brush marks level a little, and then stand</source>
        <translation>Thixotropy: how much of its stiffness is gone where a tool or a run works it; brush marks level a little, and then stand</translation>
    </message>
    <message>
        <source>Stiffens in</source>
        <translation>Stiffens in</translation>
    </message>
    <message>
        <source>How long it rests until two thirds of what it lost have come back</source>
        <translation>How long it rests until two thirds of what it lost have come back</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Loosens after</source>
        <translation>Loosens after</translation>
    </message>
    <message>
        <source>How far it has to run before it is loosened, in times its own thickness</source>
        <translation>How far it has to run before it is loosened, in times its own thickness</translation>
    </message>
    <message>
        <source>round</source>
        <translation>round</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>flat</translation>
    </message>
    <message>
        <source>filbert</source>
        <translation>filbert</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>fan</translation>
    </message>
    <message>
        <source>knife</source>
        <translation>knife</translation>
    </message>
    <message>
        <source>comb</source>
        <translation>comb</translation>
    </message>
    <message>
        <source>soft pad</source>
        <translation>soft pad</translation>
    </message>
    <message>
        <source>used as it is</source>
        <translation>used as it is</translation>
    </message>
    <message>
        <source>dipped in paint</source>
        <translation>dipped in paint</translation>
    </message>
    <message>
        <source>stays on the tool</source>
        <translation>stays on the tool</translation>
    </message>
    <message>
        <source>is thrown away</source>
        <translation>is thrown away</translation>
    </message>
    <message>
        <source>another in each stroke</source>
        <translation>another in each stroke</translation>
    </message>
    <message>
        <source>always the same</source>
        <translation>always the same</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Shape</translation>
    </message>
    <message>
        <source>How the elements of the tip are arranged.</source>
        <translation>How the elements of the tip are arranged.</translation>
    </message>
    <message>
        <source>Before use</source>
        <translation>Before use</translation>
    </message>
    <message>
        <source>A brush is dipped; a rag or a comb is used as it is.</source>
        <translation>A brush is dipped; a rag or a comb is used as it is.</translation>
    </message>
    <message>
        <source>What it takes</source>
        <translation>What it takes</translation>
    </message>
    <message>
        <source>A rag throws away what it takes up; it never comes back.</source>
        <translation>A rag throws away what it takes up; it never comes back.</translation>
    </message>
    <message>
        <source>Chance</source>
        <translation>Chance</translation>
    </message>
    <message>
        <source>Small random differences, such as where drops fall.</source>
        <translation>Small random differences, such as where drops fall.</translation>
    </message>
    <message>
        <source>%1 From %2 to %3%4.</source>
        <translation>%1 From %2 to %3%4.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Width</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Thickness</translation>
    </message>
    <message>
        <source>Hair length</source>
        <translation>Hair length</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Bristles</source>
        <translation>Bristles</translation>
    </message>
    <message>
        <source>Hairs in each</source>
        <translation>Hairs in each</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Piece</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Bend</translation>
    </message>
    <message>
        <source>Splay</source>
        <translation>Splay</translation>
    </message>
    <message>
        <source>Trail</source>
        <translation>Trail</translation>
    </message>
    <message>
        <source>Press depth</source>
        <translation>Press depth</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Lean</translation>
    </message>
    <message>
        <source>Into the weave</source>
        <translation>Into the weave</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Stiffness</translation>
    </message>
    <message>
        <source>Ride</source>
        <translation>Ride</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>Lasts</translation>
    </message>
    <message>
        <source>Grooves</source>
        <translation>Grooves</translation>
    </message>
    <message>
        <source>Hair streaks</source>
        <translation>Hair streaks</translation>
    </message>
    <message>
        <source>Uneven load</source>
        <translation>Uneven load</translation>
    </message>
    <message>
        <source>Gathering</source>
        <translation>Gathering</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Edges</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Stays behind</source>
        <translation>Stays behind</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reach</translation>
    </message>
    <message>
        <source>Pickup</source>
        <translation>Pickup</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>Mixing</translation>
    </message>
    <message>
        <source>Wicking</source>
        <translation>Wicking</translation>
    </message>
    <message>
        <source> /mm</source>
        <translation> /mm</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>Dragging</translation>
    </message>
    <message>
        <source>Overflow</source>
        <translation>Overflow</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Step</translation>
    </message>
    <message>
        <source>Least step</source>
        <translation>Least step</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Smoothing</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>String</source>
        <translation>String</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Drop</translation>
    </message>
    <message>
        <source> mm³</source>
        <translation> mm³</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source> mm³/s</source>
        <translation> mm³/s</translation>
    </message>
    <message>
        <source>First drop</source>
        <translation>First drop</translation>
    </message>
    <message>
        <source>Bottle</source>
        <translation>Bottle</translation>
    </message>
    <message>
        <source>Steepness</source>
        <translation>Steepness</translation>
    </message>
    <message>
        <source>Centring</source>
        <translation>Centring</translation>
    </message>
    <message>
        <source>Throw</source>
        <translation>Throw</translation>
    </message>
    <message>
        <source>Air pressure</source>
        <translation>Air pressure</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Tip</translation>
    </message>
    <message>
        <source>Hairs</source>
        <translation>Hairs</translation>
    </message>
    <message>
        <source>Paint it leaves</source>
        <translation>Paint it leaves</translation>
    </message>
    <message>
        <source>Paint it takes</source>
        <translation>Paint it takes</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Stroke</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Drops</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Air</translation>
    </message>
    <message>
        <source>nib</source>
        <translation>nib</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Teeth</translation>
    </message>
    <message>
        <source>Pores</source>
        <translation>Pores</translation>
    </message>
    <message>
        <source>Girth</source>
        <translation>Girth</translation>
    </message>
    <message>
        <source>On the grain</source>
        <translation>On the grain</translation>
    </message>
    <message>
        <source>%1: %2 to %3%4</source>
        <translation>%1: %2 to %3%4</translation>
    </message>
    <message>
        <source>Middle, from the left</source>
        <translation>Middle, from the left</translation>
    </message>
    <message>
        <source>Middle, from above</source>
        <translation>Middle, from above</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Slope</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Height</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Turned by</translation>
    </message>
    <message>
        <source>First point, from the left</source>
        <translation>First point, from the left</translation>
    </message>
    <message>
        <source>First point, from above</source>
        <translation>First point, from above</translation>
    </message>
    <message>
        <source>Second point, from the left</source>
        <translation>Second point, from the left</translation>
    </message>
    <message>
        <source>Second point, from above</source>
        <translation>Second point, from above</translation>
    </message>
    <message>
        <source>Third point, from the left</source>
        <translation>Third point, from the left</translation>
    </message>
    <message>
        <source>Third point, from above</source>
        <translation>Third point, from above</translation>
    </message>
    <message>
        <source>Slope of the horizon</source>
        <translation>Slope of the horizon</translation>
    </message>
    <message>
        <source>Crossing, from the left</source>
        <translation>Crossing, from the left</translation>
    </message>
    <message>
        <source>Crossing, from above</source>
        <translation>Crossing, from above</translation>
    </message>
    <message>
        <source>Slope of the first lines</source>
        <translation>Slope of the first lines</translation>
    </message>
    <message>
        <source>Spacing of the first lines</source>
        <translation>Spacing of the first lines</translation>
    </message>
    <message>
        <source>Slope of the others</source>
        <translation>Slope of the others</translation>
    </message>
    <message>
        <source>Spacing of the others</source>
        <translation>Spacing of the others</translation>
    </message>
    <message>
        <source>Snaps within</source>
        <translation>Snaps within</translation>
    </message>
    <message>
        <source>From paint that breaks off sharply to paint that flows out at its edges and in long runs: the angle at which it spreads, the front and tail of drips, and the flow index</source>
        <translation>From paint that breaks off sharply to paint that flows out at its edges and in long runs: the angle at which it spreads, the front and tail of drips, and the flow index</translation>
    </message>
    <message>
        <source>How easily it slides over the canvas, in pixels of the painting: more lets edges run on</source>
        <translation>How easily it slides over the canvas, in pixels of the painting: more lets edges run on</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Front of drips</source>
        <translation>Front of drips</translation>
    </message>
    <message>
        <source>How fast a drip goes at its front, where surface tension holds it back: less makes it thicker and rounder there</source>
        <translation>How fast a drip goes at its front, where surface tension holds it back: less makes it thicker and rounder there</translation>
    </message>
    <message>
        <source>Tail of drips</source>
        <translation>Tail of drips</translation>
    </message>
    <message>
        <source>How fast a drip follows at its tail, where surface tension draws it along: more makes it thinner there</source>
        <translation>How fast a drip follows at its tail, where surface tension draws it along: more makes it thinner there</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::AidsPart</name>
    <message>
        <source>Harmony and gamut mask</source>
        <translation>Harmony and gamut mask</translation>
    </message>
    <message>
        <source>Marks for hues that go together, and a shape on the wheel to choose within</source>
        <translation>Marks for hues that go together, and a shape on the wheel to choose within</translation>
    </message>
    <message>
        <source>Harmony</source>
        <translation>Harmony</translation>
    </message>
    <message>
        <source>None</source>
        <translation>None</translation>
    </message>
    <message>
        <source>Complementary</source>
        <translation>Complementary</translation>
    </message>
    <message>
        <source>Split complementary</source>
        <translation>Split complementary</translation>
    </message>
    <message>
        <source>Analogous</source>
        <translation>Analogous</translation>
    </message>
    <message>
        <source>Triad</source>
        <translation>Triad</translation>
    </message>
    <message>
        <source>Tetrad</source>
        <translation>Tetrad</translation>
    </message>
    <message>
        <source>The hues that go with yours are marked on the ring: a click takes one</source>
        <translation>The hues that go with yours are marked on the ring: a click takes one</translation>
    </message>
    <message>
        <source>Gamut mask</source>
        <translation>Gamut mask</translation>
    </message>
    <message>
        <source>Atmospheric triad</source>
        <translation>Atmospheric triad</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Circle</translation>
    </message>
    <message>
        <source>The colours of one lightness on a disc, and a shape that the wheel keeps to</source>
        <translation>The colours of one lightness on a disc, and a shape that the wheel keeps to</translation>
    </message>
    <message>
        <source>Turn of the gamut mask</source>
        <translation>Turn of the gamut mask</translation>
    </message>
    <message>
        <source>Turns the gamut mask</source>
        <translation>Turns the gamut mask</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushEditor</name>
    <message>
        <source>Brush editor</source>
        <translation>Brush editor</translation>
    </message>
    <message>
        <source>A stroke of the tool in hand, pressed hardest in its middle</source>
        <translation>A stroke of the tool in hand, pressed hardest in its middle</translation>
    </message>
    <message>
        <source>The same stroke of the tool as it is saved</source>
        <translation>The same stroke of the tool as it is saved</translation>
    </message>
    <message>
        <source>As saved</source>
        <translation>As saved</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Compare</translation>
    </message>
    <message>
        <source>Shows below the stroke of the tool as it is saved</source>
        <translation>Shows below the stroke of the tool as it is saved</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Revert</translation>
    </message>
    <message>
        <source>Takes back all changes of the tool in hand</source>
        <translation>Takes back all changes of the tool in hand</translation>
    </message>
    <message>
        <source>In hand</source>
        <translation>In hand</translation>
    </message>
    <message>
        <source>Parts of the tool</source>
        <translation>Parts of the tool</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Curves</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, changed</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushFinder</name>
    <message>
        <source>Which tools are listed</source>
        <translation>Which tools are listed</translation>
    </message>
    <message>
        <source>Find a tool</source>
        <translation>Find a tool</translation>
    </message>
    <message>
        <source>A few letters of its name or of its family; Return takes the first</source>
        <translation>A few letters of its name or of its family; Return takes the first</translation>
    </message>
    <message>
        <source>All</source>
        <translation>All</translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>Favourites</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recent</translation>
    </message>
    <message>
        <source>My own</source>
        <translation>My own</translation>
    </message>
    <message>
        <source>No tool has such a name.</source>
        <translation>No tool has such a name.</translation>
    </message>
    <message>
        <source>Tools that you mark with a star are listed here.</source>
        <translation>Tools that you mark with a star are listed here.</translation>
    </message>
    <message>
        <source>Tools that you have taken are listed here, the latest first.</source>
        <translation>Tools that you have taken are listed here, the latest first.</translation>
    </message>
    <message>
        <source>Tools that you save as your own are listed here.</source>
        <translation>Tools that you save as your own are listed here.</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushList</name>
    <message>
        <source>%1, your own</source>
        <translation>%1, your own</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushPanel</name>
    <message>
        <source>Brush</source>
        <translation>Brush</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Width of the brush&apos;s tip  ([ and ])</source>
        <translation>Width of the brush&apos;s tip  ([ and ])</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>Steady</translation>
    </message>
    <message>
        <source>How the hand is steadied</source>
        <translation>How the hand is steadied</translation>
    </message>
    <message>
        <source>off</source>
        <translation>off</translation>
    </message>
    <message>
        <source>lags behind</source>
        <translation>lags behind</translation>
    </message>
    <message>
        <source>pulled on a string</source>
        <translation>pulled on a string</translation>
    </message>
    <message>
        <source>How much the hand is steadied</source>
        <translation>How much the hand is steadied</translation>
    </message>
    <message>
        <source>Length of the string: wide curves without a tremor</source>
        <translation>Length of the string: wide curves without a tremor</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>How far the brush lags behind the hand</source>
        <translation>How far the brush lags behind the hand</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Width of the brush&apos;s tip</source>
        <translation>Width of the brush&apos;s tip</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Tags</translation>
    </message>
    <message>
        <source>New tag...</source>
        <translation>New tag...</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ColourPanel</name>
    <message>
        <source>Mix a colour</source>
        <translation>Mix a colour</translation>
    </message>
    <message>
        <source>Nearest from the tubes</source>
        <translation>Nearest from the tubes</translation>
    </message>
    <message>
        <source>Use the recipe</source>
        <translation>Use the recipe</translation>
    </message>
    <message>
        <source>Dip the brush in this mixture from the tubes instead</source>
        <translation>Dip the brush in this mixture from the tubes instead</translation>
    </message>
    <message>
        <source>Used before</source>
        <translation>Used before</translation>
    </message>
    <message>
        <source>Your palette</source>
        <translation>Your palette</translation>
    </message>
    <message>
        <source>Paints that you keep stay here.</source>
        <translation>Paints that you keep stay here.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Keep</translation>
    </message>
    <message>
        <source>Lay the paint in hand out on your palette</source>
        <translation>Lay the paint in hand out on your palette</translation>
    </message>
    <message>
        <source>The colour itself, as a paint of its own: %1</source>
        <translation>The colour itself, as a paint of its own: %1</translation>
    </message>
    <message>
        <source>Your palette is full: the right button takes a paint away.</source>
        <translation>Your palette is full: the right button takes a paint away.</translation>
    </message>
    <message>
        <source>%1
The right button, or Delete, takes it away.</source>
        <translation>%1
The right button, or Delete, takes it away.</translation>
    </message>
    <message>
        <source>%1
ΔE %2, %3; %4</source>
        <translation>%1
ΔE %2, %3; %4</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Save...</translation>
    </message>
    <message>
        <source>The colours of your palette for GIMP, Krita or Inkscape, as a .gpl file</source>
        <translation>The colours of your palette for GIMP, Krita or Inkscape, as a .gpl file</translation>
    </message>
    <message>
        <source>There is no room for more mixes; take one away first.</source>
        <translation>There is no room for more mixes; take one away first.</translation>
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
        <translation>Lightness, chroma and hue as the eye sees them</translation>
    </message>
    <message>
        <source>HSV</source>
        <translation>HSV</translation>
    </message>
    <message>
        <source>Hue, saturation and value</source>
        <translation>Hue, saturation and value</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>Red, green and blue of the screen</source>
        <translation>Red, green and blue of the screen</translation>
    </message>
    <message>
        <source>The colour as it is written, for example #c03020</source>
        <translation>The colour as it is written, for example #c03020</translation>
    </message>
    <message>
        <source>Colour as written</source>
        <translation>Colour as written</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; write it for example as #c03020.</source>
        <translation>&quot;%1&quot; is no colour; write it for example as #c03020.</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ColourWheel</name>
    <message>
        <source>Colour wheel</source>
        <translation>Colour wheel</translation>
    </message>
    <message>
        <source>The ring is the hue. Inside, lightness goes up and chroma to the right, as far as the
screen has it. Keys: arrows, Page Up and Page Down for the hue, with Ctrl finely.</source>
        <translation>The ring is the hue. Inside, lightness goes up and chroma to the right, as far as the
screen has it. Keys: arrows, Page Up and Page Down for the hue, with Ctrl finely.</translation>
    </message>
    <message>
        <source>Lightness %1 %, chroma %2, hue %3°</source>
        <translation>Lightness %1 %, chroma %2, hue %3°</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::CurveEditor</name>
    <message>
        <source>Curve</source>
        <translation>Curve</translation>
    </message>
    <message>
        <source>Drag a point, click beside one to add another, right click to take one away.
Keys: Page Up and Page Down choose, arrows move, Insert adds, Delete takes away.</source>
        <translation>Drag a point, click beside one to add another, right click to take one away.
Keys: Page Up and Page Down choose, arrows move, Insert adds, Delete takes away.</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message>
        <source>Point %1 of %2: %3 % across, %4 % up</source>
        <translation>Point %1 of %2: %3 % across, %4 % up</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::CurvesPanel</name>
    <message>
        <source>Add</source>
        <translation>Add</translation>
    </message>
    <message>
        <source>Another curve: what of the hand sets what of the tool</source>
        <translation>Another curve: what of the hand sets what of the tool</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remove</translation>
    </message>
    <message>
        <source>Takes this curve away</source>
        <translation>Takes this curve away</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Reset</translation>
    </message>
    <message>
        <source>The curve as the tool was kept with</source>
        <translation>The curve as the tool was kept with</translation>
    </message>
    <message>
        <source>How it answers to the hand</source>
        <translation>How it answers to the hand</translation>
    </message>
    <message>
        <source>What of the hand sets what of the tool</source>
        <translation>What of the hand sets what of the tool</translation>
    </message>
    <message>
        <source>This tool has no curves.</source>
        <translation>This tool has no curves.</translation>
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
        <translation>Tilt</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Light</translation>
    </message>
    <message>
        <source>Drying</source>
        <translation>Drying</translation>
    </message>
    <message>
        <source>How fast wet paint dries; D dries it at once</source>
        <translation>How fast wet paint dries; D dries it at once</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>flat</translation>
    </message>
    <message>
        <source>How steeply the canvas stands</source>
        <translation>How steeply the canvas stands</translation>
    </message>
    <message>
        <source>Where down is: 0 right, 90 bottom</source>
        <translation>Where down is: 0 right, 90 bottom</translation>
    </message>
    <message>
        <source>How high the lamp stands</source>
        <translation>How high the lamp stands</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 right, 90 top</source>
        <translation>Where the light comes from: 0 right, 90 top</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::FeelRow</name>
    <message>
        <source>From %1 to %2</source>
        <translation>From %1 to %2</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::GuidesPanel</name>
    <message>
        <source>Mirrors and copies</source>
        <translation>Mirrors and copies</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Copies</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>From the left</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>From above</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axis</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::HistoryModel</name>
    <message>
        <source>As far back as is kept</source>
        <translation>As far back as is kept</translation>
    </message>
    <message>
        <source>Click: do again up to here</source>
        <translation>Click: do again up to here</translation>
    </message>
    <message>
        <source>Click: go back to this moment</source>
        <translation>Click: go back to this moment</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::HistoryPanel</name>
    <message>
        <source>What was done</source>
        <translation>What was done</translation>
    </message>
    <message>
        <source>What the steps take; &quot;Memory for undo&quot; in the Edit menu says how much they may</source>
        <translation>What the steps take; &quot;Memory for undo&quot; in the Edit menu says how much they may</translation>
    </message>
    <message>
        <source>%1 of %2 MB</source>
        <translation>%1 of %2 MB</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::IlluminantBox</name>
    <message>
        <source>The light on the easel; the paint stays as it is</source>
        <translation>The light on the easel; the paint stays as it is</translation>
    </message>
    <message>
        <source>Daylight (D65)</source>
        <translation>Daylight (D65)</translation>
    </message>
    <message>
        <source>Print booth (D50)</source>
        <translation>Print booth (D50)</translation>
    </message>
    <message>
        <source>Light bulb (A)</source>
        <translation>Light bulb (A)</translation>
    </message>
    <message>
        <source>LED lamp</source>
        <translation>LED lamp</translation>
    </message>
    <message>
        <source>From a file...</source>
        <translation>From a file...</translation>
    </message>
    <message>
        <source>Seen in</source>
        <translation>Seen in</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LaidGuidePart</name>
    <message>
        <source>Guide</source>
        <translation>Guide</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Snapping strength</source>
        <translation>Snapping strength</translation>
    </message>
    <message>
        <source>How far the guide draws the brush from where your hand is: 0 not at all, 100 all the way</source>
        <translation>How far the guide draws the brush from where your hand is: 0 not at all, 100 all the way</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>What guides your strokes</source>
        <translation>What guides your strokes</translation>
    </message>
    <message>
        <source>none</source>
        <translation>none</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Ruler</translation>
    </message>
    <message>
        <source>Parallel ruler</source>
        <translation>Parallel ruler</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Concentric ellipse</source>
        <translation>Concentric ellipse</translation>
    </message>
    <message>
        <source>1 point perspective</source>
        <translation>1 point perspective</translation>
    </message>
    <message>
        <source>2 point perspective</source>
        <translation>2 point perspective</translation>
    </message>
    <message>
        <source>3 point perspective</source>
        <translation>3 point perspective</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grid</translation>
    </message>
    <message>
        <source>Lies on the canvas</source>
        <translation>Lies on the canvas</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LayerModel</name>
    <message>
        <source>a group of %1</source>
        <translation>a group of %1</translation>
    </message>
    <message>
        <source>the layer that you paint on</source>
        <translation>the layer that you paint on</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>hidden</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>locked</translation>
    </message>
    <message>
        <source>opacity %1 %</source>
        <translation>opacity %1 %</translation>
    </message>
    <message>
        <source>what is bare is locked</source>
        <translation>what is bare is locked</translation>
    </message>
    <message>
        <source>clipped to the layer below</source>
        <translation>clipped to the layer below</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LayerPanel</name>
    <message>
        <source>Layers</source>
        <translation>Layers</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacity</translation>
    </message>
    <message>
        <source>Fades what its paint does to light; its relief stays</source>
        <translation>Fades what its paint does to light; its relief stays</translation>
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
        <translation>Drag the lamp: near the rim it rakes over the relief. Double-click puts it back.
Keys: arrows move it, Home puts it back.</translation>
    </message>
    <message>
        <source>%1° high, from %2°</source>
        <translation>%1° high, from %2°</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LightPanel</name>
    <message>
        <source>Seen in</source>
        <translation>Seen in</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Lamp</translation>
    </message>
    <message>
        <source>From</source>
        <translation>From</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 right, 90 above, 180 left, 270 below</source>
        <translation>Where the light comes from: 0 right, 90 above, 180 left, 270 below</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Height</translation>
    </message>
    <message>
        <source>Low light rakes over the relief, 90 is overhead</source>
        <translation>Low light rakes over the relief, 90 is overhead</translation>
    </message>
    <message>
        <source>Even light</source>
        <translation>Even light</translation>
    </message>
    <message>
        <source>The part of the light that comes from all sides; the lamp gives the rest. More of it softens the relief</source>
        <translation>The part of the light that comes from all sides; the lamp gives the rest. More of it softens the relief</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Varnish</source>
        <translation>Varnish</translation>
    </message>
    <message>
        <source>A clear coat to look through, here and in exports; it changes no paint, and can be taken off again</source>
        <translation>A clear coat to look through, here and in exports; it changes no paint, and can be taken off again</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Amount</translation>
    </message>
    <message>
        <source>A thin coat evens the gloss only in part</source>
        <translation>A thin coat evens the gloss only in part</translation>
    </message>
    <message>
        <source>Aged</source>
        <translation>Aged</translation>
    </message>
    <message>
        <source>Old varnish turns yellow: 100 % is about a century</source>
        <translation>Old varnish turns yellow: 100 % is about a century</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LoadBar</name>
    <message>
        <source>The paint in the brush, across its width: how full it is, and of which colour</source>
        <translation>The paint in the brush, across its width: how full it is, and of which colour</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LoadPanel</name>
    <message>
        <source>On the brush</source>
        <translation>On the brush</translation>
    </message>
    <message>
        <source>How the brush is dipped, from the next time on</source>
        <translation>How the brush is dipped, from the next time on</translation>
    </message>
    <message>
        <source>Full, in one paint</source>
        <translation>Full, in one paint</translation>
    </message>
    <message>
        <source>Only the tip</source>
        <translation>Only the tip</translation>
    </message>
    <message>
        <source>One paint on each side</source>
        <translation>One paint on each side</translation>
    </message>
    <message>
        <source>Half mixed from two</source>
        <translation>Half mixed from two</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Fill</translation>
    </message>
    <message>
        <source>How full the brush is dipped; little leaves a dry brush</source>
        <translation>How full the brush is dipped; little leaves a dry brush</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Second</translation>
    </message>
    <message>
        <source>The second paint&apos;s share of a half-mixed load</source>
        <translation>The second paint&apos;s share of a half-mixed load</translation>
    </message>
    <message>
        <source>In hand: %1</source>
        <translation>In hand: %1</translation>
    </message>
    <message>
        <source>The second paint of the load: %1</source>
        <translation>The second paint of the load: %1</translation>
    </message>
    <message>
        <source>The second paint, laid out for later: %1</source>
        <translation>The second paint, laid out for later: %1</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>empty</translation>
    </message>
    <message>
        <source>all but empty</source>
        <translation>all but empty</translation>
    </message>
    <message>
        <source>%1 % full</source>
        <translation>%1 % full</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MediumPanel</name>
    <message>
        <source>As it comes</source>
        <translation>As it comes</translation>
    </message>
    <message>
        <source>Kind of paint</source>
        <translation>Kind of paint</translation>
    </message>
    <message>
        <source>The brush is cleaned, and dipped in paint of this kind</source>
        <translation>The brush is cleaned, and dipped in paint of this kind</translation>
    </message>
    <message>
        <source>Takes back what was changed below</source>
        <translation>Takes back what was changed below</translation>
    </message>
    <message>
        <source>What it is like</source>
        <translation>What it is like</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Numbers</translation>
    </message>
    <message>
        <source>Each number of the paint</source>
        <translation>Each number of the paint</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MessageBar</name>
    <message>
        <source>What needs your attention</source>
        <translation>What needs your attention</translation>
    </message>
    <message>
        <source>Put away</source>
        <translation>Put away</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MessagePanel</name>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Nothing has been told yet.</source>
        <translation>Nothing has been told yet.</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Copy all</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Clear</translation>
    </message>
    <message>
        <source>All messages, to be pasted elsewhere</source>
        <translation>All messages, to be pasted elsewhere</translation>
    </message>
    <message>
        <source>Take all messages off the list</source>
        <translation>Take all messages off the list</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MixesPart</name>
    <message>
        <source>Your mixes</source>
        <translation>Your mixes</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Rename</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remove</translation>
    </message>
    <message>
        <source>Keep as a mix</source>
        <translation>Keep as a mix</translation>
    </message>
    <message>
        <source>Keep the paint in hand as a recipe of tubes, under a name of your own</source>
        <translation>Keep the paint in hand as a recipe of tubes, under a name of your own</translation>
    </message>
    <message>
        <source>Take the chosen mix away</source>
        <translation>Take the chosen mix away</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Export...</translation>
    </message>
    <message>
        <source>Save your mixes and your palette as a file for others</source>
        <translation>Save your mixes and your palette as a file for others</translation>
    </message>
    <message>
        <source>Import...</source>
        <translation>Import...</translation>
    </message>
    <message>
        <source>Add the mixes and the palette of such a file</source>
        <translation>Add the mixes and the palette of such a file</translation>
    </message>
    <message>
        <source>Paints that you keep are listed here, under names of your own.</source>
        <translation>Paints that you keep are listed here, under names of your own.</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MousePart</name>
    <message>
        <source>Pressure</source>
        <translation>Pressure</translation>
    </message>
    <message>
        <source>How hard the brush is pressed</source>
        <translation>How hard the brush is pressed</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Lighter the faster it goes</source>
        <translation>Lighter the faster it goes</translation>
    </message>
    <message>
        <source>A slow line is pressed as set above, a fast one down to a quarter of it</source>
        <translation>A slow line is pressed as set above, a fast one down to a quarter of it</translation>
    </message>
    <message>
        <source>A mouse, or a finger on the screen, does not tell how hard it presses.</source>
        <translation>A mouse, or a finger on the screen, does not tell how hard it presses.</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::NavigatorMap</name>
    <message>
        <source>The middle of the window is %1 % from the left and %2 % from the top</source>
        <translation>The middle of the window is %1 % from the left and %2 % from the top</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::NavigatorPanel</name>
    <message>
        <source>The whole canvas</source>
        <translation>The whole canvas</translation>
    </message>
    <message>
        <source>Drag the frame, or click, to go there
Wheel: closer, farther</source>
        <translation>Drag the frame, or click, to go there
Wheel: closer, farther</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Screen pixels for a pixel of the saved picture</source>
        <translation>Screen pixels for a pixel of the saved picture</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Turned</translation>
    </message>
    <message>
        <source>How far the canvas is turned, clockwise</source>
        <translation>How far the canvas is turned, clockwise</translation>
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
        <translation>none opened</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Open...</translation>
    </message>
    <message>
        <source>Colours of GIMP, Krita or Inkscape, from a .gpl file</source>
        <translation>Colours of GIMP, Krita or Inkscape, from a .gpl file</translation>
    </message>
    <message>
        <source>From a picture...</source>
        <translation>From a picture...</translation>
    </message>
    <message>
        <source>Finds the colours that a picture is made of</source>
        <translation>Finds the colours that a picture is made of</translation>
    </message>
    <message>
        <source>Colours of the picture</source>
        <translation>Colours of the picture</translation>
    </message>
    <message>
        <source>How many colours are looked for</source>
        <translation>How many colours are looked for</translation>
    </message>
    <message>
        <source>As recipes of the tubes</source>
        <translation>As recipes of the tubes</translation>
    </message>
    <message>
        <source>A click dips the brush in the nearest mixture of tubes, not in the colour itself</source>
        <translation>A click dips the brush in the nearest mixture of tubes, not in the colour itself</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>From a file</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PaceNotice</name>
    <message>
        <source>The paint runs at %1 of its pace.</source>
        <translation>The paint runs at %1 of its pace.</translation>
    </message>
    <message>
        <source>Time runs at %1 of %2 ×.</source>
        <translation>Time runs at %1 of %2 ×.</translation>
    </message>
    <message>
        <source>What helps</source>
        <translation>What helps</translation>
    </message>
    <message>
        <source>What lets the paint keep up again</source>
        <translation>What lets the paint keep up again</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PaintPanel</name>
    <message>
        <source>The medium without pigment, for example thinner</source>
        <translation>The medium without pigment, for example thinner</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Paint</translation>
    </message>
    <message>
        <source>%1 (%2), %3
As the tool in hand lays it (%4 mm), thinned over white and over black, and with white</source>
        <translation>%1 (%2), %3
As the tool in hand lays it (%4 mm), thinned over white and over black, and with white</translation>
    </message>
    <message>
        <source>Put into a set</source>
        <translation>Put into a set</translation>
    </message>
    <message>
        <source>Take out of this set</source>
        <translation>Take out of this set</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PenButtons</name>
    <message>
        <source>Ends and buttons of pens</source>
        <translation>Ends and buttons of pens</translation>
    </message>
    <message>
        <source>Eraser end</source>
        <translation>Eraser end</translation>
    </message>
    <message>
        <source>Lower button</source>
        <translation>Lower button</translation>
    </message>
    <message>
        <source>Upper button</source>
        <translation>Upper button</translation>
    </message>
    <message>
        <source>picks up paint</source>
        <translation>picks up paint</translation>
    </message>
    <message>
        <source>picks the colour seen</source>
        <translation>picks the colour seen</translation>
    </message>
    <message>
        <source>moves the canvas</source>
        <translation>moves the canvas</translation>
    </message>
    <message>
        <source>opens the palette</source>
        <translation>opens the palette</translation>
    </message>
    <message>
        <source>does nothing</source>
        <translation>does nothing</translation>
    </message>
    <message>
        <source>takes %1</source>
        <translation>takes %1</translation>
    </message>
    <message>
        <source>paints like the tip</source>
        <translation>paints like the tip</translation>
    </message>
    <message>
        <source>Third button</source>
        <translation>Third button</translation>
    </message>
    <message>
        <source>Wheel forward</source>
        <translation>Wheel forward</translation>
    </message>
    <message>
        <source>Wheel back</source>
        <translation>Wheel back</translation>
    </message>
    <message>
        <source>Fingers paint</source>
        <translation>Fingers paint</translation>
    </message>
    <message>
        <source>Otherwise one finger moves the canvas, as two always do</source>
        <translation>Otherwise one finger moves the canvas, as two always do</translation>
    </message>
    <message>
        <source>Wet mark</source>
        <translation>Wet mark</translation>
    </message>
    <message>
        <source>Shows paint under the pen at once, until the paint itself is on the screen</source>
        <translation>Shows paint under the pen at once, until the paint itself is on the screen</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PenDialog</name>
    <message>
        <source>Pen and tablet</source>
        <translation>Pen and tablet</translation>
    </message>
    <message>
        <source>Pens and mouse</source>
        <translation>Pens and mouse</translation>
    </message>
    <message>
        <source>A pen that is not listed comes here when it touches the sheet below.</source>
        <translation>A pen that is not listed comes here when it touches the sheet below.</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Soft</translation>
    </message>
    <message>
        <source>A light hand already presses hard</source>
        <translation>A light hand already presses hard</translation>
    </message>
    <message>
        <source>As it comes</source>
        <translation>As it comes</translation>
    </message>
    <message>
        <source>The pressure as the pen tells it, without a curve</source>
        <translation>The pressure as the pen tells it, without a curve</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Firm</translation>
    </message>
    <message>
        <source>Only a heavy hand presses hard</source>
        <translation>Only a heavy hand presses hard</translation>
    </message>
    <message>
        <source>From left to right what the pen tells, upwards what the brush is pressed with.</source>
        <translation>From left to right what the pen tells, upwards what the brush is pressed with.</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>Wipe</translation>
    </message>
    <message>
        <source>Try it here</source>
        <translation>Try it here</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Mouse</translation>
    </message>
    <message>
        <source>Pressure of %1</source>
        <translation>Pressure of %1</translation>
    </message>
    <message>
        <source>Pressure of the mouse</source>
        <translation>Pressure of the mouse</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PenPad</name>
    <message>
        <source>Sheet to try the pen on</source>
        <translation>Sheet to try the pen on</translation>
    </message>
    <message>
        <source>Scribble here with a pen or the mouse</source>
        <translation>Scribble here with a pen or the mouse</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PictureBoard</name>
    <message>
        <source>no picture</source>
        <translation>no picture</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 pixels</translation>
    </message>
    <message>
        <source>A picture that you choose to trace lies here, to look at and to pick colours from, and below the paint.</source>
        <translation>A picture that you choose to trace lies here, to look at and to pick colours from, and below the paint.</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PopupPalette</name>
    <message>
        <source>Pop-up palette</source>
        <translation>Pop-up palette</translation>
    </message>
    <message>
        <source>A narrower brush</source>
        <translation>A narrower brush</translation>
    </message>
    <message>
        <source>A wider brush</source>
        <translation>A wider brush</translation>
    </message>
    <message>
        <source>%1: take this one, and put the other here</source>
        <translation>%1: take this one, and put the other here</translation>
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
        <translation>%1: as the tool is saved</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::RecorderPanel</name>
    <message>
        <source>Strokes</source>
        <translation>Strokes</translation>
    </message>
    <message>
        <source>Painting time</source>
        <translation>Painting time</translation>
    </message>
    <message>
        <source>Recorded so far</source>
        <translation>Recorded so far</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ReferencePanel</name>
    <message>
        <source>Opacity</source>
        <translation>Opacity</translation>
    </message>
    <message>
        <source>How strongly the chosen picture shows</source>
        <translation>How strongly the chosen picture shows</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>Raise</translation>
    </message>
    <message>
        <source>Above the next picture (PgUp)</source>
        <translation>Above the next picture (PgUp)</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Lower</translation>
    </message>
    <message>
        <source>Below the picture under it (PgDown)</source>
        <translation>Below the picture under it (PgDown)</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Mirror</translation>
    </message>
    <message>
        <source>Left and right change sides</source>
        <translation>Left and right change sides</translation>
    </message>
    <message>
        <source>Greys</source>
        <translation>Greys</translation>
    </message>
    <message>
        <source>Shown in greys as light as its colours</source>
        <translation>Shown in greys as light as its colours</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Take away</translation>
    </message>
    <message>
        <source>Take the chosen picture off the board (Del)</source>
        <translation>Take the chosen picture off the board (Del)</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ReferenceView</name>
    <message>
        <source>Board of references</source>
        <translation>Board of references</translation>
    </message>
    <message>
        <source>Drag: move a picture, scale it by a corner, turn it by the ring
Control and click: paint of that colour
Wheel: closer, farther; with Shift it turns the picture
Double click, 0: all of it</source>
        <translation>Drag: move a picture, scale it by a corner, turn it by the ring
Control and click: paint of that colour
Wheel: closer, farther; with Shift it turns the picture
Double click, 0: all of it</translation>
    </message>
    <message>
        <source>pictures: %1</source>
        <translation>pictures: %1</translation>
    </message>
    <message>
        <source>pictures: %1; chosen: %2</source>
        <translation>pictures: %1; chosen: %2</translation>
    </message>
    <message>
        <source>Drag pictures here, to look at them and pick their colours while you paint.</source>
        <translation>Drag pictures here, to look at them and pick their colours while you paint.</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::StatusReadings</name>
    <message>
        <source>The pen&apos;s place on the canvas, from its upper left corner</source>
        <translation>The pen&apos;s place on the canvas, from its upper left corner</translation>
    </message>
    <message>
        <source>Tools keep to what is outlined; Ctrl+A ends the selection, Esc goes back to painting</source>
        <translation>Tools keep to what is outlined; Ctrl+A ends the selection, Esc goes back to painting</translation>
    </message>
    <message>
        <source>Memory that the program holds: the painting, its history and its pictures</source>
        <translation>Memory that the program holds: the painting, its history and its pictures</translation>
    </message>
    <message>
        <source>Size of the canvas and of its saved picture</source>
        <translation>Size of the canvas and of its saved picture</translation>
    </message>
    <message>
        <source>What the canvas shows; Alt+1 shows it in its light again</source>
        <translation>What the canvas shows; Alt+1 shows it in its light again</translation>
    </message>
    <message>
        <source>How the canvas stands on the screen; 5 puts it upright, M mirrors it</source>
        <translation>How the canvas stands on the screen; 5 puts it upright, M mirrors it</translation>
    </message>
    <message>
        <source>Screen pixels for a pixel of the saved picture</source>
        <translation>Screen pixels for a pixel of the saved picture</translation>
    </message>
    <message>
        <source>%1 × %2 mm   %3 × %4 px</source>
        <translation>%1 × %2 mm   %3 × %4 px</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>mirrored</translation>
    </message>
    <message>
        <source>turned %1°</source>
        <translation>turned %1°</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>paused</translation>
    </message>
    <message>
        <source>paint at rest</source>
        <translation>paint at rest</translation>
    </message>
    <message>
        <source>%1 × time</source>
        <translation>%1 × time</translation>
    </message>
    <message>
        <source>%1 % selected</source>
        <translation>%1 % selected</translation>
    </message>
    <message>
        <source>Paint time against the clock: less than you set where there is more wet paint than this computer can move in time</source>
        <translation>Paint time against the clock: less than you set where there is more wet paint than this computer can move in time</translation>
    </message>
    <message>
        <source>Whether paint still moves, and how much of its time this computer works on it</source>
        <translation>Whether paint still moves, and how much of its time this computer works on it</translation>
    </message>
    <message>
        <source>paint moving, %1 % busy</source>
        <translation>paint moving, %1 % busy</translation>
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
        <translation>Paint : medium, from paste to stain. To the right the paint is thinned: it runs sooner, and lets through what lies below</translation>
    </message>
    <message>
        <source>Paint : medium</source>
        <translation>Paint : medium</translation>
    </message>
    <message>
        <source>Paint : medium, from paste to stain. Upwards the paint is thinned: it runs sooner, and lets through what lies below</source>
        <translation>Paint : medium, from paste to stain. Upwards the paint is thinned: it runs sooner, and lets through what lies below</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TiltDial</name>
    <message>
        <source>Drag to tilt the canvas: the paint runs towards the knob. Double-click lays it flat.
Keys: arrows tilt it, Home lays it flat.</source>
        <translation>Drag to tilt the canvas: the paint runs towards the knob. Double-click lays it flat.
Keys: arrows tilt it, Home lays it flat.</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>flat</translation>
    </message>
    <message>
        <source>%1° steep, down is at %2°</source>
        <translation>%1° steep, down is at %2°</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TracingPanel</name>
    <message>
        <source>Picture to trace</source>
        <translation>Picture to trace</translation>
    </message>
    <message>
        <source>Click: paint of that colour
Wheel: closer, farther
Drag: move the picture
0: all of it</source>
        <translation>Click: paint of that colour
Wheel: closer, farther
Drag: move the picture
0: all of it</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacity</translation>
    </message>
    <message>
        <source>How strongly it shows below the paint</source>
        <translation>How strongly it shows below the paint</translation>
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
        <translation>From the left</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>From above</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Width</translation>
    </message>
    <message>
        <source>Its height follows in proportion</source>
        <translation>Its height follows in proportion</translation>
    </message>
    <message>
        <source>Where its left edge lies on the canvas</source>
        <translation>Where its left edge lies on the canvas</translation>
    </message>
    <message>
        <source>Where its upper edge lies on the canvas</source>
        <translation>Where its upper edge lies on the canvas</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TubeMenu</name>
    <message>
        <source>Which tubes are shown: all of them, or a set of yours</source>
        <translation>Which tubes are shown: all of them, or a set of yours</translation>
    </message>
    <message>
        <source>All tubes</source>
        <translation>All tubes</translation>
    </message>
    <message>
        <source>Save as a set...</source>
        <translation>Save as a set...</translation>
    </message>
    <message>
        <source>Rename the set...</source>
        <translation>Rename the set...</translation>
    </message>
    <message>
        <source>Remove the set</source>
        <translation>Remove the set</translation>
    </message>
    <message>
        <source>Squeeze these onto the mixing well</source>
        <translation>Squeeze these onto the mixing well</translation>
    </message>
    <message>
        <source>Import sets...</source>
        <translation>Import sets...</translation>
    </message>
    <message>
        <source>Export my sets...</source>
        <translation>Export my sets...</translation>
    </message>
    <message>
        <source>Squeeze out the last painting&apos;s palette</source>
        <translation>Squeeze out the last painting&apos;s palette</translation>
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
        <translation>There is no OpenGL any more to draw the canvas with.</translation>
    </message>
</context>
<context>
    <name>pastoso::screens</name>
    <message>
        <source>All commands and their keys</source>
        <translation>All commands and their keys</translation>
    </message>
    <message>
        <source>In the order of the menus. &quot;Keys&quot; in the &quot;Settings&quot; menu changes them ([how](settings.md#keys)). This page is printed by the program; `packaging/screens.sh --manual` prints it anew.</source>
        <translation>In the order of the menus. &quot;Keys&quot; in the &quot;Settings&quot; menu changes them ([how](settings.md#keys)). This page is printed by the program; `packaging/screens.sh --manual` prints it anew.</translation>
    </message>
    <message>
        <source>command</source>
        <translation>command</translation>
    </message>
    <message>
        <source>like Krita</source>
        <translation>like Krita</translation>
    </message>
    <message>
        <source>like Photoshop</source>
        <translation>like Photoshop</translation>
    </message>
    <message>
        <source>does</source>
        <translation>does</translation>
    </message>
</context>
<context>
    <name>pastoso::start::ExamplesSection</name>
    <message>
        <source>Examples, painted before your eyes</source>
        <translation>Examples, painted before your eyes</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Examples</translation>
    </message>
    <message>
        <source>Watch how it is painted, stroke by stroke, and paint on</source>
        <translation>Watch how it is painted, stroke by stroke, and paint on</translation>
    </message>
</context>
<context>
    <name>pastoso::start::NewCanvasSection</name>
    <message>
        <source>New canvas</source>
        <translation>New canvas</translation>
    </message>
    <message>
        <source>Sizes of a new canvas</source>
        <translation>Sizes of a new canvas</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Landscape</translation>
    </message>
    <message>
        <source>Wider than high</source>
        <translation>Wider than high</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Portrait</translation>
    </message>
    <message>
        <source>Higher than wide</source>
        <translation>Higher than wide</translation>
    </message>
    <message>
        <source>More...</source>
        <translation>More...</translation>
    </message>
    <message>
        <source>Any size</source>
        <translation>Any size</translation>
    </message>
    <message>
        <source>Choose width, height, resolution and support yourself</source>
        <translation>Choose width, height, resolution and support yourself</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, %4 px/mm</source>
        <translation>%1, %2 × %3 pixels, %4 px/mm</translation>
    </message>
</context>
<context>
    <name>pastoso::start::PaintingReader</name>
    <message>
        <source>This file is not there any more.</source>
        <translation>This file is not there any more.</translation>
    </message>
    <message>
        <source>This file cannot be read.</source>
        <translation>This file cannot be read.</translation>
    </message>
</context>
<context>
    <name>pastoso::start::RecentSection</name>
    <message>
        <source>Today, %1</source>
        <translation>Today, %1</translation>
    </message>
    <message>
        <source>Yesterday, %1</source>
        <translation>Yesterday, %1</translation>
    </message>
    <message>
        <source>Recent paintings</source>
        <translation>Recent paintings</translation>
    </message>
    <message>
        <source>Open a file...</source>
        <translation>Open a file...</translation>
    </message>
    <message>
        <source>Paintings that you save will stand here.</source>
        <translation>Paintings that you save will stand here.</translation>
    </message>
</context>
<context>
    <name>pastoso::start::StartPage</name>
    <message>
        <source>Show this page at start</source>
        <translation>Show this page at start</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Start page</translation>
    </message>
    <message>
        <source>Esc closes it; &quot;Start page&quot; in the &quot;File&quot; menu brings it back.</source>
        <translation>Esc closes it; &quot;Start page&quot; in the &quot;File&quot; menu brings it back.</translation>
    </message>
    <message>
        <source>Back to the painting</source>
        <translation>Back to the painting</translation>
    </message>
    <message>
        <source>Start painting</source>
        <translation>Start painting</translation>
    </message>
    <message>
        <source>The painting stands on the easel as you left it.</source>
        <translation>The painting stands on the easel as you left it.</translation>
    </message>
    <message>
        <source>A canvas of %1, %2, is ready. You can also just paint on it.</source>
        <translation>A canvas of %1, %2, is ready. You can also just paint on it.</translation>
    </message>
</context>
<context>
    <name>pastoso::start::UnfinishedSection</name>
    <message>
        <source>Not closed last time</source>
        <translation>Not closed last time</translation>
    </message>
    <message>
        <source>Choose or discard...</source>
        <translation>Choose or discard...</translation>
    </message>
    <message>
        <source>All paintings that were left unfinished</source>
        <translation>All paintings that were left unfinished</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recover</translation>
    </message>
</context>
<context>
    <name>pastoso::tools</name>
    <message>
        <source>PNG, 8 bits</source>
        <translation>PNG, 8 bits</translation>
    </message>
    <message>
        <source>PNG, 16 bits</source>
        <translation>PNG, 16 bits</translation>
    </message>
    <message>
        <source>JPEG</source>
        <translation>JPEG</translation>
    </message>
    <message>
        <source>TIFF, 8 bits</source>
        <translation>TIFF, 8 bits</translation>
    </message>
    <message>
        <source>TIFF, 16 bits</source>
        <translation>TIFF, 16 bits</translation>
    </message>
    <message>
        <source>TIFF, 32 bits of linear light</source>
        <translation>TIFF, 32 bits of linear light</translation>
    </message>
    <message>
        <source>WebP</source>
        <translation>WebP</translation>
    </message>
    <message>
        <source>OpenEXR, linear light</source>
        <translation>OpenEXR, linear light</translation>
    </message>
    <message>
        <source>PNG, 8 bits, heights in 16</source>
        <translation>PNG, 8 bits, heights in 16</translation>
    </message>
    <message>
        <source>TIFF, 32 bits, heights in mm</source>
        <translation>TIFF, 32 bits, heights in mm</translation>
    </message>
    <message>
        <source>OpenEXR, heights in mm</source>
        <translation>OpenEXR, heights in mm</translation>
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
        <translation>Numbered pictures, PNG of 8 bits</translation>
    </message>
    <message>
        <source>Numbered pictures, PNG of 16 bits</source>
        <translation>Numbered pictures, PNG of 16 bits</translation>
    </message>
    <message>
        <source>Video, MP4</source>
        <translation>Video, MP4</translation>
    </message>
    <message>
        <source>Video, Matroska</source>
        <translation>Video, Matroska</translation>
    </message>
    <message>
        <source>Video, WebM</source>
        <translation>Video, WebM</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Red</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Green</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blue</translation>
    </message>
    <message>
        <source>Hue, degrees</source>
        <translation>Hue, degrees</translation>
    </message>
    <message>
        <source>Saturation, %</source>
        <translation>Saturation, %</translation>
    </message>
    <message>
        <source>Value, %</source>
        <translation>Value, %</translation>
    </message>
    <message>
        <source>Lightness as it is seen, %</source>
        <translation>Lightness as it is seen, %</translation>
    </message>
    <message>
        <source>Chroma: how far from grey</source>
        <translation>Chroma: how far from grey</translation>
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
        <translation>Wet paint</translation>
    </message>
    <message>
        <source>Height of the paint</source>
        <translation>Height of the paint</translation>
    </message>
    <message>
        <source>Slopes of the surface</source>
        <translation>Slopes of the surface</translation>
    </message>
    <message>
        <source>Flat colour</source>
        <translation>Flat colour</translation>
    </message>
</context>
<context>
    <name>std</name>
    <message>
        <source>Stroke in the mixing well</source>
        <translation>Stroke in the mixing well</translation>
    </message>
    <message>
        <source>Canvas mirrored</source>
        <translation>Canvas mirrored</translation>
    </message>
    <message>
        <source>Canvas turned</source>
        <translation>Canvas turned</translation>
    </message>
    <message>
        <source>Masking tape</source>
        <translation>Masking tape</translation>
    </message>
    <message>
        <source>Masking peeled off</source>
        <translation>Masking peeled off</translation>
    </message>
</context>
</TS>
