<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="sv" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>Painting with thick wet paint</source>
        <translation>Måla med tjock, våt färg</translation>
    </message>
    <message>
        <source>The Pastoso authors</source>
        <translation>Pastosos upphovspersoner</translation>
    </message>
    <message>
        <source>Free software: you may use, study, share and change it under the GNU General Public License, version 3 or later. It comes without any warranty.</source>
        <translation>Fri programvara: du får använda, studera, dela och ändra den under GNU General Public License, version 3 eller senare. Den ges helt utan garanti.</translation>
    </message>
</context>
<context>
    <name>CanvasChoices</name>
    <message>
        <source>Small study</source>
        <translation>Liten studie</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Kvadrat</translation>
    </message>
    <message>
        <source>Small canvas</source>
        <translation>Liten duk</translation>
    </message>
    <message>
        <source>Large canvas</source>
        <translation>Stor duk</translation>
    </message>
    <message>
        <source>Screen, HD</source>
        <translation>Skärm, HD</translation>
    </message>
    <message>
        <source>Screen, QHD</source>
        <translation>Skärm, QHD</translation>
    </message>
    <message>
        <source>Linen</source>
        <translation>Linne</translation>
    </message>
    <message>
        <source>coarse weave</source>
        <translation>grov väv</translation>
    </message>
    <message>
        <source>Cotton duck</source>
        <translation>Bomullsduk</translation>
    </message>
    <message>
        <source>fine weave</source>
        <translation>fin väv</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Pannå</translation>
    </message>
    <message>
        <source>smooth gesso</source>
        <translation>slät gesso</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>an image</source>
        <translation>en bild</translation>
    </message>
    <message>
        <source>Medium linen</source>
        <translation>Medelgrovt linne</translation>
    </message>
    <message>
        <source>lively weave with slubs</source>
        <translation>levande väv med knutar</translation>
    </message>
    <message>
        <source>Fine portrait linen</source>
        <translation>Fint porträttlinne</translation>
    </message>
    <message>
        <source>Rough jute</source>
        <translation>Grov jute</translation>
    </message>
    <message>
        <source>fine even weave</source>
        <translation>fin jämn väv</translation>
    </message>
    <message>
        <source>Gesso panel</source>
        <translation>Gessopannå</translation>
    </message>
    <message>
        <source>brushed gesso</source>
        <translation>struken gesso</translation>
    </message>
</context>
<context>
    <name>Engine</name>
    <message>
        <source>&quot;%1&quot; holds no picture and is left out.</source>
        <translation>”%1” innehåller ingen bild och utelämnas.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2, but must lie between %3 and %4.</source>
        <translation>”%1” är %2, men måste ligga mellan %3 och %4.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is known in millimetres only; in cells describe a &quot;weave&quot;.</source>
        <translation>”%1” finns bara i millimeter; beskriv en ”weave” när måtten är i celler.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is needed on the canvas itself.</source>
        <translation>”%1” behövs på själva duken.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither &quot;once&quot; nor &quot;reflected&quot;.</source>
        <translation>”%1” är varken ”once” eller ”reflected”.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither K nor S.</source>
        <translation>”%1” är varken K eller S.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no form of a shape; there are %2.</source>
        <translation>”%1” är ingen av formerna; det finns %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tool that an eraser end can take.</source>
        <translation>”%1” är inget verktyg som en suddände kan ta.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none of &quot;particles&quot;, &quot;level_set&quot;, &quot;upwind_level_set&quot; and &quot;particle_level_set&quot;.</source>
        <translation>”%1” är ingen av ”particles”, ”level_set”, ”upwind_level_set” och ”particle_level_set”.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none of %2.</source>
        <translation>”%1” är ingen av %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a colour such as #783c14.</source>
        <translation>”%1” är ingen färg som till exempel #783c14.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a colour; a colour is # and six hexadecimal digits, for example #c03020.</source>
        <translation>”%1” är ingen kulör; en kulör är # och sex hexadecimala siffror, till exempel #c03020.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a finite number.</source>
        <translation>”%1” är inget ändligt tal.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a key such as Ctrl+Shift+Z.</source>
        <translation>”%1” är ingen tangent som till exempel Ctrl+Shift+Z.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number.</source>
        <translation>”%1” är inget tal.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a wavelength in nm and a power with one comma.</source>
        <translation>”%1” är inte en våglängd i nm och en effekt med ett kommatecken emellan.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not one of %2.</source>
        <translation>”%1” är inte någon av %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the key of %2 already.</source>
        <translation>”%1” är redan tangenten för %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the name of no command.</source>
        <translation>”%1” är inget kommandos namn.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands here twice.</source>
        <translation>”%1” står här två gånger.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands once for the whole file.</source>
        <translation>”%1” anges en enda gång, för hela filen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was laid over the others by %2 and is laid over them as paint.</source>
        <translation>”%1” lades över de andra med %2 och läggs över dem som färg.</translation>
    </message>
    <message>
        <source>&quot;endloop&quot; is missing before %1.</source>
        <translation>”endloop” saknas före %1.</translation>
    </message>
    <message>
        <source>&quot;tilt&quot; and &quot;gravity&quot; say the same; give one of them.</source>
        <translation>”tilt” och ”gravity” säger samma sak; ange bara en av dem.</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; is not a finite number.</source>
        <translation>%1 ”%2” är inget ändligt tal.</translation>
    </message>
    <message>
        <source>%1 (&quot;%2&quot;)</source>
        <translation>%1 (”%2”)</translation>
    </message>
    <message>
        <source>%1 (&quot;%2&quot;): the field &quot;family&quot; is missing.</source>
        <translation>%1 (”%2”): fältet ”family” saknas.</translation>
    </message>
    <message>
        <source>%1 (&quot;%2&quot;): thinned_with is &quot;%3&quot;, it must be the name of another medium here.</source>
        <translation>%1 (”%2”): thinned_with är ”%3”, men måste vara namnet på ett annat medium i filen.</translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation>%1 (%2).</translation>
    </message>
    <message>
        <source>%1 Not read: %2</source>
        <translation>%1 Inte läst: %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 och %2</translation>
    </message>
    <message>
        <source>%1 does not belong in an STL file.</source>
        <translation>%1 hör inte hemma i en STL-fil.</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which cannot set &quot;%3&quot;.</source>
        <translation>%1 är ”%2”, som inte kan styra ”%3”.</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which is none of: %3.</source>
        <translation>%1 är ”%2”, som inte är någon av: %3.</translation>
    </message>
    <message>
        <source>%1 is %2 in cell (%3, %4), but must lie between 0 and %5 (cells count from 0 at the upper left).</source>
        <translation>%1 är %2 i cell (%3, %4), men måste ligga mellan 0 och %5 (cellerna räknas från 0 uppe till vänster).</translation>
    </message>
    <message>
        <source>%1 is %2, it must be a number from %3 to %4.</source>
        <translation>%1 är %2, men måste vara ett tal från %3 till %4.</translation>
    </message>
    <message>
        <source>%1 is %2, it must be a text.</source>
        <translation>%1 är %2, men måste vara en text.</translation>
    </message>
    <message>
        <source>%1 is %2, more than the length, %3.</source>
        <translation>%1 är %2, mer än längden, %3.</translation>
    </message>
    <message>
        <source>%1 is %2, not between %3 and %4.</source>
        <translation>%1 är %2, inte mellan %3 och %4.</translation>
    </message>
    <message>
        <source>%1 is %2, outside %3 to %4.</source>
        <translation>%1 är %2, utanför området %3 till %4.</translation>
    </message>
    <message>
        <source>%1 is %2, so that more than 100000 drops a second would fall.</source>
        <translation>%1 är %2, så att mer än 100000 droppar per sekund skulle falla.</translation>
    </message>
    <message>
        <source>%1 is %2, whose input is not above that of the point before it.</source>
        <translation>%1 är %2, vars ingångsvärde inte ligger över den föregående punktens.</translation>
    </message>
    <message>
        <source>%1 is a file; numbered pictures go into a folder.</source>
        <translation>%1 är en fil; numrerade bilder läggs i en mapp.</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1 är tomt.</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1 saknas.</translation>
    </message>
    <message>
        <source>%1 is no corner of a face.</source>
        <translation>%1 är inget hörn i en sidoyta.</translation>
    </message>
    <message>
        <source>%1 is no number.</source>
        <translation>%1 är inget tal.</translation>
    </message>
    <message>
        <source>%1 is not a field of a brush preset (value %2).</source>
        <translation>%1 är inget fält i en penselförinställning (värde %2).</translation>
    </message>
    <message>
        <source>%1 is not a list of %2 numbers.</source>
        <translation>%1 är inte en lista med %2 tal.</translation>
    </message>
    <message>
        <source>%1 is not above 0 and at most %2.</source>
        <translation>%1 är inte större än 0 och högst %2.</translation>
    </message>
    <message>
        <source>%1 is not between %2 and %3.</source>
        <translation>%1 är inte mellan %2 och %3.</translation>
    </message>
    <message>
        <source>%1 is not finite in single precision.</source>
        <translation>%1 är inte ändligt i enkel precision.</translation>
    </message>
    <message>
        <source>%1 is not from %2 to %3.</source>
        <translation>%1 ligger inte mellan %2 och %3.</translation>
    </message>
    <message>
        <source>%1 must be a list, not %2.</source>
        <translation>%1 måste vara en lista, inte %2.</translation>
    </message>
    <message>
        <source>%1 must be a number, not %2.</source>
        <translation>%1 måste vara ett tal, inte %2.</translation>
    </message>
    <message>
        <source>%1 must be a text, not %2.</source>
        <translation>%1 måste vara en text, inte %2.</translation>
    </message>
    <message>
        <source>%1 must be a whole number, not %2.</source>
        <translation>%1 måste vara ett heltal, inte %2.</translation>
    </message>
    <message>
        <source>%1 must be an object, not %2.</source>
        <translation>%1 måste vara ett objekt, inte %2.</translation>
    </message>
    <message>
        <source>%1 must be true or false, not %2.</source>
        <translation>%1 måste vara true eller false, inte %2.</translation>
    </message>
    <message>
        <source>%1 must be two numbers, not %2.</source>
        <translation>%1 måste vara två tal, inte %2.</translation>
    </message>
    <message>
        <source>%1 must have 1 to %2 points, not %3.</source>
        <translation>%1 måste ha 1 till %2 punkter, inte %3.</translation>
    </message>
    <message>
        <source>%1 names %2 %3, but %4 were given until here.</source>
        <translation>%1 anger %2 %3, men hittills har bara %4 angetts.</translation>
    </message>
    <message>
        <source>%1 needs about %2; %3 of memory are free.</source>
        <translation>%1 behöver omkring %2; %3 minne är ledigt.</translation>
    </message>
    <message>
        <source>%1 normal</source>
        <translation>en normal i %1</translation>
    </message>
    <message>
        <source>%1 of the pigment &quot;%2&quot; is given twice.</source>
        <translation>%1 för pigmentet ”%2” anges två gånger.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 eller %2</translation>
    </message>
    <message>
        <source>%1 per mm is negative.</source>
        <translation>%1 per mm är negativt.</translation>
    </message>
    <message>
        <source>%1 position</source>
        <translation>en position i %1</translation>
    </message>
    <message>
        <source>%1 triangles take %2 bytes, but the file has %3.</source>
        <translation>%1 trianglar tar %2 byte, men filen har %3.</translation>
    </message>
    <message>
        <source>%1 x %2 cells need about %3; %4 of memory are free.</source>
        <translation>%1 x %2 celler behöver omkring %3; %4 minne är ledigt.</translation>
    </message>
    <message>
        <source>%1, %2 nm: %3 is not a number.</source>
        <translation>%1, %2 nm: %3 är inget tal.</translation>
    </message>
    <message>
        <source>%1, %2 nm: the weight %3 is negative.</source>
        <translation>%1, %2 nm: vikten %3 är negativ.</translation>
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
        <translation>%1, post %2</translation>
    </message>
    <message>
        <source>%1, event %2: %3</source>
        <translation>%1, händelse %2: %3</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, rad %2: %3</translation>
    </message>
    <message>
        <source>%1, line %2: this is not JSON, or it is cut off here.</source>
        <translation>%1, rad %2: detta är inte JSON, eller så är filen avklippt här.</translation>
    </message>
    <message>
        <source>%1, line %2: this is not valid JSON.</source>
        <translation>%1, rad %2: detta är inte giltig JSON.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a list of %3 bands.</source>
        <translation>%1: ”%2” är inte en lista med %3 band.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; stands there twice.</source>
        <translation>%1: ”%2” står där två gånger.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 files do not hold %3-bit pictures.</source>
        <translation>%1: %2-filer kan inte innehålla %3-bitarsbilder.</translation>
    </message>
    <message>
        <source>%1: %2 files do not hold %3.</source>
        <translation>%1: %2-filer kan inte innehålla %3.</translation>
    </message>
    <message>
        <source>%1: %2 files hold at most %3 pixels a side; this picture has %4 x %5.</source>
        <translation>%1: %2-filer rymmer högst %3 pixlar per sida; den här bilden har %4 x %5.</translation>
    </message>
    <message>
        <source>%1: %2 of the pigment &quot;%3&quot; is %4 per mm in band %5 of %6, above the %7 that paint can have; give the pigment in a weaker paint.</source>
        <translation>%1: %2 för pigmentet ”%3” är %4 per mm i band %5 av %6, över de %7 som färg kan ha; ange pigmentet i en svagare färg.</translation>
    </message>
    <message>
        <source>%1: %2 x %3 pixels are more than the %4 a side that a PSD file holds.</source>
        <translation>%1: %2 x %3 pixlar är mer än de %4 per sida som en PSD-fil rymmer.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1: 32 bits a channel hold linear light, which needs no ICC profile.</source>
        <translation>%1: 32 bitar per kanal innehåller linjärt ljus, som inte behöver någon ICC-profil.</translation>
    </message>
    <message>
        <source>%1: a PSD file of these layers would be larger than 2 GB.</source>
        <translation>%1: en PSD-fil av de här lagren skulle bli större än 2 GB.</translation>
    </message>
    <message>
        <source>%1: a batch begins at an action or tick that cannot be.</source>
        <translation>%1: en bunt börjar vid en åtgärd eller ett tick som inte kan finnas.</translation>
    </message>
    <message>
        <source>%1: a batch is too short.</source>
        <translation>%1: en bunt är för kort.</translation>
    </message>
    <message>
        <source>%1: a copy in layers is saved as .ora or .psd; this name ends in neither.</source>
        <translation>%1: en kopia i lager sparas som .ora eller .psd; det här namnet slutar på något annat.</translation>
    </message>
    <message>
        <source>%1: a mesh is read from .obj or .stl; this name ends otherwise.</source>
        <translation>%1: ett triangelnät läses från .obj eller .stl; det här namnet slutar på något annat.</translation>
    </message>
    <message>
        <source>%1: a picture is saved as .png, .tif, .jpg, .webp or .exr; this name ends in none of them.</source>
        <translation>%1: en bild sparas som .png, .tif, .jpg, .webp eller .exr; det här namnet slutar på något annat.</translation>
    </message>
    <message>
        <source>%1: a relief is saved as .stl, .ply or .obj; this name ends in none of them.</source>
        <translation>%1: en relief sparas som .stl, .ply eller .obj; det här namnet slutar på inget av dem.</translation>
    </message>
    <message>
        <source>%1: a relief is saved as .stl, .ply or .obj; this name ends otherwise.</source>
        <translation>%1: en relief sparas som .stl, .ply eller .obj; det här namnet slutar på något annat.</translation>
    </message>
    <message>
        <source>%1: a scene is saved as .pbrt; this name ends otherwise.</source>
        <translation>%1: en scen sparas som .pbrt; det här namnet slutar på något annat.</translation>
    </message>
    <message>
        <source>%1: a surface is saved as .obj, .ply, .stl or .pbrt; this name ends otherwise.</source>
        <translation>%1: en yta sparas som .obj, .ply, .stl eller .pbrt; det här namnet slutar på något annat.</translation>
    </message>
    <message>
        <source>%1: a video is made by the program ffmpeg, which is not installed; a folder&apos;s name instead gives numbered pictures.</source>
        <translation>%1: en video görs av programmet ffmpeg, som inte är installerat; namnet på en mapp ger numrerade bilder i stället.</translation>
    </message>
    <message>
        <source>%1: a video is saved as .mp4, .mkv or .webm, and a folder&apos;s name has no ending.</source>
        <translation>%1: en video sparas som .mp4, .mkv eller .webm, och namnet på en mapp har ingen ändelse.</translation>
    </message>
    <message>
        <source>%1: a volume is saved as .vdb; this name ends otherwise.</source>
        <translation>%1: en volym sparas som .vdb; det här namnet slutar på något annat.</translation>
    </message>
    <message>
        <source>%1: another program is at it.</source>
        <translation>%1: ett annat program arbetar med den.</translation>
    </message>
    <message>
        <source>%1: band %2 of &quot;%3&quot;</source>
        <translation>%1: band %2 av ”%3”</translation>
    </message>
    <message>
        <source>%1: cannot be created (%2).</source>
        <translation>%1: kan inte skapas (%2).</translation>
    </message>
    <message>
        <source>%1: cannot be opened (%2).</source>
        <translation>%1: kan inte öppnas (%2).</translation>
    </message>
    <message>
        <source>%1: cannot be read (%2).</source>
        <translation>%1: kan inte läsas (%2).</translation>
    </message>
    <message>
        <source>%1: cannot be read to its end.</source>
        <translation>%1: kan inte läsas till slutet.</translation>
    </message>
    <message>
        <source>%1: cannot be removed (%2).</source>
        <translation>%1: kan inte tas bort (%2).</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2).</source>
        <translation>%1: kan inte skrivas (%2).</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2); what is painted now can be saved, but not recovered.</source>
        <translation>%1: kan inte skrivas (%2); det som målas nu kan sparas, men inte återskapas.</translation>
    </message>
    <message>
        <source>%1: cannot be written, since this program was built without OpenVDB.</source>
        <translation>%1: kan inte skrivas, eftersom det här programmet är byggt utan OpenVDB.</translation>
    </message>
    <message>
        <source>%1: does not say what was painted on.</source>
        <translation>%1: säger inte vad det målades på.</translation>
    </message>
    <message>
        <source>%1: expected the name of a pigment.</source>
        <translation>%1: här ska namnet på ett pigment stå.</translation>
    </message>
    <message>
        <source>%1: ffmpeg cannot be started (%2).</source>
        <translation>%1: ffmpeg kan inte startas (%2).</translation>
    </message>
    <message>
        <source>%1: ffmpeg cannot make the video (%2).</source>
        <translation>%1: ffmpeg kan inte göra videon (%2).</translation>
    </message>
    <message>
        <source>%1: holds a number that is too large (%2).</source>
        <translation>%1: innehåller ett tal som är för stort (%2).</translation>
    </message>
    <message>
        <source>%1: holds a number that is too large.</source>
        <translation>%1: innehåller ett tal som är för stort.</translation>
    </message>
    <message>
        <source>%1: holds an ICC profile for %2, but the picture&apos;s values are red, green and blue.</source>
        <translation>%1: innehåller en ICC-profil för %2, men bildens värden är rött, grönt och blått.</translation>
    </message>
    <message>
        <source>%1: holds an ICC profile that cannot be applied (%2).</source>
        <translation>%1: innehåller en ICC-profil som inte kan användas (%2).</translation>
    </message>
    <message>
        <source>%1: holds an ICC profile that is none (%2).</source>
        <translation>%1: innehåller en ogiltig ICC-profil (%2).</translation>
    </message>
    <message>
        <source>%1: holds frames of another time-lapse; name another folder, or remove them.</source>
        <translation>%1: innehåller bildrutor från en annan timelapse; ange en annan mapp, eller ta bort dem.</translation>
    </message>
    <message>
        <source>%1: holds no actions of a painting.</source>
        <translation>%1: innehåller inga åtgärder från en målning.</translation>
    </message>
    <message>
        <source>%1: holds no stroke; expected lines &quot;seconds x y pressure&quot;, some with a pressure above 0.</source>
        <translation>%1: innehåller inget penseldrag; här ska det stå rader med ”sekunder x y tryck”, varav några med ett tryck över 0.</translation>
    </message>
    <message>
        <source>%1: holds no strokes that could be painted again.</source>
        <translation>%1: innehåller inga penseldrag som kan målas om.</translation>
    </message>
    <message>
        <source>%1: is %2, not a file.</source>
        <translation>%1: är %2, inte en fil.</translation>
    </message>
    <message>
        <source>%1: is an ICC profile for %2, but a picture is written in red, green and blue.</source>
        <translation>%1: är en ICC-profil för %2, men en bild skrivs i rött, grönt och blått.</translation>
    </message>
    <message>
        <source>%1: is an ICC profile for %2, but a screen shows red, green and blue.</source>
        <translation>%1: är en ICC-profil för %2, men en skärm visar rött, grönt och blått.</translation>
    </message>
    <message>
        <source>%1: is an ICC profile that no colour can be shown with (%2).</source>
        <translation>%1: är en ICC-profil som inga färger kan visas med (%2).</translation>
    </message>
    <message>
        <source>%1: is an ICC profile that no picture can be written in (%2).</source>
        <translation>%1: är en ICC-profil som ingen bild kan skrivas i (%2).</translation>
    </message>
    <message>
        <source>%1: is an ICC profile that no print can be shown with (%2).</source>
        <translation>%1: är en ICC-profil som ingen utskrift kan visas med (%2).</translation>
    </message>
    <message>
        <source>%1: is an OpenRaster picture of another program; it holds no wet paint.</source>
        <translation>%1: är en OpenRaster-bild från ett annat program; den innehåller ingen våt färg.</translation>
    </message>
    <message>
        <source>%1: is damaged; %2 actions after it are lost.</source>
        <translation>%1: är skadad; %2 åtgärder därefter har gått förlorade.</translation>
    </message>
    <message>
        <source>%1: is damaged; 1 action after it is lost.</source>
        <translation>%1: är skadad; 1 åtgärd därefter har gått förlorad.</translation>
    </message>
    <message>
        <source>%1: is damaged; the painting is there, but some of its strokes are missing, so that they cannot be replayed.</source>
        <translation>%1: är skadad; målningen finns, men några av dess penseldrag saknas, så att de inte kan spelas upp.</translation>
    </message>
    <message>
        <source>%1: is larger than the %2 bytes that are read at most.</source>
        <translation>%1: är större än de %2 byte som läses som mest.</translation>
    </message>
    <message>
        <source>%1: is no ICC profile (%2).</source>
        <translation>%1: är ingen ICC-profil (%2).</translation>
    </message>
    <message>
        <source>%1: is no OpenRaster file, which would hold %2.</source>
        <translation>%1: är ingen OpenRaster-fil, som skulle innehålla %2.</translation>
    </message>
    <message>
        <source>%1: is no painting of Pastoso, or its end is missing (%2).</source>
        <translation>%1: är ingen målning från Pastoso, eller så saknas slutet (%2).</translation>
    </message>
    <message>
        <source>%1: is no painting of Pastoso.</source>
        <translation>%1: är ingen målning från Pastoso.</translation>
    </message>
    <message>
        <source>%1: is not a list of media in square brackets.</source>
        <translation>%1: är inte en lista med medier inom hakparenteser.</translation>
    </message>
    <message>
        <source>%1: is not an object in braces.</source>
        <translation>%1: är inte ett objekt inom klammerparenteser.</translation>
    </message>
    <message>
        <source>%1: is of another moment.</source>
        <translation>%1: är från ett annat ögonblick.</translation>
    </message>
    <message>
        <source>%1: is write-protected; allow writing to it, or choose another name.</source>
        <translation>%1: är skrivskyddad; tillåt skrivning till den, eller välj ett annat namn.</translation>
    </message>
    <message>
        <source>%1: is written, but may be lost in a power cut (%2).</source>
        <translation>%1: är skriven, men kan gå förlorad vid ett strömavbrott (%2).</translation>
    </message>
    <message>
        <source>%1: keeps frames of %2; choose another folder.</source>
        <translation>%1: innehåller bildrutor av %2; välj en annan mapp.</translation>
    </message>
    <message>
        <source>%1: lists and objects are nested more than %2 deep.</source>
        <translation>%1: listor och objekt är nästlade mer än %2 nivåer djupt.</translation>
    </message>
    <message>
        <source>%1: lists and objects stand more than %2 deep in each other.</source>
        <translation>%1: listor och objekt ligger mer än %2 nivåer djupt i varandra.</translation>
    </message>
    <message>
        <source>%1: maps are saved as .png, .tif or .exr; %2 files do not hold heights.</source>
        <translation>%1: texturkartor sparas som .png, .tif eller .exr; %2-filer kan inte innehålla höjder.</translation>
    </message>
    <message>
        <source>%1: name is &quot;%2&quot;, which another preset of yours has already.</source>
        <translation>%1: name är ”%2”, som redan är namnet på ett annat av dina verktyg.</translation>
    </message>
    <message>
        <source>%1: only .exr files hold layers.</source>
        <translation>%1: bara .exr-filer kan innehålla lager.</translation>
    </message>
    <message>
        <source>%1: only .exr files hold the layers&apos; heights and normals.</source>
        <translation>%1: bara .exr-filer kan innehålla lagrens höjder och normaler.</translation>
    </message>
    <message>
        <source>%1: the %2 of vertex %3 is not finite; nothing was written.</source>
        <translation>%1: hörnpunkt %3 har en %2 som inte är ändlig; inget skrevs.</translation>
    </message>
    <message>
        <source>%1: the disk is full.</source>
        <translation>%1: disken är full.</translation>
    </message>
    <message>
        <source>%1: the entry &quot;%2&quot; is missing.</source>
        <translation>%1: posten ”%2” saknas.</translation>
    </message>
    <message>
        <source>%1: the list &quot;%2&quot; of paints is missing.</source>
        <translation>%1: listan ”%2” med färger saknas.</translation>
    </message>
    <message>
        <source>%1: the name &quot;%2&quot; begins with #, as only colours do.</source>
        <translation>%1: namnet ”%2” börjar med #, som bara kulörer gör.</translation>
    </message>
    <message>
        <source>%1: the name must end in .pbrt, .obj, .ply or .stl. Choose one of them.</source>
        <translation>%1: namnet måste sluta på .pbrt, .obj, .ply eller .stl. Välj en av dem.</translation>
    </message>
    <message>
        <source>%1: the pigment &quot;%2&quot; has no line for %3.</source>
        <translation>%1: pigmentet ”%2” har ingen rad för %3.</translation>
    </message>
    <message>
        <source>%1: the readings go from %2 to %3 nm; a light is needed from 400 to 700 nm.</source>
        <translation>%1: mätvärdena går från %2 till %3 nm; ett ljus behövs från 400 till 700 nm.</translation>
    </message>
    <message>
        <source>%1: the system refuses this (%2).</source>
        <translation>%1: systemet tillåter inte detta (%2).</translation>
    </message>
    <message>
        <source>%1: the weights add up to %2 instead of 1.</source>
        <translation>%1: vikternas summa är %2 i stället för 1.</translation>
    </message>
    <message>
        <source>%1: there are more than %2 triangles.</source>
        <translation>%1: det finns fler än %2 trianglar.</translation>
    </message>
    <message>
        <source>%1: there is already a pigment &quot;%2&quot;; give yours another name.</source>
        <translation>%1: det finns redan ett pigment ”%2”; ge ditt ett annat namn.</translation>
    </message>
    <message>
        <source>%1: there is no colour in this palette.</source>
        <translation>%1: det finns ingen kulör i den här paletten.</translation>
    </message>
    <message>
        <source>%1: there is no pigment &quot;%2&quot;.</source>
        <translation>%1: det finns inget pigment ”%2”.</translation>
    </message>
    <message>
        <source>%1: there is no pigment in this file.</source>
        <translation>%1: det finns inget pigment i den här filen.</translation>
    </message>
    <message>
        <source>%1: there is no reading of a light in this file.</source>
        <translation>%1: det finns inget mätvärde för ett ljus i den här filen.</translation>
    </message>
    <message>
        <source>%1: this file of the program itself is missing; reinstall it or set PASTOSO_RESOURCES to the folder that holds it.</source>
        <translation>%1: den här filen, som hör till själva programmet, saknas; installera om det eller sätt PASTOSO_RESOURCES till mappen som innehåller den.</translation>
    </message>
    <message>
        <source>%1: this folder cannot be made (%2).</source>
        <translation>%1: den här mappen kan inte skapas (%2).</translation>
    </message>
    <message>
        <source>%1: this format holds linear light, which needs no ICC profile.</source>
        <translation>%1: det här formatet innehåller linjärt ljus, som inte behöver någon ICC-profil.</translation>
    </message>
    <message>
        <source>%1: this is not valid JSON.</source>
        <translation>%1: detta är inte giltig JSON.</translation>
    </message>
    <message>
        <source>%1: this light has no power that is seen.</source>
        <translation>%1: det här ljuset har ingen effekt som syns.</translation>
    </message>
    <message>
        <source>%1: this light is so nearly a pure colour that nothing looks white in it.</source>
        <translation>%1: det här ljuset är så nära en ren kulör att inget ser vitt ut i det.</translation>
    </message>
    <message>
        <source>%1: this part of the program cannot be loaded (%2).</source>
        <translation>%1: den här delen av programmet kan inte laddas (%2).</translation>
    </message>
    <message>
        <source>%1: this part of the program is of another version; reinstall it.</source>
        <translation>%1: den här delen av programmet är av en annan version; installera om den.</translation>
    </message>
    <message>
        <source>%1: was saved by Pastoso with another form of %2; where nothing is painted, the canvas looks different.</source>
        <translation>%1: sparades av Pastoso med en annan form av %2; där inget är målat ser duken annorlunda ut.</translation>
    </message>
    <message>
        <source>16-bit pictures</source>
        <translation>16-bitarsbilder</translation>
    </message>
    <message>
        <source>8-bit pictures</source>
        <translation>8-bitarsbilder</translation>
    </message>
    <message>
        <source>&lt;%1&gt; is left out.</source>
        <translation>&lt;%1&gt; utelämnas.</translation>
    </message>
    <message>
        <source>A brush needs a name.</source>
        <translation>En pensel behöver ett namn.</translation>
    </message>
    <message>
        <source>A canvas of %1 x %2 mm at %3 px/mm</source>
        <translation>En duk på %1 x %2 mm med %3 px/mm</translation>
    </message>
    <message>
        <source>A diffusivity of %1 m2/s over %2 s; both must be 0 or more.</source>
        <translation>En diffusivitet på %1 m2/s under %2 s; båda måste vara 0 eller mer.</translation>
    </message>
    <message>
        <source>A diffusivity or viscosity of %1 m2/s is too large for a step of %2 s.</source>
        <translation>En diffusivitet eller viskositet på %1 m2/s är för stor för ett steg på %2 s.</translation>
    </message>
    <message>
        <source>A parcel&apos;s ball</source>
        <translation>En droppes kula</translation>
    </message>
    <message>
        <source>A parcel&apos;s coldness</source>
        <translation>En droppes kyla</translation>
    </message>
    <message>
        <source>A parcel&apos;s place</source>
        <translation>En droppes läge</translation>
    </message>
    <message>
        <source>A parcel&apos;s shape is none.</source>
        <translation>En droppe har en form som inte finns.</translation>
    </message>
    <message>
        <source>A parcel&apos;s volume</source>
        <translation>En droppes volym</translation>
    </message>
    <message>
        <source>A particle of this state is not within the tank.</source>
        <translation>En partikel i det här tillståndet ligger inte i tanken.</translation>
    </message>
    <message>
        <source>A picture</source>
        <translation>En bild</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels is larger than the 268 million that can be rendered.</source>
        <translation>En bild på %1 x %2 pixlar är större än de 268 miljoner som kan renderas.</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels is larger than the 32768 a side that can be made.</source>
        <translation>En bild på %1 x %2 pixlar är större än de 32768 per sida som kan göras.</translation>
    </message>
    <message>
        <source>A relief of %1 x %2 points is more than the 25 million that can be made; a coarser resolution takes fewer.</source>
        <translation>En relief på %1 x %2 punkter är mer än de 25 miljoner som kan göras; en grövre upplösning ger färre.</translation>
    </message>
    <message>
        <source>Cannot make the folder %1: %2.</source>
        <translation>Kan inte skapa mappen %1: %2.</translation>
    </message>
    <message>
        <source>Cannot write </source>
        <translation>Kan inte skriva </translation>
    </message>
    <message>
        <source>Cup, box, cells, time step, seed and the recipe&apos;s milk cannot change while the tea runs.</source>
        <translation>Glas, låda, celler, tidssteg, frö och receptets mjölk kan inte ändras medan teet är i gång.</translation>
    </message>
    <message>
        <source>Nothing has been painted yet that a film could show.</source>
        <translation>Ännu har inget målats som en film kan visa.</translation>
    </message>
    <message>
        <source>OpenGL reports error %1</source>
        <translation>OpenGL meldar fel %1</translation>
    </message>
    <message>
        <source>PASTOSO_ISA is &quot;%1&quot;, but there are baseline, avx2 and avx512.</source>
        <translation>PASTOSO_ISA är ”%1”, men det finns baseline, avx2 och avx512.</translation>
    </message>
    <message>
        <source>The %1 of the canvas is %2 %3, but must lie between %4 and %5.</source>
        <translation>Dukens %1 är %2 %3, men måste ligga mellan %4 och %5.</translation>
    </message>
    <message>
        <source>The box of liquid has %1 x %2 x %3 cells; each side may have 2 to %4.</source>
        <translation>Vätskans låda har %1 x %2 x %3 celler; varje sida får ha 2 till %4.</translation>
    </message>
    <message>
        <source>The cells of the box of liquid are %1 m wide, which is no size.</source>
        <translation>Cellerna i vätskans låda är %1 m breda, vilket inte är någon storlek.</translation>
    </message>
    <message>
        <source>The cup&apos;s radius at its level</source>
        <translation>Glasets radie vid vätskenivån</translation>
    </message>
    <message>
        <source>The diffusivity or viscosity is %1 m2/s; it must be 0 or more.</source>
        <translation>Diffusiviteten eller viskositeten är %1 m2/s; den måste vara 0 eller mer.</translation>
    </message>
    <message>
        <source>The file needs a name.</source>
        <translation>Filen behöver ett namn.</translation>
    </message>
    <message>
        <source>The film is of %1 media, but may be of %2 at most.</source>
        <translation>Skiktet består av %1 medier, men får bestå av högst %2.</translation>
    </message>
    <message>
        <source>The folder %1 holds the frames of another time-lapse; name another one.</source>
        <translation>Mappen %1 innehåller bildrutor från en annan timelapse; ange en annan.</translation>
    </message>
    <message>
        <source>The graphics card cannot draw the canvas: %1.</source>
        <translation>Grafikkortet kan inte rita duken: %1.</translation>
    </message>
    <message>
        <source>The graphics driver refuses a program that pictures are drawn with: %1</source>
        <translation>Grafikdrivrutinen vägrar ett program som bilder ritas med: %1</translation>
    </message>
    <message>
        <source>The height of the support</source>
        <translation>Underlagets höjd</translation>
    </message>
    <message>
        <source>The latest strokes %1</source>
        <translation>De senaste penseldragen %1</translation>
    </message>
    <message>
        <source>The light&apos;s %1 is %2, outside the range from %3 to %4.</source>
        <translation>Ljuset: %1 är %2, utanför området från %3 till %4.</translation>
    </message>
    <message>
        <source>The milk that was poured</source>
        <translation>Mjölken som hällts i</translation>
    </message>
    <message>
        <source>The next ball&apos;s time</source>
        <translation>Nästa kulas tid</translation>
    </message>
    <message>
        <source>The number of balls</source>
        <translation>Antalet kulor</translation>
    </message>
    <message>
        <source>The number of parcels</source>
        <translation>Antalet droppar</translation>
    </message>
    <message>
        <source>The painting is as it was saved, but its strokes %1</source>
        <translation>Målningen är som den sparades, men dess penseldrag %1</translation>
    </message>
    <message>
        <source>The painting is recovered up to an action that cannot be repeated: %1</source>
        <translation>Målningen är återskapad fram till en åtgärd som inte kan upprepas: %1</translation>
    </message>
    <message>
        <source>The painting is whole, but its strokes cannot be replayed: %1</source>
        <translation>Målningen är hel, men dess penseldrag kan inte spelas upp: %1</translation>
    </message>
    <message>
        <source>The part of the canvas to render is empty or reaches beyond the canvas.</source>
        <translation>Den del av duken som ska renderas är tom eller når utanför duken.</translation>
    </message>
    <message>
        <source>The picture&apos;s scale is %1 pixels per cell, outside the range from 1/64 to 64.</source>
        <translation>Bildens skala är %1 pixlar per cell, utanför området från 1/64 till 64.</translation>
    </message>
    <message>
        <source>The pressure is allowed %1 iterations; it needs at least 1.</source>
        <translation>Trycket får ta %1 iterationer; det behöver minst 1.</translation>
    </message>
    <message>
        <source>The pressure&apos;s tolerance is %1; it may be 1e-7 to 1.</source>
        <translation>Tryckets tolerans är %1; den får vara 1e-7 till 1.</translation>
    </message>
    <message>
        <source>The relief&apos;s %1 is %2, outside the range from %3 to %4.</source>
        <translation>Reliefens %1 är %2, utanför området från %3 till %4.</translation>
    </message>
    <message>
        <source>The state is that of another box of cells.</source>
        <translation>Tillståndet hör till en annan låda av celler.</translation>
    </message>
    <message>
        <source>The step</source>
        <translation>Steget</translation>
    </message>
    <message>
        <source>The stream&apos;s end</source>
        <translation>Strålens slut</translation>
    </message>
    <message>
        <source>The stream&apos;s parcels</source>
        <translation>Strålens droppar</translation>
    </message>
    <message>
        <source>The stream&apos;s place</source>
        <translation>Strålens läge</translation>
    </message>
    <message>
        <source>The stream&apos;s time</source>
        <translation>Strålens tid</translation>
    </message>
    <message>
        <source>The support &quot;image&quot; needs a height image; none is named.</source>
        <translation>Underlaget ”image” behöver en höjdbild; ingen är angiven.</translation>
    </message>
    <message>
        <source>The thickness of the film</source>
        <translation>Skiktets tjocklek</translation>
    </message>
    <message>
        <source>The time of this state is not one of a tank.</source>
        <translation>Det här tillståndets tid kan inte höra till en tank.</translation>
    </message>
    <message>
        <source>The time step is %1 s; it must be 0 or more.</source>
        <translation>Tidssteget är %1 s; det måste vara 0 eller mer.</translation>
    </message>
    <message>
        <source>The varnish&apos;s %1 is %2, outside the range from 0 to 1.</source>
        <translation>Fernissans %1 är %2, utanför området från 0 till 1.</translation>
    </message>
    <message>
        <source>The viscosity is %1 m2/s; it must be 0 or more.</source>
        <translation>Viskositeten är %1 m2/s; den måste vara 0 eller mer.</translation>
    </message>
    <message>
        <source>The vorticity confinement is %1; it may be 0 to 0.3.</source>
        <translation>Bevarandet av virvlar är %1; det får vara 0 till 0.3.</translation>
    </message>
    <message>
        <source>The wall&apos;s distance at (%1, %2, %3) m is not a number.</source>
        <translation>Avståndet till väggen vid (%1, %2, %3) m är inget tal.</translation>
    </message>
    <message>
        <source>There are %1 values for the %2 x %3 cells of the canvas.</source>
        <translation>Det finns %1 värden för dukens %2 x %3 celler.</translation>
    </message>
    <message>
        <source>There is already a brush &quot;%1&quot;.</source>
        <translation>Det finns redan en pensel ”%1”.</translation>
    </message>
    <message>
        <source>There is already a file %1.</source>
        <translation>Det finns redan en fil %1.</translation>
    </message>
    <message>
        <source>There is no brush &quot;%1&quot;; the brushes are %2.</source>
        <translation>Det finns ingen pensel ”%1”; penslarna är %2.</translation>
    </message>
    <message>
        <source>There is no case &quot;%1&quot;, only %2.</source>
        <translation>Det finns inget fall ”%1”, bara %2.</translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation>Det finns ingen mapp %1.</translation>
    </message>
    <message>
        <source>There is no light &quot;%1&quot;; there are D65, D50, A and LED, or give the path of a CSV file.</source>
        <translation>Det finns inget ljus ”%1”; det finns D65, D50, A och LED, eller ange sökvägen till en CSV-fil.</translation>
    </message>
    <message>
        <source>There is no medium &quot;%1&quot;; the media are: %2.</source>
        <translation>Det finns inget medium ”%1”; medierna är: %2.</translation>
    </message>
    <message>
        <source>There is no picture yet that could be saved.</source>
        <translation>Det finns ännu ingen bild att spara.</translation>
    </message>
    <message>
        <source>There is no pigment &quot;%1&quot;; %2</source>
        <translation>Det finns inget pigment ”%1”; %2</translation>
    </message>
    <message>
        <source>There is no pigment &quot;%1&quot;; did you mean %2; %3</source>
        <translation>Det finns inget pigment ”%1”; kanske menas %2; %3</translation>
    </message>
    <message>
        <source>There is no scene &quot;%1&quot;; give a file ending in .json, or one of: %2.</source>
        <translation>Det finns ingen scen ”%1”; ange en fil som slutar på .json, eller en av: %2.</translation>
    </message>
    <message>
        <source>There is no support &quot;%1&quot;; the supports are: %2.</source>
        <translation>Det finns inget underlag ”%1”; underlagen är: %2.</translation>
    </message>
    <message>
        <source>This is the state of a level set, not of particles.</source>
        <translation>Detta är tillståndet för en nivåmängd, inte för partiklar.</translation>
    </message>
    <message>
        <source>This is the state of a tank that is followed in another way.</source>
        <translation>Detta är tillståndet för en tank som följs på ett annat sätt.</translation>
    </message>
    <message>
        <source>This is the state of another tank.</source>
        <translation>Detta är tillståndet för en annan tank.</translation>
    </message>
    <message>
        <source>a bristle holds what none can.</source>
        <translation>ett borst innehåller något som inget borst kan innehålla.</translation>
    </message>
    <message>
        <source>a cap is at most a half sphere: its thickness %1 must lie above 0 and not above its radius %2.</source>
        <translation>en kalott är högst ett halvt klot: dess tjocklek %1 måste ligga över 0 och inte över dess radie %2.</translation>
    </message>
    <message>
        <source>a cell holds more of its media than it holds paint.</source>
        <translation>en cell innehåller mer av sina medier än den innehåller färg.</translation>
    </message>
    <message>
        <source>a combination has no parts.</source>
        <translation>en kombination har inga delar.</translation>
    </message>
    <message>
        <source>a corner of triangle %1 is not finite (%2).</source>
        <translation>ett hörn i triangel %1 är inte ändligt (%2).</translation>
    </message>
    <message>
        <source>a corner stands outside of a loop.</source>
        <translation>ett hörn står utanför en slinga.</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>en enhet</translation>
    </message>
    <message>
        <source>a document type is not read here.</source>
        <translation>en dokumenttyp kan inte läsas här.</translation>
    </message>
    <message>
        <source>a face has %1 corners, not three or more.</source>
        <translation>en sidoyta har %1 hörn, inte tre eller fler.</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>en fil</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>en mapp</translation>
    </message>
    <message>
        <source>a glass of milk tea</source>
        <translation>ett glas mjölkte</translation>
    </message>
    <message>
        <source>a group needs a layer.</source>
        <translation>en grupp behöver ett lager.</translation>
    </message>
    <message>
        <source>a height of the support</source>
        <translation>en höjd hos underlaget</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>en lista</translation>
    </message>
    <message>
        <source>a loop begins within another one.</source>
        <translation>en slinga börjar inuti en annan.</translation>
    </message>
    <message>
        <source>a loop ends that has no three corners.</source>
        <translation>en slinga slutar utan att ha tre hörn.</translation>
    </message>
    <message>
        <source>a mixture</source>
        <translation>en blandning</translation>
    </message>
    <message>
        <source>a named pipe</source>
        <translation>ett namngivet rör</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>ett tal</translation>
    </message>
    <message>
        <source>a number is missing.</source>
        <translation>ett tal saknas.</translation>
    </message>
    <message>
        <source>a painting has 1 to %1 layers, not %2.</source>
        <translation>en målning har 1 till %1 lager, inte %2.</translation>
    </message>
    <message>
        <source>a painting has at most %1 layers.</source>
        <translation>en målning har högst %1 lager.</translation>
    </message>
    <message>
        <source>a painting keeps its last layer.</source>
        <translation>en målning behåller sitt sista lager.</translation>
    </message>
    <message>
        <source>a picture on it has no strokes, and comes no finer than it is.</source>
        <translation>en bild på den har inga penseldrag, och blir inte finare än den är.</translation>
    </message>
    <message>
        <source>a point of an outline has two numbers, x and y.</source>
        <translation>en punkt i en kontur har två tal, x och y.</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>ett tryck</translation>
    </message>
    <message>
        <source>a pressure curve leads from 0 to 1 and never falls.</source>
        <translation>en tryckkurva går från 0 till 1 och faller aldrig.</translation>
    </message>
    <message>
        <source>a reflectance</source>
        <translation>en reflektans</translation>
    </message>
    <message>
        <source>a run is named by up to 64 small letters, digits and hyphens.</source>
        <translation>en körning har ett namn på högst 64 små bokstäver, siffror och bindestreck.</translation>
    </message>
    <message>
        <source>a scene</source>
        <translation>en scen</translation>
    </message>
    <message>
        <source>a scene of a glass tank</source>
        <translation>en scen med en glastank</translation>
    </message>
    <message>
        <source>a shape is an object with one entry, its form, which is one of %1.</source>
        <translation>en form är ett objekt med en enda post, själva formen, som är en av %1.</translation>
    </message>
    <message>
        <source>a socket</source>
        <translation>en socket</translation>
    </message>
    <message>
        <source>a stroke needs at least one sample.</source>
        <translation>ett penseldrag behöver minst ett sampel.</translation>
    </message>
    <message>
        <source>a stroke recording</source>
        <translation>en inspelning av penseldrag</translation>
    </message>
    <message>
        <source>a stroke that goes on stays on its surface.</source>
        <translation>ett penseldrag som fortsätter stannar på sin yta.</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>en text</translation>
    </message>
    <message>
        <source>a thickness</source>
        <translation>en tjocklek</translation>
    </message>
    <message>
        <source>a thickness of dry paint</source>
        <translation>en tjocklek av torr färg</translation>
    </message>
    <message>
        <source>a tilt needs millimetres; in cells give &quot;gravity&quot;.</source>
        <translation>en lutning behöver millimeter; ange ”gravity” när måtten är i celler.</translation>
    </message>
    <message>
        <source>a triangle has more than three corners.</source>
        <translation>en triangel har fler än tre hörn.</translation>
    </message>
    <message>
        <source>a velocity</source>
        <translation>en hastighet</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>ett heltal</translation>
    </message>
    <message>
        <source>alpha_min is %1, it must not be larger than alpha_max, %2.</source>
        <translation>alpha_min är %1, men får inte vara större än alpha_max, %2.</translation>
    </message>
    <message>
        <source>ambient share</source>
        <translation>andelen jämnt ljus</translation>
    </message>
    <message>
        <source>amount</source>
        <translation>mängd</translation>
    </message>
    <message>
        <source>an amount of a medium</source>
        <translation>en mängd av ett medium</translation>
    </message>
    <message>
        <source>an amount of dry pigment</source>
        <translation>en mängd torrt pigment</translation>
    </message>
    <message>
        <source>an amount of paint</source>
        <translation>en mängd färg</translation>
    </message>
    <message>
        <source>an exception of an unknown kind</source>
        <translation>ett undantag av okänt slag</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ett objekt</translation>
    </message>
    <message>
        <source>aside</source>
        <translation>vid sidan</translation>
    </message>
    <message>
        <source>at least one run is needed.</source>
        <translation>minst en körning behövs.</translation>
    </message>
    <message>
        <source>axis of the symmetry</source>
        <translation>symmetrins axel</translation>
    </message>
    <message>
        <source>azimuth in degrees</source>
        <translation>azimuten i grader</translation>
    </message>
    <message>
        <source>bare support</source>
        <translation>det tomma underlaget</translation>
    </message>
    <message>
        <source>base in mm</source>
        <translation>bas i mm</translation>
    </message>
    <message>
        <source>belongs to another scene.</source>
        <translation>hör till en annan scen.</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>blått</translation>
    </message>
    <message>
        <source>camera eye</source>
        <translation>kamerans öga</translation>
    </message>
    <message>
        <source>camera target</source>
        <translation>kamerans mål</translation>
    </message>
    <message>
        <source>cannot be read (%1).</source>
        <translation>kan inte läsas (%1).</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>kan inte läsas till slutet</translation>
    </message>
    <message>
        <source>canvas</source>
        <translation>duken</translation>
    </message>
    <message>
        <source>cell (%1, %2) holds %3 that cannot be.</source>
        <translation>cell (%1, %2) innehåller något omöjligt: %3.</translation>
    </message>
    <message>
        <source>cell (%1, %2) holds a lower stratum that is no part of its paint.</source>
        <translation>cell (%1, %2) innehåller ett undre skikt som inte är en del av dess färg.</translation>
    </message>
    <message>
        <source>checkpoint of a tank</source>
        <translation>kontrollpunkt för en tank</translation>
    </message>
    <message>
        <source>checkpoint of tea</source>
        <translation>kontrollpunkt för te</translation>
    </message>
    <message>
        <source>column %1 (%2): %3</source>
        <translation>kolumn %1 (%2): %3</translation>
    </message>
    <message>
        <source>cup axis</source>
        <translation>glasets axel</translation>
    </message>
    <message>
        <source>cup floor</source>
        <translation>glasets botten</translation>
    </message>
    <message>
        <source>cup foot</source>
        <translation>glasets fot</translation>
    </message>
    <message>
        <source>cup level</source>
        <translation>glasets vätskenivå</translation>
    </message>
    <message>
        <source>cup radius at the foot</source>
        <translation>glasets radie vid foten</translation>
    </message>
    <message>
        <source>cup radius at the rim</source>
        <translation>glasets radie vid kanten</translation>
    </message>
    <message>
        <source>cup rim</source>
        <translation>glasets kant</translation>
    </message>
    <message>
        <source>cup slope</source>
        <translation>glasets lutning</translation>
    </message>
    <message>
        <source>cup wall</source>
        <translation>glasets vägg</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>grader</translation>
    </message>
    <message>
        <source>dent</source>
        <translation>fördjupningen</translation>
    </message>
    <message>
        <source>dent depth</source>
        <translation>fördjupningens djup</translation>
    </message>
    <message>
        <source>dent radius</source>
        <translation>fördjupningens radie</translation>
    </message>
    <message>
        <source>direction of the tilt</source>
        <translation>lutningens riktning</translation>
    </message>
    <message>
        <source>distance from eye to target</source>
        <translation>avståndet från ögat till målet</translation>
    </message>
    <message>
        <source>distance of the ruler&apos;s points</source>
        <translation>avståndet mellan linjalens punkter</translation>
    </message>
    <message>
        <source>elevation in degrees</source>
        <translation>höjden i grader</translation>
    </message>
    <message>
        <source>ellipse&apos;s centre</source>
        <translation>ellipsens mitt</translation>
    </message>
    <message>
        <source>event %1: %2</source>
        <translation>händelse %1: %2</translation>
    </message>
    <message>
        <source>exaggeration</source>
        <translation>överhöjning</translation>
    </message>
    <message>
        <source>expected &quot;%1&quot;.</source>
        <translation>här ska det stå ”%1”.</translation>
    </message>
    <message>
        <source>expected &quot;levels&quot; or &quot;fine&quot;.</source>
        <translation>här ska det stå ”levels” eller ”fine”.</translation>
    </message>
    <message>
        <source>expected &quot;none&quot;, &quot;several&quot; or the numbers of one.</source>
        <translation>här ska det stå ”none”, ”several” eller talen för en enda.</translation>
    </message>
    <message>
        <source>expected %1 media at most.</source>
        <translation>här ska det stå högst %1 medier.</translation>
    </message>
    <message>
        <source>expected %1 numbers, one for each tile.</source>
        <translation>här ska det stå %1 tal, ett för varje ruta.</translation>
    </message>
    <message>
        <source>expected %1 numbers.</source>
        <translation>här ska det stå %1 tal.</translation>
    </message>
    <message>
        <source>expected %1, found %2.</source>
        <translation>här ska det stå %1, inte %2.</translation>
    </message>
    <message>
        <source>expected 0 or more.</source>
        <translation>här ska det stå 0 eller mer.</translation>
    </message>
    <message>
        <source>expected 0 to 10000.</source>
        <translation>här ska det stå 0 till 10000.</translation>
    </message>
    <message>
        <source>expected 0 to 10000000.</source>
        <translation>här ska det stå 0 till 10000000.</translation>
    </message>
    <message>
        <source>expected 0 to a million seconds.</source>
        <translation>här ska det stå 0 till en miljon sekunder.</translation>
    </message>
    <message>
        <source>expected 1 to %1 layers.</source>
        <translation>här ska det stå 1 till %1 lager.</translation>
    </message>
    <message>
        <source>expected 4 numbers, seconds x y pressure, found %1.</source>
        <translation>här ska det stå 4 tal, sekunder x y tryck, men det står %1.</translation>
    </message>
    <message>
        <source>expected a colour and its name, for example [&quot;#783c14&quot;, &quot;Umber&quot;].</source>
        <translation>här ska det stå en kulör och dess namn, till exempel [&quot;#783c14&quot;, &quot;Umber&quot;].</translation>
    </message>
    <message>
        <source>expected a name that begins with pastoso/.</source>
        <translation>här ska det stå ett namn som börjar med pastoso/.</translation>
    </message>
    <message>
        <source>expected a number for &quot;%1&quot;.</source>
        <translation>för ”%1” ska det stå ett tal.</translation>
    </message>
    <message>
        <source>expected a number from 1 to 1000.</source>
        <translation>här ska det stå ett tal från 1 till 1000.</translation>
    </message>
    <message>
        <source>expected a pigment and its parts, for example [&quot;PB29&quot;, 1].</source>
        <translation>här ska det stå ett pigment och dess delar, till exempel [&quot;PB29&quot;, 1].</translation>
    </message>
    <message>
        <source>expected a width and a height.</source>
        <translation>här ska det stå en bredd och en höjd.</translation>
    </message>
    <message>
        <source>expected an amount of paint up to 1e18.</source>
        <translation>här ska det stå en mängd färg på högst 1e18.</translation>
    </message>
    <message>
        <source>expected four numbers, [left, top, right, bottom].</source>
        <translation>här ska det stå fyra tal, [vänster, överkant, höger, underkant].</translation>
    </message>
    <message>
        <source>expected four whole numbers, [left, top, right, bottom].</source>
        <translation>här ska det stå fyra heltal, [vänster, överkant, höger, underkant].</translation>
    </message>
    <message>
        <source>expected one number for each medium.</source>
        <translation>här ska det stå ett tal för varje medium.</translation>
    </message>
    <message>
        <source>expected one of %1 beside the tick.</source>
        <translation>här ska det stå en av %1 bredvid tick.</translation>
    </message>
    <message>
        <source>expected sixteen hexadecimal digits.</source>
        <translation>här ska det stå sexton hexadecimala siffror.</translation>
    </message>
    <message>
        <source>expected the first tile and how many there are.</source>
        <translation>här ska det stå den första rutan och hur många de är.</translation>
    </message>
    <message>
        <source>expected the name of a file in the journal&apos;s folder.</source>
        <translation>här ska det stå namnet på en fil i journalens mapp.</translation>
    </message>
    <message>
        <source>expected three numbers, found %1.</source>
        <translation>här ska det stå tre tal, men det står %1.</translation>
    </message>
    <message>
        <source>expected three whole numbers, found %1.</source>
        <translation>här ska det stå tre heltal, men det står %1.</translation>
    </message>
    <message>
        <source>expected two numbers, [width, height].</source>
        <translation>här ska det stå två tal, [bredd, höjd].</translation>
    </message>
    <message>
        <source>expected two numbers, [x, y].</source>
        <translation>här ska det stå två tal, [x, y].</translation>
    </message>
    <message>
        <source>expected two numbers, for example [0.5, 0.7].</source>
        <translation>här ska det stå två tal, till exempel [0.5, 0.7].</translation>
    </message>
    <message>
        <source>expected two numbers, for example [20, 30].</source>
        <translation>här ska det stå två tal, till exempel [20, 30].</translation>
    </message>
    <message>
        <source>fill of the brush</source>
        <translation>penselns fyllnad</translation>
    </message>
    <message>
        <source>frame of tea</source>
        <translation>bildruta av te</translation>
    </message>
    <message>
        <source>green</source>
        <translation>grönt</translation>
    </message>
    <message>
        <source>group of the layer</source>
        <translation>lagrets grupp</translation>
    </message>
    <message>
        <source>grouping layers that do not lie next to each other would tear a group of layers apart.</source>
        <translation>att gruppera lager som inte ligger intill varandra skulle slita isär en grupp av lager.</translation>
    </message>
    <message>
        <source>half height of the ellipse</source>
        <translation>ellipsens halva höjd</translation>
    </message>
    <message>
        <source>half width of the ellipse</source>
        <translation>ellipsens halva bredd</translation>
    </message>
    <message>
        <source>has %1 x %2 pixels, but at most 32768 a side and 100 million in all are read.</source>
        <translation>har %1 x %2 pixlar, men högst 32768 per sida och sammanlagt 100 miljoner läses.</translation>
    </message>
    <message>
        <source>height</source>
        <translation>höjd</translation>
    </message>
    <message>
        <source>height of the new canvas</source>
        <translation>den nya dukens höjd</translation>
    </message>
    <message>
        <source>height of the picture</source>
        <translation>bildens höjd</translation>
    </message>
    <message>
        <source>holds %1 bytes, but at most %2 are possible here.</source>
        <translation>innehåller %1 byte, men högst %2 är möjligt här.</translation>
    </message>
    <message>
        <source>holds a parcel (number %1) whose shape is none.</source>
        <translation>innehåller en droppe (nummer %1) med en form som inte finns.</translation>
    </message>
    <message>
        <source>holds a parcel (number %1) whose values are not finite.</source>
        <translation>innehåller en droppe (nummer %1) vars värden inte är ändliga.</translation>
    </message>
    <message>
        <source>holds a particle whose numbers are not finite.</source>
        <translation>innehåller en partikel vars tal inte är ändliga.</translation>
    </message>
    <message>
        <source>holds a value of a cell that is not finite.</source>
        <translation>innehåller ett cellvärde som inte är ändligt.</translation>
    </message>
    <message>
        <source>holds a value that is not a finite number.</source>
        <translation>innehåller ett värde som inte är ett ändligt tal.</translation>
    </message>
    <message>
        <source>holds an ICC profile that is none (it is damaged).</source>
        <translation>innehåller en ogiltig ICC-profil (den är skadad).</translation>
    </message>
    <message>
        <source>holds sizes or numbers that no tank has.</source>
        <translation>innehåller storlekar eller tal som ingen tank har.</translation>
    </message>
    <message>
        <source>holds sizes or numbers that no tea has.</source>
        <translation>innehåller storlekar eller tal som inget te har.</translation>
    </message>
    <message>
        <source>holds sizes or times that no frame has.</source>
        <translation>innehåller storlekar eller tider som ingen bildruta har.</translation>
    </message>
    <message>
        <source>holds the paint of another brush than the one %1, which has %2 bristles.</source>
        <translation>innehåller färgen från en annan pensel än den %1, som har %2 borst.</translation>
    </message>
    <message>
        <source>in hand</source>
        <translation>i handen</translation>
    </message>
    <message>
        <source>is cut off: the end of the JPEG picture is missing.</source>
        <translation>är avklippt: JPEG-bildens slut saknas.</translation>
    </message>
    <message>
        <source>is damaged (%1).</source>
        <translation>är skadad (%1).</translation>
    </message>
    <message>
        <source>is damaged (it cannot be decompressed, or its checksum is another).</source>
        <translation>är skadad (den kan inte packas upp, eller så är dess kontrollsumma en annan).</translation>
    </message>
    <message>
        <source>is damaged (it ends within its first %1 bytes).</source>
        <translation>är skadad (den slutar inom sina första %1 byte).</translation>
    </message>
    <message>
        <source>is damaged (it is longer than it says).</source>
        <translation>är skadad (den är längre än den anger).</translation>
    </message>
    <message>
        <source>is damaged (it is shorter than it says).</source>
        <translation>är skadad (den är kortare än den anger).</translation>
    </message>
    <message>
        <source>is damaged (its checksum is another).</source>
        <translation>är skadad (dess kontrollsumma är en annan).</translation>
    </message>
    <message>
        <source>is damaged (its header reaches beyond the end).</source>
        <translation>är skadad (dess huvud når bortom slutet).</translation>
    </message>
    <message>
        <source>is damaged (its length is not the one that is noted).</source>
        <translation>är skadad (dess längd är inte den som är noterad).</translation>
    </message>
    <message>
        <source>is larger than the %1 bytes that are read of a WebP picture at most.</source>
        <translation>är större än de %1 byte som läses av en WebP-bild som mest.</translation>
    </message>
    <message>
        <source>is missing.</source>
        <translation>saknas.</translation>
    </message>
    <message>
        <source>is no %1.</source>
        <translation>är ingen %1.</translation>
    </message>
    <message>
        <source>is no PNG picture</source>
        <translation>är ingen PNG-bild</translation>
    </message>
    <message>
        <source>is not an image that can be read (it is none of %1).</source>
        <translation>är ingen bild som kan läsas (den är ingen av %1).</translation>
    </message>
    <message>
        <source>is of version %1, this program reads %2.</source>
        <translation>har version %1, men det här programmet läser %2.</translation>
    </message>
    <message>
        <source>is stored in tiles of %1 x %2 pixels, but 8 a side are the least that are read.</source>
        <translation>är lagrad i rutor på %1 x %2 pixlar, men 8 per sida är det minsta som läses.</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>den är skadad</translation>
    </message>
    <message>
        <source>it was reset</source>
        <translation>det har startats om</translation>
    </message>
    <message>
        <source>its end is missing</source>
        <translation>slutet saknas</translation>
    </message>
    <message>
        <source>its memory does not suffice</source>
        <translation>dess minne räcker inte</translation>
    </message>
    <message>
        <source>its strokes %1</source>
        <translation>dess penseldrag %1</translation>
    </message>
    <message>
        <source>its support is a picture, and comes no finer than that.</source>
        <translation>dess underlag är en bild, och blir inte finare än så.</translation>
    </message>
    <message>
        <source>lamp radiance</source>
        <translation>lampans radians</translation>
    </message>
    <message>
        <source>lamp radius</source>
        <translation>lampans radie</translation>
    </message>
    <message>
        <source>lamp towards</source>
        <translation>lampans riktning</translation>
    </message>
    <message>
        <source>least height</source>
        <translation>minsta höjden</translation>
    </message>
    <message>
        <source>least thickness of wet paint</source>
        <translation>minsta tjockleken av våt färg</translation>
    </message>
    <message>
        <source>linear pictures</source>
        <translation>linjära bilder</translation>
    </message>
    <message>
        <source>memory ran out: what was asked for last is not done, or not whole.</source>
        <translation>minnet tog slut: det som begärdes sist är inte gjort, eller inte helt.</translation>
    </message>
    <message>
        <source>mesh: &quot;%1&quot; was not read.</source>
        <translation>mesh: ”%1” har inte lästs.</translation>
    </message>
    <message>
        <source>mesh: it is not closed: the edge from %1 to %2 is not shared by exactly two triangles that run along it in opposite directions.</source>
        <translation>mesh: nätet är inte slutet: kanten från %1 till %2 delas inte av precis två trianglar som löper längs den i motsatta riktningar.</translation>
    </message>
    <message>
        <source>mesh: there are no triangles.</source>
        <translation>mesh: det finns inga trianglar.</translation>
    </message>
    <message>
        <source>mesh: triangle %1 names vertex %2 of %3.</source>
        <translation>mesh: triangel %1 anger hörnpunkt %2 av %3.</translation>
    </message>
    <message>
        <source>mesh: vertex %1 lies at %2, which is no place.</source>
        <translation>mesh: hörnpunkt %1 ligger vid %2, vilket inte är någon plats.</translation>
    </message>
    <message>
        <source>milk share</source>
        <translation>andelen mjölk</translation>
    </message>
    <message>
        <source>milk share&apos;s cell</source>
        <translation>cellen i andelen mjölk</translation>
    </message>
    <message>
        <source>missing; %1</source>
        <translation>saknas; %1</translation>
    </message>
    <message>
        <source>mixing well</source>
        <translation>blandningsytan</translation>
    </message>
    <message>
        <source>most height</source>
        <translation>största höjden</translation>
    </message>
    <message>
        <source>most thickness of wet paint</source>
        <translation>största tjockleken av våt färg</translation>
    </message>
    <message>
        <source>moving the group there would tear a group of layers apart.</source>
        <translation>att flytta gruppen dit skulle slita isär en grupp av lager.</translation>
    </message>
    <message>
        <source>moving the layer there would tear a group of layers apart.</source>
        <translation>att flytta lagret dit skulle slita isär en grupp av lager.</translation>
    </message>
    <message>
        <source>name of a group</source>
        <translation>gruppens namn</translation>
    </message>
    <message>
        <source>name of a layer</source>
        <translation>lagrets namn</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>ingen orsak angiven</translation>
    </message>
    <message>
        <source>no reason was given</source>
        <translation>ingen orsak angavs</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>number of parts of %1</source>
        <translation>antalet delar %1</translation>
    </message>
    <message>
        <source>number of the group</source>
        <translation>gruppens nummer</translation>
    </message>
    <message>
        <source>number of the layer</source>
        <translation>lagrets nummer</translation>
    </message>
    <message>
        <source>number of the outline&apos;s points</source>
        <translation>antalet punkter i konturen</translation>
    </message>
    <message>
        <source>number of the picture&apos;s pixels</source>
        <translation>antalet pixlar i bilden</translation>
    </message>
    <message>
        <source>number of the symmetry&apos;s copies</source>
        <translation>antalet kopior i symmetrin</translation>
    </message>
    <message>
        <source>opacity of the layer</source>
        <translation>lagrets opacitet</translation>
    </message>
    <message>
        <source>opacity of the tracing picture</source>
        <translation>den kalkerade bildens opacitet</translation>
    </message>
    <message>
        <source>other tea</source>
        <translation>annat te</translation>
    </message>
    <message>
        <source>pictures of %1 million pixels are too large; choose a &quot;picture_scale&quot; for at most 100 million.</source>
        <translation>bilder på %1 miljoner pixlar är för stora; välj en ”picture_scale” som ger högst 100 miljoner.</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pixlar</translation>
    </message>
    <message>
        <source>place on the cloth in x</source>
        <translation>läge på tyget i x-led</translation>
    </message>
    <message>
        <source>place on the cloth in y</source>
        <translation>läge på tyget i y-led</translation>
    </message>
    <message>
        <source>position</source>
        <translation>position</translation>
    </message>
    <message>
        <source>position of the group</source>
        <translation>gruppens plats</translation>
    </message>
    <message>
        <source>position of the layer</source>
        <translation>lagrets plats</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>trycket</translation>
    </message>
    <message>
        <source>pressure of the pen</source>
        <translation>pennans tryck</translation>
    </message>
    <message>
        <source>radius of the fan</source>
        <translation>fläktens radie</translation>
    </message>
    <message>
        <source>reach of the guide</source>
        <translation>hjälplinjens räckvidd</translation>
    </message>
    <message>
        <source>receding_angle_deg is %1, it must not be larger than advancing_angle_deg, %2.</source>
        <translation>receding_angle_deg är %1, men får inte vara större än advancing_angle_deg, %2.</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rött</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>upplösning</translation>
    </message>
    <message>
        <source>resolution in mm</source>
        <translation>upplösning i mm</translation>
    </message>
    <message>
        <source>rotation of the pen</source>
        <translation>pennans rotation</translation>
    </message>
    <message>
        <source>roughness on the dry support</source>
        <translation>strävheten på det torra underlaget</translation>
    </message>
    <message>
        <source>roughness on wet paint</source>
        <translation>strävheten på våt färg</translation>
    </message>
    <message>
        <source>ruler&apos;s first point</source>
        <translation>linjalens första punkt</translation>
    </message>
    <message>
        <source>ruler&apos;s second point</source>
        <translation>linjalens andra punkt</translation>
    </message>
    <message>
        <source>scale of the transform along %1, without its sign,</source>
        <translation>transformeringens skala längs %1, utan tecken,</translation>
    </message>
    <message>
        <source>scene format</source>
        <translation>scenformat</translation>
    </message>
    <message>
        <source>scene: %1 is %2, but must be from %3 to %4.</source>
        <translation>scen: %1 är %2, men måste vara från %3 till %4.</translation>
    </message>
    <message>
        <source>scene: %1 is 0, but must be a direction.</source>
        <translation>scen: %1 är 0, men måste vara en riktning.</translation>
    </message>
    <message>
        <source>scene: %1&apos;s corner is %2, but must be the number of a position.</source>
        <translation>scen: ett hörn i %1 är %2, men måste vara numret på en position.</translation>
    </message>
    <message>
        <source>scene: %1&apos;s number of normals is %2, but must be 0 or that of its positions.</source>
        <translation>scen: antalet normaler i %1 är %2, men måste vara 0 eller lika med antalet positioner.</translation>
    </message>
    <message>
        <source>scene: there is not enough memory to trace a mesh of %1 triangles.</source>
        <translation>scen: minnet räcker inte för att spåra ett nät av %1 trianglar.</translation>
    </message>
    <message>
        <source>seed of the brush</source>
        <translation>penselns frö</translation>
    </message>
    <message>
        <source>shadow softness in mm</source>
        <translation>skuggornas mjukhet i mm</translation>
    </message>
    <message>
        <source>share of paint</source>
        <translation>andelen färg</translation>
    </message>
    <message>
        <source>share of the second paint</source>
        <translation>den andra färgens andel</translation>
    </message>
    <message>
        <source>share that is wiped off the brush</source>
        <translation>andelen som torkas av från penseln</translation>
    </message>
    <message>
        <source>single-precision pictures</source>
        <translation>bilder i enkel precision</translation>
    </message>
    <message>
        <source>sky above</source>
        <translation>himlen ovanför</translation>
    </message>
    <message>
        <source>sky below</source>
        <translation>himlen nedanför</translation>
    </message>
    <message>
        <source>smoothing of the stabiliser</source>
        <translation>stabiliseringens utjämning</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>något annat</translation>
    </message>
    <message>
        <source>something went wrong within the program (%1).</source>
        <translation>något gick fel i programmet (%1).</translation>
    </message>
    <message>
        <source>speed of drying</source>
        <translation>torkningens hastighet</translation>
    </message>
    <message>
        <source>strata that give more light than they get</source>
        <translation>skikt som ger mer ljus än de får</translation>
    </message>
    <message>
        <source>strength of the fan</source>
        <translation>fläktens styrka</translation>
    </message>
    <message>
        <source>strength of the paint</source>
        <translation>färgens styrka</translation>
    </message>
    <message>
        <source>string of the stabiliser</source>
        <translation>längden på stabiliseringens snöre</translation>
    </message>
    <message>
        <source>stroke format</source>
        <translation>penseldragsformat</translation>
    </message>
    <message>
        <source>support relief</source>
        <translation>underlagsrelief</translation>
    </message>
    <message>
        <source>table fading</source>
        <translation>bordets avtoning</translation>
    </message>
    <message>
        <source>table height</source>
        <translation>bordets höjd</translation>
    </message>
    <message>
        <source>table radius</source>
        <translation>bordets radie</translation>
    </message>
    <message>
        <source>table reflectance</source>
        <translation>bordets reflektans</translation>
    </message>
    <message>
        <source>tank format</source>
        <translation>tankformat</translation>
    </message>
    <message>
        <source>tank wall</source>
        <translation>tankens vägg</translation>
    </message>
    <message>
        <source>tea format</source>
        <translation>teformat</translation>
    </message>
    <message>
        <source>tells of strokes that are later than the painting.</source>
        <translation>innehåller penseldrag som är senare än målningen.</translation>
    </message>
    <message>
        <source>the %1 &quot;%2&quot; is not a whole number from 0 to 255.</source>
        <translation>%1 ”%2” är inget heltal från 0 till 255.</translation>
    </message>
    <message>
        <source>the %1 %2 is not a number.</source>
        <translation>%1 %2 är inget tal.</translation>
    </message>
    <message>
        <source>the %1 %2 is not between -1e7 and 1e7.</source>
        <translation>%1 %2 är inte mellan -1e7 och 1e7.</translation>
    </message>
    <message>
        <source>the %1 has %2 bytes, but at most %3 are kept.</source>
        <translation>%1 har %2 byte, men högst %3 behålls.</translation>
    </message>
    <message>
        <source>the %1 has %2 x %3 cells, but %4 x %5 of another size are expected.</source>
        <translation>%1 har %2 x %3 celler, men det ska vara %4 x %5 av en annan storlek.</translation>
    </message>
    <message>
        <source>the %1 in %2 is %3, but must lie between %4 and %5.</source>
        <translation>%1 i %2 är %3, men måste ligga mellan %4 och %5.</translation>
    </message>
    <message>
        <source>the %1 is %2, but must lie between %3 and %4.</source>
        <translation>%1 är %2, men måste ligga mellan %3 och %4.</translation>
    </message>
    <message>
        <source>the %1 is missing.</source>
        <translation>%1 saknas.</translation>
    </message>
    <message>
        <source>the active layer is none.</source>
        <translation>det aktiva lagret finns inte.</translation>
    </message>
    <message>
        <source>the area is empty.</source>
        <translation>området är tomt.</translation>
    </message>
    <message>
        <source>the brush &quot;%1&quot;</source>
        <translation>penseln ”%1”</translation>
    </message>
    <message>
        <source>the brush %1 is told of only in part.</source>
        <translation>penseln %1 är bara delvis beskriven.</translation>
    </message>
    <message>
        <source>the disk is full; make room on it, or choose another place</source>
        <translation>disken är full; frigör utrymme på den, eller välj en annan plats</translation>
    </message>
    <message>
        <source>the elements are nested too deep.</source>
        <translation>elementen är nästlade för djupt.</translation>
    </message>
    <message>
        <source>the entry &quot;%1&quot; is missing.</source>
        <translation>posten ”%1” saknas.</translation>
    </message>
    <message>
        <source>the field &quot;%1&quot; is missing.</source>
        <translation>fältet ”%1” saknas.</translation>
    </message>
    <message>
        <source>the file ends here, before &quot;endsolid&quot;.</source>
        <translation>filen slutar här, före ”endsolid”.</translation>
    </message>
    <message>
        <source>the file ends here, within the head of an STL file.</source>
        <translation>filen slutar här, i huvudet på en STL-fil.</translation>
    </message>
    <message>
        <source>the groups within &quot;%1&quot; become part of it.</source>
        <translation>grupperna i ”%1” blir en del av den.</translation>
    </message>
    <message>
        <source>the heading is &quot;%1&quot; instead of &quot;%2&quot;.</source>
        <translation>rubriken är ”%1” i stället för ”%2”.</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is hidden.</source>
        <translation>lagret ”%1” är dolt.</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is in a group already.</source>
        <translation>lagret ”%1” är redan i en grupp.</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is locked.</source>
        <translation>lagret ”%1” är låst.</translation>
    </message>
    <message>
        <source>the layers are too large in all.</source>
        <translation>lagren är för stora sammantaget.</translation>
    </message>
    <message>
        <source>the layers of a group do not lie next to each other.</source>
        <translation>lagren i en grupp ligger inte intill varandra.</translation>
    </message>
    <message>
        <source>the medium</source>
        <translation>mediet</translation>
    </message>
    <message>
        <source>the palette has %1, yours %2.</source>
        <translation>i paletten finns %1, bland dina egna %2.</translation>
    </message>
    <message>
        <source>the palette has %1.</source>
        <translation>i paletten finns %1.</translation>
    </message>
    <message>
        <source>the pen touches the canvas with no brush in hand.</source>
        <translation>pennan rör vid duken utan någon pensel i handen.</translation>
    </message>
    <message>
        <source>the pen touches the mixing well with no brush in hand.</source>
        <translation>pennan rör vid blandningsytan utan någon pensel i handen.</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>bilden</translation>
    </message>
    <message>
        <source>the picture %1</source>
        <translation>bilden %1</translation>
    </message>
    <message>
        <source>the picture is no base64.</source>
        <translation>bilden är inte base64.</translation>
    </message>
    <message>
        <source>the pictures of this recording are too large; at most 500 million pixels in all are read.</source>
        <translation>bilderna i den här inspelningen är för stora; sammanlagt högst 500 miljoner pixlar läses.</translation>
    </message>
    <message>
        <source>the pigment has no name.</source>
        <translation>pigmentet har inget namn.</translation>
    </message>
    <message>
        <source>the power</source>
        <translation>effekten</translation>
    </message>
    <message>
        <source>the power %1 is negative.</source>
        <translation>effekten %1 är negativ.</translation>
    </message>
    <message>
        <source>the preset</source>
        <translation>penselförinställningen</translation>
    </message>
    <message>
        <source>the pressure %1 is not between 0 and 1.</source>
        <translation>trycket %1 är inte mellan 0 och 1.</translation>
    </message>
    <message>
        <source>the size of the picture is missing.</source>
        <translation>bildens storlek saknas.</translation>
    </message>
    <message>
        <source>the system refuses this (%1).</source>
        <translation>systemet tillåter inte detta (%1).</translation>
    </message>
    <message>
        <source>the tick %1 is earlier than %2 before it.</source>
        <translation>tick %1 är tidigare än %2, som står före.</translation>
    </message>
    <message>
        <source>the tiles hold %1 bytes, which has to be the size and at most %2.</source>
        <translation>rutorna innehåller %1 byte; det måste vara lika med storleken, och högst %2.</translation>
    </message>
    <message>
        <source>the time %1 s is earlier than %2 s before it.</source>
        <translation>tiden %1 s är tidigare än %2 s, som står före.</translation>
    </message>
    <message>
        <source>the time %1 s is not between 0 and 86400 s.</source>
        <translation>tiden %1 s är inte mellan 0 och 86400 s.</translation>
    </message>
    <message>
        <source>the wavelength</source>
        <translation>våglängden</translation>
    </message>
    <message>
        <source>the wavelength %1 nm is not greater than that of the line before.</source>
        <translation>våglängden %1 nm är inte större än den på raden före.</translation>
    </message>
    <message>
        <source>their paint adds up to more than any canvas holds.</source>
        <translation>deras färg är tillsammans mer än vad någon duk rymmer.</translation>
    </message>
    <message>
        <source>there are %1 columns instead of %2.</source>
        <translation>det finns %1 kolumner i stället för %2.</translation>
    </message>
    <message>
        <source>there are %1 paints, but only %2 have room.</source>
        <translation>det finns %1 färger, men bara %2 får plats.</translation>
    </message>
    <message>
        <source>there are %1 ticks for %2 samples.</source>
        <translation>det finns %1 tick för %2 sampel.</translation>
    </message>
    <message>
        <source>there are %1 tools instead of %2.</source>
        <translation>det finns %1 verktyg i stället för %2.</translation>
    </message>
    <message>
        <source>there are more than %1 layers.</source>
        <translation>det finns fler än %1 lager.</translation>
    </message>
    <message>
        <source>there are more than %1 triangles.</source>
        <translation>det finns fler än %1 trianglar.</translation>
    </message>
    <message>
        <source>there are more than %1 vertices.</source>
        <translation>det finns fler än %1 hörnpunkter.</translation>
    </message>
    <message>
        <source>there cannot be a group %1.</source>
        <translation>det kan inte finnas någon grupp %1.</translation>
    </message>
    <message>
        <source>there cannot be a layer %1.</source>
        <translation>det kan inte finnas något lager %1.</translation>
    </message>
    <message>
        <source>there is another run &quot;%1&quot;.</source>
        <translation>det finns en annan körning ”%1”.</translation>
    </message>
    <message>
        <source>there is no brush in hand to take paint with.</source>
        <translation>det finns ingen pensel i handen att ta färg med.</translation>
    </message>
    <message>
        <source>there is no field %1.</source>
        <translation>det finns inget fält %1.</translation>
    </message>
    <message>
        <source>there is no form &quot;%1&quot;; the forms are slab, box, disc, cap, gaussian, cosine, noise and image.</source>
        <translation>det finns ingen form ”%1”; formerna är slab, box, disc, cap, gaussian, cosine, noise och image.</translation>
    </message>
    <message>
        <source>there is no group %1 of layers.</source>
        <translation>det finns ingen lagergrupp %1.</translation>
    </message>
    <message>
        <source>there is no group %1.</source>
        <translation>det finns ingen grupp %1.</translation>
    </message>
    <message>
        <source>there is no kind of frame %1.</source>
        <translation>det finns inget block av typ %1.</translation>
    </message>
    <message>
        <source>there is no layer %1.</source>
        <translation>det finns inget lager %1.</translation>
    </message>
    <message>
        <source>there is no layer below &quot;%1&quot; to merge it onto.</source>
        <translation>det finns inget lager under ”%1” att sammanfoga det med.</translation>
    </message>
    <message>
        <source>there is no medium in hand.</source>
        <translation>det finns inget medium i handen.</translation>
    </message>
    <message>
        <source>there is no place %1 for a layer; the highest is %2.</source>
        <translation>det finns ingen plats %1 för ett lager; den högsta är %2.</translation>
    </message>
    <message>
        <source>there is no such entry as &quot;%1&quot; here.</source>
        <translation>här finns ingen post ”%1”.</translation>
    </message>
    <message>
        <source>there is no such kind of tiles as &quot;%1&quot;.</source>
        <translation>det finns inga rutor av typen ”%1”.</translation>
    </message>
    <message>
        <source>there is no support &quot;%1&quot;; the supports are flat, %2, weave, image, ramp and bump.</source>
        <translation>det finns inget underlag ”%1”; underlagen är flat, %2, weave, image, ramp och bump.</translation>
    </message>
    <message>
        <source>there is no surface &quot;%1&quot;; a stroke is on the &quot;canvas&quot; or the &quot;well&quot;.</source>
        <translation>det finns ingen yta ”%1”; ett penseldrag är på ”canvas” eller ”well”.</translation>
    </message>
    <message>
        <source>there is no visible layer to flatten.</source>
        <translation>det finns inget synligt lager att sammanfoga.</translation>
    </message>
    <message>
        <source>there is no way &quot;%1&quot; to select; they are replace, add, subtract and intersect.</source>
        <translation>det finns inget sätt ”%1” att markera; sätten är replace, add, subtract och intersect.</translation>
    </message>
    <message>
        <source>this is no journal of a painting.</source>
        <translation>detta är ingen journal för en målning.</translation>
    </message>
    <message>
        <source>this is no list of layers; it would begin with &lt;image&gt;.</source>
        <translation>detta är ingen lista med lager; den skulle börja med &lt;image&gt;.</translation>
    </message>
    <message>
        <source>this is no painting of Pastoso; it would begin with &quot;format&quot;: &quot;pastoso-project&quot;.</source>
        <translation>detta är ingen målning från Pastoso; den skulle börja med &quot;format&quot;: &quot;pastoso-project&quot;.</translation>
    </message>
    <message>
        <source>this is not %1; it would begin with &quot;format&quot;: &quot;%2&quot;.</source>
        <translation>detta är inte %1, som skulle börja med &quot;format&quot;: &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>this is not a GIMP palette; it would begin with &quot;GIMP Palette&quot;.</source>
        <translation>detta är ingen GIMP-palett; en sådan börjar med ”GIMP Palette”.</translation>
    </message>
    <message>
        <source>this is not valid JSON: %1.</source>
        <translation>detta är inte giltig JSON: %1.</translation>
    </message>
    <message>
        <source>this is not valid XML (%1).</source>
        <translation>detta är inte giltig XML (%1).</translation>
    </message>
    <message>
        <source>this makes %1 cells; 1 to %2 are possible.</source>
        <translation>det blir %1 celler; 1 till %2 är möjligt.</translation>
    </message>
    <message>
        <source>this must be an object in braces.</source>
        <translation>detta måste vara ett objekt inom klammerparenteser.</translation>
    </message>
    <message>
        <source>this paint</source>
        <translation>den här färgen</translation>
    </message>
    <message>
        <source>this was written by a newer Pastoso (%1 %2; this program reads up to %3).</source>
        <translation>detta har skrivits av en nyare Pastoso (%1 %2; det här programmet läser upp till %3).</translation>
    </message>
    <message>
        <source>this was written by a newer Pastoso (journal format %1; this program reads up to %2).</source>
        <translation>detta har skrivits av en nyare Pastoso (journalformat %1; det här programmet läser upp till %2).</translation>
    </message>
    <message>
        <source>this was written by a newer Pastoso (project format %1; this program reads up to %2).</source>
        <translation>detta har skrivits av en nyare Pastoso (projektformat %1; det här programmet läser upp till %2).</translation>
    </message>
    <message>
        <source>tile %1 comes twice.</source>
        <translation>ruta %1 kommer två gånger.</translation>
    </message>
    <message>
        <source>tile %1 moves as no paint can.</source>
        <translation>ruta %1 rör sig som ingen färg kan.</translation>
    </message>
    <message>
        <source>tile %1 moves, but there is no &quot;window&quot; that it started from.</source>
        <translation>ruta %1 rör sig, men det finns inget ”window” som den började från.</translation>
    </message>
    <message>
        <source>tile %1 sleeps, and yet its motion is followed.</source>
        <translation>ruta %1 sover, men ändå följs dess rörelse.</translation>
    </message>
    <message>
        <source>tilt of the canvas</source>
        <translation>dukens lutning</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiden</translation>
    </message>
    <message>
        <source>time of the pen</source>
        <translation>pennans tid</translation>
    </message>
    <message>
        <source>touch_dry_s is %1, it must not be larger than typical_thickness_mm times %2.</source>
        <translation>touch_dry_s är %1, men får inte vara större än typical_thickness_mm gånger %2.</translation>
    </message>
    <message>
        <source>trace settings: a side of the picture is %1, but must be from 1 to 16384 pixels.</source>
        <translation>spårningens inställningar: en sida av bilden är %1, men måste vara från 1 till 16384 pixlar.</translation>
    </message>
    <message>
        <source>trace settings: brightest is %1, but must be above 0 and finite.</source>
        <translation>spårningens inställningar: brightest är %1, men måste vara över 0 och ändligt.</translation>
    </message>
    <message>
        <source>trace settings: most_events is %1, but must be at least 1.</source>
        <translation>spårningens inställningar: most_events är %1, men måste vara minst 1.</translation>
    </message>
    <message>
        <source>transform&apos;s centre</source>
        <translation>transformeringens mitt</translation>
    </message>
    <message>
        <source>transform&apos;s move</source>
        <translation>transformeringens förflyttning</translation>
    </message>
    <message>
        <source>transform&apos;s scale</source>
        <translation>transformeringens skala</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true eller false</translation>
    </message>
    <message>
        <source>turn of the ellipse</source>
        <translation>ellipsens vridning</translation>
    </message>
    <message>
        <source>turn of the transform</source>
        <translation>transformeringens vridning</translation>
    </message>
    <message>
        <source>variation of the share</source>
        <translation>andelens variation</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>version %1</translation>
    </message>
    <message>
        <source>versions %1 to %2</source>
        <translation>version %1 till %2</translation>
    </message>
    <message>
        <source>volume of the squeezed paint</source>
        <translation>den utklämda färgens volym</translation>
    </message>
    <message>
        <source>were painted with an earlier version of the program (arithmetic %1, now %2): replayed, they come out a little differently.</source>
        <translation>målades med en tidigare version av programmet (aritmetik %1, nu %2): när de spelas upp blir de lite annorlunda.</translation>
    </message>
    <message>
        <source>width</source>
        <translation>bredd</translation>
    </message>
    <message>
        <source>width of the brush</source>
        <translation>penselns bredd</translation>
    </message>
    <message>
        <source>width of the new canvas</source>
        <translation>den nya dukens bredd</translation>
    </message>
    <message>
        <source>width of the picture</source>
        <translation>bildens bredd</translation>
    </message>
    <message>
        <source>window radiance</source>
        <translation>fönstrets radians</translation>
    </message>
    <message>
        <source>window radius</source>
        <translation>fönstrets radie</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x of the %1</source>
        <translation>x för %1</translation>
    </message>
    <message>
        <source>x of the centre of the symmetry</source>
        <translation>x för symmetrins mitt</translation>
    </message>
    <message>
        <source>x of the fan</source>
        <translation>x för fläkten</translation>
    </message>
    <message>
        <source>x of the new canvas</source>
        <translation>x för den nya duken</translation>
    </message>
    <message>
        <source>x of the pen</source>
        <translation>x för pennan</translation>
    </message>
    <message>
        <source>x of the picture</source>
        <translation>x för bilden</translation>
    </message>
    <message>
        <source>x of the squeezed paint</source>
        <translation>x för den utklämda färgen</translation>
    </message>
    <message>
        <source>x tilt of the pen</source>
        <translation>pennans lutning i x-led</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>y of the %1</source>
        <translation>y för %1</translation>
    </message>
    <message>
        <source>y of the centre of the symmetry</source>
        <translation>y för symmetrins mitt</translation>
    </message>
    <message>
        <source>y of the fan</source>
        <translation>y för fläkten</translation>
    </message>
    <message>
        <source>y of the new canvas</source>
        <translation>y för den nya duken</translation>
    </message>
    <message>
        <source>y of the pen</source>
        <translation>y för pennan</translation>
    </message>
    <message>
        <source>y of the picture</source>
        <translation>y för bilden</translation>
    </message>
    <message>
        <source>y of the squeezed paint</source>
        <translation>y för den utklämda färgen</translation>
    </message>
    <message>
        <source>y tilt of the pen</source>
        <translation>pennans lutning i y-led</translation>
    </message>
    <message>
        <source>yellowing</source>
        <translation>gulning</translation>
    </message>
    <message>
        <source>your share of the disk is used up; make room on it, or choose another place</source>
        <translation>din del av disken är förbrukad; frigör utrymme på den, eller välj en annan plats</translation>
    </message>
    <message>
        <source>difference of the colour</source>
        <translation>färgens skillnad</translation>
    </message>
    <message>
        <source>gradient&apos;s point</source>
        <translation>övergångens punkt</translation>
    </message>
    <message>
        <source>length of the gradient&apos;s line</source>
        <translation>längden på övergångens linje</translation>
    </message>
    <message>
        <source>no paint has been copied that could be pasted.</source>
        <translation>ingen färg har kopierats som kan klistras in.</translation>
    </message>
    <message>
        <source>number of points of the gradient&apos;s line</source>
        <translation>antalet punkter på övergångens linje</translation>
    </message>
    <message>
        <source>number of quarter turns</source>
        <translation>antalet kvartsvarv</translation>
    </message>
    <message>
        <source>outline&apos;s point</source>
        <translation>konturens punkt</translation>
    </message>
    <message>
        <source>there is no visible layer to copy.</source>
        <translation>det finns inget synligt lager att kopiera.</translation>
    </message>
    <message>
        <source>thickness of the film</source>
        <translation>skiktets tjocklek</translation>
    </message>
    <message>
        <source>way from where it was copied</source>
        <translation>vägen från där det kopierades</translation>
    </message>
    <message>
        <source>width of the margin</source>
        <translation>kantens bredd</translation>
    </message>
    <message>
        <source>x of the colour&apos;s place</source>
        <translation>x för färgens plats</translation>
    </message>
    <message>
        <source>y of the colour&apos;s place</source>
        <translation>y för färgens plats</translation>
    </message>
    <message>
        <source>%1: is no bundle of tools; it has no %2.</source>
        <translation>%1: är ingen samling verktyg; den saknar %2.</translation>
    </message>
    <message>
        <source>name is &quot;%1&quot;, which another tool of the bundle has already.</source>
        <translation>name är ”%1”, som ett annat verktyg i samlingen redan heter.</translation>
    </message>
    <message>
        <source>there are %1 tools, more than %2.</source>
        <translation>det finns %1 verktyg, fler än %2.</translation>
    </message>
    <message>
        <source>copied paint</source>
        <translation>den kopierade färgen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there twice.</source>
        <translation>”%1” finns två gånger.</translation>
    </message>
    <message>
        <source>a mix needs a name.</source>
        <translation>en blandning behöver ett namn.</translation>
    </message>
    <message>
        <source>a sample has 4 to 8 numbers, time, x, y, pressure, tilt_x, tilt_y, rotation, wheel; here are %1.</source>
        <translation>ett prov har 4 till 8 tal, time, x, y, pressure, tilt_x, tilt_y, rotation, wheel; här är %1.</translation>
    </message>
    <message>
        <source>a set needs a name.</source>
        <translation>en uppsättning behöver ett namn.</translation>
    </message>
    <message>
        <source>change of the resolution</source>
        <translation>upplösningens ändring</translation>
    </message>
    <message>
        <source>scale of the height</source>
        <translation>höjdens skala</translation>
    </message>
    <message>
        <source>scale of the width</source>
        <translation>breddens skala</translation>
    </message>
    <message>
        <source>the panel %1 stands there twice.</source>
        <translation>panelen %1 står där två gånger.</translation>
    </message>
    <message>
        <source>there are %1 mixes, but only %2 have room.</source>
        <translation>det finns %1 blandningar, men bara %2 får plats.</translation>
    </message>
    <message>
        <source>there is no &quot;%1&quot;.</source>
        <translation>det finns ingen ”%1”.</translation>
    </message>
    <message>
        <source>there is no panel.</source>
        <translation>det finns ingen panel.</translation>
    </message>
    <message>
        <source>wheel of the pen</source>
        <translation>pennans hjul</translation>
    </message>
    <message>
        <source>a tag needs a name.</source>
        <translation>en etikett behöver ett namn.</translation>
    </message>
    <message>
        <source>corner that is distorted</source>
        <translation>det hörn som förvrängs</translation>
    </message>
    <message>
        <source>diameter of the grains</source>
        <translation>kornens diameter</translation>
    </message>
    <message>
        <source>direction of the grid&apos;s first lines</source>
        <translation>riktningen på rutnätets första linjer</translation>
    </message>
    <message>
        <source>direction of the grid&apos;s other lines</source>
        <translation>riktningen på rutnätets andra linjer</translation>
    </message>
    <message>
        <source>direction of the horizon</source>
        <translation>horisontens riktning</translation>
    </message>
    <message>
        <source>direction of the knife</source>
        <translation>knivens riktning</translation>
    </message>
    <message>
        <source>direction of uprights</source>
        <translation>lodlinjernas riktning</translation>
    </message>
    <message>
        <source>expected at most %1 references.</source>
        <translation>här ska det stå högst %1 referenser.</translation>
    </message>
    <message>
        <source>first vanishing point</source>
        <translation>första flyktpunkten</translation>
    </message>
    <message>
        <source>grid&apos;s point</source>
        <translation>rutnätets punkt</translation>
    </message>
    <message>
        <source>height of the texture</source>
        <translation>texturens höjd</translation>
    </message>
    <message>
        <source>holds cells of another canvas than this one.</source>
        <translation>innehåller celler från en annan duk än den här.</translation>
    </message>
    <message>
        <source>holds no cell.</source>
        <translation>innehåller ingen cell.</translation>
    </message>
    <message>
        <source>length of a side of the distortion, times what it was,</source>
        <translation>längden på en sida av förvrängningen, gånger vad den var,</translation>
    </message>
    <message>
        <source>lower left corner of the distortion</source>
        <translation>förvrängningens nedre vänstra hörn</translation>
    </message>
    <message>
        <source>lower right corner of the distortion</source>
        <translation>förvrängningens nedre högra hörn</translation>
    </message>
    <message>
        <source>makes the references larger than any board holds.</source>
        <translation>gör referenserna större än någon tavla rymmer.</translation>
    </message>
    <message>
        <source>masking&apos;s point</source>
        <translation>maskeringens punkt</translation>
    </message>
    <message>
        <source>name of a reference</source>
        <translation>namnet på en referens</translation>
    </message>
    <message>
        <source>number of the masking&apos;s points</source>
        <translation>antalet punkter i maskeringen</translation>
    </message>
    <message>
        <source>number of the reference</source>
        <translation>referensens nummer</translation>
    </message>
    <message>
        <source>number of vanishing points</source>
        <translation>antalet flyktpunkter</translation>
    </message>
    <message>
        <source>opacity of the reference</source>
        <translation>referensens opacitet</translation>
    </message>
    <message>
        <source>position of the reference</source>
        <translation>referensens plats</translation>
    </message>
    <message>
        <source>second vanishing point</source>
        <translation>andra flyktpunkten</translation>
    </message>
    <message>
        <source>seed of the texture</source>
        <translation>texturens frö</translation>
    </message>
    <message>
        <source>size of what is distorted</source>
        <translation>storleken på det som förvrängs</translation>
    </message>
    <message>
        <source>spacing of the grid&apos;s first lines</source>
        <translation>avståndet mellan rutnätets första linjer</translation>
    </message>
    <message>
        <source>spacing of the grid&apos;s other lines</source>
        <translation>avståndet mellan rutnätets andra linjer</translation>
    </message>
    <message>
        <source>spacing of the ridges</source>
        <translation>åsarnas avstånd</translation>
    </message>
    <message>
        <source>strength of the guide</source>
        <translation>hjälplinjens styrka</translation>
    </message>
    <message>
        <source>the board holds %1 references, and no more are kept.</source>
        <translation>tavlan har %1 referenser, och fler behålls inte.</translation>
    </message>
    <message>
        <source>the corners of the distortion have to go round an area that bends outwards at each of them, by %1 degree or more.</source>
        <translation>förvrängningens hörn måste gå runt en yta som böjer sig utåt i vart och ett av dem, med minst %1 grad.</translation>
    </message>
    <message>
        <source>the name of a reference has %1 bytes, but at most %2 are kept.</source>
        <translation>namnet på en referens har %1 byte, men högst %2 behålls.</translation>
    </message>
    <message>
        <source>the number %1 has not been given yet.</source>
        <translation>numret %1 har inte delats ut än.</translation>
    </message>
    <message>
        <source>the references on the board are too large; at most %1 million pixels in all are kept.</source>
        <translation>referenserna på tavlan är för stora; sammanlagt högst %1 miljoner pixlar behålls.</translation>
    </message>
    <message>
        <source>there are two references %1.</source>
        <translation>det finns två referenser %1.</translation>
    </message>
    <message>
        <source>these are no corners of that mask.</source>
        <translation>detta är inga hörn av den masken.</translation>
    </message>
    <message>
        <source>third vanishing point</source>
        <translation>tredje flyktpunkten</translation>
    </message>
    <message>
        <source>turn of the canvas</source>
        <translation>dukens vridning</translation>
    </message>
    <message>
        <source>turn of the reference</source>
        <translation>referensens vridning</translation>
    </message>
    <message>
        <source>upper left corner of the distortion</source>
        <translation>förvrängningens övre vänstra hörn</translation>
    </message>
    <message>
        <source>upper right corner of the distortion</source>
        <translation>förvrängningens övre högra hörn</translation>
    </message>
    <message>
        <source>width of the masking</source>
        <translation>maskeringens bredd</translation>
    </message>
    <message>
        <source>width of the reference</source>
        <translation>referensens bredd</translation>
    </message>
    <message>
        <source>x of the reference</source>
        <translation>referensens x</translation>
    </message>
    <message>
        <source>y of the reference</source>
        <translation>referensens y</translation>
    </message>
    <message>
        <source>a group of layers cannot be clipped; its layers can.</source>
        <translation>en grupp av lager kan inte begränsas till ett lager; det kan dess lager.</translation>
    </message>
    <message>
        <source>a map has 4 numbers; here are %1.</source>
        <translation>en avbildning har 4 tal; här är %1.</translation>
    </message>
    <message>
        <source>a stroke that goes on says nothing of where it began.</source>
        <translation>ett penseldrag som fortsätter säger inget om var det började.</translation>
    </message>
    <message>
        <source>holds a cell that is not masked.</source>
        <translation>innehåller en cell som inte är maskerad.</translation>
    </message>
    <message>
        <source>radius of the feather</source>
        <translation>radien för den mjuka kanten</translation>
    </message>
    <message>
        <source>share of the dry paint</source>
        <translation>andelen av den torra färgen</translation>
    </message>
    <message>
        <source>the medium in hand leaves next to nothing when it dries.</source>
        <translation>mediet i handen lämnar nästan ingenting när det torkar.</translation>
    </message>
    <message>
        <source>there is no dry paint on &quot;%1&quot; to adjust.</source>
        <translation>det finns ingen torr färg på ”%1” att justera.</translation>
    </message>
    <message>
        <source>thickness of the glaze</source>
        <translation>lasyrens tjocklek</translation>
    </message>
    <message>
        <source>width of the cloth&apos;s threads</source>
        <translation>bredd på dukens trådar</translation>
    </message>
    <message>
        <source>The cloth has been drawn out too unevenly: for a canvas of %1 x %2 cells, %3 x %4 would have to be woven.</source>
        <translation>Duken har dragits ut för ojämnt: för en målning på %1 x %2 rutor skulle %3 x %4 behöva vävas.</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; is clipped to &quot;%2&quot;, which is hidden.</source>
        <translation>lagret ”%1” är begränsat till ”%2”, som är dolt.</translation>
    </message>
    <message>
        <source>%1 bytes of paint follow, but there should be %2.</source>
        <translation>%1 byte färg följer, men det borde vara %2.</translation>
    </message>
    <message>
        <source>%1: is no paint that was copied in Pastoso.</source>
        <translation>%1: är ingen färg som har kopierats i Pastoso.</translation>
    </message>
    <message>
        <source>format of copied paint</source>
        <translation>format för kopierad färg</translation>
    </message>
    <message>
        <source>no canvas holds so much paint.</source>
        <translation>ingen duk rymmer så mycket färg.</translation>
    </message>
    <message>
        <source>no painting has cells of this size.</source>
        <translation>ingen målning har celler av den storleken.</translation>
    </message>
    <message>
        <source>paint that was copied in another painting has no strokes here, and comes no finer than it is.</source>
        <translation>färg som kopierats i en annan målning har inga penseldrag här och blir inte finare än den är.</translation>
    </message>
    <message>
        <source>the copied paint has cells of a size that no painting has.</source>
        <translation>den kopierade färgen har celler av en storlek som ingen målning har.</translation>
    </message>
    <message>
        <source>the copied paint is no base64.</source>
        <translation>den kopierade färgen är inte base64.</translation>
    </message>
    <message>
        <source>the paint of other paintings in this recording is too large; at most 16 GB are read.</source>
        <translation>färgen från andra målningar i den här inspelningen är för stor; högst 16 GB läses.</translation>
    </message>
    <message>
        <source>there are %1 puddles, but only %2 have room.</source>
        <translation>det finns %1 pölar, men bara %2 får plats.</translation>
    </message>
    <message>
        <source>there is more paint than is read, 4 GB.</source>
        <translation>det är mer färg än vad som läses, 4 GB.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not one of pastoso, krita and photoshop.</source>
        <translation>”%1” är varken pastoso, krita eller photoshop.</translation>
    </message>
    <message>
        <source>%1 would have %2 x %3 pixels; at most %4 a side are possible.</source>
        <translation>%1 skulle ha %2 x %3 pixlar; högst %4 per sida är möjligt.</translation>
    </message>
    <message>
        <source>The canvas is %1 x %2 pixels, more than this graphics driver can show.</source>
        <translation>Duken är %1 x %2 pixlar, mer än den här grafikdrivrutinen kan visa.</translation>
    </message>
</context>
<context>
    <name>ExamplePaintings</name>
    <message>
        <source>Still life</source>
        <translation>Stilleben</translation>
    </message>
    <message>
        <source>Oil, wet in wet</source>
        <translation>Olja, vått i vått</translation>
    </message>
    <message>
        <source>Surf</source>
        <translation>Bränningar</translation>
    </message>
    <message>
        <source>Oil, in thick impasto</source>
        <translation>Olja, i tjock impasto</translation>
    </message>
    <message>
        <source>Poppies</source>
        <translation>Vallmo</translation>
    </message>
    <message>
        <source>Oil over a dry ground</source>
        <translation>Olja på torr grund</translation>
    </message>
    <message>
        <source>Evening by a river</source>
        <translation>Kväll vid floden</translation>
    </message>
    <message>
        <source>Oil, from ground to glaze</source>
        <translation>Olja, från grund till lasyr</translation>
    </message>
</context>
<context>
    <name>FactList</name>
    <message>
        <source>Copy</source>
        <translation>Kopiera</translation>
    </message>
</context>
<context>
    <name>Findable</name>
    <message>
        <source>Take this tool in hand</source>
        <translation>Ta det här verktyget i handen</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Färg</translation>
    </message>
    <message>
        <source>Choose this paint</source>
        <translation>Välj den här färgen</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Medium</translation>
    </message>
    <message>
        <source>Your mix</source>
        <translation>Din blandning</translation>
    </message>
</context>
<context>
    <name>FindableControls</name>
    <message>
        <source>Harmony</source>
        <translation>Harmoni</translation>
    </message>
    <message>
        <source>Marks for hues that go together, on the colour wheel</source>
        <translation>Märken för kulörer som går ihop, på färghjulet</translation>
    </message>
    <message>
        <source>complementary, analogous, triad, tetrad, colour scheme, color scheme</source>
        <translation>komplementfärger, analoga, triad, färgschema</translation>
    </message>
    <message>
        <source>Gamut mask</source>
        <translation>Färgmask</translation>
    </message>
    <message>
        <source>A shape on the colour wheel to choose within</source>
        <translation>En form på färghjulet att välja inom</translation>
    </message>
    <message>
        <source>limited palette, color mask</source>
        <translation>begränsad palett, gamutmask</translation>
    </message>
    <message>
        <source>Keep on your palette</source>
        <translation>Behåll på din palett</translation>
    </message>
    <message>
        <source>Lay the paint in hand out on your palette</source>
        <translation>Lägg ut färgen i handen på din palett</translation>
    </message>
    <message>
        <source>swatch, add colour, add color</source>
        <translation>färgprov, lägg till färg</translation>
    </message>
    <message>
        <source>Save the palette</source>
        <translation>Spara paletten</translation>
    </message>
    <message>
        <source>The colours of your palette for GIMP, Krita or Inkscape, as a .gpl file</source>
        <translation>Färgerna på din palett för GIMP, Krita eller Inkscape, som en .gpl-fil</translation>
    </message>
    <message>
        <source>gpl, swatches, export palette</source>
        <translation>gpl, färgprover, exportera palett</translation>
    </message>
    <message>
        <source>Open a palette</source>
        <translation>Öppna en palett</translation>
    </message>
    <message>
        <source>Colours of GIMP, Krita or Inkscape, from a .gpl file</source>
        <translation>Färger från GIMP, Krita eller Inkscape, ur en .gpl-fil</translation>
    </message>
    <message>
        <source>gpl, swatches, import palette</source>
        <translation>gpl, färgprover, importera palett</translation>
    </message>
    <message>
        <source>Palette from a picture</source>
        <translation>Palett från en bild</translation>
    </message>
    <message>
        <source>Finds the colours that a picture is made of</source>
        <translation>Hittar färgerna som en bild består av</translation>
    </message>
    <message>
        <source>extract, palette from image</source>
        <translation>plocka ut färger, palett ur bild</translation>
    </message>
    <message>
        <source>Keep as a mix</source>
        <translation>Behåll som blandning</translation>
    </message>
    <message>
        <source>Keep the paint in hand as a recipe of tubes, under a name of your own</source>
        <translation>Behåll färgen i handen som ett recept av tuber, under ett eget namn</translation>
    </message>
    <message>
        <source>recipe, save colour, save color</source>
        <translation>recept, spara färg</translation>
    </message>
    <message>
        <source>Sets of tubes</source>
        <translation>Uppsättningar av tuber</translation>
    </message>
    <message>
        <source>Which tubes are shown: all of them, or a set of yours</source>
        <translation>Vilka tuber som visas: alla, eller en egen uppsättning</translation>
    </message>
    <message>
        <source>tube sets, palette of tubes</source>
        <translation>tubuppsättningar, urval</translation>
    </message>
    <message>
        <source>Tags of tools</source>
        <translation>Verktygens etiketter</translation>
    </message>
    <message>
        <source>Which tools are listed: a family, favourites or a tag</source>
        <translation>Vilka verktyg som visas: en familj, favoriter eller en etikett</translation>
    </message>
    <message>
        <source>tagged, collections, brush sets</source>
        <translation>taggar, samlingar, penseluppsättningar</translation>
    </message>
    <message>
        <source>Snapping strength</source>
        <translation>Fäststyrka</translation>
    </message>
    <message>
        <source>How far the guide draws the brush from where your hand is</source>
        <translation>Hur långt hjälplinjen drar penseln från där din hand är</translation>
    </message>
    <message>
        <source>magnetic, assistant strength</source>
        <translation>magnetisk, assistentens styrka</translation>
    </message>
    <message>
        <source>Squeeze out the last painting&apos;s palette</source>
        <translation>Kläm ut den förra målningens palett</translation>
    </message>
    <message>
        <source>The paints and mixtures of the earlier well, onto the mixing well</source>
        <translation>Färgerna och blandningarna från förra gången, ut på blandningsytan</translation>
    </message>
    <message>
        <source>restore palette, palette of before</source>
        <translation>återställ palett, tidigare palett</translation>
    </message>
    <message>
        <source>New tag for the tool in hand</source>
        <translation>Ny etikett för verktyget i handen</translation>
    </message>
    <message>
        <source>A word of your own under which the tool is listed</source>
        <translation>Ett eget ord som verktyget visas under</translation>
    </message>
    <message>
        <source>add tag, label</source>
        <translation>lägg till etikett, tagg</translation>
    </message>
</context>
<context>
    <name>FolderFacts</name>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Inställningar</translation>
    </message>
    <message>
        <source>Your tools, paints and lamps</source>
        <translation>Egna verktyg, färger och lampor</translation>
    </message>
    <message>
        <source>Paintings that are not saved</source>
        <translation>Målningar som inte är sparade</translation>
    </message>
    <message>
        <source>What the program brings along</source>
        <translation>Det som följer med programmet</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Like Krita</source>
        <translation>Som i Krita</translation>
    </message>
    <message>
        <source>The keys of Krita, where it has the same command</source>
        <translation>Kritas kortkommandon, där Krita har samma kommando</translation>
    </message>
    <message>
        <source>Like Photoshop</source>
        <translation>Som i Photoshop</translation>
    </message>
    <message>
        <source>The keys of Photoshop, where it has the same command</source>
        <translation>Photoshops kortkommandon, där Photoshop har samma kommando</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>Krita&apos;s keys, but for short ones of what only wet paint has</source>
        <translation>Kritas kortkommandon, men korta för det som bara våt färg har</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Drops and sprays</source>
        <translation>Droppar och sprej</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Knives and combs</source>
        <translation>Knivar och kammar</translation>
    </message>
    <message>
        <source>Rags and fingers</source>
        <translation>Trasor och fingrar</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>Penslar</translation>
    </message>
    <message>
        <source>Cannot be read</source>
        <translation>Kan inte läsas</translation>
    </message>
    <message>
        <source>Clear medium</source>
        <translation>Klart medium</translation>
    </message>
    <message>
        <source>How the next paint flows; what lies on the canvas keeps its own way</source>
        <translation>Hur nästa färg flyter; det som redan ligger på duken beter sig som förut</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Verktyg</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Ångra</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Gör om</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Ladda om</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>Rengör</translation>
    </message>
    <message>
        <source>Medium </source>
        <translation>Medium </translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Mixing well</source>
        <translation>Blandningsyta</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Spara</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Byt namn</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Kläm ut</translation>
    </message>
    <message>
        <source>Wipe the well</source>
        <translation>Torka av blandningsytan</translation>
    </message>
    <message>
        <source>the same to the eye</source>
        <translation>ser likadan ut</translation>
    </message>
    <message>
        <source>close</source>
        <translation>nära</translation>
    </message>
    <message>
        <source>a little off</source>
        <translation>lite vid sidan av</translation>
    </message>
    <message>
        <source>beyond these tubes</source>
        <translation>utom räckhåll för de här tuberna</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Tryck</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Lutning</translation>
    </message>
    <message>
        <source>Barrel</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Hastighet</translation>
    </message>
    <message>
        <source>how far it is pressed</source>
        <translation>hur hårt det trycks ned</translation>
    </message>
    <message>
        <source>how far it leans</source>
        <translation>hur mycket det lutar</translation>
    </message>
    <message>
        <source>how it is turned</source>
        <translation>hur det är vridet</translation>
    </message>
    <message>
        <source>reach into hollows</source>
        <translation>hur djupt det når i fördjupningar</translation>
    </message>
    <message>
        <source>film that it leaves</source>
        <translation>skiktet det lämnar</translation>
    </message>
    <message>
        <source>paint taken up</source>
        <translation>färg som tas upp</translation>
    </message>
    <message>
        <source>flow</source>
        <translation>flöde</translation>
    </message>
    <message>
        <source>width of the spread</source>
        <translation>spridningens bredd</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 % pressure</source>
        <translation>%1 % tryck</translation>
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
        <translation>våt, inaktiv</translation>
    </message>
    <message>
        <source>A group: its eye, its lock and its opacity hold for all of its layers</source>
        <translation>En grupp: dess öga, lås och opacitet gäller alla lager i den</translation>
    </message>
    <message>
        <source>You paint on this layer; its wet paint flows and dries</source>
        <translation>Du målar på det här lagret; dess våta färg flyter och torkar</translation>
    </message>
    <message>
        <source>Its wet paint keeps still: it neither flows nor dries, and stays as wet as it is until you choose this layer</source>
        <translation>Den våta färgen sover: den varken flyter eller torkar, och förblir lika våt tills du väljer lagret</translation>
    </message>
    <message>
        <source>Click to paint on this layer; a double click names it, dragging moves it</source>
        <translation>Klicka för att måla på lagret; dubbelklicka för att namnge det, dra för att flytta det</translation>
    </message>
    <message>
        <source>Seen; click to hide it. Its relief goes with it</source>
        <translation>Syns; klicka för att dölja. Reliefen försvinner också</translation>
    </message>
    <message>
        <source>Hidden, and not painted on; click to show it</source>
        <translation>Dolt, och kan inte målas på; klicka för att visa det</translation>
    </message>
    <message>
        <source>Locked: nothing is painted on it, cleared or merged. Click to unlock</source>
        <translation>Låst: det kan inte målas på, tömmas eller sammanfogas. Klicka för att låsa upp</translation>
    </message>
    <message>
        <source>Click to lock it against painting, clearing and merging</source>
        <translation>Klicka för att låsa det mot målning, tömning och sammanfogning</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>spets</translation>
    </message>
    <message>
        <source>left</source>
        <translation>vänster</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>nedre</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>mitten</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>övre</translation>
    </message>
    <message>
        <source>right</source>
        <translation>höger</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>not told</source>
        <comment>rotation</comment>
        <translation>okänd</translation>
    </message>
    <message>
        <source>Tilt %1 across, %2 along; rotation %3; buttons: %4</source>
        <translation>Lutning %1 i sidled, %2 i höjdled; rotation %3; knappar: %4</translation>
    </message>
    <message>
        <source>%1, eraser end</source>
        <translation>%1, suddänden</translation>
    </message>
    <message>
        <source>%1, puck</source>
        <translation>%1, puck</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Mus</translation>
    </message>
    <message>
        <source>pressure %1 → %2</source>
        <translation>tryck %1 → %2</translation>
    </message>
    <message>
        <source>pressure %1</source>
        <translation>tryck %1</translation>
    </message>
    <message>
        <source>%1: %2, %3 events a second</source>
        <translation>%1: %2, %3 händelser per sekund</translation>
    </message>
    <message>
        <source>Buttons: %1</source>
        <translation>Knappar: %1</translation>
    </message>
    <message>
        <source>clear medium</source>
        <translation>klart medium</translation>
    </message>
    <message>
        <source>thinned to %1</source>
        <translation>förtunnad till %1</translation>
    </message>
    <message>
        <source>Dry now</source>
        <translation>Torka nu</translation>
    </message>
    <message>
        <source>How fast time passes for the paint: 10 × is ten seconds in one. While you draw a stroke it passes as usual</source>
        <translation>Hur fort tiden går för färgen: 10 × är tio sekunder på en. Medan du drar ett penseldrag går den som vanligt</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>transparent</translation>
    </message>
    <message>
        <source>semi-transparent</source>
        <translation>halvtransparent</translation>
    </message>
    <message>
        <source>semi-opaque</source>
        <translation>halvtäckande</translation>
    </message>
    <message>
        <source>opaque</source>
        <translation>täckande</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>ride on wet paint</source>
        <translation>glidning på våt färg</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>Lavering</translation>
    </message>
    <message>
        <source>paste</source>
        <translation>pasta</translation>
    </message>
    <message>
        <source>cream</source>
        <translation>grädde</translation>
    </message>
    <message>
        <source>milk</source>
        <translation>mjölk</translation>
    </message>
    <message>
        <source>wash</source>
        <translation>lavering</translation>
    </message>
    <message>
        <source>stain</source>
        <translation>bets</translation>
    </message>
    <message>
        <source>Each stroke</source>
        <translation>Varje drag</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Vrids</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbok</translation>
    </message>
    <message>
        <source>What is new</source>
        <translation>Nyheter</translation>
    </message>
    <message>
        <source>About Pastoso</source>
        <translation>Om Pastoso</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Redigera</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favorit</translation>
    </message>
    <message>
        <source>The brush is not over it</source>
        <translation>Penseln är inte över den</translation>
    </message>
    <message>
        <source>Brush at %1, %2 mm</source>
        <translation>Pensel vid %1, %2 mm</translation>
    </message>
    <message>
        <source>Kind of paint</source>
        <translation>Slags färg</translation>
    </message>
    <message>
        <source>Charcoal and pastels</source>
        <translation>Kol och pasteller</translation>
    </message>
    <message>
        <source>Pens</source>
        <translation>Pennor</translation>
    </message>
    <message>
        <source>Sponges and rollers</source>
        <translation>Svampar och rollrar</translation>
    </message>
    <message>
        <source>Direction of the stroke</source>
        <translation>Dragets riktning</translation>
    </message>
    <message>
        <source>Distance travelled</source>
        <translation>Tillryggalagd väg</translation>
    </message>
    <message>
        <source>Time since the touch</source>
        <translation>Tid sedan beröringen</translation>
    </message>
    <message>
        <source>Distance in brush widths</source>
        <translation>Väg i penselbredder</translation>
    </message>
    <message>
        <source>Chance, each stroke</source>
        <translation>Slump, varje drag</translation>
    </message>
    <message>
        <source>Chance along the stroke</source>
        <translation>Slump längs draget</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Hjul</translation>
    </message>
    <message>
        <source>Paint left on the tool</source>
        <translation>Färg kvar på verktyget</translation>
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
        <translation>%1 bredder</translation>
    </message>
    <message>
        <source>What is bare is locked: tools change only what has paint. Click to unlock</source>
        <translation>Det som är bart är låst: verktygen ändrar bara det som har färg. Klicka för att låsa upp</translation>
    </message>
    <message>
        <source>Click to lock what is bare: tools change only what has paint</source>
        <translation>Klicka för att låsa det som är bart: verktygen ändrar bara det som har färg</translation>
    </message>
    <message>
        <source>Clipped to the layer below: of its paint, only what lies over paint of that layer shows. The rest is hidden, and kept</source>
        <translation>Begränsat till lagret under: av dess färg syns bara det som ligger över det lagrets färg. Resten är dold och finns kvar</translation>
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
        <translation>Spara</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öppna</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ja</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Nej</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Kasta</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hjälp</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Verkställ</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Återställ</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Återställ standardvärden</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Försök igen</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorera</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>Avbryt</translation>
    </message>
</context>
<context>
    <name>SelectionMargins</name>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
</context>
<context>
    <name>TourCommands</name>
    <message>
        <source>Paint</source>
        <translation>Måla</translation>
    </message>
    <message>
        <source>Press on the canvas and drag: the brush lays wet paint, and drags along what is wet already. A pen that presses harder bends the hairs further.</source>
        <translation>Tryck på duken och dra: penseln lägger våt färg och drar med sig det som redan är vått. En penna som trycker hårdare böjer håren mer.</translation>
    </message>
    <message>
        <source>Move the canvas, and pick paint from it</source>
        <translation>Flytta duken, och ta färg från den</translation>
    </message>
    <message>
        <source>Hold Space and drag to move the canvas; the wheel goes nearer. Ctrl and a click put the paint under the pointer on your brush.</source>
        <translation>Håll ned mellanslag och dra för att flytta duken; hjulet går närmare. Ctrl och ett klick tar färgen under pekaren på penseln.</translation>
    </message>
    <message>
        <source>Take another paint, and take a stroke back</source>
        <translation>Ta en annan färg, och ångra ett penseldrag</translation>
    </message>
    <message>
        <source>Choose a paint here. %1 loads the brush anew, %2 takes the last stroke back.</source>
        <translation>Välj en färg här. %1 laddar penseln på nytt, %2 tar tillbaka det senaste penseldraget.</translation>
    </message>
</context>
<context>
    <name>pastoso::appearance</name>
    <message>
        <source>Air blower 40</source>
        <translation>Luftblåsare 40</translation>
    </message>
    <message>
        <source>Airbrush 7</source>
        <translation>Airbrush 7</translation>
    </message>
    <message>
        <source>Blender 28</source>
        <translation>Fördrivare 28</translation>
    </message>
    <message>
        <source>Blotting pad 40</source>
        <translation>Läskdyna 40</translation>
    </message>
    <message>
        <source>Bright 12</source>
        <translation>Kort flatpensel 12</translation>
    </message>
    <message>
        <source>Comb 25</source>
        <translation>Kam 25</translation>
    </message>
    <message>
        <source>Cotton bud 6</source>
        <translation>Bomullspinne 6</translation>
    </message>
    <message>
        <source>Detail round 3</source>
        <translation>Fin rund 3</translation>
    </message>
    <message>
        <source>Diamond knife 9</source>
        <translation>Rombisk målarkniv 9</translation>
    </message>
    <message>
        <source>Dropper</source>
        <translation>Pipett</translation>
    </message>
    <message>
        <source>Dry scumbler 22</source>
        <translation>Torrpensel 22</translation>
    </message>
    <message>
        <source>Eraser 15</source>
        <translation>Suddgummi 15</translation>
    </message>
    <message>
        <source>Fan 26</source>
        <translation>Solfjäder 26</translation>
    </message>
    <message>
        <source>Filbert 14</source>
        <translation>Filbert 14</translation>
    </message>
    <message>
        <source>Fine comb 18</source>
        <translation>Fin kam 18</translation>
    </message>
    <message>
        <source>Fingertip 12</source>
        <translation>Fingertopp 12</translation>
    </message>
    <message>
        <source>Flat bristle 20</source>
        <translation>Flatborst 20</translation>
    </message>
    <message>
        <source>Impasto flat 18</source>
        <translation>Impastopensel 18</translation>
    </message>
    <message>
        <source>Large filbert 26</source>
        <translation>Stor filbert 26</translation>
    </message>
    <message>
        <source>Large flat 40</source>
        <translation>Stor flatpensel 40</translation>
    </message>
    <message>
        <source>Lifting knife 14</source>
        <translation>Lyftkniv 14</translation>
    </message>
    <message>
        <source>Mop 30</source>
        <translation>Mopp 30</translation>
    </message>
    <message>
        <source>Palette knife 17</source>
        <translation>Palettkniv 17</translation>
    </message>
    <message>
        <source>Pouring bottle</source>
        <translation>Hällflaska</translation>
    </message>
    <message>
        <source>Rag 35</source>
        <translation>Trasa 35</translation>
    </message>
    <message>
        <source>Rigger 2</source>
        <translation>Släpare 2</translation>
    </message>
    <message>
        <source>Round bristle 12</source>
        <translation>Rundborst 12</translation>
    </message>
    <message>
        <source>Round sable 9</source>
        <translation>Rund mård 9</translation>
    </message>
    <message>
        <source>Scraper 30</source>
        <translation>Skrapa 30</translation>
    </message>
    <message>
        <source>Soft glazing flat 16</source>
        <translation>Mjuk lasyrpensel 16</translation>
    </message>
    <message>
        <source>Spatter 45</source>
        <translation>Stänk 45</translation>
    </message>
    <message>
        <source>Spray can 35</source>
        <translation>Sprejburk 35</translation>
    </message>
    <message>
        <source>Spreading knife 40</source>
        <translation>Bredspackel 40</translation>
    </message>
    <message>
        <source>Stippler 15</source>
        <translation>Stöppelpensel 15</translation>
    </message>
    <message>
        <source>Straw 8</source>
        <translation>Sugrör 8</translation>
    </message>
    <message>
        <source>Thinner brush 16</source>
        <translation>Förtunningspensel 16</translation>
    </message>
    <message>
        <source>Titanium white</source>
        <translation>Titanvitt</translation>
    </message>
    <message>
        <source>Zinc white</source>
        <translation>Zinkvitt</translation>
    </message>
    <message>
        <source>Cadmium yellow</source>
        <translation>Kadmiumgult</translation>
    </message>
    <message>
        <source>Hansa yellow medium</source>
        <translation>Hansagult, mellan</translation>
    </message>
    <message>
        <source>Diarylide (Indian) yellow</source>
        <translation>Diarylidgult (indiskt gult)</translation>
    </message>
    <message>
        <source>Yellow ochre</source>
        <translation>Gul ockra</translation>
    </message>
    <message>
        <source>Cadmium orange</source>
        <translation>Kadmiumorange</translation>
    </message>
    <message>
        <source>Pyrrole orange</source>
        <translation>Pyrrolorange</translation>
    </message>
    <message>
        <source>Cadmium red light</source>
        <translation>Kadmiumrött, ljust</translation>
    </message>
    <message>
        <source>Pyrrole red</source>
        <translation>Pyrrolrött</translation>
    </message>
    <message>
        <source>Red oxide (Venetian red)</source>
        <translation>Järnoxidrött (venetianskt rött)</translation>
    </message>
    <message>
        <source>Alizarin crimson</source>
        <translation>Alizarinkarmosin</translation>
    </message>
    <message>
        <source>Quinacridone rose</source>
        <translation>Kinakridonrosa</translation>
    </message>
    <message>
        <source>Quinacridone magenta</source>
        <translation>Kinakridonmagenta</translation>
    </message>
    <message>
        <source>Dioxazine violet</source>
        <translation>Dioxazinviolett</translation>
    </message>
    <message>
        <source>Ultramarine blue</source>
        <translation>Ultramarinblått</translation>
    </message>
    <message>
        <source>Cobalt blue</source>
        <translation>Koboltblått</translation>
    </message>
    <message>
        <source>Cerulean blue</source>
        <translation>Coelinblått</translation>
    </message>
    <message>
        <source>Phthalo blue GS</source>
        <translation>Ftaloblått GS</translation>
    </message>
    <message>
        <source>Prussian blue</source>
        <translation>Preussiskt blått</translation>
    </message>
    <message>
        <source>Phthalo green BS</source>
        <translation>Ftalogrönt BS</translation>
    </message>
    <message>
        <source>Phthalo green YS</source>
        <translation>Ftalogrönt YS</translation>
    </message>
    <message>
        <source>Viridian</source>
        <translation>Viridian</translation>
    </message>
    <message>
        <source>Chromium oxide green</source>
        <translation>Kromoxidgrönt</translation>
    </message>
    <message>
        <source>Burnt sienna</source>
        <translation>Bränd sienna</translation>
    </message>
    <message>
        <source>Raw umber</source>
        <translation>Obränd umbra</translation>
    </message>
    <message>
        <source>Burnt umber</source>
        <translation>Bränd umbra</translation>
    </message>
    <message>
        <source>Ivory (bone) black</source>
        <translation>Elfenbenssvart (bensvart)</translation>
    </message>
    <message>
        <source>Carbon black</source>
        <translation>Kolsvart</translation>
    </message>
    <message>
        <source>heavy-body oil</source>
        <translation>tjock oljefärg</translation>
    </message>
    <message>
        <source>Stiff, buttery oil straight from the tube: every bristle mark and every peak stays where you put it.</source>
        <translation>Styv, smörig oljefärg direkt ur tuben: varje borstspår och varje topp stannar där du lägger dem.</translation>
    </message>
    <message>
        <source>soft-body acrylic</source>
        <translation>mjuk akrylfärg</translation>
    </message>
    <message>
        <source>Creamy paint that keeps soft brush marks, and slumps slowly where you lay it on thick.</source>
        <translation>Krämig färg som behåller mjuka penselspår och långsamt sjunker ihop där du lägger på tjockt.</translation>
    </message>
    <message>
        <source>fluid acrylic</source>
        <translation>flytande akrylfärg</translation>
    </message>
    <message>
        <source>Pours like cream: brush marks level out, and thick passages sag and run on a tilted canvas.</source>
        <translation>Rinner som grädde: penselspår jämnas ut, och tjocka partier sjunker och rinner på en lutad duk.</translation>
    </message>
    <message>
        <source>house paint</source>
        <translation>lackfärg</translation>
    </message>
    <message>
        <source>Glossy enamel from the tin: it levels at once, drips freely and leaves long rounded tears.</source>
        <translation>Blank emaljfärg ur burken: den flyter genast ut, droppar fritt och lämnar långa rundade rinnor.</translation>
    </message>
    <message>
        <source>ink glaze</source>
        <translation>bläcklasyr</translation>
    </message>
    <message>
        <source>Thin as ink: a transparent film that settles into the weave and runs wherever the canvas leans.</source>
        <translation>Tunn som bläck: en genomskinlig hinna som sjunker in i väven och rinner dit duken lutar.</translation>
    </message>
    <message>
        <source>thinner</source>
        <translation>förtunning</translation>
    </message>
    <message>
        <source>Clear thinner: loosens wet paint that it meets, lifts dried ink, and leaves nothing behind.</source>
        <translation>Klar förtunning: löser upp våt färg som den möter, lyfter torkat bläck och lämnar inget efter sig.</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Färg</translation>
    </message>
    <message>
        <source>Oils</source>
        <translation>Oljefärger</translation>
    </message>
    <message>
        <source>Acrylics and others</source>
        <translation>Akryl och annat</translation>
    </message>
    <message>
        <source>wax paste</source>
        <translation>vaxpasta</translation>
    </message>
    <message>
        <source>Oil with cold wax, short and dull: it breaks off sharply at the edge and keeps every cut of the knife.</source>
        <translation>Olja med kallvax, kort och matt: den bryter tvärt i kanten och behåller varje snitt av kniven.</translation>
    </message>
    <message>
        <source>alkyd gel</source>
        <translation>alkydgel</translation>
    </message>
    <message>
        <source>A clear gel with a little paint: transparent, stands as the brush left it, and dries overnight.</source>
        <translation>En klar gel med lite färg: genomskinlig, står som penseln lämnade den och torkar över natten.</translation>
    </message>
    <message>
        <source>linseed oil</source>
        <translation>linolja</translation>
    </message>
    <message>
        <source>Paint let down with linseed oil, long and buttery: brush marks soften, and thick passages sag slowly.</source>
        <translation>Färg utdrygad med linolja, lång och smörig: penselspår mjuknar och tjocka partier sjunker sakta.</translation>
    </message>
    <message>
        <source>stand oil</source>
        <translation>standolja</translation>
    </message>
    <message>
        <source>Paint in thickened oil, smooth as enamel: brush marks flow out, and it runs in slow, round tears.</source>
        <translation>Färg i förtjockad olja, slät som emalj: penselspår flyter ut, och den rinner i långsamma, runda tårar.</translation>
    </message>
    <message>
        <source>thin oil</source>
        <translation>tunn olja</translation>
    </message>
    <message>
        <source>Oil thinned with turpentine for the first lay-in: streaky, it settles into the weave and runs when tilted.</source>
        <translation>Olja förtunnad med terpentin för den första anläggningen: strimmig, sjunker ner i väven och rinner när duken lutas.</translation>
    </message>
    <message>
        <source>Width of the tip.</source>
        <translation>Spetsens bredd.</translation>
    </message>
    <message>
        <source>Thickness of the tip; a round one is as thick as it is wide.</source>
        <translation>Spetsens tjocklek; en rund är lika tjock som bred.</translation>
    </message>
    <message>
        <source>Length of the free hairs.</source>
        <translation>De fria hårens längd.</translation>
    </message>
    <message>
        <source>How much shorter the outermost hairs are; at most the length.</source>
        <translation>Hur mycket kortare de yttersta håren är; högst längden.</translation>
    </message>
    <message>
        <source>Elements that the tip is made of.</source>
        <translation>Delar som spetsen består av.</translation>
    </message>
    <message>
        <source>Fine streaks within one element.</source>
        <translation>Fina strimmor inom en del.</translation>
    </message>
    <message>
        <source>Makes one piece differ from the next.</source>
        <translation>Gör att ett exemplar skiljer sig från nästa.</translation>
    </message>
    <message>
        <source>How far a bent hair trails behind the hand.</source>
        <translation>Hur långt ett böjt hår släpar efter handen.</translation>
    </message>
    <message>
        <source>How far the hairs spread at full pressure.</source>
        <translation>Hur långt håren sprider sig vid fullt tryck.</translation>
    </message>
    <message>
        <source>How long the hairs trail after a turn.</source>
        <translation>Hur länge håren släpar efter en sväng.</translation>
    </message>
    <message>
        <source>Way of the ferrule at full pressure, in hair lengths.</source>
        <translation>Skoningens väg vid fullt tryck, i hårlängder.</translation>
    </message>
    <message>
        <source>How much a lean lowers one side.</source>
        <translation>Hur mycket en lutning sänker ena sidan.</translation>
    </message>
    <message>
        <source>How steeply hairs follow the weave down: little gives dry brush.</source>
        <translation>Hur brant håren följer väven ned: lite ger torrpensel.</translation>
    </message>
    <message>
        <source>0: every hair for itself, 1: one stiff edge.</source>
        <translation>0: varje hår för sig, 1: en enda styv kant.</translation>
    </message>
    <message>
        <source>How far wet paint carries it in a light hand, off the ground.</source>
        <translation>Hur långt våt färg bär det vid lätt hand, över underlaget.</translation>
    </message>
    <message>
        <source>Wet film that a full brush leaves.</source>
        <translation>Vått skikt som en full pensel lämnar.</translation>
    </message>
    <message>
        <source>Stroke that a full load lasts.</source>
        <translation>Penseldrag som en full laddning räcker till.</translation>
    </message>
    <message>
        <source>Ridges between bristles, in films.</source>
        <translation>Åsar mellan borsten, i skikt.</translation>
    </message>
    <message>
        <source>Streaks of single hairs, in films.</source>
        <translation>Strimmor av enstaka hår, i skikt.</translation>
    </message>
    <message>
        <source>Difference from bristle to bristle.</source>
        <translation>Skillnad från borst till borst.</translation>
    </message>
    <message>
        <source>How far each dip gathers the hairs anew; 0: never.</source>
        <translation>Hur mycket varje doppning samlar håren på nytt; 0: aldrig.</translation>
    </message>
    <message>
        <source>Extra film along the edges, in films.</source>
        <translation>Extra skikt längs kanterna, i skikt.</translation>
    </message>
    <message>
        <source>Extra film where the stroke starts.</source>
        <translation>Extra skikt där penseldraget börjar.</translation>
    </message>
    <message>
        <source>Share of the load that stays on lifting.</source>
        <translation>Andel av laddningen som stannar kvar när den lyfts.</translation>
    </message>
    <message>
        <source>Depth that hanging paint bridges, in films.</source>
        <translation>Djup som hängande färg överbryggar, i skikt.</translation>
    </message>
    <message>
        <source>Share of the paint in the way that is taken up.</source>
        <translation>Andel av färgen i vägen som tas upp.</translation>
    </message>
    <message>
        <source>How fast it mixes with the paint below.</source>
        <translation>Hur snabbt det blandas med färgen under.</translation>
    </message>
    <message>
        <source>Exchange between neighbouring hairs.</source>
        <translation>Utbyte mellan intilliggande hår.</translation>
    </message>
    <message>
        <source>How far a fast stroke drags paint along and ploughs it aside.</source>
        <translation>Hur mycket ett snabbt drag släpar med färg och plöjer den åt sidan.</translation>
    </message>
    <message>
        <source>Fill above which paint is pushed out sideways.</source>
        <translation>Fyllnad över vilken färg trycks ut åt sidorna.</translation>
    </message>
    <message>
        <source>Step, in radii of an element.</source>
        <translation>Steg, i en dels radier.</translation>
    </message>
    <message>
        <source>Least step.</source>
        <translation>Minsta steg.</translation>
    </message>
    <message>
        <source>Time over which the hand is steadied.</source>
        <translation>Tid över vilken handen stabiliseras.</translation>
    </message>
    <message>
        <source>Length of the string that pulls the tip.</source>
        <translation>Längden på snöret som drar spetsen.</translation>
    </message>
    <message>
        <source>Mean volume of a drop.</source>
        <translation>En droppes medelvolym.</translation>
    </message>
    <message>
        <source>How much drops differ.</source>
        <translation>Hur mycket dropparna skiljer sig.</translation>
    </message>
    <message>
        <source>Paint let go while the pen is down.</source>
        <translation>Färg som släpps medan pennan är nere.</translation>
    </message>
    <message>
        <source>A drop let go when the pen comes down.</source>
        <translation>En droppe som släpps när pennan sätts ned.</translation>
    </message>
    <message>
        <source>What the bottle holds.</source>
        <translation>Vad flaskan rymmer.</translation>
    </message>
    <message>
        <source>Height over radius of a drop that has landed.</source>
        <translation>Höjd genom radie hos en droppe som landat.</translation>
    </message>
    <message>
        <source>0: evenly over the width, 1: thickest in the middle.</source>
        <translation>0: jämnt över bredden, 1: tjockast i mitten.</translation>
    </message>
    <message>
        <source>Time that drops fly on with the speed of the tip.</source>
        <translation>Tid som dropparna flyger vidare med spetsens fart.</translation>
    </message>
    <message>
        <source>Pressure in the middle of the jet.</source>
        <translation>Trycket mitt i strålen.</translation>
    </message>
    <message>
        <source>Calligraphy nib 3</source>
        <translation>Textpenna 3</translation>
    </message>
    <message>
        <source>Charcoal 8</source>
        <translation>Kol 8</translation>
    </message>
    <message>
        <source>Marbling comb 80</source>
        <translation>Marmorkam 80</translation>
    </message>
    <message>
        <source>Oil pastel 10</source>
        <translation>Oljepastell 10</translation>
    </message>
    <message>
        <source>Roller 50</source>
        <translation>Roller 50</translation>
    </message>
    <message>
        <source>Ruling pen 1</source>
        <translation>Dragstift 1</translation>
    </message>
    <message>
        <source>Sponge 45</source>
        <translation>Svamp 45</translation>
    </message>
    <message>
        <source>Squeegee 120</source>
        <translation>Gummiskrapa 120</translation>
    </message>
    <message>
        <source>Width of a comb&apos;s tooth, in distances of its teeth.</source>
        <translation>En kamtands bredd, i avstånd mellan tänderna.</translation>
    </message>
    <message>
        <source>Depth of a sponge&apos;s pores.</source>
        <translation>Djup hos en svamps porer.</translation>
    </message>
    <message>
        <source>Way round a roller, after which its mark comes again; 0: it does not roll.</source>
        <translation>Vägen runt en roller, efter vilken dess spår kommer igen; 0: den rullar inte.</translation>
    </message>
    <message>
        <source>0: levels the hollows that it reaches, 1: coats the grain alone.</source>
        <translation>0: jämnar ut de gropar den når, 1: täcker bara kornet.</translation>
    </message>
    <message>
        <source>How many squares of the paint&apos;s grid lie side by side in a millimetre, and pixels in the saved picture: more show finer hairs, and need more memory and time</source>
        <translation>Hur många rutor av färgens rutnät som ligger bredvid varandra på en millimeter, och pixlar i den sparade bilden: fler visar finare strån, och kräver mer minne och tid</translation>
    </message>
    <message>
        <source>What paint lies on, bare: linen, jute, cotton duck, a panel or a height image</source>
        <translation>Det som färgen ligger på, obemålat: linne, jute, bomullsduk, en pannå eller en höjdbild</translation>
    </message>
    <message>
        <source>How steeply the canvas stands, and where down is: wet paint runs there</source>
        <translation>Hur brant duken står och var nedåt är: dit rinner våt färg</translation>
    </message>
    <message>
        <source>Where the lamp stands that lights the painting: a low one shows the relief, the heights of paint and canvas</source>
        <translation>Var lampan står som lyser på målningen: en låg lampa visar reliefen, höjderna i färg och duk</translation>
    </message>
    <message>
        <source>How many times as fast as by the clock wet paint becomes dry paint</source>
        <translation>Hur många gånger snabbare än klockan våt färg blir torr färg</translation>
    </message>
    <message>
        <source>What the brush holds from side to side of its tip, and how full it is of what it can hold</source>
        <translation>Vad penseln håller från sida till sida av sin spets, och hur full den är av det den kan hålla</translation>
    </message>
    <message>
        <source>What pigment is mixed with: it decides how stiff the paint is, how far it levels and how soon it dries</source>
        <translation>Det som pigment blandas med: det avgör hur styv färgen är, hur långt den jämnar ut sig och hur snart den torkar</translation>
    </message>
    <message>
        <source>How a trembling hand is steadied, besides the brush&apos;s own smoothing</source>
        <translation>Hur en darrande hand stabiliseras, utöver penselns egen utjämning</translation>
    </message>
    <message>
        <source>Hues that go together by their places on the wheel</source>
        <translation>Kulörer som hör ihop genom sina platser på färghjulet</translation>
    </message>
    <message>
        <source>A shape on the disc of hues that choosing on the wheel keeps to</source>
        <translation>En form på kulörernas skiva som valet på färghjulet håller sig till</translation>
    </message>
    <message>
        <source>The light that the painting is seen in: the same paint has other colours in another one</source>
        <translation>Ljuset som målningen betraktas i: samma färg får andra kulörer i ett annat</translation>
    </message>
    <message>
        <source>A clear coat over the whole painting that is looked through, and changes no paint</source>
        <translation>Ett klart skikt över hela målningen som man ser igenom och som inte ändrar någon färg</translation>
    </message>
    <message>
        <source>ΔE is how far two colours differ to the eye: 1 is seen side by side, 2 to 3 at a second look</source>
        <translation>ΔE är hur mycket två kulörer skiljer sig för ögat: 1 syns sida vid sida, 2 till 3 vid en andra blick</translation>
    </message>
    <message>
        <source>D65, D50 and A are the lights that colours are measured in everywhere: daylight, the light of print booths, and a light bulb</source>
        <translation>D65, D50 och A är de ljus som kulörer mäts i överallt: dagsljus, ljuset där tryck granskas, och en glödlampa</translation>
    </message>
    <message>
        <source>A soft proof shows on the screen how the painting would be printed; the gamut warning shows what this printer cannot print</source>
        <translation>Skärmkorrekturen visar på skärmen hur målningen skulle tryckas; omfångsvarningen visar vad den skrivaren inte kan trycka</translation>
    </message>
</context>
<context>
    <name>pastoso::appearance::UnitBox</name>
    <message>
        <source>&quot;%1&quot; is not understood here; the number stays as it was.</source>
        <translation>”%1” går inte att förstå här; talet förblir som det var.</translation>
    </message>
</context>
<context>
    <name>pastoso::commands</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Arkiv</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Redigera</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pensel</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>&amp;Färg</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>&amp;Lager</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Markera</translation>
    </message>
    <message>
        <source>&amp;Guides</source>
        <translation>&amp;Hjälplinjer</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Visa</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>L&amp;jus</translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation>&amp;Inställningar</translation>
    </message>
    <message>
        <source>&amp;New canvas...</source>
        <translation>&amp;Ny duk...</translation>
    </message>
    <message>
        <source>Put a fresh canvas on the easel</source>
        <translation>Ställ en ny duk på staffliet</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Öppna...</translation>
    </message>
    <message>
        <source>Go on with a painting that was saved, wet as it was</source>
        <translation>Fortsätt på en sparad målning, lika våt som du lämnade den</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Spara</translation>
    </message>
    <message>
        <source>Save the painting with all its wet paint</source>
        <translation>Spara målningen med all våt färg</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Spara s&amp;om...</translation>
    </message>
    <message>
        <source>Save the painting in another file</source>
        <translation>Spara målningen i en annan fil</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportera...</translation>
    </message>
    <message>
        <source>Make a picture, layers, maps, a relief to print or a time-lapse of the painting</source>
        <translation>Gör en bild, lager, texturkartor, en relief för 3D-utskrift eller en timelapse av målningen</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Exportera i&amp;gen</translation>
    </message>
    <message>
        <source>The same export of the painting as it is now, into the same file</source>
        <translation>Samma export av målningen som den är nu, till samma fil</translation>
    </message>
    <message>
        <source>S&amp;top the export</source>
        <translation>Avbr&amp;yt exporten</translation>
    </message>
    <message>
        <source>Give up the export that is being written; its file stays as it was</source>
        <translation>Avbryt exporten som pågår; filen förblir som den var</translation>
    </message>
    <message>
        <source>Export &amp;recording...</source>
        <translation>Exportera &amp;inspelning...</translation>
    </message>
    <message>
        <source>Save all strokes, to be replayed at any resolution</source>
        <translation>Spara alla penseldrag, för uppspelning i valfri upplösning</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Avsluta</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Stäng fönstret</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ångra</translation>
    </message>
    <message>
        <source>Take the last stroke back</source>
        <translation>Ta tillbaka det senaste draget</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gör om</translation>
    </message>
    <message>
        <source>Put the last stroke back</source>
        <translation>Lägg tillbaka det senaste draget</translation>
    </message>
    <message>
        <source>&amp;Memory for undo...</source>
        <translation>Å&amp;ngraminne...</translation>
    </message>
    <message>
        <source>How much memory the steps may take that you can return to</source>
        <translation>Hur mycket minne ångrastegen får ta</translation>
    </message>
    <message>
        <source>&amp;Canvas size...</source>
        <translation>&amp;Dukstorlek...</translation>
    </message>
    <message>
        <source>Make the canvas larger, or cut it, on any side</source>
        <translation>Gör duken större, eller beskär den, på valfri sida</translation>
    </message>
    <message>
        <source>Crop to the &amp;selection</source>
        <translation>&amp;Beskär till markeringen</translation>
    </message>
    <message>
        <source>Cut the canvas to the smallest one that holds what is selected</source>
        <translation>Beskär duken till den minsta storlek som rymmer det markerade</translation>
    </message>
    <message>
        <source>&amp;Narrower</source>
        <translation>S&amp;malare</translation>
    </message>
    <message>
        <source>A narrower brush</source>
        <translation>En smalare pensel</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>&amp;Bredare</translation>
    </message>
    <message>
        <source>A wider brush</source>
        <translation>En bredare pensel</translation>
    </message>
    <message>
        <source>Next &amp;brush</source>
        <translation>&amp;Nästa pensel</translation>
    </message>
    <message>
        <source>Take the next brush of the list</source>
        <translation>Ta nästa pensel i listan</translation>
    </message>
    <message>
        <source>&amp;Previous brush</source>
        <translation>&amp;Föregående pensel</translation>
    </message>
    <message>
        <source>Take the brush before in the list</source>
        <translation>Ta föregående pensel i listan</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Ladda om</translation>
    </message>
    <message>
        <source>Clean the brush and fill it with the paint</source>
        <translation>Rengör penseln och fyll den med färgen</translation>
    </message>
    <message>
        <source>&amp;Top up</source>
        <translation>Fyll &amp;på</translation>
    </message>
    <message>
        <source>Dip the brush without cleaning it: what it holds stays on it</source>
        <translation>Doppa penseln utan att rengöra den: det som sitter på den blir kvar</translation>
    </message>
    <message>
        <source>B&amp;lot</source>
        <translation>&amp;Torka av</translation>
    </message>
    <message>
        <source>Press the brush into a cloth: a quarter of its paint stays on it</source>
        <translation>Tryck av penseln i en trasa: en fjärdedel av färgen blir kvar på den</translation>
    </message>
    <message>
        <source>&amp;Clean</source>
        <translation>&amp;Rengör</translation>
    </message>
    <message>
        <source>Wipe the brush: an empty one moves the paint that lies there</source>
        <translation>Torka penseln ren: en tom pensel flyttar färgen som redan ligger där</translation>
    </message>
    <message>
        <source>S&amp;wap the two paints</source>
        <translation>B&amp;yt plats på de två färgerna</translation>
    </message>
    <message>
        <source>Dip the brush in the second paint; the first takes its place</source>
        <translation>Doppa penseln i den andra färgen; den första tar dess plats</translation>
    </message>
    <message>
        <source>P&amp;ick up the paint there</source>
        <translation>&amp;Hämta färgen där</translation>
    </message>
    <message>
        <source>The next click dips the brush in the mixture of pigments that lies there; so does Ctrl and a click</source>
        <translation>Nästa klick doppar penseln i den pigmentblandning som ligger där; eller håll Ctrl och klicka</translation>
    </message>
    <message>
        <source>Pick the c&amp;olour seen there</source>
        <translation>Hämta &amp;kulören som syns där</translation>
    </message>
    <message>
        <source>The next click makes paint of the colour that is seen there; so does Alt and a click</source>
        <translation>Nästa klick gör färg av den kulör som syns där; eller håll Alt och klicka</translation>
    </message>
    <message>
        <source>Reload before &amp;each stroke</source>
        <translation>Ladda om före &amp;varje drag</translation>
    </message>
    <message>
        <source>Every stroke starts with a clean, full brush</source>
        <translation>Varje drag börjar med en ren, full pensel</translation>
    </message>
    <message>
        <source>&amp;Turn with the stroke</source>
        <translation>Vri&amp;d med draget</translation>
    </message>
    <message>
        <source>Flat brushes stand across their path, where the pen does not tell its rotation</source>
        <translation>Platta penslar ställer sig tvärs mot draget, när pennan inte anger sin rotation</translation>
    </message>
    <message>
        <source>&amp;Save as my own...</source>
        <translation>&amp;Spara som eget...</translation>
    </message>
    <message>
        <source>Keep the tool in hand, with its curves, among your own</source>
        <translation>Behåll verktyget i handen, med dess kurvor, bland dina egna</translation>
    </message>
    <message>
        <source>Re&amp;name...</source>
        <translation>Byt n&amp;amn...</translation>
    </message>
    <message>
        <source>Give your own tool another name</source>
        <translation>Ge ditt eget verktyg ett annat namn</translation>
    </message>
    <message>
        <source>&amp;Delete...</source>
        <translation>Ta b&amp;ort...</translation>
    </message>
    <message>
        <source>Throw your own tool away</source>
        <translation>Ta bort ditt eget verktyg</translation>
    </message>
    <message>
        <source>&amp;Pause the paint</source>
        <translation>&amp;Pausa färgen</translation>
    </message>
    <message>
        <source>Wet paint stands still until you go on</source>
        <translation>Våt färg står stilla tills du fortsätter</translation>
    </message>
    <message>
        <source>&amp;Dry now</source>
        <translation>&amp;Torka nu</translation>
    </message>
    <message>
        <source>All wet paint dries at once: paint over it without stirring it up</source>
        <translation>All våt färg torkar på en gång: måla över den utan att röra upp den</translation>
    </message>
    <message>
        <source>Mixing &amp;well</source>
        <translation>&amp;Blandningsyta</translation>
    </message>
    <message>
        <source>A palette of wet paint: mix there with any tool, and carry it to the canvas</source>
        <translation>En palett med våt färg: blanda där med vilket verktyg som helst, och för över till duken</translation>
    </message>
    <message>
        <source>&amp;Squeeze onto the well</source>
        <translation>&amp;Kläm ut på blandningsytan</translation>
    </message>
    <message>
        <source>Squeeze the paint that you chose onto the mixing well; Control and click says where</source>
        <translation>Kläm ut den valda färgen på blandningsytan; håll Ctrl och klicka där den ska ligga</translation>
    </message>
    <message>
        <source>&amp;Clean the well</source>
        <translation>&amp;Rengör blandningsytan</translation>
    </message>
    <message>
        <source>Wipe the mixing well bare</source>
        <translation>Torka blandningsytan helt ren</translation>
    </message>
    <message>
        <source>&amp;New layer</source>
        <translation>&amp;Nytt lager</translation>
    </message>
    <message>
        <source>A bare layer above the one that you paint on</source>
        <translation>Ett tomt lager ovanför det du målar på</translation>
    </message>
    <message>
        <source>From a &amp;picture...</source>
        <translation>Från en &amp;bild...</translation>
    </message>
    <message>
        <source>Put a picture onto the canvas as a layer of dry paint</source>
        <translation>Lägg en bild på duken som ett lager torr färg</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplicera</translation>
    </message>
    <message>
        <source>The same paint once more, on a layer above</source>
        <translation>Samma färg en gång till, på ett lager ovanför</translation>
    </message>
    <message>
        <source>Na&amp;me...</source>
        <translation>Na&amp;mn...</translation>
    </message>
    <message>
        <source>Give the layer or the group another name</source>
        <translation>Ge lagret eller gruppen ett annat namn</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Ta bort</translation>
    </message>
    <message>
        <source>Take the layer away with all its paint</source>
        <translation>Ta bort lagret med all färg på det</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>T&amp;öm</translation>
    </message>
    <message>
        <source>Wipe all paint off the layer</source>
        <translation>Torka bort all färg från lagret</translation>
    </message>
    <message>
        <source>&amp;Transform</source>
        <translation>T&amp;ransformera</translation>
    </message>
    <message>
        <source>Move, scale, turn and mirror the layer&apos;s paint, or what is selected of it, by a frame</source>
        <translation>Flytta, skala, vrid och spegla lagrets färg, eller den markerade delen, med en ram</translation>
    </message>
    <message>
        <source>M&amp;erge down</source>
        <translation>Sammanfoga n&amp;edåt</translation>
    </message>
    <message>
        <source>Put the layer&apos;s paint on the layer below, and make them one</source>
        <translation>Lägg lagrets färg på lagret under, och gör dem till ett</translation>
    </message>
    <message>
        <source>&amp;Flatten what is visible</source>
        <translation>Sammanfoga s&amp;ynliga</translation>
    </message>
    <message>
        <source>Make one layer of all that are visible; hidden ones stay</source>
        <translation>Gör ett lager av alla som syns; dolda lager blir kvar</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>&amp;Gruppera</translation>
    </message>
    <message>
        <source>Put the chosen layers into a group, which is hidden, locked and faded as one</source>
        <translation>Lägg de valda lagren i en grupp, som döljs, låses och tonas ned som ett</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>Lös upp gru&amp;ppen</translation>
    </message>
    <message>
        <source>Dissolve the group; its layers stay where they are</source>
        <translation>Lös upp gruppen; lagren i den blir kvar på sin plats</translation>
    </message>
    <message>
        <source>&amp;Visible</source>
        <translation>&amp;Synligt</translation>
    </message>
    <message>
        <source>Show or hide the layer or the group</source>
        <translation>Visa eller dölj lagret eller gruppen</translation>
    </message>
    <message>
        <source>&amp;Locked</source>
        <translation>&amp;Låst</translation>
    </message>
    <message>
        <source>Keep the layer or the group from being painted on, cleared and merged</source>
        <translation>Skydda lagret eller gruppen mot målning, tömning och sammanfogning</translation>
    </message>
    <message>
        <source>Choose the one &amp;above</source>
        <translation>Välj lagret &amp;ovanför</translation>
    </message>
    <message>
        <source>Paint on the layer above</source>
        <translation>Måla på lagret ovanför</translation>
    </message>
    <message>
        <source>Choose the one &amp;below</source>
        <translation>V&amp;älj lagret under</translation>
    </message>
    <message>
        <source>Paint on the layer below</source>
        <translation>Måla på lagret under</translation>
    </message>
    <message>
        <source>Move u&amp;p</source>
        <translation>Flytta &amp;upp</translation>
    </message>
    <message>
        <source>Move the layer or the group one place up, into and out of groups</source>
        <translation>Flytta lagret eller gruppen ett steg upp, in i och ut ur grupper</translation>
    </message>
    <message>
        <source>Move d&amp;own</source>
        <translation>&amp;Flytta ned</translation>
    </message>
    <message>
        <source>Move the layer or the group one place down, into and out of groups</source>
        <translation>Flytta lagret eller gruppen ett steg ned, in i och ut ur grupper</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>&amp;Rektangel</translation>
    </message>
    <message>
        <source>Drag a rectangle that tools keep to; Shift adds, Alt takes away, Ctrl makes a square</source>
        <translation>Dra en rektangel som verktygen håller sig inom; Shift lägger till, Alt tar bort, Ctrl ger en kvadrat</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>&amp;Lasso</translation>
    </message>
    <message>
        <source>Draw around what tools keep to; Shift adds, Alt takes away</source>
        <translation>Rita runt det som verktygen ska hålla sig inom; Shift lägger till, Alt tar bort</translation>
    </message>
    <message>
        <source>End the selection: tools work on all of the canvas</source>
        <translation>Avsluta markeringen: verktygen arbetar på hela duken</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>&amp;Invertera</translation>
    </message>
    <message>
        <source>Select what is not selected</source>
        <translation>Markera det som inte är markerat</translation>
    </message>
    <message>
        <source>By &amp;height...</source>
        <translation>Efter &amp;höjd...</translation>
    </message>
    <message>
        <source>Select where the paint stands so high above the bare canvas</source>
        <translation>Markera där färgen når en viss höjd över den tomma duken</translation>
    </message>
    <message>
        <source>By &amp;wetness...</source>
        <translation>Efter &amp;våthet...</translation>
    </message>
    <message>
        <source>Select where the wet paint of the layer is so thick</source>
        <translation>Markera där lagrets våta färg har en viss tjocklek</translation>
    </message>
    <message>
        <source>Show the &amp;outline</source>
        <translation>Visa &amp;konturen</translation>
    </message>
    <message>
        <source>Hidden, it is out of the way of what you paint; tools keep to it as before</source>
        <translation>Dold är den inte i vägen när du målar; verktygen håller sig inom den som förut</translation>
    </message>
    <message>
        <source>&amp;Mirror left and right</source>
        <translation>Spegla &amp;vänster och höger</translation>
    </message>
    <message>
        <source>Every stroke is painted on both sides of the upright line</source>
        <translation>Varje drag målas på båda sidor om den lodräta linjen</translation>
    </message>
    <message>
        <source>Mirror a&amp;bove and below</source>
        <translation>Spegla &amp;uppe och nere</translation>
    </message>
    <message>
        <source>Every stroke is painted on both sides of the level line</source>
        <translation>Varje drag målas på båda sidor om den vågräta linjen</translation>
    </message>
    <message>
        <source>M&amp;ore copies around the middle</source>
        <translation>&amp;Fler kopior runt mitten</translation>
    </message>
    <message>
        <source>Every stroke is painted once more around the middle of the canvas</source>
        <translation>Varje drag målas en gång till runt dukens mitt</translation>
    </message>
    <message>
        <source>&amp;Fewer copies around the middle</source>
        <translation>Fä&amp;rre kopior runt mitten</translation>
    </message>
    <message>
        <source>Every stroke is painted once less around the middle of the canvas</source>
        <translation>Varje drag målas en gång mindre runt dukens mitt</translation>
    </message>
    <message>
        <source>&amp;Ruler along the last stroke</source>
        <translation>&amp;Linjal längs senaste draget</translation>
    </message>
    <message>
        <source>Strokes run along the ruler, or parallel to it; Shift and drag draw a straight line</source>
        <translation>Dragen följer linjalen, eller löper parallellt med den; dra med Shift för en rak linje</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>&amp;Ellips</translation>
    </message>
    <message>
        <source>Strokes run along the ellipse, or along another of the same shape</source>
        <translation>Dragen följer ellipsen, eller en annan med samma form</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>&amp;Handtag</translation>
    </message>
    <message>
        <source>Points by which guides are dragged; Shift keeps to steps and proportions</source>
        <translation>Punkter att dra hjälplinjerna i; med Shift i steg och med bevarade proportioner</translation>
    </message>
    <message>
        <source>&amp;No guides</source>
        <translation>&amp;Inga hjälplinjer</translation>
    </message>
    <message>
        <source>&amp;Trace a picture...</source>
        <translation>&amp;Kalkera en bild...</translation>
    </message>
    <message>
        <source>Lay a picture below the paint, and beside the canvas; it is in no picture that you save</source>
        <translation>Lägg en bild under färgen, och bredvid duken; den kommer inte med i någon bild som du sparar</translation>
    </message>
    <message>
        <source>&amp;Show it below the paint</source>
        <translation>Vi&amp;sa den under färgen</translation>
    </message>
    <message>
        <source>Show or hide the picture that you trace</source>
        <translation>Visa eller dölj bilden som du kalkerar</translation>
    </message>
    <message>
        <source>F&amp;it it to the canvas</source>
        <translation>Anp&amp;assa den till duken</translation>
    </message>
    <message>
        <source>In the middle of the canvas, as large as it fits</source>
        <translation>Mitt på duken, så stor som får plats</translation>
    </message>
    <message>
        <source>Ta&amp;ke it away</source>
        <translation>&amp;Ta bort den</translation>
    </message>
    <message>
        <source>Take the picture that you trace away</source>
        <translation>Ta bort bilden som du kalkerar</translation>
    </message>
    <message>
        <source>&amp;Fit the canvas</source>
        <translation>Visa &amp;hela duken</translation>
    </message>
    <message>
        <source>Show the whole canvas</source>
        <translation>Visa hela duken</translation>
    </message>
    <message>
        <source>&amp;Actual pixels</source>
        <translation>Verkliga &amp;pixlar</translation>
    </message>
    <message>
        <source>One screen pixel for every pixel of the saved picture</source>
        <translation>En skärmpixel för varje pixel i den sparade bilden</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Zooma in</translation>
    </message>
    <message>
        <source>Closer</source>
        <translation>Närmare</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Zooma &amp;ut</translation>
    </message>
    <message>
        <source>Farther</source>
        <translation>Längre bort</translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation>Vrid åt &amp;vänster</translation>
    </message>
    <message>
        <source>Turn the canvas a little to the left on the screen; so does Shift+Space and a drag</source>
        <translation>Vrid duken lite åt vänster på skärmen; eller håll Shift+mellanslag och dra</translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation>&amp;Räta upp</translation>
    </message>
    <message>
        <source>The canvas stands again as it is saved</source>
        <translation>Duken står åter som den sparas</translation>
    </message>
    <message>
        <source>Turn &amp;right</source>
        <translation>Vrid åt hö&amp;ger</translation>
    </message>
    <message>
        <source>Turn the canvas a little to the right on the screen; so does Shift+Space and a drag</source>
        <translation>Vrid duken lite åt höger på skärmen; eller håll Shift+mellanslag och dra</translation>
    </message>
    <message>
        <source>&amp;Mirror the view</source>
        <translation>&amp;Spegla vyn</translation>
    </message>
    <message>
        <source>See the painting as in a mirror, and paint on it so; it is saved as it is</source>
        <translation>Se målningen som i en spegel, och måla på den så; den sparas rättvänd</translation>
    </message>
    <message>
        <source>Canvas &amp;only</source>
        <translation>Bara &amp;duken</translation>
    </message>
    <message>
        <source>Nothing but the canvas; Tab or Escape brings the panels back</source>
        <translation>Inget annat än duken; Tab eller Escape tar fram panelerna igen</translation>
    </message>
    <message>
        <source>In its l&amp;ight</source>
        <translation>I sitt &amp;ljus</translation>
    </message>
    <message>
        <source>The paint as it hangs in its light</source>
        <translation>Färgen som den ser ut i sitt ljus</translation>
    </message>
    <message>
        <source>Show &amp;wet</source>
        <translation>Visa vå&amp;tt</translation>
    </message>
    <message>
        <source>Tints what is still wet, the more the thicker it is</source>
        <translation>Tonar det som ännu är vått, starkare ju tjockare det är</translation>
    </message>
    <message>
        <source>Show &amp;height</source>
        <translation>Visa hö&amp;jd</translation>
    </message>
    <message>
        <source>How high the paint stands above the bare canvas, in steps of colour</source>
        <translation>Hur högt färgen når över den tomma duken, i färgade steg</translation>
    </message>
    <message>
        <source>Show &amp;normals</source>
        <translation>Visa &amp;normaler</translation>
    </message>
    <message>
        <source>Where the surface faces: red to the right, green up, blue towards you</source>
        <translation>Vart ytan vetter: rött åt höger, grönt uppåt, blått mot dig</translation>
    </message>
    <message>
        <source>&amp;Flat colour</source>
        <translation>Kul&amp;ör utan ljus</translation>
    </message>
    <message>
        <source>The paint&apos;s colours alone, without light and relief</source>
        <translation>Färgens kulörer för sig, utan ljus och relief</translation>
    </message>
    <message>
        <source>&amp;Tool panel</source>
        <translation>Verkt&amp;ygspanel</translation>
    </message>
    <message>
        <source>What the brush holds, and how it answers to the hand</source>
        <translation>Vad penseln bär, och hur den svarar på handen</translation>
    </message>
    <message>
        <source>&amp;Colour panel</source>
        <translation>&amp;Kulörpanel</translation>
    </message>
    <message>
        <source>A paint of any colour, and its recipe from the tubes</source>
        <translation>Färg i vilken kulör som helst, och receptet från tuberna</translation>
    </message>
    <message>
        <source>P&amp;hysics panel</source>
        <translation>&amp;Fysikpanel</translation>
    </message>
    <message>
        <source>What the paint is like: how it flows, holds and dries</source>
        <translation>Hur färgen beter sig: hur den flyter, håller formen och torkar</translation>
    </message>
    <message>
        <source>&amp;Guides panel</source>
        <translation>Hjälplinjepan&amp;el</translation>
    </message>
    <message>
        <source>&amp;Layers panel</source>
        <translation>L&amp;agerpanel</translation>
    </message>
    <message>
        <source>The layers of the painting: seen, locked, faded, in what order</source>
        <translation>Målningens lager: synliga, låsta, nedtonade, i vilken ordning</translation>
    </message>
    <message>
        <source>Tr&amp;acing panel</source>
        <translation>Kalker&amp;ingspanel</translation>
    </message>
    <message>
        <source>The picture that you trace, to look at and to pick colours from</source>
        <translation>Bilden som du kalkerar, att titta på och hämta kulörer från</translation>
    </message>
    <message>
        <source>&amp;History panel</source>
        <translation>Hist&amp;orikpanel</translation>
    </message>
    <message>
        <source>What was done, to go back to any of it</source>
        <translation>Vad som har gjorts, för att gå tillbaka till valfritt steg</translation>
    </message>
    <message>
        <source>&amp;Reset the panels</source>
        <translation>&amp;Återställ panelerna</translation>
    </message>
    <message>
        <source>Panels and mixing well as they stood at the first start</source>
        <translation>Paneler och blandningsyta som de stod vid första starten</translation>
    </message>
    <message>
        <source>Colours for s&amp;RGB</source>
        <translation>Färger för sRG&amp;B</translation>
    </message>
    <message>
        <source>Shows the painting for common screens</source>
        <translation>Visar målningen för vanliga skärmar</translation>
    </message>
    <message>
        <source>Colours for Display &amp;P3</source>
        <translation>F&amp;ärger för Display P3</translation>
    </message>
    <message>
        <source>Shows the painting for a screen of wide gamut</source>
        <translation>Visar målningen för en skärm med brett färgomfång</translation>
    </message>
    <message>
        <source>&amp;Daylight (D65)</source>
        <translation>&amp;Dagsljus (D65)</translation>
    </message>
    <message>
        <source>The light that screens are made for</source>
        <translation>Ljuset som skärmar är gjorda för</translation>
    </message>
    <message>
        <source>&amp;Print booth (D50)</source>
        <translation>&amp;Granskningsljus (D50)</translation>
    </message>
    <message>
        <source>The light that prints are judged in</source>
        <translation>Ljuset som utskrifter bedöms i</translation>
    </message>
    <message>
        <source>Light &amp;bulb (A)</source>
        <translation>Glödla&amp;mpa (A)</translation>
    </message>
    <message>
        <source>Incandescent lamplight</source>
        <translation>Ljus från glödlampor</translation>
    </message>
    <message>
        <source>&amp;LED lamp</source>
        <translation>&amp;LED-lampa</translation>
    </message>
    <message>
        <source>A white LED with its blue peak</source>
        <translation>En vit LED med sin blå topp</translation>
    </message>
    <message>
        <source>From a &amp;file...</source>
        <translation>Från en &amp;fil...</translation>
    </message>
    <message>
        <source>A lamp that you have measured, as a CSV file</source>
        <translation>En lampa som du har mätt, som CSV-fil</translation>
    </message>
    <message>
        <source>&amp;Move the light</source>
        <translation>Fl&amp;ytta ljuset</translation>
    </message>
    <message>
        <source>Drag the lamp over the canvas: towards the rim it rakes over the relief</source>
        <translation>Dra lampan över duken: mot kanten ger den släpljus över reliefen</translation>
    </message>
    <message>
        <source>&amp;Find a command...</source>
        <translation>&amp;Sök ett kommando...</translation>
    </message>
    <message>
        <source>Type a few letters of what you want to do</source>
        <translation>Skriv några bokstäver av det du vill göra</translation>
    </message>
    <message>
        <source>&amp;Keys...</source>
        <translation>&amp;Kortkommandon...</translation>
    </message>
    <message>
        <source>Choose a set of keys, and give any command keys of your own</source>
        <translation>Välj en uppsättning kortkommandon, och ge valfritt kommando egna tangenter</translation>
    </message>
    <message>
        <source>&amp;Settings...</source>
        <translation>&amp;Inställningar...</translation>
    </message>
    <message>
        <source>The look of the window, what is kept, and how much of the machine is used</source>
        <translation>Fönstrets utseende, vad som sparas och hur mycket av datorn som används</translation>
    </message>
    <message>
        <source>Start &amp;page</source>
        <translation>Sta&amp;rtsida</translation>
    </message>
    <message>
        <source>New canvases, recent paintings and examples at a glance</source>
        <translation>Nya dukar, senaste målningar och exempel i en överblick</translation>
    </message>
    <message>
        <source>&amp;Watch it grow...</source>
        <translation>Se den &amp;växa fram...</translation>
    </message>
    <message>
        <source>See how the painting came about, in a window of its own; the painting stays as it is</source>
        <translation>Se hur målningen kom till, i ett eget fönster; målningen förblir som den är</translation>
    </message>
    <message>
        <source>&amp;Make a time-lapse...</source>
        <translation>Gör en time&amp;lapse...</translation>
    </message>
    <message>
        <source>A film, or numbered pictures, of how the painting came about</source>
        <translation>En film, eller numrerade bilder, av hur målningen kom till</translation>
    </message>
    <message>
        <source>Pop-&amp;up palette</source>
        <translation>Popup-pale&amp;tt</translation>
    </message>
    <message>
        <source>Tools and paints around the pointer; so does a right click on the canvas</source>
        <translation>Verktyg och färger runt pekaren; eller högerklicka på duken</translation>
    </message>
    <message>
        <source>&amp;Navigator</source>
        <translation>Övers&amp;ikt</translation>
    </message>
    <message>
        <source>The whole canvas, to see where the window is and to go elsewhere</source>
        <translation>Hela duken, för att se var fönstret är och gå någon annanstans</translation>
    </message>
    <message>
        <source>Li&amp;ghts panel</source>
        <translation>Bel&amp;ysningspanel</translation>
    </message>
    <message>
        <source>The lamp, its light, and a coat of varnish to look through</source>
        <translation>Lampan, dess ljus, och ett skikt fernissa att se igenom</translation>
    </message>
    <message>
        <source>Recor&amp;der panel</source>
        <translation>Inspelni&amp;ngspanel</translation>
    </message>
    <message>
        <source>What is recorded of the painting: watch it grow again, or make a time-lapse</source>
        <translation>Vad som är inspelat av målningen: se den växa fram igen, eller gör en timelapse</translation>
    </message>
    <message>
        <source>&amp;Pen and tablet...</source>
        <translation>&amp;Penna och ritplatta...</translation>
    </message>
    <message>
        <source>How pens and mouse press, what their buttons do, and a sheet to try them on</source>
        <translation>Hur pennor och mus trycker, vad knapparna gör, och ett ark att prova dem på</translation>
    </message>
    <message>
        <source>&amp;Milk tea</source>
        <translation>&amp;Mjölkte</translation>
    </message>
    <message>
        <source>A glass of tea in place of the canvas, to pour milk into; the painting waits as it is</source>
        <translation>Ett glas te i dukens ställe att hälla mjölk i; målningen väntar som den är</translation>
    </message>
    <message>
        <source>&amp;New glass</source>
        <translation>&amp;Nytt glas</translation>
    </message>
    <message>
        <source>Begin again with clear tea</source>
        <translation>Börja om med klart te</translation>
    </message>
    <message>
        <source>&amp;Open a scene...</source>
        <translation>&amp;Öppna en scen...</translation>
    </message>
    <message>
        <source>Begin again with the numbers of a file</source>
        <translation>Börja om med talen i en fil</translation>
    </message>
    <message>
        <source>&amp;Save the scene...</source>
        <translation>&amp;Spara scenen...</translation>
    </message>
    <message>
        <source>Keep all numbers of the glass in a file</source>
        <translation>Spara glasets alla tal i en fil</translation>
    </message>
    <message>
        <source>&amp;Export the surface...</source>
        <translation>&amp;Exportera ytan...</translation>
    </message>
    <message>
        <source>&amp;Render a picture...</source>
        <translation>&amp;Rendera en bild...</translation>
    </message>
    <message>
        <source>A picture by the light&apos;s true ways, to be saved or painted on</source>
        <translation>En bild efter ljusets verkliga vägar, att spara eller måla på</translation>
    </message>
    <message>
        <source>As &amp;fast as it can</source>
        <translation>Så &amp;fort det går</translation>
    </message>
    <message>
        <source>Time in the glass passes as fast as it is computed</source>
        <translation>Tiden i glaset går så fort den kan beräknas</translation>
    </message>
    <message>
        <source>S&amp;tir</source>
        <translation>&amp;Rör om</translation>
    </message>
    <message>
        <source>A force around an upright axis stirs the tea</source>
        <translation>En kraft runt en lodrät axel rör om teet</translation>
    </message>
    <message>
        <source>Axis to the &amp;middle</source>
        <translation>Axeln till &amp;mitten</translation>
    </message>
    <message>
        <source>The axis of the force stands in the middle of the glass again</source>
        <translation>Kraftens axel står åter mitt i glaset</translation>
    </message>
    <message>
        <source>The other &amp;way round</source>
        <translation>Åt &amp;andra hållet</translation>
    </message>
    <message>
        <source>Stir the other way round</source>
        <translation>Rör om åt andra hållet</translation>
    </message>
    <message>
        <source>Axis to the &amp;left</source>
        <translation>Axeln åt &amp;vänster</translation>
    </message>
    <message>
        <source>Move the axis of the force to the left</source>
        <translation>Flytta kraftens axel åt vänster</translation>
    </message>
    <message>
        <source>Axis to the r&amp;ight</source>
        <translation>Axeln åt &amp;höger</translation>
    </message>
    <message>
        <source>Move the axis of the force to the right</source>
        <translation>Flytta kraftens axel åt höger</translation>
    </message>
    <message>
        <source>Axis &amp;away</source>
        <translation>Axeln &amp;bort</translation>
    </message>
    <message>
        <source>Move the axis of the force away from you</source>
        <translation>Flytta kraftens axel bort från dig</translation>
    </message>
    <message>
        <source>Axis n&amp;ear</source>
        <translation>Axeln &amp;närmare</translation>
    </message>
    <message>
        <source>Move the axis of the force towards you</source>
        <translation>Flytta kraftens axel mot dig</translation>
    </message>
    <message>
        <source>Look from the fr&amp;ont</source>
        <translation>Se fram&amp;ifrån</translation>
    </message>
    <message>
        <source>See the whole glass from the front again</source>
        <translation>Se hela glaset framifrån igen</translation>
    </message>
    <message>
        <source>Liqui&amp;ds</source>
        <translation>Vätsk&amp;or</translation>
    </message>
    <message>
        <source>&amp;Glass tank</source>
        <translation>&amp;Glastank</translation>
    </message>
    <message>
        <source>A tank of liquid in place of the canvas, with balls that fall, a drain and wind; the painting waits as it is</source>
        <translation>En tank med vätska i stället för duken, med kulor som faller, ett avlopp och vind; målningen väntar som den är</translation>
    </message>
    <message>
        <source>The liquid&apos;s surface as triangles, for PBRT and other programs</source>
        <translation>Vätskans yta som trianglar, för PBRT och andra program</translation>
    </message>
    <message>
        <source>&amp;Pause the liquid</source>
        <translation>&amp;Pausa vätskan</translation>
    </message>
    <message>
        <source>The liquid stands still until you go on</source>
        <translation>Vätskan står stilla tills du fortsätter</translation>
    </message>
    <message>
        <source>A tank where liquid &amp;falls</source>
        <translation>En tank där vätska &amp;faller</translation>
    </message>
    <message>
        <source>A ball of liquid falls into a glass tank</source>
        <translation>En kula av vätska faller ner i en glastank</translation>
    </message>
    <message>
        <source>A tank where t&amp;wo liquids meet</source>
        <translation>En tank där t&amp;vå vätskor möts</translation>
    </message>
    <message>
        <source>Liquid breaks over a solid and meets another liquid</source>
        <translation>Vätska bryts mot ett fast föremål och möter en annan vätska</translation>
    </message>
    <message>
        <source>&amp;Open a tank...</source>
        <translation>&amp;Öppna en tank...</translation>
    </message>
    <message>
        <source>Begin with the tank of a file</source>
        <translation>Börja med tanken i en fil</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>&amp;Börja om</translation>
    </message>
    <message>
        <source>Export &amp;all moments...</source>
        <translation>Exportera &amp;alla ögonblick...</translation>
    </message>
    <message>
        <source>The liquid&apos;s surface at every moment that is kept, each in a file of its own</source>
        <translation>Vätskans yta i varje sparat ögonblick, var och en i en egen fil</translation>
    </message>
    <message>
        <source>Add a &amp;ball of liquid</source>
        <translation>Lägg till en &amp;kula vätska</translation>
    </message>
    <message>
        <source>A ball of liquid falls from above; press on the liquid to say where</source>
        <translation>En kula vätska faller uppifrån; tryck på vätskan för att säga var</translation>
    </message>
    <message>
        <source>Open the &amp;drain</source>
        <translation>Öppna a&amp;vloppet</translation>
    </message>
    <message>
        <source>Liquid runs out through the floor until you shut it again</source>
        <translation>Vätskan rinner ut genom botten tills du stänger igen</translation>
    </message>
    <message>
        <source>W&amp;ind</source>
        <translation>V&amp;ind</translation>
    </message>
    <message>
        <source>Wind over the tank drags the liquid&apos;s surface along</source>
        <translation>Vind över tanken drar vätskans yta med sig</translation>
    </message>
    <message>
        <source>Turn the wind to the &amp;left</source>
        <translation>Vrid vinden åt &amp;vänster</translation>
    </message>
    <message>
        <source>Turn the wind by 15 degrees to the left</source>
        <translation>Vrid vinden 15 grader åt vänster</translation>
    </message>
    <message>
        <source>Turn the wind to the &amp;right</source>
        <translation>Vrid vinden åt &amp;höger</translation>
    </message>
    <message>
        <source>Turn the wind by 15 degrees to the right</source>
        <translation>Vrid vinden 15 grader åt höger</translation>
    </message>
    <message>
        <source>Stron&amp;ger wind</source>
        <translation>St&amp;arkare vind</translation>
    </message>
    <message>
        <source>The wind blows faster by half a metre a second</source>
        <translation>Vinden blåser en halv meter i sekunden snabbare</translation>
    </message>
    <message>
        <source>W&amp;eaker wind</source>
        <translation>Sva&amp;gare vind</translation>
    </message>
    <message>
        <source>The wind blows slower by half a metre a second</source>
        <translation>Vinden blåser en halv meter i sekunden långsammare</translation>
    </message>
    <message>
        <source>Show &amp;velocities</source>
        <translation>Visa &amp;hastigheter</translation>
    </message>
    <message>
        <source>Arrows show where the liquid flows, and how fast</source>
        <translation>Pilar visar vart vätskan strömmar, och hur fort</translation>
    </message>
    <message>
        <source>Render a pic&amp;ture...</source>
        <translation>Rendera en bil&amp;d...</translation>
    </message>
    <message>
        <source>Pi&amp;ctures of every step...</source>
        <translation>Bil&amp;der av varje steg...</translation>
    </message>
    <message>
        <source>While the liquid moves, a picture of every moment, as you see the tank, goes into a folder</source>
        <translation>Medan vätskan rör sig läggs en bild av varje ögonblick, som du ser tanken, i en mapp</translation>
    </message>
    <message>
        <source>S&amp;urfaces of every step...</source>
        <translation>&amp;Ytor av varje steg...</translation>
    </message>
    <message>
        <source>While the liquid moves, its surface at every moment goes into a folder</source>
        <translation>Medan vätskan rör sig läggs dess yta i varje ögonblick i en mapp</translation>
    </message>
    <message>
        <source>M&amp;essages</source>
        <translation>M&amp;eddelanden</translation>
    </message>
    <message>
        <source>What you were told last, to be read again and copied</source>
        <translation>Det senaste som meddelats, att läsa igen och kopiera</translation>
    </message>
    <message>
        <source>Time runs &amp;faster</source>
        <translation>Tiden går &amp;fortare</translation>
    </message>
    <message>
        <source>Watch slow paint run, level and dry: up to 20 times as fast</source>
        <translation>Se trög färg rinna, jämna ut sig och torka: upp till 20 gånger så fort</translation>
    </message>
    <message>
        <source>Time runs s&amp;lower</source>
        <translation>Tiden går &amp;långsammare</translation>
    </message>
    <message>
        <source>A step back towards real time</source>
        <translation>Ett steg tillbaka mot realtid</translation>
    </message>
    <message>
        <source>&amp;Real time</source>
        <translation>&amp;Realtid</translation>
    </message>
    <message>
        <source>A second of the paint takes a second again</source>
        <translation>En sekund för färgen tar åter en sekund</translation>
    </message>
    <message>
        <source>&amp;Hold it tilted</source>
        <translation>&amp;Håll det lutat</translation>
    </message>
    <message>
        <source>A mouse holds the tool aslant: a knife then scrapes with its edge</source>
        <translation>Med mus hålls verktyget på sned: en kniv skrapar då med eggen</translation>
    </message>
    <message>
        <source>More &amp;medium</source>
        <translation>Mer &amp;medium</translation>
    </message>
    <message>
        <source>Thin the paint in hand by a quarter, from paste towards a stain</source>
        <translation>Tunna ut färgen i handen med en fjärdedel, från pasta mot bets</translation>
    </message>
    <message>
        <source>More p&amp;aint</source>
        <translation>Mer f&amp;ärg</translation>
    </message>
    <message>
        <source>Take a step back towards paint from the tube</source>
        <translation>Gå ett steg tillbaka mot färg ur tuben</translation>
    </message>
    <message>
        <source>Thin was&amp;h</source>
        <translation>Tunn laverin&amp;g</translation>
    </message>
    <message>
        <source>Thin the paint in hand to a wash for a first lay-in, and back</source>
        <translation>Tunna ut färgen i handen till en lavering för undermålning, och tillbaka</translation>
    </message>
    <message>
        <source>Po&amp;ur</source>
        <translation>H&amp;äll</translation>
    </message>
    <message>
        <source>Pour the recipe&apos;s milk into the middle, or stop pouring it; press on the tea to pour where you point</source>
        <translation>Häll receptets mjölk i mitten, eller sluta hälla; tryck på teet för att hälla där du pekar</translation>
    </message>
    <message>
        <source>The tank as it stood at the beginning; wind and drain stay as they are</source>
        <translation>Tanken som den stod i början; vind och avlopp förblir som de är</translation>
    </message>
    <message>
        <source>Pa&amp;int it again, finer...</source>
        <translation>Måla &amp;om det finare...</translation>
    </message>
    <message>
        <source>Soft &amp;proof</source>
        <translation>Skärm&amp;korrektur</translation>
    </message>
    <message>
        <source>Shows the painting as the printer chosen in the settings would print it</source>
        <translation>Visar målningen som den skrivare som valts i inställningarna skulle skriva ut den</translation>
    </message>
    <message>
        <source>Gamut &amp;warning</source>
        <translation>Omfångs&amp;varning</translation>
    </message>
    <message>
        <source>Colours that this printer has not are grey</source>
        <translation>Färger som den skrivaren inte har är grå</translation>
    </message>
    <message>
        <source>Cance&amp;l opening</source>
        <translation>Avbryt ö&amp;ppningen</translation>
    </message>
    <message>
        <source>Give up what is being opened or made; the painting on the easel stays</source>
        <translation>Ge upp det som öppnas eller görs; målningen på staffliet stannar kvar</translation>
    </message>
    <message>
        <source>&amp;Value check</source>
        <translation>&amp;Valörkontroll</translation>
    </message>
    <message>
        <source>The painting in greys as light as its colours: darks and lights by themselves</source>
        <translation>Målningen i gråtoner lika ljusa som dess färger: mörker och ljus för sig</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hjälp</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbok</translation>
    </message>
    <message>
        <source>Read about what is under the pointer</source>
        <translation>Läs om det som finns under pekaren</translation>
    </message>
    <message>
        <source>What is &amp;new</source>
        <translation>&amp;Nyheter</translation>
    </message>
    <message>
        <source>What has changed, version by version</source>
        <translation>Vad som har ändrats, version för version</translation>
    </message>
    <message>
        <source>&amp;About Pastoso</source>
        <translation>&amp;Om Pastoso</translation>
    </message>
    <message>
        <source>Its version and licence, what it is made of, this machine, its folders</source>
        <translation>Version och licens, vad det består av, den här datorn, mapparna</translation>
    </message>
    <message>
        <source>Save a &amp;copy...</source>
        <translation>Spara en &amp;kopia...</translation>
    </message>
    <message>
        <source>The layers as pictures for other programs, in OpenRaster or PSD</source>
        <translation>Lagren som bilder för andra program, i OpenRaster eller PSD</translation>
    </message>
    <message>
        <source>&amp;Image</source>
        <translation>&amp;Bild</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Klipp u&amp;t</translation>
    </message>
    <message>
        <source>Copy the layer&apos;s paint, or what is selected of it, and wipe it off</source>
        <translation>Kopiera lagrets färg, eller det som är markerat av den, och torka bort den</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiera</translation>
    </message>
    <message>
        <source>Keep the layer&apos;s paint, or what is selected of it, to be pasted: wet as it is, and as a picture for other programs</source>
        <translation>Behåll lagrets färg, eller det som är markerat av den, för att klistra in: våt som den är, och som bild för andra program</translation>
    </message>
    <message>
        <source>Cop&amp;y merged</source>
        <translation>Kopiera samma&amp;nslaget</translation>
    </message>
    <message>
        <source>The same of all layers that are visible, as if they were one</source>
        <translation>Detsamma av alla synliga lager, som om de vore ett</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>K&amp;listra in</translation>
    </message>
    <message>
        <source>What was copied as a new layer: paint where it was, or a picture of another program as dry paint</source>
        <translation>Det kopierade som ett nytt lager: färg där den var, eller ett annat programs bild som torr färg</translation>
    </message>
    <message>
        <source>Paste &amp;at cursor</source>
        <translation>Klistra in vid m&amp;arkören</translation>
    </message>
    <message>
        <source>The same, with the middle of the copied paint where the pointer is</source>
        <translation>Detsamma, med den kopierade färgens mitt där pekaren är</translation>
    </message>
    <message>
        <source>Mirror image &amp;horizontally</source>
        <translation>Spegla bilden &amp;vågrätt</translation>
    </message>
    <message>
        <source>Left and right of the whole painting change places, canvas and all</source>
        <translation>Vänster och höger i hela målningen byter plats, med duk och allt</translation>
    </message>
    <message>
        <source>Mirror image &amp;vertically</source>
        <translation>Spegla bilden &amp;lodrätt</translation>
    </message>
    <message>
        <source>Top and bottom of the whole painting change places, canvas and all</source>
        <translation>Upptill och nertill i hela målningen byter plats, med duk och allt</translation>
    </message>
    <message>
        <source>Rotate image 90° to the &amp;right</source>
        <translation>Rotera bilden 90° åt &amp;höger</translation>
    </message>
    <message>
        <source>The whole painting stands on its right side</source>
        <translation>Hela målningen ställs på sin högra sida</translation>
    </message>
    <message>
        <source>Rotate image 90° to the &amp;left</source>
        <translation>Rotera bilden 90° åt &amp;vänster</translation>
    </message>
    <message>
        <source>The whole painting stands on its left side</source>
        <translation>Hela målningen ställs på sin vänstra sida</translation>
    </message>
    <message>
        <source>Rotate image &amp;180°</source>
        <translation>Rotera bilden &amp;180°</translation>
    </message>
    <message>
        <source>The whole painting stands on its head</source>
        <translation>Hela målningen ställs upp och ner</translation>
    </message>
    <message>
        <source>F&amp;ill with the paint in hand</source>
        <translation>&amp;Fyll med färgen i handen</translation>
    </message>
    <message>
        <source>Pour an even film of wet paint over what is selected, or over the whole canvas</source>
        <translation>Häll ett jämnt skikt våt färg över det som är markerat, eller över hela duken</translation>
    </message>
    <message>
        <source>Fill with the s&amp;econd paint</source>
        <translation>Fyll med den &amp;andra färgen</translation>
    </message>
    <message>
        <source>Pour an even film of the second paint over what is selected</source>
        <translation>Häll ett jämnt skikt av den andra färgen över det som är markerat</translation>
    </message>
    <message>
        <source>&amp;Gradient of the two paints</source>
        <translation>&amp;Övergång mellan de två färgerna</translation>
    </message>
    <message>
        <source>Drag a line: the film goes from the paint in hand to the second one along it</source>
        <translation>Dra en linje: skiktet går längs den från färgen i handen till den andra</translation>
    </message>
    <message>
        <source>&amp;Thickness of fills...</source>
        <translation>Fyllningarnas &amp;tjocklek...</translation>
    </message>
    <message>
        <source>How thick a film of paint fills and gradients pour</source>
        <translation>Hur tjockt skikt av färg som fyllningar och övergångar häller</translation>
    </message>
    <message>
        <source>Elli&amp;pse</source>
        <translation>Elli&amp;ps</translation>
    </message>
    <message>
        <source>Drag an ellipse that tools keep to; Shift adds, Alt takes away, Ctrl makes a circle</source>
        <translation>Dra en ellips som verktygen håller sig inom; Shift lägger till, Alt tar bort, Ctrl ger en cirkel</translation>
    </message>
    <message>
        <source>Pol&amp;ygon</source>
        <translation>Pol&amp;ygon</translation>
    </message>
    <message>
        <source>Click the corners of what tools keep to; Enter or a double click closes it</source>
        <translation>Klicka hörnen av det som verktygen ska hålla sig inom; Enter eller ett dubbelklick sluter det</translation>
    </message>
    <message>
        <source>&amp;Contiguous colour</source>
        <translation>&amp;Sammanhängande färg</translation>
    </message>
    <message>
        <source>Click a colour: what hangs together there is selected; drag for more or less of it</source>
        <translation>Klicka på en färg: det som hänger ihop där markeras; dra för mer eller mindre av den</translation>
    </message>
    <message>
        <source>&amp;Similar colour</source>
        <translation>&amp;Liknande färg</translation>
    </message>
    <message>
        <source>Click a colour: it is selected wherever it is; drag for more or less of it</source>
        <translation>Klicka på en färg: den markeras överallt; dra för mer eller mindre av den</translation>
    </message>
    <message>
        <source>&amp;Grow...</source>
        <translation>&amp;Utvidga...</translation>
    </message>
    <message>
        <source>Make the selection wider on all sides</source>
        <translation>Gör markeringen bredare åt alla håll</translation>
    </message>
    <message>
        <source>Shri&amp;nk...</source>
        <translation>Kry&amp;mp...</translation>
    </message>
    <message>
        <source>Make the selection narrower on all sides</source>
        <translation>Gör markeringen smalare från alla håll</translation>
    </message>
    <message>
        <source>&amp;Border...</source>
        <translation>&amp;Kant...</translation>
    </message>
    <message>
        <source>Select a band along the outline of the selection</source>
        <translation>Markera ett band längs markeringens kontur</translation>
    </message>
    <message>
        <source>&amp;From the layer</source>
        <translation>&amp;Från lagret</translation>
    </message>
    <message>
        <source>Select where the layer has paint, wet or dry</source>
        <translation>Markera där lagret har färg, våt eller torr</translation>
    </message>
    <message>
        <source>Brush e&amp;ditor...</source>
        <translation>Penselre&amp;digerare...</translation>
    </message>
    <message>
        <source>Every number of the tool in hand, and the stroke that it paints</source>
        <translation>Varje tal hos verktyget i handen, och draget som det målar</translation>
    </message>
    <message>
        <source>&amp;Favourite</source>
        <translation>&amp;Favorit</translation>
    </message>
    <message>
        <source>Keep the tool in hand among your favourites, which the list can show alone</source>
        <translation>Behåll verktyget i handen bland dina favoriter, som listan kan visa för sig</translation>
    </message>
    <message>
        <source>&amp;Import tools...</source>
        <translation>&amp;Importera verktyg...</translation>
    </message>
    <message>
        <source>Add the tools of a bundle to your own</source>
        <translation>Lägg till verktygen i en samling till dina egna</translation>
    </message>
    <message>
        <source>E&amp;xport my tools...</source>
        <translation>E&amp;xportera mina verktyg...</translation>
    </message>
    <message>
        <source>Write all tools of your own into a bundle, a file to keep or to give away</source>
        <translation>Skriv alla dina egna verktyg till en samling, en fil att behålla eller ge bort</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fönster</translation>
    </message>
    <message>
        <source>Save a &amp;version</source>
        <translation>Spara en &amp;version</translation>
    </message>
    <message>
        <source>Go on in a file of the next number beside this one, which stays as it is</source>
        <translation>Fortsätt i en fil med nästa nummer bredvid den här, som förblir som den är</translation>
    </message>
    <message>
        <source>Close the pain&amp;ting</source>
        <translation>Stäng m&amp;ålningen</translation>
    </message>
    <message>
        <source>Put the painting away; the start page says what there is to go on with</source>
        <translation>Ställ undan målningen; startsidan visar vad du kan fortsätta med</translation>
    </message>
    <message>
        <source>Scale image to &amp;new size...</source>
        <translation>Skala bilden till &amp;ny storlek...</translation>
    </message>
    <message>
        <source>Draw the whole painting out, or make it of finer or coarser pixels</source>
        <translation>Gör hela målningen större eller mindre, eller med finare eller grövre pixlar</translation>
    </message>
    <message>
        <source>Toned g&amp;round...</source>
        <translation>Tonad g&amp;rund...</translation>
    </message>
    <message>
        <source>Cover the whole canvas with a dry coat of the paint in hand, below all layers</source>
        <translation>Täck hela duken med ett torrt lager av färgen i handen, under alla lager</translation>
    </message>
    <message>
        <source>Full scr&amp;een</source>
        <translation>H&amp;elskärm</translation>
    </message>
    <message>
        <source>The window on the whole screen, without the bars of the desktop</source>
        <translation>Fönstret över hela skärmen, utan skrivbordets lister</translation>
    </message>
    <message>
        <source>S&amp;quint</source>
        <translation>&amp;Kisa</translation>
    </message>
    <message>
        <source>The painting as with half-closed eyes: large shapes without their details</source>
        <translation>Målningen som med halvslutna ögon: stora former utan detaljer</translation>
    </message>
    <message>
        <source>&amp;Brushes panel</source>
        <translation>&amp;Penselpanel</translation>
    </message>
    <message>
        <source>The tools to paint with, how wide they are and how steady they keep</source>
        <translation>Verktygen att måla med, hur breda de är och hur stadigt de går</translation>
    </message>
    <message>
        <source>&amp;Paints panel</source>
        <translation>&amp;Färgpanel</translation>
    </message>
    <message>
        <source>The tubes of paint</source>
        <translation>Färgtuberna</translation>
    </message>
    <message>
        <source>&amp;Easel panel</source>
        <translation>&amp;Stafflipanel</translation>
    </message>
    <message>
        <source>How the canvas stands, where the lamp is, and how fast paint dries</source>
        <translation>Hur duken står, var lampan är och hur fort färgen torkar</translation>
    </message>
    <message>
        <source>T&amp;ool bar</source>
        <translation>V&amp;erktygsfält</translation>
    </message>
    <message>
        <source>The bar of buttons; drag it by its end to another side, or off the window</source>
        <translation>Fältet med knappar; dra det i änden till en annan sida, eller bort från fönstret</translation>
    </message>
    <message>
        <source>&amp;New window</source>
        <translation>&amp;Nytt fönster</translation>
    </message>
    <message>
        <source>Another window, with an easel of its own</source>
        <translation>Ett fönster till, med ett eget staffli</translation>
    </message>
    <message>
        <source>S&amp;ketch</source>
        <translation>S&amp;kiss</translation>
    </message>
    <message>
        <source>Brushes and paints beside a large canvas, and nothing else</source>
        <translation>Penslar och färger bredvid en stor duk, och inget annat</translation>
    </message>
    <message>
        <source>&amp;Oil</source>
        <translation>&amp;Olja</translation>
    </message>
    <message>
        <source>Brushes, paints and easel beside the tool and the layers</source>
        <translation>Penslar, färger och staffli, med verktyget och lagren</translation>
    </message>
    <message>
        <source>&amp;Mixing</source>
        <translation>&amp;Blandning</translation>
    </message>
    <message>
        <source>Paints, colours and what the paint is like, beside a large mixing well</source>
        <translation>Färger, kulörer och hur färgen är, bredvid en stor blandningsyta</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Export</translation>
    </message>
    <message>
        <source>Lights, layers, the whole canvas and its recording, to finish a painting</source>
        <translation>Ljus, lager, hela duken och dess inspelning, för att göra en målning färdig</translation>
    </message>
    <message>
        <source>&amp;Save the workspace...</source>
        <translation>&amp;Spara arbetsytan...</translation>
    </message>
    <message>
        <source>Keep the panels as they stand now, under a name of your own</source>
        <translation>Behåll panelerna som de står nu, under ett eget namn</translation>
    </message>
    <message>
        <source>&amp;Rename the workspace...</source>
        <translation>&amp;Byt namn på arbetsytan...</translation>
    </message>
    <message>
        <source>Give your own workspace that is in use another name</source>
        <translation>Ge din egen arbetsyta som används ett annat namn</translation>
    </message>
    <message>
        <source>Remo&amp;ve the workspace</source>
        <translation>&amp;Ta bort arbetsytan</translation>
    </message>
    <message>
        <source>Forget your own workspace that is in use; the panels stay as they stand</source>
        <translation>Glöm din egen arbetsyta som används; panelerna står kvar</translation>
    </message>
    <message>
        <source>&amp;Left-handed</source>
        <translation>&amp;Vänsterhänt</translation>
    </message>
    <message>
        <source>What stands on the left changes places with what stands on the right</source>
        <translation>Det som står till vänster byter plats med det som står till höger</translation>
    </message>
    <message>
        <source>Show me &amp;round</source>
        <translation>Visa mig &amp;runt</translation>
    </message>
    <message>
        <source>Three steps: paint, move the canvas, take other paint</source>
        <translation>Tre steg: måla, flytta duken, ta en annan färg</translation>
    </message>
    <message>
        <source>Rotate &amp;image...</source>
        <translation>Rotera &amp;bilden...</translation>
    </message>
    <message>
        <source>Turn the whole painting by any angle, to put a horizon straight</source>
        <translation>Vrid hela målningen hur mycket som helst, till exempel så att en horisont blir rak</translation>
    </message>
    <message>
        <source>Te&amp;xture paste...</source>
        <translation>Te&amp;xturpasta...</translation>
    </message>
    <message>
        <source>Lay a dry relief of the paint in hand: sand, modelling paste, or a picture pressed in</source>
        <translation>Lägg en torr relief av färgen i handen: sand, modelleringspasta eller en intryckt bild</translation>
    </message>
    <message>
        <source>Lock &amp;what is bare</source>
        <translation>Lås det som är &amp;bart</translation>
    </message>
    <message>
        <source>Tools change the layer only where it has paint already</source>
        <translation>Verktygen ändrar lagret bara där det redan har färg</translation>
    </message>
    <message>
        <source>&amp;Masking fluid</source>
        <translation>Ma&amp;skeringsvätska</translation>
    </message>
    <message>
        <source>Paint a skin that no paint gets below, as wide as the tool in hand; Alt peels it off</source>
        <translation>Måla en hinna som ingen färg tar sig in under, lika bred som verktyget i handen; Alt drar av den</translation>
    </message>
    <message>
        <source>Masking &amp;tape</source>
        <translation>Maskerings&amp;tejp</translation>
    </message>
    <message>
        <source>Drag a strip with clean edges that no paint gets below; Alt peels it off</source>
        <translation>Dra en remsa med rena kanter som ingen färg tar sig in under; Alt drar av den</translation>
    </message>
    <message>
        <source>M&amp;ask the selection</source>
        <translation>M&amp;askera markeringen</translation>
    </message>
    <message>
        <source>Keep all paint off what is selected, until the masking is peeled off</source>
        <translation>Håll all färg borta från det som är markerat, tills maskeringen dras av</translation>
    </message>
    <message>
        <source>Select what is maske&amp;d</source>
        <translation>Markera &amp;det maskerade</translation>
    </message>
    <message>
        <source>Select all that masking fluid and tape cover</source>
        <translation>Markera allt som maskeringsvätska och tejp täcker</translation>
    </message>
    <message>
        <source>Peel off all mas&amp;king</source>
        <translation>Dra av all mas&amp;kering</translation>
    </message>
    <message>
        <source>Take all masking fluid and tape away; the paint below is as it was</source>
        <translation>Ta bort all maskeringsvätska och tejp; färgen under är som den var</translation>
    </message>
    <message>
        <source>&amp;Parallel ruler</source>
        <translation>&amp;Parallell linjal</translation>
    </message>
    <message>
        <source>Strokes run parallel to the ruler from wherever they start</source>
        <translation>Dragen löper parallellt med linjalen var de än börjar</translation>
    </message>
    <message>
        <source>&amp;Concentric ellipse</source>
        <translation>&amp;Koncentrisk ellips</translation>
    </message>
    <message>
        <source>Strokes run round the same middle from wherever they start</source>
        <translation>Dragen löper kring samma mittpunkt var de än börjar</translation>
    </message>
    <message>
        <source>&amp;1 point perspective</source>
        <translation>&amp;1-punktsperspektiv</translation>
    </message>
    <message>
        <source>Strokes run to the vanishing point, level or upright</source>
        <translation>Dragen löper mot flyktpunkten, vågrätt eller lodrätt</translation>
    </message>
    <message>
        <source>&amp;2 point perspective</source>
        <translation>&amp;2-punktsperspektiv</translation>
    </message>
    <message>
        <source>Strokes run to one of two vanishing points, or upright</source>
        <translation>Dragen löper mot en av två flyktpunkter, eller lodrätt</translation>
    </message>
    <message>
        <source>&amp;3 point perspective</source>
        <translation>&amp;3-punktsperspektiv</translation>
    </message>
    <message>
        <source>Strokes run to one of three vanishing points</source>
        <translation>Dragen löper mot en av tre flyktpunkter</translation>
    </message>
    <message>
        <source>Gri&amp;d</source>
        <translation>Rutnä&amp;t</translation>
    </message>
    <message>
        <source>Strokes run along the lines of a grid, or beside them</source>
        <translation>Dragen följer rutnätets linjer, eller löper bredvid dem</translation>
    </message>
    <message>
        <source>Snap to the &amp;guide</source>
        <translation>&amp;Fäst vid hjälplinjen</translation>
    </message>
    <message>
        <source>Without it your hand is free, and the guide only shows where to go</source>
        <translation>Utan den är handen fri, och hjälplinjen visar bara vägen</translation>
    </message>
    <message>
        <source>Take mirrors, copies and the guide away</source>
        <translation>Ta bort speglar, kopior och hjälplinjen</translation>
    </message>
    <message>
        <source>&amp;Add reference pictures...</source>
        <translation>&amp;Lägg till referensbilder...</translation>
    </message>
    <message>
        <source>Lay pictures on the board of references, to look at and to pick colours from</source>
        <translation>Lägg bilder på referenstavlan, att titta på och hämta kulörer från</translation>
    </message>
    <message>
        <source>References in a &amp;window of their own</source>
        <translation>Referenser i ett &amp;eget fönster</translation>
    </message>
    <message>
        <source>The board of references above the canvas, or among the panels</source>
        <translation>Referenstavlan ovanför duken, eller bland panelerna</translation>
    </message>
    <message>
        <source>Mirrors, rulers, perspectives and grids in numbers</source>
        <translation>Speglar, linjaler, perspektiv och rutnät i siffror</translation>
    </message>
    <message>
        <source>Re&amp;ferences panel</source>
        <translation>Re&amp;ferenspanel</translation>
    </message>
    <message>
        <source>Pictures to look at while you paint, and to pick colours from</source>
        <translation>Bilder att titta på medan du målar, och hämta kulörer från</translation>
    </message>
    <message>
        <source>Ad&amp;just dry paint...</source>
        <translation>&amp;Justera torr färg...</translation>
    </message>
    <message>
        <source>Colour adjustment of what is dry: a glaze over it, or another hue by other pigments</source>
        <translation>Färgjustering av det torra: en lasyr över det, eller en annan kulör genom andra pigment</translation>
    </message>
    <message>
        <source>Cl&amp;ip to the layer below</source>
        <translation>Begränsa t&amp;ill lagret under</translation>
    </message>
    <message>
        <source>Show the layer only where the one below has paint; the rest is hidden, and kept</source>
        <translation>Visa lagret bara där lagret under har färg; resten döljs och finns kvar</translation>
    </message>
    <message>
        <source>E&amp;verything</source>
        <translation>A&amp;llt</translation>
    </message>
    <message>
        <source>F&amp;eather...</source>
        <translation>M&amp;juk kant...</translation>
    </message>
    <message>
        <source>Make the edge of the selection soft, so that paint fades out there</source>
        <translation>Gör markeringens kant mjuk, så att färgen tonar ut där</translation>
    </message>
    <message>
        <source>All strokes once more, finer, beside the painting on the easel</source>
        <translation>Alla penseldrag en gång till, finare, bredvid målningen på staffliet</translation>
    </message>
    <message>
        <source>save incremental, iteration</source>
        <translation>spara stegvis, inkrementell</translation>
    </message>
    <message>
        <source>png, jpeg, tiff, save as a picture</source>
        <translation>png, jpeg, tiff, spara som bild</translation>
    </message>
    <message>
        <source>replay, playback</source>
        <translation>spela upp</translation>
    </message>
    <message>
        <source>video, mp4, speed painting</source>
        <translation>video, film, mp4</translation>
    </message>
    <message>
        <source>upscale, higher resolution, enlarge</source>
        <translation>skala upp, högre upplösning, förstora</translation>
    </message>
    <message>
        <source>copy visible, copy flattened</source>
        <translation>kopiera synligt</translation>
    </message>
    <message>
        <source>resize image, resolution, dpi</source>
        <translation>ändra bildstorlek, upplösning, dpi</translation>
    </message>
    <message>
        <source>resize canvas, extend, expand</source>
        <translation>ändra dukens storlek, utöka</translation>
    </message>
    <message>
        <source>trim to selection</source>
        <translation>trimma till markeringen</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>vänd, spegelvänd</translation>
    </message>
    <message>
        <source>straighten</source>
        <translation>räta upp, rotera</translation>
    </message>
    <message>
        <source>brush size, smaller</source>
        <translation>penselstorlek, mindre</translation>
    </message>
    <message>
        <source>brush size, larger, bigger</source>
        <translation>penselstorlek, större</translation>
    </message>
    <message>
        <source>dip, load</source>
        <translation>doppa, ladda</translation>
    </message>
    <message>
        <source>rinse, wash, smudge, blend</source>
        <translation>skölj, tvätta, gnid ut</translation>
    </message>
    <message>
        <source>dilute, water, thinner, solvent</source>
        <translation>späd, vatten, förtunning</translation>
    </message>
    <message>
        <source>quick menu, radial menu</source>
        <translation>snabbmeny, radialmeny</translation>
    </message>
    <message>
        <source>eyedropper, colour picker, color picker, pipette</source>
        <translation>pipett, färgväljare</translation>
    </message>
    <message>
        <source>eyedropper, color picker, pipette</source>
        <translation>pipett, färgväljare</translation>
    </message>
    <message>
        <source>brush settings, brush studio, brush engine</source>
        <translation>penselinställningar</translation>
    </message>
    <message>
        <source>bundle, brush set, resources</source>
        <translation>bunt, penselsamling</translation>
    </message>
    <message>
        <source>dryer, fast dry, dry layer</source>
        <translation>hårtork, snabbtorka</translation>
    </message>
    <message>
        <source>mixing palette, mixer, scratchpad</source>
        <translation>blandningspalett, palett</translation>
    </message>
    <message>
        <source>bucket, flood fill</source>
        <translation>färghink, fyllning</translation>
    </message>
    <message>
        <source>bucket, background fill</source>
        <translation>färghink, bakgrund</translation>
    </message>
    <message>
        <source>imprimatura, background, gesso</source>
        <translation>imprimatur, bakgrund, gesso</translation>
    </message>
    <message>
        <source>import layer, insert image, place image</source>
        <translation>importera lager, infoga bild</translation>
    </message>
    <message>
        <source>delete layer</source>
        <translation>ta bort lager, radera</translation>
    </message>
    <message>
        <source>free transform, scale, rotate, distort, perspective, skew, move tool</source>
        <translation>fri omvandling, skala, rotera, förvräng, perspektiv, skeva</translation>
    </message>
    <message>
        <source>saturation, hsv, colour balance, color balance</source>
        <translation>mättnad, färgbalans</translation>
    </message>
    <message>
        <source>merge visible, merge all</source>
        <translation>slå ihop synliga</translation>
    </message>
    <message>
        <source>folder, quick group</source>
        <translation>mapp, snabbgrupp</translation>
    </message>
    <message>
        <source>alpha lock, lock transparency</source>
        <translation>alfalås, lås transparens</translation>
    </message>
    <message>
        <source>clipping mask, clipping group, inherit alpha</source>
        <translation>urklippsmask, ärv alfa</translation>
    </message>
    <message>
        <source>marquee, rectangular selection</source>
        <translation>rektangulär markering</translation>
    </message>
    <message>
        <source>marquee, elliptical selection, oval, circle</source>
        <translation>elliptisk markering, oval, cirkel</translation>
    </message>
    <message>
        <source>freehand selection</source>
        <translation>frihandsmarkering</translation>
    </message>
    <message>
        <source>magic wand, automatic selection</source>
        <translation>trollstav, automatisk markering</translation>
    </message>
    <message>
        <source>magic wand, colour range, color range</source>
        <translation>trollstav, färgintervall</translation>
    </message>
    <message>
        <source>deselect, select none, select all</source>
        <translation>avmarkera, markera allt</translation>
    </message>
    <message>
        <source>inverse</source>
        <translation>invertera, omvänd</translation>
    </message>
    <message>
        <source>expand</source>
        <translation>utvidga</translation>
    </message>
    <message>
        <source>contract</source>
        <translation>dra ihop</translation>
    </message>
    <message>
        <source>soften, blur edge</source>
        <translation>mjuk kant</translation>
    </message>
    <message>
        <source>select opaque, alpha to selection</source>
        <translation>markera opakt, alfa till markering</translation>
    </message>
    <message>
        <source>frisket, liquid mask, drawing gum</source>
        <translation>frisket, gummi, maskera</translation>
    </message>
    <message>
        <source>frisket, stencil</source>
        <translation>frisket, schablon</translation>
    </message>
    <message>
        <source>frisket, stencil, protect</source>
        <translation>frisket, schablon, skydda</translation>
    </message>
    <message>
        <source>remove frisket</source>
        <translation>ta bort frisket</translation>
    </message>
    <message>
        <source>marching ants, display selection</source>
        <translation>myrkrig, visa markering</translation>
    </message>
    <message>
        <source>symmetry tool, multibrush</source>
        <translation>symmetri, multipensel</translation>
    </message>
    <message>
        <source>radial symmetry, multibrush, mandala</source>
        <translation>radiell symmetri, multipensel, mandala</translation>
    </message>
    <message>
        <source>assistant, straight line, drawing guide</source>
        <translation>assistent, rak linje, ritguide</translation>
    </message>
    <message>
        <source>assistant, drawing guide</source>
        <translation>assistent, ritguide</translation>
    </message>
    <message>
        <source>assistant, vanishing point</source>
        <translation>assistent, flyktpunkt</translation>
    </message>
    <message>
        <source>assistant, snapping</source>
        <translation>assistent, fäst</translation>
    </message>
    <message>
        <source>tracing paper, light table, template</source>
        <translation>kalkerpapper, ljusbord, mall</translation>
    </message>
    <message>
        <source>reference image, mood board</source>
        <translation>referensbild, moodboard</translation>
    </message>
    <message>
        <source>flip canvas</source>
        <translation>vänd duken</translation>
    </message>
    <message>
        <source>hide panels, canvas-only mode</source>
        <translation>dölj paneler</translation>
    </message>
    <message>
        <source>greyscale, grayscale, black and white, desaturate</source>
        <translation>gråskala, svartvitt</translation>
    </message>
    <message>
        <source>cmyk, print preview</source>
        <translation>cmyk, utskriftsförhandsvisning</translation>
    </message>
    <message>
        <source>brush library, presets</source>
        <translation>penselbibliotek, förinställningar</translation>
    </message>
    <message>
        <source>gravity, drips, canvas tilt</source>
        <translation>tyngdkraft, droppar, lutning</translation>
    </message>
    <message>
        <source>color wheel, colour selector, swatches</source>
        <translation>färghjul, färgväljare, färgprov</translation>
    </message>
    <message>
        <source>gloss, impasto, bump</source>
        <translation>glans, impasto</translation>
    </message>
    <message>
        <source>overview</source>
        <translation>översikt</translation>
    </message>
    <message>
        <source>default layout, reset workspace</source>
        <translation>standardlayout, återställ</translation>
    </message>
    <message>
        <source>search actions</source>
        <translation>sök åtgärder</translation>
    </message>
    <message>
        <source>shortcuts, hotkeys, keyboard</source>
        <translation>kortkommandon, genvägar, tangentbord</translation>
    </message>
    <message>
        <source>preferences, configure, options, theme, language</source>
        <translation>inställningar, alternativ, tema, språk</translation>
    </message>
    <message>
        <source>stylus, pressure curve</source>
        <translation>styluspenna, tryckkurva</translation>
    </message>
    <message>
        <source>tutorial, getting started</source>
        <translation>handledning, kom igång</translation>
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
        <translation>%1 × %2 pixlar för %3 × %4 mm, vilket är %5 pixlar per tum.</translation>
    </message>
    <message>
        <source>Four files of %1 × %2 pixels, %3 to %4.</source>
        <translation>Fyra filer på %1 × %2 pixlar, %3 till %4.</translation>
    </message>
    <message>
        <source>A solid of %1 × %2 mm; its front has %3 × %4 points, %5 mm apart.</source>
        <translation>En solid kropp på %1 × %2 mm; framsidan har %3 × %4 punkter, %5 mm emellan.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of painting become %2 of film: %n frame(s) of %3 × %4 pixels.</source>
        <translation>
            <numerusform>%1 målande blir %2 film: %n bildruta på %3 × %4 pixlar.</numerusform>
            <numerusform>%1 målande blir %2 film: %n bildrutor på %3 × %4 pixlar.</numerusform>
        </translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Spara</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersätt</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Spara som...</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::AdjustDialog</name>
    <message>
        <source>The medium in hand leaves next to nothing when it dries.</source>
        <translation>Mediet i handen lämnar nästan ingenting när det torkar.</translation>
    </message>
    <message>
        <source>Adjust dry paint</source>
        <translation>Justera torr färg</translation>
    </message>
    <message>
        <source>The dry paint of the layer that you paint on takes another colour, where it is selected or all over. Wet paint stays as it is.</source>
        <translation>Den torra färgen på lagret som du målar på får en annan kulör, där det är markerat eller överallt. Våt färg förblir som den är.</translation>
    </message>
    <message>
        <source>As a glaze</source>
        <translation>Som en lasyr</translation>
    </message>
    <message>
        <source>As other pigments</source>
        <translation>Som andra pigment</translation>
    </message>
    <message>
        <source>Adjust</source>
        <translation>Justera</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Tjocklek</translation>
    </message>
    <message>
        <source> µm</source>
        <translation> µm</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Andel</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>The mean colour as it is</source>
        <translation>Medelkulören som den är</translation>
    </message>
    <message>
        <source>The mean colour after it is adjusted</source>
        <translation>Medelkulören efter justeringen</translation>
    </message>
    <message>
        <source>Before, after</source>
        <translation>Före, efter</translation>
    </message>
    <message>
        <source>A thin even coat of the paint in hand dries over it, and what lies below shows through. It is as thick as this when it is dry.</source>
        <translation>Ett tunt jämnt skikt av färgen i handen torkar över det, och det som ligger under lyser igenom. Så här tjockt är det när det är torrt.</translation>
    </message>
    <message>
        <source>So much of the dry paint is taken out and replaced by the paint in hand, which is stirred in. It stays as thick as it is.</source>
        <translation>Så mycket av den torra färgen tas bort och ersätts av färgen i handen, som rörs in. Den förblir lika tjock.</translation>
    </message>
    <message>
        <source>&amp;Preview</source>
        <translation>&amp;Förhandsvisning</translation>
    </message>
    <message>
        <source>Show on the canvas what comes of it</source>
        <translation>Visa på duken vad det blir</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CanvasSizeDialog</name>
    <message>
        <source>The upper left corner stays where it is</source>
        <translation>Övre vänstra hörnet ligger kvar</translation>
    </message>
    <message>
        <source>The middle of the upper edge stays where it is</source>
        <translation>Överkantens mitt ligger kvar</translation>
    </message>
    <message>
        <source>The upper right corner stays where it is</source>
        <translation>Övre högra hörnet ligger kvar</translation>
    </message>
    <message>
        <source>The middle of the left edge stays where it is</source>
        <translation>Vänsterkantens mitt ligger kvar</translation>
    </message>
    <message>
        <source>The middle stays where it is</source>
        <translation>Mitten ligger kvar</translation>
    </message>
    <message>
        <source>The middle of the right edge stays where it is</source>
        <translation>Högerkantens mitt ligger kvar</translation>
    </message>
    <message>
        <source>The lower left corner stays where it is</source>
        <translation>Nedre vänstra hörnet ligger kvar</translation>
    </message>
    <message>
        <source>The middle of the lower edge stays where it is</source>
        <translation>Underkantens mitt ligger kvar</translation>
    </message>
    <message>
        <source>The lower right corner stays where it is</source>
        <translation>Nedre högra hörnet ligger kvar</translation>
    </message>
    <message>
        <source>%1 mm on the left</source>
        <translation>%1 mm till vänster</translation>
    </message>
    <message>
        <source>%1 mm on the right</source>
        <translation>%1 mm till höger</translation>
    </message>
    <message>
        <source>%1 mm at the top</source>
        <translation>%1 mm upptill</translation>
    </message>
    <message>
        <source>%1 mm at the bottom</source>
        <translation>%1 mm nedtill</translation>
    </message>
    <message>
        <source>Added: %1.</source>
        <translation>Läggs till: %1.</translation>
    </message>
    <message>
        <source>Cut off: %1. What lies there is wiped off.</source>
        <translation>Skärs av: %1. Det som ligger där torkas bort.</translation>
    </message>
    <message>
        <source>Canvas size</source>
        <translation>Dukstorlek</translation>
    </message>
    <message>
        <source>Change the size</source>
        <translation>Ändra storleken</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Bredd</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höjd</translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation>Ligger kvar</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The canvas has this size.</source>
        <translation>Duken har den här storleken.</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels.
%3</source>
        <translation>En bild på %1 × %2 pixlar.
%3</translation>
    </message>
    <message>
        <source>Other units may be typed as well: 50 cm, 20 in, 3000 px</source>
        <translation>Det går också att skriva andra enheter: 50 cm, 20 in, 3000 px</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>Vad vill du göra?</translation>
    </message>
    <message>
        <source>Not now: %1</source>
        <translation>Inte nu: %1</translation>
    </message>
    <message>
        <source>Nothing of that name. Fewer letters find more.</source>
        <translation>Det finns inget med det namnet. Färre bokstäver hittar fler.</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CrashDialog</name>
    <message>
        <source>Pastoso failed the last time</source>
        <translation>Pastoso kraschade förra gången</translation>
    </message>
    <message>
        <source>We are sorry. What you had painted was kept and is offered to you next. This report says where the program was; it tells nothing of your painting. With it the mistake can be found.</source>
        <translation>Vi beklagar. Det du hade målat är bevarat och erbjuds dig strax. Den här rapporten talar om var programmet befann sig; den säger inget om din målning. Med den går felet att hitta.</translation>
    </message>
    <message>
        <source>It is kept as %1.</source>
        <translation>Den är sparad som %1.</translation>
    </message>
    <message>
        <source>Copy the report</source>
        <translation>Kopiera rapporten</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::ExportDialog</name>
    <message>
        <source>Where the folder is put</source>
        <translation>Var mappen läggs</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportera</translation>
    </message>
    <message>
        <source>;;All files (*)</source>
        <translation>;;Alla filer (*)</translation>
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
        <translation>ICC-profil...</translation>
    </message>
    <message>
        <source>ICC profile</source>
        <translation>ICC-profil</translation>
    </message>
    <message>
        <source>ICC profiles (*.icc *.icm);;All files (*)</source>
        <translation>ICC-profiler (*.icc *.icm);;Alla filer (*)</translation>
    </message>
    <message>
        <source>What the painting looks like.</source>
        <translation>Hur målningen ser ut.</translation>
    </message>
    <message>
        <source>The picture, and of every layer its colours, normals, heights in mm, wetness, gloss and cover, as channels of one file.</source>
        <translation>Bilden, och för varje lager dess färger, normaler, höjder i mm, våthet, glans och täckning, som kanaler i en fil.</translation>
    </message>
    <message>
        <source>Base colour, normal (OpenGL, +Y up), height and roughness, a file for each.</source>
        <translation>Grundfärg, normaler (OpenGL, +Y uppåt), höjd och strävhet, en fil för var och en.</translation>
    </message>
    <message>
        <source>The paint as it stands on the canvas: a closed solid in millimetres.</source>
        <translation>Färgen som den ligger på duken: en sluten solid kropp i millimeter.</translation>
    </message>
    <message>
        <source>How the painting came about. It is painted once more, which takes a while.</source>
        <translation>Hur målningen kom till. Den målas en gång till, vilket tar en stund.</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Mapp</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersätt</translation>
    </message>
    <message>
        <source>What the file is; its name ends accordingly</source>
        <translation>Filens format; namnet får motsvarande ändelse</translation>
    </message>
    <message>
        <source>What is made of the painting</source>
        <translation>Vad som görs av målningen</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Layers, for compositing</source>
        <translation>Lager, för kompositing</translation>
    </message>
    <message>
        <source>Maps, for 3D programs</source>
        <translation>Texturkartor, för 3D-program</translation>
    </message>
    <message>
        <source>Relief, for 3D printing</source>
        <translation>Relief, för 3D-utskrift</translation>
    </message>
    <message>
        <source>Time-lapse</source>
        <translation>Timelapse</translation>
    </message>
    <message>
        <source>Where it is put; the ending of the name chooses the format</source>
        <translation>Var den läggs; namnets ändelse väljer formatet</translation>
    </message>
    <message>
        <source>&amp;Browse...</source>
        <translation>&amp;Bläddra...</translation>
    </message>
    <message>
        <source>1 is a small file, 100 a fine picture</source>
        <translation>1 är en liten fil, 100 en fin bild</translation>
    </message>
    <message>
        <source>What the picture is of</source>
        <translation>Vad bilden visar</translation>
    </message>
    <message>
        <source>The canvas</source>
        <translation>Duken</translation>
    </message>
    <message>
        <source>The mixing well</source>
        <translation>Blandningsytan</translation>
    </message>
    <message>
        <source>&amp;Light and shade</source>
        <translation>L&amp;jus och skugga</translation>
    </message>
    <message>
        <source>As the window shows the painting; otherwise the paint&apos;s own colours, as a scan would have them</source>
        <translation>Som fönstret visar målningen; annars färgens egna kulörer, som en skanning återger dem</translation>
    </message>
    <message>
        <source> px wide</source>
        <translation> px bred</translation>
    </message>
    <message>
        <source>The width that the scale comes to, or the scale that gives this width</source>
        <translation>Bredden som skalan ger, eller skalan som ger den här bredden</translation>
    </message>
    <message>
        <source>What the numbers in the file mean; the file says so too. sRGB is for common screens, Display P3 for screens of wide gamut, an ICC profile for a printer</source>
        <translation>Vad talen i filen betyder; det står också i filen. sRGB är för vanliga skärmar, Display P3 för skärmar med brett färgomfång, en ICC-profil för en skrivare</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Thickness from the flat back to the lowest level of the canvas</source>
        <translation>Tjockleken från den plana baksidan till dukens lägsta nivå</translation>
    </message>
    <message>
        <source> times as high</source>
        <translation> gånger höjden</translation>
    </message>
    <message>
        <source>1 is the relief as it is painted, 2 twice as high; width and height stay</source>
        <translation>1 är reliefen som den är målad, 2 dubbelt så hög; bredd och höjd ändras inte</translation>
    </message>
    <message>
        <source> mm apart</source>
        <translation> mm emellan</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatiskt</translation>
    </message>
    <message>
        <source> times as fast</source>
        <translation> gånger så fort</translation>
    </message>
    <message>
        <source>Seconds of painting in a second of film</source>
        <translation>Sekunder av målande per sekund film</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> per sekund</translation>
    </message>
    <message>
        <source>Frames in a second of film</source>
        <translation>Bildrutor per sekund film</translation>
    </message>
    <message>
        <source>&amp;Make</source>
        <translation>&amp;Skapa</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>F&amp;ormat</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Kvalitet</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>&amp;Visa</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>Ska&amp;la</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Färger</translation>
    </message>
    <message>
        <source>&amp;Thickness</source>
        <translation>&amp;Tjocklek</translation>
    </message>
    <message>
        <source>&amp;Heights</source>
        <translation>&amp;Höjder</translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation>&amp;Punkter</translation>
    </message>
    <message>
        <source>Sp&amp;eed</source>
        <translation>Hasti&amp;ghet</translation>
    </message>
    <message>
        <source>F&amp;rames</source>
        <translation>Bil&amp;drutor</translation>
    </message>
    <message>
        <source>&amp;File name</source>
        <translation>F&amp;ilnamn</translation>
    </message>
    <message>
        <source> px/mm</source>
        <translation> px/mm</translation>
    </message>
    <message>
        <source>as it was painted</source>
        <translation>som den målades</translation>
    </message>
    <message>
        <source>Canvas of &amp;it</source>
        <translation>D&amp;ukens upplösning</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source>1 as the window paints it, 2 twice as wide and high: finer, not merely enlarged</source>
        <translation>1 är som fönstret målar, 2 dubbelt så bred och hög: finare, inte bara förstorad</translation>
    </message>
    <message>
        <source>Width of the picture in pixels</source>
        <translation>Bildens bredd i pixlar</translation>
    </message>
    <message>
        <source>Distance between two points of the surface; 0 is as far as the pixels, or farther where the canvas is large</source>
        <translation>Avståndet mellan två punkter på ytan; 0 är lika långt som mellan pixlarna, eller längre om duken är stor</translation>
    </message>
    <message>
        <source>Pixels in a millimetre of the canvas that it is painted on once more: more show finer paint and take longer; 0 is as it was painted</source>
        <translation>Pixlar per millimeter duk när den målas på nytt: fler ger finare färg och tar längre tid; 0 är som den målades</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::KeyCatcher</name>
    <message>
        <source>Press the keys... (Esc: none)</source>
        <translation>Tryck på tangenterna... (Esc: inga)</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>Kortkommandon</translation>
    </message>
    <message>
        <source>What the keys are to start with; keys of your own stay</source>
        <translation>Vilka kortkommandon du utgår från; dina egna ligger kvar</translation>
    </message>
    <message>
        <source>Find by words, or by keys such as Ctrl+J</source>
        <translation>Sök med ord, eller med tangenter som Ctrl+J</translation>
    </message>
    <message>
        <source>Click, and press other keys</source>
        <translation>Klicka, och tryck på andra tangenter</translation>
    </message>
    <message>
        <source>Add a key</source>
        <translation>Lägg till en tangent</translation>
    </message>
    <message>
        <source>As the set has it</source>
        <translation>Som i uppsättningen</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>Låt bli</translation>
    </message>
    <message>
        <source>Forget all my own keys</source>
        <translation>Glöm alla mina egna kortkommandon</translation>
    </message>
    <message>
        <source>Click, and press other keys in place of these</source>
        <translation>Klicka, och tryck på andra tangenter i stället för dessa</translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation>Ta bort %1</translation>
    </message>
    <message>
        <source>%1 is needed on the canvas itself: it can be given to no command. Choose another key.</source>
        <translation>%1 behövs på själva duken och kan inte ges till något kommando. Välj en annan tangent.</translation>
    </message>
    <message>
        <source>%1 is its key already.</source>
        <translation>%1 är redan dess tangent.</translation>
    </message>
    <message>
        <source>%1 is the key of &quot;%2&quot;.</source>
        <translation>%1 används av ”%2”.</translation>
    </message>
    <message>
        <source>Take it from there</source>
        <translation>Ta den därifrån</translation>
    </message>
    <message>
        <source>%1 stays with &quot;%2&quot;, which you gave it to.</source>
        <translation>%1 stannar hos ”%2”, som du gav den till.</translation>
    </message>
    <message>
        <source>All keys will be as the set &quot;%1&quot; has them.</source>
        <translation>Alla kortkommandon blir som i uppsättningen ”%1”.</translation>
    </message>
    <message>
        <source>Forget my own</source>
        <translation>Glöm mina egna</translation>
    </message>
    <message>
        <source>Set of keys</source>
        <translation>Uppsättning kortkommandon</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Kommandon</translation>
    </message>
    <message>
        <source>No command has such words or keys.</source>
        <translation>Inget kommando har sådana ord eller tangenter.</translation>
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
        <translation>Ny duk</translation>
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
        <translation>Höjdbild...</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höjd</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Upplösning</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Underlag</translation>
    </message>
    <message>
        <source>Height image: white is high</source>
        <translation>Höjdbild: vitt är högt</translation>
    </message>
    <message>
        <source>Image: %1</source>
        <translation>Bild: %1</translation>
    </message>
    <message>
        <source>For large forms: brush marks blur.</source>
        <translation>För stora former: penselspår suddas ut.</translation>
    </message>
    <message>
        <source>Bristle marks of broad brushes show; close up, edges are soft.</source>
        <translation>Breda penslars borstspår syns; på nära håll är kanterna mjuka.</translation>
    </message>
    <message>
        <source>Every bristle and thread shows close up, in fine brushes as well.</source>
        <translation>Varje borst och tråd syns på nära håll, även med fina penslar.</translation>
    </message>
    <message>
        <source>This machine keeps pace with the hand.</source>
        <translation>Den här datorn hinner med handen.</translation>
    </message>
    <message>
        <source>Bristle marks and the weave show.</source>
        <translation>Borstspår och väven syns.</translation>
    </message>
    <message>
        <source>Dots per inch may be typed as well: 127 dpi</source>
        <translation>Det går också att skriva punkter per tum: 127 dpi</translation>
    </message>
    <message>
        <source>This machine keeps pace with the hand up to %1 px/mm; what is painted can be painted again finer.</source>
        <translation>Den här datorn hinner med handen upp till %1 px/mm; det som är målat kan målas om finare.</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels, %3 dpi; up to %4 MB of memory when all of it is wet.</source>
        <translation>En bild på %1 × %2 pixlar, %3 dpi; upp till %4 MB minne när allt är vått.</translation>
    </message>
    <message>
        <source>Other units may be typed as well: 50 cm, 20 in, 3000 px</source>
        <translation>Det går också att skriva andra enheter: 50 cm, 20 in, 3000 px</translation>
    </message>
    <message>
        <source>Toned ground</source>
        <translation>Tonad grund</translation>
    </message>
    <message>
        <source>A dry coat of the paint in hand covers the whole canvas, on a layer of its own</source>
        <translation>Ett torrt skikt av färgen i handen täcker hela duken, på ett eget lager</translation>
    </message>
    <message>
        <source>0.02 mm tints the canvas, 0.1 mm covers it</source>
        <translation>0,02 mm tonar duken, 0,1 mm täcker den</translation>
    </message>
    <message>
        <source>Thickness of the toned ground</source>
        <translation>Den tonade grundens tjocklek</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::RecoveryDialog</name>
    <message>
        <source>A painting without a name</source>
        <translation>En målning utan namn</translation>
    </message>
    <message>
        <source>A painting that cannot be read
%1</source>
        <translation>En målning som inte kan läsas
%1</translation>
    </message>
    <message numerus="yes">
        <source>%1
%2
%3 × %4 mm, %n change(s) not saved</source>
        <translation>
            <numerusform>%1
%2
%3 × %4 mm, %n osparad ändring</numerusform>
            <numerusform>%1
%2
%3 × %4 mm, %n osparade ändringar</numerusform>
        </translation>
    </message>
    <message>
        <source>Unfinished paintings</source>
        <translation>Oavslutade målningar</translation>
    </message>
    <message>
        <source>Pastoso ended before these were saved.</source>
        <translation>Pastoso avslutades innan de här hade sparats.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Återskapa</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Inte nu</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Kasta</translation>
    </message>
    <message>
        <source>Discard %1 for good? It is nowhere else.</source>
        <translation>Kasta %1 för gott? Den finns ingen annanstans.</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::RepaintDialog</name>
    <message>
        <source>Paint it again</source>
        <translation>Måla om det</translation>
    </message>
    <message>
        <source> px/mm</source>
        <translation> px/mm</translation>
    </message>
    <message>
        <source>&amp;Pixels per millimetre</source>
        <translation>&amp;Pixlar per millimeter</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, which take about %3 GB of memory; %4 GB are free. The strokes are painted again beside the painting on the easel, which stays as it is.</source>
        <translation>%1 × %2 pixlar, som tar omkring %3 GB minne; %4 GB är lediga. Penseldragen målas om bredvid målningen på staffliet, som förblir som den är.</translation>
    </message>
    <message>
        <source>Dots per inch may be typed as well: 127 dpi</source>
        <translation>Det går också att skriva punkter per tum: 127 dpi</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::RotateDialog</name>
    <message>
        <source>&amp;Keep the size of the canvas</source>
        <translation>&amp;Behåll dukens storlek</translation>
    </message>
    <message>
        <source>Rotate the image</source>
        <translation>Rotera bilden</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Clockwise, about the middle of the canvas</source>
        <translation>Medurs, runt dukens mitt</translation>
    </message>
    <message>
        <source>What comes beyond the canvas is wiped off</source>
        <translation>Det som hamnar utanför duken torkas bort</translation>
    </message>
    <message>
        <source>Put the &amp;ruler straight</source>
        <translation>Räta upp efter &amp;linjalen</translation>
    </message>
    <message>
        <source>Turns until the ruler is level or upright, whichever is nearer</source>
        <translation>Vrider tills linjalen ligger vågrätt eller står lodrätt, vilket som är närmast</translation>
    </message>
    <message>
        <source>Lay a ruler along the horizon first</source>
        <translation>Lägg först en linjal längs horisonten</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Vrid</translation>
    </message>
    <message>
        <source>The image stands like this.</source>
        <translation>Bilden står redan så.</translation>
    </message>
    <message>
        <source>A canvas of %1 × %2 mm.</source>
        <translation>En duk på %1 × %2 mm.</translation>
    </message>
    <message>
        <source>What comes beyond it is wiped off.</source>
        <translation>Det som hamnar utanför den torkas bort.</translation>
    </message>
    <message>
        <source>What is new in its corners is bare.</source>
        <translation>Det som är nytt i hörnen är omålat.</translation>
    </message>
    <message>
        <source>The weave turns with the paint.</source>
        <translation>Väven vrids med färgen.</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::ScaleDialog</name>
    <message>
        <source>Paint keeps its thickness, so that there is %1 times as much of it.</source>
        <translation>Färgen behåller sin tjocklek, så det blir %1 gånger så mycket av den.</translation>
    </message>
    <message>
        <source>Keep the &amp;proportions</source>
        <translation>Behåll &amp;proportionerna</translation>
    </message>
    <message>
        <source>Scale the image</source>
        <translation>Skala bilden</translation>
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
        <translation>Det går också att skriva punkter per tum: 127 dpi</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höjd</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Upplösning</translation>
    </message>
    <message>
        <source>The image has this size and this resolution.</source>
        <translation>Bilden har den här storleken och upplösningen.</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels, %3 dpi; up to %4 MB of memory when all of it is wet.</source>
        <translation>En bild på %1 × %2 pixlar, %3 dpi; upp till %4 MB minne när allt är vått.</translation>
    </message>
    <message>
        <source>Other units may be typed as well: 50 cm, 20 in, 3000 px</source>
        <translation>Det går också att skriva andra enheter: 50 cm, 20 in, 3000 px</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::SelectRangeDialog</name>
    <message>
        <source>Select it</source>
        <translation>Markera det</translation>
    </message>
    <message>
        <source>Add it to the selection</source>
        <translation>Lägg till det i markeringen</translation>
    </message>
    <message>
        <source>Take it out of the selection</source>
        <translation>Ta bort det ur markeringen</translation>
    </message>
    <message>
        <source>Keep what is in both</source>
        <translation>Behåll det som finns i båda</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Markera</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Från</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Till</translation>
    </message>
    <message>
        <source>Do</source>
        <translation>Gör</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Nothing is there to be selected.</source>
        <translation>Det finns inget att markera.</translation>
    </message>
    <message>
        <source>Then %1 % of the canvas is selected.</source>
        <translation>Då är %1 % av duken markerad.</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Inställningar</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Utseende</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Prestanda</translation>
    </message>
    <message>
        <source>This machine</source>
        <translation>Den här datorn</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Mörkt</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Ljust</translation>
    </message>
    <message>
        <source>Both are neutral greys, so that nothing beside the canvas colours what you see on it.</source>
        <translation>Båda är neutralt grå, så att inget bredvid duken färgar det du ser på den.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Språk</translation>
    </message>
    <message>
        <source>As on the desktop</source>
        <translation>Som på skrivbordet</translation>
    </message>
    <message>
        <source>Another language speaks from the next start on.</source>
        <translation>Ett annat språk gäller från nästa start.</translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation>Ångraminne</translation>
    </message>
    <message>
        <source>The steps that you can return to. The oldest are given up when it is full; 500 are kept at most.</source>
        <translation>Stegen som du kan gå tillbaka till. De äldsta släpps när minnet är fullt; högst 500 behålls.</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Aldrig</translation>
    </message>
    <message>
        <source>Save by itself every</source>
        <translation>Spara automatiskt</translation>
    </message>
    <message>
        <source>Into the painting&apos;s own file, once it has one. Whatever you choose, every stroke is kept aside within a second and offered to you again should the program or the machine fail.</source>
        <translation>Till målningens egen fil, när den väl har en. Vad du än väljer sparas varje drag undan inom en sekund och erbjuds dig igen om programmet eller datorn skulle haverera.</translation>
    </message>
    <message>
        <source>All of the machine (%1)</source>
        <translation>Hela datorn (%1)</translation>
    </message>
    <message>
        <source>How many things the program works on at once, from the next painting on. The paint flows the same with any number.</source>
        <translation>Hur många saker programmet arbetar med samtidigt, från och med nästa målning. Färgen flyter likadant med vilket antal som helst.</translation>
    </message>
    <message>
        <source>How carefully moving paint is shown follows from how fast this machine draws; what stands still is always shown in full.</source>
        <translation>Hur noga färg i rörelse visas beror på hur snabbt den här datorn ritar; det som står stilla visas alltid i full kvalitet.</translation>
    </message>
    <message numerus="yes">
        <source> minute(s)</source>
        <translation>
            <numerusform> minut emellan</numerusform>
            <numerusform> minuter emellan</numerusform>
        </translation>
    </message>
    <message>
        <source>The canvas is drawn by</source>
        <translation>Duken ritas av</translation>
    </message>
    <message>
        <source>What is faster here</source>
        <translation>Det som är snabbast här</translation>
    </message>
    <message>
        <source>The graphics card (OpenGL)</source>
        <translation>Grafikkortet (OpenGL)</translation>
    </message>
    <message>
        <source>The processor</source>
        <translation>Processorn</translation>
    </message>
    <message>
        <source>Choose the processor where a graphics driver shows the canvas wrongly.</source>
        <translation>Välj processorn där en grafikdrivrutin visar duken fel.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Färg</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ingen</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Välj...</translation>
    </message>
    <message>
        <source>ICC profiles (*.icc *.icm);;All files (*)</source>
        <translation>ICC-profiler (*.icc *.icm);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Of the system, which has none here</source>
        <translation>Systemets, som inte har någon här</translation>
    </message>
    <message>
        <source>Of the system (%1)</source>
        <translation>Systemets (%1)</translation>
    </message>
    <message>
        <source>The screen&apos;s profile</source>
        <translation>Skärmens profil</translation>
    </message>
    <message>
        <source>None (sRGB)</source>
        <translation>Ingen (sRGB)</translation>
    </message>
    <message>
        <source>A file</source>
        <translation>En fil</translation>
    </message>
    <message>
        <source>Its file</source>
        <translation>Dess fil</translation>
    </message>
    <message>
        <source>With the profile of your screen, canvas and swatches have the same colours as on any other that is measured. Files and exports are not changed.</source>
        <translation>Med skärmens profil har duk och färgprover samma färger som på alla andra skärmar som är uppmätta. Filer och exporter ändras inte.</translation>
    </message>
    <message>
        <source>The printer&apos;s profile</source>
        <translation>Skrivarens profil</translation>
    </message>
    <message>
        <source>For &quot;Soft proof&quot; and &quot;Gamut warning&quot; in the &quot;View&quot; menu: of your printer and paper, or of your printing house.</source>
        <translation>För ”Skärmkorrektur” och ”Omfångsvarning” i menyn ”Visa”: din skrivares och ditt pappers, eller ditt tryckeris.</translation>
    </message>
    <message>
        <source>Undo and saving</source>
        <translation>Ångra och spara</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Processors in use</source>
        <translation>Processorer som används</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::TextureDialog</name>
    <message>
        <source>A&amp;nother</source>
        <translation>En a&amp;nnan</translation>
    </message>
    <message>
        <source>Texture paste</source>
        <translation>Texturpasta</translation>
    </message>
    <message>
        <source>A dry coat of the paint in hand lies on the layer that you paint on, where it is selected or all over. Brushes then catch on it.</source>
        <translation>Ett torrt skikt av färgen i handen ligger på lagret som du målar på, där det är markerat eller överallt. Penslar fastnar sedan på det.</translation>
    </message>
    <message>
        <source>Sand</source>
        <translation>Sand</translation>
    </message>
    <message>
        <source>Modelling paste</source>
        <translation>Modelleringspasta</translation>
    </message>
    <message>
        <source>A picture pressed in</source>
        <translation>En intryckt bild</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Grains</source>
        <translation>Korn</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höjd</translation>
    </message>
    <message>
        <source>Between ridges</source>
        <translation>Mellan åsarna</translation>
    </message>
    <message>
        <source>Other grains or other passes of the knife</source>
        <translation>Andra korn eller andra drag med kniven</translation>
    </message>
    <message>
        <source>Lay the paste</source>
        <translation>Lägg pastan</translation>
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
        <translation>Åt vilket håll kniven gick: 0 åt höger, 90 nedåt</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Riktning</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>What is &amp;dark stands up</source>
        <translation>Det &amp;mörka står upp</translation>
    </message>
    <message>
        <source>Picture to press in</source>
        <translation>Bild att trycka in</translation>
    </message>
    <message>
        <source>Choose a picture...</source>
        <translation>Välj en bild...</translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::TransformDialog</name>
    <message>
        <source>Transform</source>
        <translation>Transformera</translation>
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
        <translation>Flytta åt höger</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Flytta nedåt</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höjd</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Vrid</translation>
    </message>
    <message>
        <source>Clockwise, about the middle of the frame</source>
        <translation>Medurs, runt ramens mitt</translation>
    </message>
    <message>
        <source>Left–right</source>
        <translation>Vänster–höger</translation>
    </message>
    <message>
        <source>Left and right of the paint change places, before it is turned</source>
        <translation>Färgens vänstra och högra sida byter plats, innan den vrids</translation>
    </message>
    <message>
        <source>Up–down</source>
        <translation>Uppe–nere</translation>
    </message>
    <message>
        <source>Above and below change places, before the paint is turned</source>
        <translation>Uppe och nere byter plats, innan färgen vrids</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spegla</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Verkställ</translation>
    </message>
    <message>
        <source>The paint keeps its thickness and its amount.</source>
        <translation>Färgen behåller sin tjocklek och sin mängd.</translation>
    </message>
    <message>
        <source>The paint keeps its thickness: %1 % of it will be there.</source>
        <translation>Färgen behåller sin tjocklek: %1 % av den blir kvar.</translation>
    </message>
    <message>
        <source>What comes beyond the canvas is wiped off.</source>
        <translation>Det som hamnar utanför duken torkas bort.</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Hörn</translation>
    </message>
    <message>
        <source>Drag with Ctrl: a corner alone, or a side askew. By keys: Tab chooses a corner, arrows move it, with Shift by ten pixels.</source>
        <translation>Dra med Ctrl: ett hörn för sig, eller en sida på sned. Med tangenter: Tab väljer ett hörn, piltangenterna flyttar det, med Shift tio pixlar.</translation>
    </message>
</context>
<context>
    <name>pastoso::document::Table</name>
    <message>
        <source>Dry now</source>
        <translation>Torka nu</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Penseldrag</translation>
    </message>
    <message>
        <source>Paint squeezed out</source>
        <translation>Färg utklämd</translation>
    </message>
    <message>
        <source>Mixing well wiped</source>
        <translation>Blandningsytan avtorkad</translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>Nytt lager</translation>
    </message>
    <message>
        <source>Look of a layer</source>
        <translation>Lagrets utseende</translation>
    </message>
    <message>
        <source>Layer duplicated</source>
        <translation>Lager duplicerat</translation>
    </message>
    <message>
        <source>Layer removed</source>
        <translation>Lager borttaget</translation>
    </message>
    <message>
        <source>Layer cleared</source>
        <translation>Lager tömt</translation>
    </message>
    <message>
        <source>Transform</source>
        <translation>Transformera</translation>
    </message>
    <message>
        <source>Layer moved</source>
        <translation>Lager flyttat</translation>
    </message>
    <message>
        <source>Merged down</source>
        <translation>Sammanfogat nedåt</translation>
    </message>
    <message>
        <source>Flattened</source>
        <translation>Synliga lager sammanfogade</translation>
    </message>
    <message>
        <source>Layers grouped</source>
        <translation>Lager grupperade</translation>
    </message>
    <message>
        <source>Look of a group</source>
        <translation>Gruppens utseende</translation>
    </message>
    <message>
        <source>Group moved</source>
        <translation>Grupp flyttad</translation>
    </message>
    <message>
        <source>Group dissolved</source>
        <translation>Grupp upplöst</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Markering</translation>
    </message>
    <message>
        <source>Size of the canvas</source>
        <translation>Dukens storlek</translation>
    </message>
    <message>
        <source>Picture as paint</source>
        <translation>Bild som färg</translation>
    </message>
    <message>
        <source>Picture to trace</source>
        <translation>Bild att kalkera</translation>
    </message>
    <message>
        <source>Place of the traced picture</source>
        <translation>Den kalkerade bildens läge</translation>
    </message>
    <message>
        <source>Paint pasted</source>
        <translation>Färg inklistrad</translation>
    </message>
    <message>
        <source>Filled with paint</source>
        <translation>Fylld med färg</translation>
    </message>
    <message>
        <source>Painting scaled</source>
        <translation>Målningen skalad</translation>
    </message>
    <message>
        <source>Ground toned</source>
        <translation>Grunden tonad</translation>
    </message>
    <message>
        <source>Painting rotated</source>
        <translation>Målningen roterad</translation>
    </message>
    <message>
        <source>Masking fluid</source>
        <translation>Maskeringsvätska</translation>
    </message>
    <message>
        <source>Selection masked</source>
        <translation>Markering maskerad</translation>
    </message>
    <message>
        <source>Masking peeled off</source>
        <translation>Maskering avdragen</translation>
    </message>
    <message>
        <source>Reference picture</source>
        <translation>Referensbild</translation>
    </message>
    <message>
        <source>Place of a reference</source>
        <translation>En referens läge</translation>
    </message>
    <message>
        <source>Order of the references</source>
        <translation>Referensernas ordning</translation>
    </message>
    <message>
        <source>Reference taken away</source>
        <translation>Referens borttagen</translation>
    </message>
    <message>
        <source>Texture laid</source>
        <translation>Textur lagd</translation>
    </message>
    <message>
        <source>Dry paint adjusted</source>
        <translation>Torr färg justerad</translation>
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
        <translation>Hälls i</translation>
    </message>
    <message>
        <source>How long the milk of a new glass is poured</source>
        <translation>Hur länge mjölken hälls i ett nytt glas</translation>
    </message>
    <message>
        <source>Stream</source>
        <translation>Stråle</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Fart</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Fat lifts</source>
        <translation>Fett lyfter</translation>
    </message>
    <message>
        <source>How fast fat lets milk rise</source>
        <translation>Hur fort fett får mjölk att stiga</translation>
    </message>
    <message>
        <source>Cold sinks</source>
        <translation>Kyla sänker</translation>
    </message>
    <message>
        <source>How fast cold lets milk sink</source>
        <translation>Hur fort kyla får mjölk att sjunka</translation>
    </message>
    <message>
        <source>Milky tea sinks</source>
        <translation>Mjölkigt te sjunker</translation>
    </message>
    <message>
        <source>How fast tea with milk in it sinks</source>
        <translation>Hur fort te med mjölk i sjunker</translation>
    </message>
    <message>
        <source>Warms at rest in</source>
        <translation>Värms i vila på</translation>
    </message>
    <message>
        <source>Time in which milk at rest warms</source>
        <translation>Tiden det tar för mjölk i vila att bli varm</translation>
    </message>
    <message>
        <source>A ball warms in</source>
        <translation>En kula värms på</translation>
    </message>
    <message>
        <source>Time in which a ball warms</source>
        <translation>Tiden det tar för en kula att bli varm</translation>
    </message>
    <message>
        <source>Cold given on</source>
        <translation>Kyla ges vidare</translation>
    </message>
    <message>
        <source>Share of the milk&apos;s cold that the tea gets</source>
        <translation>Andel av mjölkens kyla som teet får</translation>
    </message>
    <message>
        <source>First ball after</source>
        <translation>Första kulan efter</translation>
    </message>
    <message>
        <source>When the first ball forms</source>
        <translation>När den första kulan bildas</translation>
    </message>
    <message>
        <source>A ball every</source>
        <translation>En kula var</translation>
    </message>
    <message>
        <source>Time between two balls, in the mean</source>
        <translation>Tiden mellan två kulor, i medeltal</translation>
    </message>
    <message>
        <source>Ball&apos;s radius</source>
        <translation>Kulans radie</translation>
    </message>
    <message>
        <source>Radius of a ball, in the mean</source>
        <translation>En kulas radie, i medeltal</translation>
    </message>
    <message>
        <source>Sizes differ by</source>
        <translation>Storlek varierar</translation>
    </message>
    <message>
        <source>How much balls differ in size</source>
        <translation>Hur mycket kulornas storlek varierar</translation>
    </message>
    <message>
        <source>A warm ball in</source>
        <translation>En varm kula på</translation>
    </message>
    <message>
        <source>Time in which a warm ball dissolves</source>
        <translation>Tiden det tar för en varm kula att lösas upp</translation>
    </message>
    <message>
        <source>On top in</source>
        <translation>Överst på</translation>
    </message>
    <message>
        <source>Time in which milk under the surface dissolves</source>
        <translation>Tiden det tar för mjölk under ytan att lösas upp</translation>
    </message>
    <message>
        <source>On top is</source>
        <translation>Överst är</translation>
    </message>
    <message>
        <source>How far down that is</source>
        <translation>Hur långt ner det är</translation>
    </message>
    <message>
        <source>At rest in</source>
        <translation>I vila på</translation>
    </message>
    <message>
        <source>Time in which milk at rest dissolves</source>
        <translation>Tiden det tar för mjölk i vila att lösas upp</translation>
    </message>
    <message>
        <source>All from</source>
        <translation>Allt från</translation>
    </message>
    <message>
        <source>When all milk begins to dissolve</source>
        <translation>När all mjölk börjar lösas upp</translation>
    </message>
    <message>
        <source>Warm below</source>
        <translation>Varm under</translation>
    </message>
    <message>
        <source>Coldness below which a ball dissolves</source>
        <translation>Kyla under vilken en kula löses upp</translation>
    </message>
    <message>
        <source>Milk spreads</source>
        <translation>Mjölk sprids</translation>
    </message>
    <message>
        <source>How dissolved milk spreads</source>
        <translation>Hur upplöst mjölk sprids</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viskositet</translation>
    </message>
    <message>
        <source>Kinematic viscosity: water 1, oil 80, honey 5000</source>
        <translation>Kinematisk viskositet: vatten 1, olja 80, honung 5000</translation>
    </message>
    <message>
        <source>Heat spreads</source>
        <translation>Värme sprids</translation>
    </message>
    <message>
        <source>How heat spreads</source>
        <translation>Hur värme sprids</translation>
    </message>
    <message>
        <source>Whirls kept</source>
        <translation>Virvlar bevaras</translation>
    </message>
    <message>
        <source>Force that keeps small whirls alive</source>
        <translation>Kraft som håller små virvlar vid liv</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Tidssteg</translation>
    </message>
    <message>
        <source>Length of a time step</source>
        <translation>Ett tidsstegs längd</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Pressure within</source>
        <translation>Tryck inom</translation>
    </message>
    <message>
        <source>How exact the pressure is solved</source>
        <translation>Hur noga trycket löses</translation>
    </message>
    <message>
        <source>Pouring</source>
        <translation>Hällning</translation>
    </message>
    <message>
        <source>Sinking and rising</source>
        <translation>Sjunka och stiga</translation>
    </message>
    <message>
        <source>Balls of milk</source>
        <translation>Mjölkkulor</translation>
    </message>
    <message>
        <source>Dissolving</source>
        <translation>Upplösning</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Flöde</translation>
    </message>
    <message>
        <source>Milk</source>
        <translation>Mjölk</translation>
    </message>
    <message>
        <source>How much milk is poured into a new glass by itself</source>
        <translation>Hur mycket mjölk som av sig själv hälls i ett nytt glas</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>Force reaches</source>
        <translation>Kraften når</translation>
    </message>
    <message>
        <source>How far the force reaches from its axis</source>
        <translation>Hur långt kraften når från sin axel</translation>
    </message>
    <message>
        <source>Tank: liquid falls</source>
        <translation>Tank: vätska faller</translation>
    </message>
    <message>
        <source>Tank: two liquids meet</source>
        <translation>Tank: två vätskor möts</translation>
    </message>
    <message>
        <source>Back to the painting</source>
        <translation>Tillbaka till målningen</translation>
    </message>
    <message>
        <source>The glass waits as it is, and so did the painting</source>
        <translation>Glaset väntar som det är, och det gjorde målningen också</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Tyngdkraft</translation>
    </message>
    <message>
        <source>How fast what falls gets faster</source>
        <translation>Hur fort det som faller blir snabbare</translation>
    </message>
    <message>
        <source>Lively</source>
        <translation>Livlighet</translation>
    </message>
    <message>
        <source>What of its own velocity a drop keeps from step to step: less is calmer</source>
        <translation>Hur mycket av sin egen hastighet en droppe behåller från steg till steg: mindre är lugnare</translation>
    </message>
    <message>
        <source>Volume mended</source>
        <translation>Volym lagas</translation>
    </message>
    <message>
        <source>How much of a wrong density a step mends</source>
        <translation>Hur mycket av en felaktig täthet ett steg rättar till</translation>
    </message>
    <message>
        <source>Way of a step</source>
        <translation>Stegets väg</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Siffror</translation>
    </message>
    <message>
        <source>Each number of the liquid</source>
        <translation>Varje siffra för vätskan</translation>
    </message>
    <message>
        <source>thin as water</source>
        <translation>tunn som vatten</translation>
    </message>
    <message>
        <source>thick as honey</source>
        <translation>tjock som honung</translation>
    </message>
    <message>
        <source>Its viscosity</source>
        <translation>Dess viskositet</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>lugn</translation>
    </message>
    <message>
        <source>lively</source>
        <translation>livlig</translation>
    </message>
    <message>
        <source>How much of its own movement each drop keeps</source>
        <translation>Hur mycket av sin egen rörelse varje droppe behåller</translation>
    </message>
    <message>
        <source>warm milk</source>
        <translation>varm mjölk</translation>
    </message>
    <message>
        <source>cold milk</source>
        <translation>kall mjölk</translation>
    </message>
    <message>
        <source>Warm milk spreads under the surface, cold milk falls to the floor</source>
        <translation>Varm mjölk breder ut sig under ytan, kall mjölk faller till botten</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>tunn</translation>
    </message>
    <message>
        <source>creamy</source>
        <translation>gräddig</translation>
    </message>
    <message>
        <source>Thin milk stays below and mixes soon, creamy milk rises in large soft clouds</source>
        <translation>Tunn mjölk stannar nere och blandas snart, gräddig mjölk stiger i stora mjuka moln</translation>
    </message>
    <message>
        <source>hot tea</source>
        <translation>hett te</translation>
    </message>
    <message>
        <source>ice-cold tea</source>
        <translation>iskallt te</translation>
    </message>
    <message>
        <source>Hot tea warms the milk, and it rises again; in ice-cold tea it lies where it fell</source>
        <translation>Hett te värmer mjölken, och den stiger igen; i iskallt te ligger den där den föll</translation>
    </message>
    <message>
        <source>Cold milk</source>
        <translation>Kall mjölk</translation>
    </message>
    <message>
        <source>Cold milk sinks, and comes up again in soft clouds as it warms</source>
        <translation>Kall mjölk sjunker, och kommer upp igen i mjuka moln när den blir varm</translation>
    </message>
    <message>
        <source>Cold brew</source>
        <translation>Kallbryggt</translation>
    </message>
    <message>
        <source>A thin stream into cold tea: it heaps up on the floor and stays there for long</source>
        <translation>En tunn stråle i kallt te: den samlas på botten och stannar där länge</translation>
    </message>
    <message>
        <source>Cream</source>
        <translation>Grädde</translation>
    </message>
    <message>
        <source>Thick cream turns round and floats on the tea</source>
        <translation>Tjock grädde vänder och flyter på teet</translation>
    </message>
    <message>
        <source>A drop</source>
        <translation>En skvätt</translation>
    </message>
    <message>
        <source>A little thin milk, drawn out to fingers and veils</source>
        <translation>Lite tunn mjölk som dras ut till fingrar och slöjor</translation>
    </message>
    <message>
        <source>Stirred</source>
        <translation>Omrört</translation>
    </message>
    <message>
        <source>The spoon goes round while the milk is poured</source>
        <translation>Skeden går runt medan mjölken hälls</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Vitt</translation>
    </message>
    <message>
        <source>A wide stream of milk billows up and fills the glass</source>
        <translation>En bred mjölkstråle väller upp och fyller glaset</translation>
    </message>
    <message>
        <source>poured low</source>
        <translation>hälls lågt</translation>
    </message>
    <message>
        <source>from high</source>
        <translation>från högt</translation>
    </message>
    <message>
        <source>Poured low, milk comes to lie on the floor; from high, it stirs the whole glass</source>
        <translation>Hälls mjölken lågt lägger den sig på botten; från högt rör den om hela glaset</translation>
    </message>
    <message>
        <source>Radius of the stream at the jug</source>
        <translation>Strålens radie vid kannan</translation>
    </message>
    <message>
        <source>Speed of the stream at the jug, downwards</source>
        <translation>Strålens fart nedåt vid kannan</translation>
    </message>
    <message>
        <source>Falls</source>
        <translation>Faller</translation>
    </message>
    <message>
        <source>How high above the tea the lip of the jug is</source>
        <translation>Hur högt över teet kannans pip är</translation>
    </message>
    <message>
        <source>The longest way of a step, against the finest detail of the liquid: longer is faster and coarser</source>
        <translation>Stegets längsta väg, jämfört med vätskans finaste detalj: längre är snabbare och grövre</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::GlassChooser</name>
    <message>
        <source>What is in the glass</source>
        <translation>Vad som finns i glaset</translation>
    </message>
    <message>
        <source>What is in the glass: milk tea, or a tank of liquid</source>
        <translation>Vad som finns i glaset: mjölkte eller en tank med vätska</translation>
    </message>
    <message>
        <source>Milk tea</source>
        <translation>Mjölkte</translation>
    </message>
    <message>
        <source>Open a tank...</source>
        <translation>Öppna en tank...</translation>
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
        <translation>%1 av %2 s</translation>
    </message>
    <message>
        <source>%1   paused</source>
        <translation>%1   pausad</translation>
    </message>
    <message>
        <source>%1   %2 steps/s</source>
        <translation>%1   %2 steg/s</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pausad</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::LiquidPictureDialog</name>
    <message>
        <source>Pixels from left to right</source>
        <translation>Pixlar från vänster till höger</translation>
    </message>
    <message>
        <source>Pixels from top to bottom</source>
        <translation>Pixlar uppifrån och ner</translation>
    </message>
    <message>
        <source>Ways of light for each pixel: four times as many, half the noise</source>
        <translation>Ljusvägar för varje bildpunkt: fyra gånger så många, halva bruset</translation>
    </message>
    <message>
        <source>As a surface</source>
        <translation>Som en yta</translation>
    </message>
    <message>
        <source>As a cloud</source>
        <translation>Som ett moln</translation>
    </message>
    <message>
        <source>How milk that has not dissolved is seen: a cloud is softer and takes longer</source>
        <translation>Hur mjölk som inte löst sig syns: ett moln är mjukare och tar längre tid</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höjd</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Sampel</translation>
    </message>
    <message>
        <source>Milk</source>
        <translation>Mjölk</translation>
    </message>
    <message>
        <source>Use on the canvas</source>
        <translation>Använd på duken</translation>
    </message>
    <message>
        <source>Puts the picture onto the painting as a layer of dry paint, and goes there</source>
        <translation>Lägger bilden på målningen som ett lager torr färg, och går dit</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Spara...</translation>
    </message>
    <message>
        <source>As PNG and others as it is shown, or as EXR with the light itself</source>
        <translation>Som PNG med flera som den visas, eller som EXR med ljuset självt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>Taking the noise out...</source>
        <translation>Bruset tas bort...</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stoppa</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>Rendera</translation>
    </message>
    <message>
        <source>Keep the picture as fine as it is by now</source>
        <translation>Behåll bilden så fin som den är nu</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Spara bilden</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>Finding the surface...</source>
        <translation>Söker ytan...</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) in %1 s, without noise</source>
        <translation>
            <numerusform>%n sampel på %1 s, utan brus</numerusform>
            <numerusform>%n sampel på %1 s, utan brus</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n sample(s)</source>
        <translation>
            <numerusform>%1 av %n sampel</numerusform>
            <numerusform>%1 av %n sampel</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) in %1 s: too few to take all noise out</source>
        <translation>
            <numerusform>%n sampel på %1 s: för få för att ta bort allt brus</numerusform>
            <numerusform>%n sampel på %1 s: för få för att ta bort allt brus</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pastoso::glass::TankPage</name>
    <message>
        <source>Moment of the tank</source>
        <translation>Tankens ögonblick</translation>
    </message>
    <message>
        <source>Drag to any moment of the tank; going on goes on from its last</source>
        <translation>Dra till vilket ögonblick som helst; när du fortsätter går det vidare från det sista</translation>
    </message>
    <message>
        <source>Liquid in the tank, and how many steps a second are computed</source>
        <translation>Vätska i tanken, och hur många steg i sekunden som beräknas</translation>
    </message>
    <message>
        <source>Filling the tank...</source>
        <translation>Fyller tanken...</translation>
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
        <translation>Kulor och avlopp</translation>
    </message>
    <message>
        <source>Ball&apos;s radius</source>
        <translation>Kulans radie</translation>
    </message>
    <message>
        <source>How large the ball is that falls where you press</source>
        <translation>Hur stor kulan är som faller där du trycker</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Milk in it</source>
        <translation>Mjölk i den</translation>
    </message>
    <message>
        <source>How much of the ball is milk</source>
        <translation>Hur mycket av kulan som är mjölk</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vind</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Hastighet</translation>
    </message>
    <message>
        <source>How fast the air goes</source>
        <translation>Hur fort luften rör sig</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Blows to</source>
        <translation>Blåser mot</translation>
    </message>
    <message>
        <source>0 to the right along the front, 90 away from it</source>
        <translation>0 åt höger längs framsidan, 90 bort från den</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Drags</source>
        <translation>Drar</translation>
    </message>
    <message>
        <source>How firmly it takes the liquid&apos;s surface along</source>
        <translation>Hur kraftigt den tar vätskans yta med sig</translation>
    </message>
    <message>
        <source> /s</source>
        <translation> /s</translation>
    </message>
    <message>
        <source>Look and export</source>
        <translation>Visa och exportera</translation>
    </message>
    <message>
        <source>Liquid</source>
        <translation>Vätska</translation>
    </message>
    <message>
        <source>Every step into a folder</source>
        <translation>Varje steg till en mapp</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::TeaPage</name>
    <message>
        <source>Moment of the tea</source>
        <translation>Teets ögonblick</translation>
    </message>
    <message>
        <source>Drag to any moment of the glass; going on goes on from its last</source>
        <translation>Dra till vilket ögonblick som helst; att fortsätta fortsätter från det sista</translation>
    </message>
    <message>
        <source>Milk poured so far, and how many steps of 1/30 s a second are computed</source>
        <translation>Mjölk som hällts i hittills, och hur många steg på 1/30 s som beräknas per sekund</translation>
    </message>
    <message>
        <source>Filling the glass...</source>
        <translation>Glaset fylls...</translation>
    </message>
    <message>
        <source>%1 ml of milk</source>
        <translation>%1 ml mjölk</translation>
    </message>
    <message>
        <source>Press on the tea to pour milk where you point</source>
        <translation>Tryck på teet för att hälla mjölk där du pekar</translation>
    </message>
    <message>
        <source>The glass is full</source>
        <translation>Glaset är fullt</translation>
    </message>
</context>
<context>
    <name>pastoso::glass::TeaPanel</name>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>Drops that the next glass&apos; milk is made of</source>
        <translation>Droppar som mjölken i nästa glas består av</translation>
    </message>
    <message>
        <source>Drops of milk</source>
        <translation>Mjölkdroppar</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Around the axis</source>
        <translation>Runt axeln</translation>
    </message>
    <message>
        <source>How fast the stirring gets faster; below 0 it goes the other way round</source>
        <translation>Hur fort omrörningen ökar; under 0 går den åt andra hållet</translation>
    </message>
    <message>
        <source> rad/s²</source>
        <translation> rad/s²</translation>
    </message>
    <message>
        <source>Downwards</source>
        <translation>Nedåt</translation>
    </message>
    <message>
        <source> m/s²</source>
        <translation> m/s²</translation>
    </message>
    <message>
        <source>A push down along the axis; below 0 it goes up</source>
        <translation>En knuff nedåt längs axeln; under 0 går den uppåt</translation>
    </message>
    <message>
        <source>Milk and tea</source>
        <translation>Mjölk och te</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recept</translation>
    </message>
    <message>
        <source>The next glass</source>
        <translation>Nästa glas</translation>
    </message>
    <message>
        <source>Fineness</source>
        <translation>Finhet</translation>
    </message>
    <message>
        <source>Parts that each side of the next glass is divided into: twice as many take sixteen times as long; balls rise from 64 on</source>
        <translation>Delar som varje sida i nästa glas delas i: dubbelt så många tar sexton gånger så lång tid; kulor stiger från 64</translation>
    </message>
</context>
<context>
    <name>pastoso::help::AboutDialog</name>
    <message>
        <source>About Pastoso</source>
        <translation>Om Pastoso</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <source>This machine</source>
        <translation>Den här datorn</translation>
    </message>
    <message>
        <source>Folders</source>
        <translation>Mappar</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliotek</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Licens</translation>
    </message>
</context>
<context>
    <name>pastoso::help::HelpView</name>
    <message>
        <source>Page of the manual</source>
        <translation>Sida i handboken</translation>
    </message>
</context>
<context>
    <name>pastoso::help::HelpWindow</name>
    <message>
        <source>Manual</source>
        <translation>Handbok</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Sök i handboken</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Handbokens sidor</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Sökträffar</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Tillbaka</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Framåt</translation>
    </message>
    <message>
        <source>Nothing is found.</source>
        <translation>Inget hittades.</translation>
    </message>
</context>
<context>
    <name>pastoso::help::TourBubble</name>
    <message>
        <source>Skip the tour</source>
        <translation>Hoppa över</translation>
    </message>
    <message>
        <source>Go on with the tour</source>
        <translation>Fortsätt rundturen</translation>
    </message>
    <message>
        <source>Leave the tour, as Escape does; &quot;Show me round&quot; in the &quot;Help&quot; menu brings it back</source>
        <translation>Lämna rundturen, som Escape gör; ”Visa mig runt” i menyn ”Hjälp” tar fram den igen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 av %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Klar</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nästa</translation>
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
        <translation>ingen</translation>
    </message>
    <message>
        <source>Graphics</source>
        <translation>Grafik</translation>
    </message>
    <message>
        <source>%1 (the processor draws, no graphics card)</source>
        <translation>%1 (processorn ritar, inget grafikkort)</translation>
    </message>
    <message>
        <source>Its maker</source>
        <translation>Dess tillverkare</translation>
    </message>
    <message>
        <source>Shading language</source>
        <translation>Skuggningsspråk</translation>
    </message>
    <message>
        <source>Largest texture</source>
        <translation>Största textur</translation>
    </message>
    <message>
        <source>%1 pixels a side</source>
        <translation>%1 pixlar per sida</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, %3 for one of the layout</source>
        <translation>%1 × %2 pixlar, %3 per layoutpixel</translation>
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
        <translation>%1 trådar, %2, beräkningskod för %3</translation>
    </message>
    <message>
        <source>Free memory</source>
        <translation>Ledigt minne</translation>
    </message>
    <message>
        <source>Windows by</source>
        <translation>Fönster via</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Skärm</translation>
    </message>
    <message>
        <source>Top up</source>
        <translation>Fyll på</translation>
    </message>
    <message>
        <source>Blot</source>
        <translation>Torka av</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Byt plats</translation>
    </message>
    <message>
        <source>Pick paint</source>
        <translation>Hämta färg</translation>
    </message>
    <message>
        <source>Pick colour</source>
        <translation>Hämta kulör</translation>
    </message>
    <message>
        <source>Left, right</source>
        <translation>Vänster, höger</translation>
    </message>
    <message>
        <source>Above, below</source>
        <translation>Uppe, nere</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Välj...</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Below the paint</source>
        <translation>Under färgen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassa</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>Räta upp</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spegla</translation>
    </message>
    <message>
        <source>Watch it grow...</source>
        <translation>Se den växa fram...</translation>
    </message>
    <message>
        <source>Make a time-lapse...</source>
        <translation>Gör en timelapse...</translation>
    </message>
    <message>
        <source>Save the recording...</source>
        <translation>Spara inspelningen...</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Verktyg</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Kulör</translation>
    </message>
    <message>
        <source>Physics</source>
        <translation>Fysik</translation>
    </message>
    <message>
        <source>Guides</source>
        <translation>Hjälplinjer</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Belysning</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lager</translation>
    </message>
    <message>
        <source>Tracing</source>
        <translation>Kalkering</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historik</translation>
    </message>
    <message>
        <source>Navigator</source>
        <translation>Översikt</translation>
    </message>
    <message>
        <source>Recorder</source>
        <translation>Inspelning</translation>
    </message>
    <message>
        <source>As it was painted</source>
        <translation>Som den målades</translation>
    </message>
    <message>
        <source>4 times as fast</source>
        <translation>4 gånger så fort</translation>
    </message>
    <message>
        <source>16 times as fast</source>
        <translation>16 gånger så fort</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>Så fort som möjligt</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nytt</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öppna</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Spara</translation>
    </message>
    <message>
        <source>Stir</source>
        <translation>Rör om</translation>
    </message>
    <message>
        <source>Other way round</source>
        <translation>Andra hållet</translation>
    </message>
    <message>
        <source>Render a picture...</source>
        <translation>Rendera en bild...</translation>
    </message>
    <message>
        <source>Export the surface...</source>
        <translation>Exportera ytan...</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Börja om</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kula</translation>
    </message>
    <message>
        <source>Drain</source>
        <translation>Avlopp</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vind</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>Hastigheter</translation>
    </message>
    <message>
        <source>Export all moments...</source>
        <translation>Exportera alla ögonblick...</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Ytor</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meddelanden</translation>
    </message>
    <message>
        <source>Pour</source>
        <translation>Häll</translation>
    </message>
    <message>
        <source>Paint it again, finer...</source>
        <translation>Måla om det finare...</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>Penslar</translation>
    </message>
    <message>
        <source>Paints</source>
        <translation>Färger</translation>
    </message>
    <message>
        <source>Easel</source>
        <translation>Staffli</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Fäst</translation>
    </message>
    <message>
        <source>Add...</source>
        <translation>Lägg till...</translation>
    </message>
    <message>
        <source>Own window</source>
        <translation>Eget fönster</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Referenser</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>A recording is being played; the paint is yours when it has ended.</source>
        <translation>En inspelning spelas upp; färgen blir din igen när den är slut.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BackgroundExport</name>
    <message>
        <source>A file is being written already. Try again in a moment.</source>
        <translation>En fil skrivs redan. Försök igen om en stund.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BrushBundles</name>
    <message>
        <source>Import tools</source>
        <translation>Importera verktyg</translation>
    </message>
    <message>
        <source>Bundles of tools (*.zip)</source>
        <translation>Samlingar av verktyg (*.zip)</translation>
    </message>
    <message>
        <source>You have all tools of that bundle already.</source>
        <translation>Du har redan alla verktyg i den samlingen.</translation>
    </message>
    <message numerus="yes">
        <source>%n tool(s) added to your own.</source>
        <translation>
            <numerusform>%n verktyg lades till dina egna.</numerusform>
            <numerusform>%n verktyg lades till dina egna.</numerusform>
        </translation>
    </message>
    <message>
        <source>You have no tools of your own yet; save the one in hand first.</source>
        <translation>Du har inga egna verktyg än; spara först det i handen.</translation>
    </message>
    <message>
        <source>Export my tools</source>
        <translation>Exportera mina verktyg</translation>
    </message>
    <message>
        <source>my-tools.zip</source>
        <translation>mina-verktyg.zip</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Sparade %1.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BrushJar</name>
    <message>
        <source>%1 was read again; the next stroke is painted with it.</source>
        <translation>%1 har lästs in på nytt; nästa drag målas med det.</translation>
    </message>
    <message>
        <source>Name of the tool:</source>
        <translation>Verktygets namn:</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>My %1</source>
        <translation>Min %1</translation>
    </message>
    <message>
        <source>Save as my own</source>
        <translation>Spara som eget</translation>
    </message>
    <message>
        <source>There is already a tool of your own named &quot;%1&quot;.</source>
        <translation>Du har redan ett eget verktyg som heter ”%1”.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Skriv över</translation>
    </message>
    <message>
        <source>Kept &quot;%1&quot; among your own.</source>
        <translation>”%1” finns nu bland dina egna.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Byt namn</translation>
    </message>
    <message>
        <source>Throw your tool &quot;%1&quot; away? Its file is deleted.</source>
        <translation>Ta bort ditt verktyg ”%1”? Dess fil raderas.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is thrown away; what you have in hand stays.</source>
        <translation>”%1” är borttaget; det du har i handen finns kvar.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::BrushShelving</name>
    <message>
        <source>A tag needs a name.</source>
        <translation>En etikett behöver ett namn.</translation>
    </message>
    <message>
        <source>New tag</source>
        <translation>Ny etikett</translation>
    </message>
    <message>
        <source>Name of the tag:</source>
        <translation>Etikettens namn:</translation>
    </message>
</context>
<context>
    <name>pastoso::main::CanvasSizing</name>
    <message>
        <source>A recording is being played; the canvas is yours when it has ended.</source>
        <translation>En inspelning spelas upp; duken blir din igen när den är slut.</translation>
    </message>
    <message>
        <source>The selection reaches over the whole canvas: there is nothing to cut.</source>
        <translation>Markeringen täcker hela duken: det finns inget att skära bort.</translation>
    </message>
    <message>
        <source>The canvas is %1 × %2 mm now; Undo brings back what it was.</source>
        <translation>Duken är nu %1 × %2 mm; Ångra återställer den.</translation>
    </message>
    <message>
        <source>Making the canvas</source>
        <translation>Gör duken</translation>
    </message>
    <message>
        <source>Meanwhile the canvas has become another one; that keeps its size.</source>
        <translation>Duken har under tiden blivit en annan; den behåller sin storlek.</translation>
    </message>
    <message>
        <source>The selection is too soft to crop to: nothing is outlined.</source>
        <translation>Markeringen är för mjuk att beskära till: inget har någon kontur.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Clipboard</name>
    <message>
        <source>There is no paint to copy here.</source>
        <translation>Här finns ingen färg att kopiera.</translation>
    </message>
    <message>
        <source>Copied; paste it as a layer, or as a picture in another program.</source>
        <translation>Kopierat; klistra in det som ett lager, eller som bild i ett annat program.</translation>
    </message>
    <message>
        <source>Pasted</source>
        <translation>Inklistrat</translation>
    </message>
    <message>
        <source>There is nothing to paste: no paint and no picture has been copied.</source>
        <translation>Det finns inget att klistra in: ingen färg och ingen bild har kopierats.</translation>
    </message>
    <message>
        <source>The copied paint is too large to go to another painting as paint (at most %1 MB); a picture of it goes.</source>
        <translation>Den kopierade färgen är för stor för att föras över till en annan målning som färg (högst %1 MB); en bild av den förs över.</translation>
    </message>
    <message>
        <source>The clipboard</source>
        <translation>Urklipp</translation>
    </message>
    <message>
        <source>What was dragged here</source>
        <translation>Det som drogs hit</translation>
    </message>
</context>
<context>
    <name>pastoso::main::DroppedFiles</name>
    <message>
        <source>%1 is no painting and no picture that can be opened.</source>
        <translation>%1 är varken en målning eller en bild som går att öppna.</translation>
    </message>
    <message>
        <source>Put it on a &amp;layer, as dry paint</source>
        <translation>Lägg den på ett &amp;lager, som torr färg</translation>
    </message>
    <message>
        <source>&amp;Trace it, below the paint</source>
        <translation>&amp;Kalkera den, under färgen</translation>
    </message>
    <message>
        <source>&amp;New canvas made of it</source>
        <translation>&amp;Ny duk av den</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>Låt bli</translation>
    </message>
    <message>
        <source>&amp;Keep it beside the canvas, as a reference</source>
        <translation>&amp;Ha den bredvid duken, som referens</translation>
    </message>
    <message>
        <source>Put each on a &amp;layer, as dry paint</source>
        <translation>Lägg var och en på ett &amp;lager, som torr färg</translation>
    </message>
    <message>
        <source>&amp;Keep them beside the canvas, as references</source>
        <translation>&amp;Ha dem bredvid duken, som referenser</translation>
    </message>
    <message>
        <source>Leave them</source>
        <translation>Låt bli</translation>
    </message>
    <message>
        <source>There is no picture in it that can be read.</source>
        <translation>Det finns ingen bild i det som går att läsa.</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>Each of the other files opens in a window of its own. Open %1 more windows?</source>
        <translation>De andra filerna öppnas var och en i ett eget fönster. Öppna %1 fönster till?</translation>
    </message>
    <message>
        <source>Open them</source>
        <translation>Öppna dem</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
</context>
<context>
    <name>pastoso::main::DryAdjusting</name>
    <message>
        <source>The layer that you paint on has no dry paint.</source>
        <translation>Lagret som du målar på har ingen torr färg.</translation>
    </message>
    <message>
        <source>The layer that you paint on has no dry paint where it is selected.</source>
        <translation>Lagret som du målar på har ingen torr färg där det är markerat.</translation>
    </message>
    <message>
        <source>The glaze lies over the dry paint.</source>
        <translation>Lasyren ligger över den torra färgen.</translation>
    </message>
    <message>
        <source>The dry paint has other pigments in it.</source>
        <translation>Den torra färgen har andra pigment i sig.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Exporting</name>
    <message>
        <source>Exported %1 and %2 more; heights from %3 mm (black) to %4 mm (white).</source>
        <translation>Exporterade %1 och %2 till; höjder från %3 mm (svart) till %4 mm (vitt).</translation>
    </message>
    <message>
        <source>Exported %1: %2 × %3 pixels.</source>
        <translation>Exporterade %1: %2 × %3 pixlar.</translation>
    </message>
    <message>
        <source>Stopped; %1 holds the pictures that are complete.</source>
        <translation>Avbruten; %1 innehåller de bilder som blev klara.</translation>
    </message>
    <message>
        <source>Stopped; %1 was not written.</source>
        <translation>Avbruten; %1 skrevs inte.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>målning</translation>
    </message>
    <message>
        <source>%1 is still being written; wait for it, or stop it.</source>
        <translation>%1 skrivs fortfarande; vänta tills den är klar, eller avbryt.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Exporterar %1</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>%1 is still being written.</source>
        <translation>%1 skrivs fortfarande.</translation>
    </message>
    <message>
        <source>Close when it is done</source>
        <translation>Stäng när den är klar</translation>
    </message>
    <message>
        <source>Stop it</source>
        <translation>Avbryt den</translation>
    </message>
    <message>
        <source>The window closes as soon as %1 is written.</source>
        <translation>Fönstret stängs så snart %1 är skriven.</translation>
    </message>
    <message>
        <source>Export recording</source>
        <translation>Exportera inspelning</translation>
    </message>
    <message>
        <source>painting.json</source>
        <translation>målning.json</translation>
    </message>
    <message>
        <source>Recordings (*.json)</source>
        <translation>Inspelningar (*.json)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Sparade %1.</translation>
    </message>
    <message numerus="yes">
        <source>Exported %1: %n triangle(s), %2 × %3 mm.</source>
        <translation>
            <numerusform>Exporterade %1: %n triangel, %2 × %3 mm.</numerusform>
            <numerusform>Exporterade %1: %n trianglar, %2 × %3 mm.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Exported %1: %n frame(s) of %2 × %3 pixels.</source>
        <translation>
            <numerusform>Exporterade %1: %n bildruta på %2 × %3 pixlar.</numerusform>
            <numerusform>Exporterade %1: %n bildrutor på %2 × %3 pixlar.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Nothing was exported: make room or choose another place.</source>
        <translation>%1 Inget exporterades: frigör utrymme eller välj en annan plats.</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportera...</translation>
    </message>
    <message numerus="yes">
        <source>Saved %1: %n layer(s) of %2 × %3 pixels.</source>
        <translation>
            <numerusform>Sparade %1: %n lager med %2 × %3 pixlar.</numerusform>
            <numerusform>Sparade %1: %n lager med %2 × %3 pixlar.</numerusform>
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
        <translation>Spara en kopia</translation>
    </message>
</context>
<context>
    <name>pastoso::main::FillCommands</name>
    <message>
        <source>Nothing was poured. Esc again goes back to painting.</source>
        <translation>Inget hälldes. Tryck Esc igen för att fortsätta måla.</translation>
    </message>
    <message>
        <source>Drag a line from the paint in hand to the second paint; Shift keeps it level, upright or halfway. Esc, or taking a tool, goes back to painting.</source>
        <translation>Dra en linje från färgen i handen till den andra färgen; Shift håller den vågrät, lodrät eller mitt emellan. Tryck Esc, eller ta ett verktyg, för att måla igen.</translation>
    </message>
    <message>
        <source>The brush paints again.</source>
        <translation>Penseln målar igen.</translation>
    </message>
    <message>
        <source>%1 mm of paint are poured over the whole canvas.</source>
        <translation>%1 mm färg hälls över hela duken.</translation>
    </message>
    <message>
        <source>%1 mm of paint are poured over what is selected.</source>
        <translation>%1 mm färg hälls över det som är markerat.</translation>
    </message>
    <message>
        <source>Thickness of fills</source>
        <translation>Fyllningarnas tjocklek</translation>
    </message>
    <message>
        <source>Fills and gradients pour an even film of wet paint, as thick as this: 0.05 mm shows what lies below, 0.2 mm covers, 1 mm stands as a paste.</source>
        <translation>Fyllningar och övergångar häller ett jämnt skikt våt färg, så här tjockt: 0,05 mm låter det som ligger under synas, 0,2 mm täcker, 1 mm står som en pasta.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Tjocklek</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behåll</translation>
    </message>
    <message>
        <source>Toned ground</source>
        <translation>Tonad grund</translation>
    </message>
    <message>
        <source>An even coat of the paint in hand covers the whole canvas, dry at once, on a layer below all others: 0.02 mm tints the canvas, 0.1 mm covers it.</source>
        <translation>Ett jämnt skikt av färgen i handen täcker hela duken, genast torrt, på ett lager under alla andra: 0,02 mm tonar duken, 0,1 mm täcker den.</translation>
    </message>
    <message>
        <source>Tone the ground</source>
        <translation>Tona grunden</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Grund</translation>
    </message>
</context>
<context>
    <name>pastoso::main::GlassMode</name>
    <message>
        <source>Surfaces (*.pbrt *.obj *.ply *.stl)</source>
        <translation>Ytor (*.pbrt *.obj *.ply *.stl)</translation>
    </message>
</context>
<context>
    <name>pastoso::main::GuideCommands</name>
    <message>
        <source>Strokes around the middle: %1</source>
        <translation>Penseldrag runt mitten: %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::KeepingUp</name>
    <message>
        <source>Real time</source>
        <translation>Realtid</translation>
    </message>
    <message>
        <source>Thin less</source>
        <translation>Späd mindre</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Dry</source>
        <translation>Torka</translation>
    </message>
</context>
<context>
    <name>pastoso::main::LayerCommands</name>
    <message>
        <source>Layer %1</source>
        <translation>Lager %1</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Grupp %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::LayerTransform</name>
    <message>
        <source>A recording is being played; the layers are yours when it has ended.</source>
        <translation>En inspelning spelas upp; lagren blir dina igen när den är slut.</translation>
    </message>
    <message>
        <source>There is no paint on this layer.</source>
        <translation>Det finns ingen färg på det här lagret.</translation>
    </message>
    <message>
        <source>There is no paint of this layer in the selection.</source>
        <translation>Det finns ingen färg från det här lagret i markeringen.</translation>
    </message>
    <message>
        <source>The paint stays as it is.</source>
        <translation>Färgen förblir som den är.</translation>
    </message>
    <message>
        <source>Drag inside to move, a handle to scale, outside to turn (Shift: in steps), with Ctrl a corner or a side alone. Enter applies, Esc gives up.</source>
        <translation>Dra inuti för att flytta, i ett handtag för att skala, utanför för att vrida (Shift: stegvis), med Ctrl ett hörn eller en sida för sig. Enter verkställer, Esc avbryter.</translation>
    </message>
    <message>
        <source>No corner is chosen</source>
        <translation>Inget hörn är valt</translation>
    </message>
    <message>
        <source>Upper left corner</source>
        <translation>Övre vänstra hörnet</translation>
    </message>
    <message>
        <source>Upper right corner</source>
        <translation>Övre högra hörnet</translation>
    </message>
    <message>
        <source>Lower right corner</source>
        <translation>Nedre högra hörnet</translation>
    </message>
    <message>
        <source>Lower left corner</source>
        <translation>Nedre vänstra hörnet</translation>
    </message>
    <message>
        <source>%1 at %2, %3 mm</source>
        <translation>%1 vid %2, %3 mm</translation>
    </message>
</context>
<context>
    <name>pastoso::main::LightChoice</name>
    <message>
        <source>Light from a file</source>
        <translation>Ljus från en fil</translation>
    </message>
    <message>
        <source>Spectra (*.csv)</source>
        <translation>Spektra (*.csv)</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Loading</name>
    <message>
        <source>%1: given up; all is as it was.</source>
        <translation>%1: avbrutet; allt är som det var.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>%1: wait for it, or cancel it.</source>
        <translation>%1: vänta på det, eller avbryt det.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::MaskingCommands</name>
    <message>
        <source>Paint masking fluid, as wide as the tool in hand: no paint gets below it. Alt peels it off again; Esc, or taking a tool, goes back to painting.</source>
        <translation>Måla maskeringsvätska, lika bred som verktyget i handen: ingen färg tar sig in under den. Alt drar av den igen; tryck Esc, eller ta ett verktyg, för att måla igen.</translation>
    </message>
    <message>
        <source>Drag a strip of masking tape, as wide as the tool in hand; Shift keeps it level, upright or halfway. Alt peels it off again; Esc, or taking a tool, goes back to painting.</source>
        <translation>Dra en remsa maskeringstejp, lika bred som verktyget i handen; Shift håller den vågrät, lodrät eller mitt emellan. Alt drar av den igen; tryck Esc, eller ta ett verktyg, för att måla igen.</translation>
    </message>
    <message>
        <source>Nothing was masked. Esc again goes back to painting.</source>
        <translation>Inget maskerades. Tryck Esc igen för att fortsätta måla.</translation>
    </message>
    <message>
        <source>Peels the masking off there.</source>
        <translation>Drar av maskeringen där.</translation>
    </message>
    <message>
        <source>Masks the canvas there.</source>
        <translation>Maskerar duken där.</translation>
    </message>
    <message>
        <source>The brush paints again.</source>
        <translation>Penseln målar igen.</translation>
    </message>
    <message>
        <source>The masking is peeled off.</source>
        <translation>Maskeringen är avdragen.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::NewWindow</name>
    <message>
        <source>%1 cannot be started: there is no other window.</source>
        <translation>%1 kan inte startas: det blir inget fönster till.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintPicking</name>
    <message>
        <source>Picked up wet paint: %1</source>
        <translation>Hämtade våt färg: %1</translation>
    </message>
    <message>
        <source>Picked up dry paint: %1</source>
        <translation>Hämtade torr färg: %1</translation>
    </message>
    <message>
        <source>There is no colour to pick beside the canvas.</source>
        <translation>Det finns ingen kulör att hämta bredvid duken.</translation>
    </message>
    <message>
        <source>Picked the colour seen: %1</source>
        <translation>Hämtade kulören som syns: %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintSettings</name>
    <message>
        <source>Open a palette</source>
        <translation>Öppna en palett</translation>
    </message>
    <message>
        <source>Palettes (*.gpl)</source>
        <translation>Paletter (*.gpl)</translation>
    </message>
    <message>
        <source>Colours of a picture</source>
        <translation>En bilds färger</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Läser %1</translation>
    </message>
    <message>
        <source>Save the palette</source>
        <translation>Spara paletten</translation>
    </message>
    <message>
        <source>my-palette.gpl</source>
        <translation>min-palett.gpl</translation>
    </message>
    <message>
        <source>Export my paints</source>
        <translation>Exportera mina färger</translation>
    </message>
    <message>
        <source>my-paints.json</source>
        <translation>mina-farger.json</translation>
    </message>
    <message>
        <source>Sets of paints (*.json)</source>
        <translation>Färgsatser (*.json)</translation>
    </message>
    <message>
        <source>Import paints</source>
        <translation>Importera färger</translation>
    </message>
    <message>
        <source>You have all paints of that set already.</source>
        <translation>Du har redan alla färger i den uppsättningen.</translation>
    </message>
    <message numerus="yes">
        <source>%n paint(s) added to your own.</source>
        <translation>
            <numerusform>%n färg lades till dina egna.</numerusform>
            <numerusform>%n färger lades till dina egna.</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Sparade %1.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintTime</name>
    <message>
        <source>%1 × time</source>
        <translation>%1 × tiden</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintingAgain</name>
    <message>
        <source>painting</source>
        <translation>målning</translation>
    </message>
    <message>
        <source>Nothing has been painted yet that could be painted again.</source>
        <translation>Ännu har inget målats som kan målas om.</translation>
    </message>
    <message>
        <source>The painting</source>
        <translation>Målningen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Spara</translation>
    </message>
    <message>
        <source>Paintings and pictures (%1)</source>
        <translation>Målningar och bilder (%1)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Sparade %1.</translation>
    </message>
    <message>
        <source>Saved %1: %2 × %3 pixels.</source>
        <translation>Sparade %1: %2 × %3 pixlar.</translation>
    </message>
    <message>
        <source>Another question is open; answer it first.</source>
        <translation>En annan fråga är öppen; svara på den först.</translation>
    </message>
    <message>
        <source>The finer painting is still being written.</source>
        <translation>Den finare målningen skrivs fortfarande.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PictureLayers</name>
    <message>
        <source>Layer from a picture</source>
        <translation>Lager från en bild</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>Bilder (%1);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Läser %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::PopupCommands</name>
    <message>
        <source>Mirror</source>
        <translation>Spegla</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassa</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ProjectFiles</name>
    <message>
        <source>Open re&amp;cent</source>
        <translation>Öppna &amp;tidigare</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Sparade %1.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Spara</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Inga ännu</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Duk</translation>
    </message>
    <message>
        <source>%1[*] %2 × %3 mm</source>
        <translation>%1[*] %2 × %3 mm</translation>
    </message>
    <message>
        <source>Saving %1...</source>
        <translation>Sparar %1...</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öppna</translation>
    </message>
    <message>
        <source>Paintings and pictures (*.pastoso *.ora %1);;All files (*)</source>
        <translation>Målningar och bilder (*.pastoso *.ora %1);;Alla filer (*)</translation>
    </message>
    <message>
        <source>painting.pastoso</source>
        <translation>målning.pastoso</translation>
    </message>
    <message>
        <source>Paintings (*.pastoso)</source>
        <translation>Målningar (*.pastoso)</translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation>Pastoso</translation>
    </message>
    <message>
        <source>The painting on the easel has changes that are not saved.</source>
        <translation>Målningen på staffliet har ändringar som inte är sparade.</translation>
    </message>
    <message>
        <source>Discard them</source>
        <translation>Kasta dem</translation>
    </message>
    <message>
        <source>Painted from its strokes; the brush is yours when it is done.</source>
        <translation>Målas fram drag för drag; penseln blir din när det är klart.</translation>
    </message>
    <message>
        <source>What you paint is kept again.</source>
        <translation>Det du målar sparas undan igen.</translation>
    </message>
    <message>
        <source>Should the program fail, this painting would come back slowly, from its strokes alone: %1 %2 are free there. Make room; you can paint on.</source>
        <translation>Om programmet skulle haverera återkommer målningen långsamt, enbart ur sina drag: %1 %2 är ledigt där. Frigör utrymme; du kan måla vidare.</translation>
    </message>
    <message>
        <source>The disk is full: what you paint now would be lost if the program failed. It is kept in %1, where %2 are free and %3 wait to be written. Make room there, or save the painting to another disk. You can paint on; as soon as there is room, all of it is kept again.</source>
        <translation>Disken är full: det du målar nu skulle gå förlorat om programmet havererade. Det sparas undan i %1, där %2 är ledigt och %3 väntar på att skrivas. Frigör utrymme där, eller spara målningen på en annan disk. Du kan måla vidare; så snart det finns utrymme sparas allt undan igen.</translation>
    </message>
    <message>
        <source>What you paint now would be lost if the program failed: %1 %2 are free there. Make room, or save the painting to another disk. You can paint on; as soon as it can be, all of it is kept again.</source>
        <translation>Det du målar nu skulle gå förlorat om programmet havererade: %1 %2 är ledigt där. Frigör utrymme, eller spara målningen på en annan disk. Du kan måla vidare; så snart det går sparas allt undan igen.</translation>
    </message>
    <message>
        <source>The painting</source>
        <translation>Målningen</translation>
    </message>
    <message>
        <source>%1 The painting is not saved: make room or choose another place, and save again.</source>
        <translation>%1 Målningen är inte sparad: frigör utrymme eller välj en annan plats, och spara igen.</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Spara som...</translation>
    </message>
    <message>
        <source>Another program has changed %1 since you opened or saved it here. Replacing it loses what was changed there.</source>
        <translation>Ett annat program har ändrat %1 sedan du öppnade eller sparade den här. Om den ersätts går det som ändrades där förlorat.</translation>
    </message>
    <message>
        <source>%1 is protected against being written to.</source>
        <translation>%1 är skrivskyddad.</translation>
    </message>
    <message>
        <source>%1 The painting was not saved by itself.</source>
        <translation>%1 Målningen sparades inte automatiskt.</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Spara...</translation>
    </message>
    <message>
        <source>%1 - %2</source>
        <translation>%1 - %2</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Öppnar %1</translation>
    </message>
    <message>
        <source>Making the canvas</source>
        <translation>Gör duken</translation>
    </message>
    <message>
        <source>Putting it on the easel</source>
        <translation>Ställer den på staffliet</translation>
    </message>
    <message>
        <source>Recovering the painting</source>
        <translation>Återställer målningen</translation>
    </message>
    <message>
        <source>Save a version</source>
        <translation>Spara en version</translation>
    </message>
</context>
<context>
    <name>pastoso::main::RangeSelection</name>
    <message>
        <source>Wet paint of this layer is up to %1 mm thick, %2 mm on average.</source>
        <translation>Lagrets våta färg är upp till %1 mm tjock, i genomsnitt %2 mm.</translation>
    </message>
    <message>
        <source>Paint, wet and dry, stands up to %1 mm above the canvas, %2 mm on average.</source>
        <translation>Färgen, våt och torr, når upp till %1 mm över duken, i genomsnitt %2 mm.</translation>
    </message>
    <message>
        <source>Select by wetness</source>
        <translation>Markera efter våthet</translation>
    </message>
    <message>
        <source>Select by height</source>
        <translation>Markera efter höjd</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Recorder</name>
    <message>
        <source>Nothing has been painted yet that could be shown again.</source>
        <translation>Ännu har inget målats som kan visas igen.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ReferenceCommands</name>
    <message>
        <source>Add reference pictures</source>
        <translation>Lägg till referensbilder</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>Bilder (%1);;Alla filer (*)</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>bilden</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>There is no picture in it; save it as a file, and drag that here.</source>
        <translation>Det finns ingen bild i det; spara den som en fil, och dra den hit.</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Läser %1</translation>
    </message>
    <message>
        <source>Picked from the reference: %1</source>
        <translation>Hämtat från referensen: %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::RepaintWindow</name>
    <message>
        <source>Paused</source>
        <translation>Pausad</translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation>ungefär %1 kvar</translation>
    </message>
    <message>
        <source>How much is painted</source>
        <translation>Hur mycket som är målat</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Spara...</translation>
    </message>
    <message>
        <source>As a painting, or as a picture</source>
        <translation>Som målning eller som bild</translation>
    </message>
    <message>
        <source>Put it on the easel</source>
        <translation>Ställ den på staffliet</translation>
    </message>
    <message>
        <source>It cannot be painted any further</source>
        <translation>Det går inte att måla vidare</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Fortsätt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>It is not painted to its end yet. Give it up?</source>
        <translation>Den är inte färdigmålad än. Ge upp?</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Klart</translation>
    </message>
    <message>
        <source>Painted again at %1 px/mm</source>
        <translation>Målas om med %1 px/mm</translation>
    </message>
    <message>
        <source>The finer painting is in no file yet. Throw it away?</source>
        <translation>Den finare målningen finns inte i någon fil än. Kasta den?</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ReplayWindow</name>
    <message>
        <source>How it was painted</source>
        <translation>Så målades den</translation>
    </message>
    <message>
        <source>Play, or stop for a moment (Space)</source>
        <translation>Spela upp, eller pausa en stund (mellanslag)</translation>
    </message>
    <message>
        <source>Moment of the painting</source>
        <translation>Ögonblick i målningen</translation>
    </message>
    <message>
        <source>Drag to any moment of the painting</source>
        <translation>Dra till valfritt ögonblick i målningen</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Hastighet</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Spela upp</translation>
    </message>
    <message>
        <source>It cannot be shown any further</source>
        <translation>Den kan inte visas längre än så</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 av %2</translation>
    </message>
</context>
<context>
    <name>pastoso::main::SelectionCommands</name>
    <message>
        <source>Outside the selection: nothing is painted there.</source>
        <translation>Utanför markeringen: där målas inget.</translation>
    </message>
    <message>
        <source>Nothing was selected. Esc again goes back to painting.</source>
        <translation>Inget markerades. Tryck Esc igen för att fortsätta måla.</translation>
    </message>
    <message>
        <source>Tools keep to the outline. Esc, or taking a tool, goes back to painting.</source>
        <translation>Verktygen håller sig inom konturen. Tryck Esc, eller ta ett verktyg, för att måla igen.</translation>
    </message>
    <message>
        <source>Drag around what tools shall keep to. Shift adds, Alt takes away, both keep what is in both; a click ends the selection.</source>
        <translation>Dra runt det som verktygen ska hålla sig inom. Shift lägger till, Alt tar bort, båda behåller det som finns i båda; ett klick avslutar markeringen.</translation>
    </message>
    <message>
        <source>The brush paints again.</source>
        <translation>Penseln målar igen.</translation>
    </message>
    <message>
        <source>Selects what is inside.</source>
        <translation>Markerar det som är innanför.</translation>
    </message>
    <message>
        <source>Adds what is inside to the selection.</source>
        <translation>Lägger till det som är innanför i markeringen.</translation>
    </message>
    <message>
        <source>Takes what is inside out of the selection.</source>
        <translation>Tar bort det som är innanför ur markeringen.</translation>
    </message>
    <message>
        <source>Keeps what is inside and was selected before.</source>
        <translation>Behåller det som är innanför och redan var markerat.</translation>
    </message>
    <message>
        <source>A recording is being played; the brush is yours when it has ended.</source>
        <translation>En inspelning spelas upp; penseln blir din igen när den är slut.</translation>
    </message>
    <message>
        <source>Nothing is selected: tools work on all of the canvas.</source>
        <translation>Inget är markerat: verktygen arbetar på hela duken.</translation>
    </message>
    <message>
        <source>lasso</source>
        <translation>lasso</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>rektangel</translation>
    </message>
    <message>
        <source>ellipse</source>
        <translation>ellips</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>polygon</translation>
    </message>
    <message>
        <source>contiguous colour</source>
        <translation>sammanhängande färg</translation>
    </message>
    <message>
        <source>similar colour</source>
        <translation>liknande färg</translation>
    </message>
    <message>
        <source>Click the colour that tools shall keep to; drag to the right for more, to the left for less of it. Shift adds, Alt takes away, both keep what is in both.</source>
        <translation>Klicka på färgen som verktygen ska hålla sig till; dra åt höger för mer, åt vänster för mindre av den. Shift lägger till, Alt tar bort, båda behåller det som finns i båda.</translation>
    </message>
    <message>
        <source>Click the corners of what tools shall keep to. Enter or a double click closes it, Backspace takes the last corner back, Esc gives it up.</source>
        <translation>Klicka hörnen av det som verktygen ska hålla sig inom. Enter eller ett dubbelklick sluter det, Backsteg tar tillbaka det sista hörnet, Esc avbryter.</translation>
    </message>
    <message>
        <source>Colours that differ by up to %1. Drag to the right for more, to the left for less.</source>
        <translation>Färger som skiljer sig med upp till %1. Dra åt höger för mer, åt vänster för mindre.</translation>
    </message>
    <message>
        <source>Tools keep to colours that differ by up to %1 from the one there. Esc, or taking a tool, goes back to painting.</source>
        <translation>Verktygen håller sig till färger som skiljer sig med upp till %1 från den där. Tryck Esc, eller ta ett verktyg, för att måla igen.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::SelectionMargins</name>
    <message>
        <source>Grow the selection</source>
        <translation>Utvidga markeringen</translation>
    </message>
    <message>
        <source>The selection becomes so much wider on all sides.</source>
        <translation>Markeringen blir så mycket bredare åt alla håll.</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Utvidga</translation>
    </message>
    <message>
        <source>Shrink the selection</source>
        <translation>Krymp markeringen</translation>
    </message>
    <message>
        <source>The selection becomes so much narrower on all sides, but not along the edges of the canvas.</source>
        <translation>Markeringen blir så mycket smalare från alla håll, men inte längs dukens kanter.</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Krymp</translation>
    </message>
    <message>
        <source>Border of the selection</source>
        <translation>Markeringens kant</translation>
    </message>
    <message>
        <source>Selects a band so wide along the outline, half of it on either side.</source>
        <translation>Markerar ett så brett band längs konturen, hälften på var sida.</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Markera</translation>
    </message>
    <message>
        <source>Feather the selection</source>
        <translation>Mjuk kant på markeringen</translation>
    </message>
    <message>
        <source>The edge becomes soft: paint fades out so far on either side of the outline.</source>
        <translation>Kanten blir mjuk: färgen tonar ut så långt på båda sidor om konturen.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radie</translation>
    </message>
    <message>
        <source>Feather</source>
        <translation>Mjuka upp</translation>
    </message>
    <message>
        <source>Nothing would be left of the selection.</source>
        <translation>Inget skulle bli kvar av markeringen.</translation>
    </message>
    <message>
        <source>The selection would stay as it is.</source>
        <translation>Markeringen skulle förbli som den är.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::Studio</name>
    <message numerus="yes">
        <source>%1 is open, and %n note(s) tell what is not as it was in the file.</source>
        <translation>
            <numerusform>%1 är öppnad, och %n anmärkning säger vad som inte är som det var i filen.</numerusform>
            <numerusform>%1 är öppnad, och %n anmärkningar säger vad som inte är som det var i filen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Visa dem</translation>
    </message>
    <message>
        <source>%1 From now on the processor draws the canvas, which is slower.</source>
        <translation>%1 Från och med nu ritar processorn duken, vilket går långsammare.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TankMode</name>
    <message>
        <source>Open a tank</source>
        <translation>Öppna en tank</translation>
    </message>
    <message>
        <source>Scenes of a tank (*.json);;All files (*)</source>
        <translation>Tankscener (*.json);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Export the liquid&apos;s surface</source>
        <translation>Exportera vätskans yta</translation>
    </message>
    <message>
        <source>A folder for all moments</source>
        <translation>En mapp för alla ögonblick</translation>
    </message>
    <message>
        <source>The liquid&apos;s surface is in %1.</source>
        <translation>Vätskans yta finns i %1.</translation>
    </message>
    <message>
        <source>All surfaces are in %1.</source>
        <translation>Alla ytor finns i %1.</translation>
    </message>
    <message>
        <source>Picture of the tank</source>
        <translation>Bild av tanken</translation>
    </message>
    <message>
        <source>The tank as it is seen in the window, traced along the light&apos;s ways through glass and liquid. Choose a size and press Render.</source>
        <translation>Tanken som den syns i fönstret, spårad längs ljusets vägar genom glas och vätska. Välj en storlek och tryck på Rendera.</translation>
    </message>
    <message>
        <source>Glass tank</source>
        <translation>Glastank</translation>
    </message>
    <message>
        <source>A folder for pictures of every step</source>
        <translation>En mapp för bilder av varje steg</translation>
    </message>
    <message>
        <source>A folder for surfaces of every step</source>
        <translation>En mapp för ytor av varje steg</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s) written</source>
        <translation>
            <numerusform>%n bild skriven</numerusform>
            <numerusform>%n bilder skrivna</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n surface(s) written</source>
        <translation>
            <numerusform>%n yta skriven</numerusform>
            <numerusform>%n ytor skrivna</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pastoso::main::TankRecorder</name>
    <message numerus="yes">
        <source>%n picture(s) are in %1.</source>
        <translation>
            <numerusform>%n bild finns i %1.</numerusform>
            <numerusform>%n bilder finns i %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n surface(s) are in %1.</source>
        <translation>
            <numerusform>%n yta finns i %1.</numerusform>
            <numerusform>%n ytor finns i %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pastoso::main::TeaMode</name>
    <message>
        <source>Open a scene of milk tea</source>
        <translation>Öppna en scen med mjölkte</translation>
    </message>
    <message>
        <source>Scenes of milk tea (*.json);;All files (*)</source>
        <translation>Scener med mjölkte (*.json);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Spara scenen</translation>
    </message>
    <message>
        <source>Scenes of milk tea (*.json)</source>
        <translation>Scener med mjölkte (*.json)</translation>
    </message>
    <message>
        <source>Export the milk&apos;s surface</source>
        <translation>Exportera mjölkens yta</translation>
    </message>
    <message>
        <source>The milk&apos;s surface is in %1.</source>
        <translation>Mjölkens yta finns i %1.</translation>
    </message>
    <message>
        <source>Milk tea</source>
        <translation>Mjölkte</translation>
    </message>
    <message>
        <source>Picture of the glass</source>
        <translation>Bild av glaset</translation>
    </message>
    <message>
        <source>The glass as it is seen in the window, traced along the light&apos;s ways through glass, tea and milk. Choose a size and press Render.</source>
        <translation>Glaset som det syns i fönstret, spårat längs ljusets vägar genom glas, te och mjölk. Välj en storlek och tryck på Rendera.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TextureCommands</name>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>Bilder (%1);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Läser %1</translation>
    </message>
    <message>
        <source>The paste lies on the whole canvas, dry.</source>
        <translation>Pastan ligger på hela duken, torr.</translation>
    </message>
    <message>
        <source>The paste lies where it is selected, dry.</source>
        <translation>Pastan ligger där det är markerat, torr.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TracingCommands</name>
    <message>
        <source>Picked the colour of the picture: %1</source>
        <translation>Hämtade bildens kulör: %1</translation>
    </message>
    <message>
        <source>Trace a picture</source>
        <translation>Kalkera en bild</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>Bilder (%1);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Läser %1</translation>
    </message>
</context>
<context>
    <name>pastoso::main::TubeCommands</name>
    <message>
        <source>Save the tubes as a set</source>
        <translation>Spara tuberna som en uppsättning</translation>
    </message>
    <message>
        <source>Rename the set</source>
        <translation>Byt namn på uppsättningen</translation>
    </message>
    <message>
        <source>Name of the set:</source>
        <translation>Uppsättningens namn:</translation>
    </message>
    <message>
        <source>A set needs a name.</source>
        <translation>En uppsättning behöver ett namn.</translation>
    </message>
    <message>
        <source>Type another name: that one is empty, or another set&apos;s.</source>
        <translation>Skriv ett annat namn: det är tomt, eller en annan uppsättnings.</translation>
    </message>
    <message>
        <source>Export my sets of tubes</source>
        <translation>Exportera mina tubuppsättningar</translation>
    </message>
    <message>
        <source>my-tubes.json</source>
        <translation>mina-tuber.json</translation>
    </message>
    <message>
        <source>Sets of tubes (*.json)</source>
        <translation>Tubuppsättningar (*.json)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Sparade %1.</translation>
    </message>
    <message>
        <source>Import sets of tubes</source>
        <translation>Importera tubuppsättningar</translation>
    </message>
    <message>
        <source>You have all sets of that file already.</source>
        <translation>Du har redan alla uppsättningar i den filen.</translation>
    </message>
    <message numerus="yes">
        <source>%n set(s) added to your own.</source>
        <translation>
            <numerusform>%n uppsättning lades till dina egna.</numerusform>
            <numerusform>%n uppsättningar lades till dina egna.</numerusform>
        </translation>
    </message>
    <message>
        <source>No paint was squeezed out beside an earlier painting yet.</source>
        <translation>Ingen färg har klämts ut vid en tidigare målning än.</translation>
    </message>
</context>
<context>
    <name>pastoso::main::ViewCommands</name>
    <message>
        <source>Canvas %1 × %2 mm, %3 pixels per millimetre</source>
        <translation>Duk %1 × %2 mm, %3 pixlar per millimeter</translation>
    </message>
</context>
<context>
    <name>pastoso::main::WorkspaceCommands</name>
    <message>
        <source>There is a workspace &quot;%1&quot; already.</source>
        <translation>Det finns redan en arbetsyta ”%1”.</translation>
    </message>
    <message>
        <source>The workspace &quot;%1&quot; comes with the program: choose another name.</source>
        <translation>Arbetsytan ”%1” följer med programmet: välj ett annat namn.</translation>
    </message>
    <message>
        <source>Save the workspace</source>
        <translation>Spara arbetsytan</translation>
    </message>
    <message>
        <source>Name of the workspace; one of your own with this name is replaced:</source>
        <translation>Arbetsytans namn; en egen med samma namn ersätts:</translation>
    </message>
    <message>
        <source>Rename the workspace</source>
        <translation>Byt namn på arbetsytan</translation>
    </message>
    <message>
        <source>Name of the workspace:</source>
        <translation>Arbetsytans namn:</translation>
    </message>
</context>
<context>
    <name>pastoso::panels</name>
    <message>
        <source>never</source>
        <translation>aldrig</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>realtid</translation>
    </message>
    <message>
        <source>10 times</source>
        <translation>10 gånger</translation>
    </message>
    <message>
        <source>a minute a second</source>
        <translation>en minut per sekund</translation>
    </message>
    <message>
        <source>10 min a second</source>
        <translation>10 min per sekund</translation>
    </message>
    <message>
        <source>an hour a second</source>
        <translation>en timme per sekund</translation>
    </message>
    <message>
        <source>a day a second</source>
        <translation>ett dygn per sekund</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viskositet</translation>
    </message>
    <message>
        <source>How slowly it flows: water 1, ink 100, cream 3000, oil from the tube 300000</source>
        <translation>Hur trögt den flyter: vatten 1, bläck 100, grädde 3000, olja ur tuben 300000</translation>
    </message>
    <message>
        <source> mm²/s</source>
        <translation> mm²/s</translation>
    </message>
    <message>
        <source>Yield stress</source>
        <translation>Flytgräns</translation>
    </message>
    <message>
        <source>What it stands up to before it moves at all: at 0 it runs for ever, at 80 it keeps every bristle mark, at 200 it stands in peaks</source>
        <translation>Vad den står emot innan den rör sig alls: vid 0 rinner den i det oändliga, vid 80 behåller den varje borstspår, vid 200 står den i toppar</translation>
    </message>
    <message>
        <source> Pa</source>
        <translation> Pa</translation>
    </message>
    <message>
        <source>Flow index</source>
        <translation>Flödesindex</translation>
    </message>
    <message>
        <source>Below 1 it thins where it is sheared: a brush or a fast run finds it thinner</source>
        <translation>Under 1 blir den tunnare när den skjuvas: under penseln eller i en snabb rinning flyter den lättare</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densitet</translation>
    </message>
    <message>
        <source>Heavy paint runs faster down a tilted canvas</source>
        <translation>Tung färg rinner snabbare nedför en lutande duk</translation>
    </message>
    <message>
        <source> kg/m³</source>
        <translation> kg/m³</translation>
    </message>
    <message>
        <source>Surface tension</source>
        <translation>Ytspänning</translation>
    </message>
    <message>
        <source>Rounds drips and edges, and draws thin lines into drops</source>
        <translation>Rundar rinningar och kanter, och drar ihop tunna linjer till droppar</translation>
    </message>
    <message>
        <source> mN/m</source>
        <translation> mN/m</translation>
    </message>
    <message>
        <source>Spreads at</source>
        <translation>Breder ut sig vid</translation>
    </message>
    <message>
        <source>The edge moves out where it is steeper than this: low numbers wet the canvas easily, high ones stand in beads</source>
        <translation>Kanten flyter utåt där den är brantare än så: vid låga värden väter färgen duken lätt, vid höga står den i droppar</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Draws back at</source>
        <translation>Drar sig tillbaka vid</translation>
    </message>
    <message>
        <source>The edge draws back where it is flatter than this; 0: it stays where it was</source>
        <translation>Kanten drar sig tillbaka där den är flackare än så; 0: den stannar där den var</translation>
    </message>
    <message>
        <source>Slip</source>
        <translation>Glidning</translation>
    </message>
    <message>
        <source>Dry after</source>
        <translation>Torr efter</translation>
    </message>
    <message>
        <source>Until a film of the usual thickness can be touched, in still air</source>
        <translation>Tills ett skikt av vanlig tjocklek tål beröring, i stillastående luft</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Usual thickness</source>
        <translation>Vanlig tjocklek</translation>
    </message>
    <message>
        <source>The film that dries in that time; thicker ones take longer</source>
        <translation>Skiktet som torkar på den tiden; tjockare tar längre tid</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Stays when dry</source>
        <translation>Kvar efter torkning</translation>
    </message>
    <message>
        <source>How much of the wet thickness is left: oil keeps all, watery paint sinks in</source>
        <translation>Hur mycket av den våta tjockleken som blir kvar: olja behåller allt, vattnig färg sjunker in</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Flöde</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Yta</translation>
    </message>
    <message>
        <source>Drying</source>
        <translation>Torkning</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ingen</translation>
    </message>
    <message>
        <source>Matte</source>
        <translation>Matt</translation>
    </message>
    <message>
        <source>Satin</source>
        <translation>Satin</translation>
    </message>
    <message>
        <source>Gloss</source>
        <translation>Blank</translation>
    </message>
    <message>
        <source>half</source>
        <translation>hälften</translation>
    </message>
    <message>
        <source>a third</source>
        <translation>en tredjedel</translation>
    </message>
    <message>
        <source>a quarter</source>
        <translation>en fjärdedel</translation>
    </message>
    <message>
        <source>a fifth</source>
        <translation>en femtedel</translation>
    </message>
    <message>
        <source>a tenth</source>
        <translation>en tiondel</translation>
    </message>
    <message>
        <source>less than a tenth</source>
        <translation>mindre än en tiondel</translation>
    </message>
    <message>
        <source>stiff</source>
        <translation>styv</translation>
    </message>
    <message>
        <source>runny</source>
        <translation>rinnig</translation>
    </message>
    <message>
        <source>From paint that stands in peaks to paint that runs like ink: viscosity and yield stress</source>
        <translation>Från färg som står i toppar till färg som rinner som bläck: viskositet och flytgräns</translation>
    </message>
    <message>
        <source>short</source>
        <translation>kort</translation>
    </message>
    <message>
        <source>long</source>
        <translation>lång</translation>
    </message>
    <message>
        <source>opaque</source>
        <translation>täckande</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>transparent</translation>
    </message>
    <message>
        <source>From paint that hides what lies below to a glaze: how much pigment is in it</source>
        <translation>Från färg som döljer det som ligger under till en lasyr: hur mycket pigment som finns i den</translation>
    </message>
    <message>
        <source>Pigment</source>
        <translation>Pigment</translation>
    </message>
    <message>
        <source>How much of full-strength paint is in it: paint from the tube 100, a glaze 3 to 6</source>
        <translation>Hur mycket färg av full styrka som finns i den: färg ur tuben 100, en lasyr 3 till 6</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Kulör</translation>
    </message>
    <message>
        <source>Loosens by</source>
        <translation>Lossnar med</translation>
    </message>
    <message>
        <source>Thixotropy: how much of its stiffness is gone where a tool or a run works it; brush marks level a little, and then stand</source>
        <translation>Tixotropi: hur mycket av styvheten som försvinner där ett verktyg eller ett rinn bearbetar färgen; penselspåren jämnas ut lite och står sedan kvar</translation>
    </message>
    <message>
        <source>Stiffens in</source>
        <translation>Styvnar på</translation>
    </message>
    <message>
        <source>How long it rests until two thirds of what it lost have come back</source>
        <translation>Hur länge den vilar tills två tredjedelar av den förlorade styvheten är tillbaka</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Loosens after</source>
        <translation>Lossnar efter</translation>
    </message>
    <message>
        <source>How far it has to run before it is loosened, in times its own thickness</source>
        <translation>Hur långt den måste rinna innan den lossnar, i gånger sin egen tjocklek</translation>
    </message>
    <message>
        <source>round</source>
        <translation>rund</translation>
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
        <translation>solfjäder</translation>
    </message>
    <message>
        <source>knife</source>
        <translation>kniv</translation>
    </message>
    <message>
        <source>comb</source>
        <translation>kam</translation>
    </message>
    <message>
        <source>soft pad</source>
        <translation>mjuk dyna</translation>
    </message>
    <message>
        <source>used as it is</source>
        <translation>används som det är</translation>
    </message>
    <message>
        <source>dipped in paint</source>
        <translation>doppas i färg</translation>
    </message>
    <message>
        <source>stays on the tool</source>
        <translation>stannar på verktyget</translation>
    </message>
    <message>
        <source>is thrown away</source>
        <translation>kastas bort</translation>
    </message>
    <message>
        <source>another in each stroke</source>
        <translation>ny i varje drag</translation>
    </message>
    <message>
        <source>always the same</source>
        <translation>alltid densamma</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>How the elements of the tip are arranged.</source>
        <translation>Hur spetsens delar är ordnade.</translation>
    </message>
    <message>
        <source>Before use</source>
        <translation>Före användning</translation>
    </message>
    <message>
        <source>A brush is dipped; a rag or a comb is used as it is.</source>
        <translation>En pensel doppas; en trasa eller kam används som den är.</translation>
    </message>
    <message>
        <source>What it takes</source>
        <translation>Det den tar</translation>
    </message>
    <message>
        <source>A rag throws away what it takes up; it never comes back.</source>
        <translation>En trasa kastar bort det den tar upp; det kommer aldrig tillbaka.</translation>
    </message>
    <message>
        <source>Chance</source>
        <translation>Slump</translation>
    </message>
    <message>
        <source>Small random differences, such as where drops fall.</source>
        <translation>Små slumpmässiga skillnader, till exempel var droppar faller.</translation>
    </message>
    <message>
        <source>%1 From %2 to %3%4.</source>
        <translation>%1 Från %2 till %3%4.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Tjocklek</translation>
    </message>
    <message>
        <source>Hair length</source>
        <translation>Hårlängd</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Spets</translation>
    </message>
    <message>
        <source>Bristles</source>
        <translation>Borst</translation>
    </message>
    <message>
        <source>Hairs in each</source>
        <translation>Hår i varje</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Exemplar</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Böjning</translation>
    </message>
    <message>
        <source>Splay</source>
        <translation>Spridning</translation>
    </message>
    <message>
        <source>Trail</source>
        <translation>Släp</translation>
    </message>
    <message>
        <source>Press depth</source>
        <translation>Tryckdjup</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Lutning</translation>
    </message>
    <message>
        <source>Into the weave</source>
        <translation>Ned i väven</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Styvhet</translation>
    </message>
    <message>
        <source>Ride</source>
        <translation>Glidning</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Skikt</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>Räcker</translation>
    </message>
    <message>
        <source>Grooves</source>
        <translation>Åsar</translation>
    </message>
    <message>
        <source>Hair streaks</source>
        <translation>Hårstrimmor</translation>
    </message>
    <message>
        <source>Uneven load</source>
        <translation>Ojämn laddning</translation>
    </message>
    <message>
        <source>Gathering</source>
        <translation>Samling</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanter</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Början</translation>
    </message>
    <message>
        <source>Stays behind</source>
        <translation>Stannar kvar</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Räckvidd</translation>
    </message>
    <message>
        <source>Pickup</source>
        <translation>Upptagning</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>Blandning</translation>
    </message>
    <message>
        <source>Wicking</source>
        <translation>Uppsugning</translation>
    </message>
    <message>
        <source> /mm</source>
        <translation> /mm</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>Släpning</translation>
    </message>
    <message>
        <source>Overflow</source>
        <translation>Överflöd</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>Least step</source>
        <translation>Minsta steg</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Utjämning</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>String</source>
        <translation>Snöre</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Droppe</translation>
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
        <translation>Flöde</translation>
    </message>
    <message>
        <source> mm³/s</source>
        <translation> mm³/s</translation>
    </message>
    <message>
        <source>First drop</source>
        <translation>Första droppen</translation>
    </message>
    <message>
        <source>Bottle</source>
        <translation>Flaska</translation>
    </message>
    <message>
        <source>Steepness</source>
        <translation>Branthet</translation>
    </message>
    <message>
        <source>Centring</source>
        <translation>Centrering</translation>
    </message>
    <message>
        <source>Throw</source>
        <translation>Kast</translation>
    </message>
    <message>
        <source>Air pressure</source>
        <translation>Lufttryck</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Spets</translation>
    </message>
    <message>
        <source>Hairs</source>
        <translation>Hår</translation>
    </message>
    <message>
        <source>Paint it leaves</source>
        <translation>Färg det lämnar</translation>
    </message>
    <message>
        <source>Paint it takes</source>
        <translation>Färg det tar</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Penseldrag</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Droppar</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>nib</source>
        <translation>pennspets</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Tänder</translation>
    </message>
    <message>
        <source>Pores</source>
        <translation>Porer</translation>
    </message>
    <message>
        <source>Girth</source>
        <translation>Omkrets</translation>
    </message>
    <message>
        <source>On the grain</source>
        <translation>På kornet</translation>
    </message>
    <message>
        <source>%1: %2 to %3%4</source>
        <translation>%1: %2 till %3%4</translation>
    </message>
    <message>
        <source>Middle, from the left</source>
        <translation>Mitten, från vänster</translation>
    </message>
    <message>
        <source>Middle, from above</source>
        <translation>Mitten, uppifrån</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Lutning</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höjd</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Vriden</translation>
    </message>
    <message>
        <source>First point, from the left</source>
        <translation>Första punkten, från vänster</translation>
    </message>
    <message>
        <source>First point, from above</source>
        <translation>Första punkten, uppifrån</translation>
    </message>
    <message>
        <source>Second point, from the left</source>
        <translation>Andra punkten, från vänster</translation>
    </message>
    <message>
        <source>Second point, from above</source>
        <translation>Andra punkten, uppifrån</translation>
    </message>
    <message>
        <source>Third point, from the left</source>
        <translation>Tredje punkten, från vänster</translation>
    </message>
    <message>
        <source>Third point, from above</source>
        <translation>Tredje punkten, uppifrån</translation>
    </message>
    <message>
        <source>Slope of the horizon</source>
        <translation>Horisontens lutning</translation>
    </message>
    <message>
        <source>Crossing, from the left</source>
        <translation>Korsningen, från vänster</translation>
    </message>
    <message>
        <source>Crossing, from above</source>
        <translation>Korsningen, uppifrån</translation>
    </message>
    <message>
        <source>Slope of the first lines</source>
        <translation>De första linjernas lutning</translation>
    </message>
    <message>
        <source>Spacing of the first lines</source>
        <translation>De första linjernas avstånd</translation>
    </message>
    <message>
        <source>Slope of the others</source>
        <translation>De andras lutning</translation>
    </message>
    <message>
        <source>Spacing of the others</source>
        <translation>De andras avstånd</translation>
    </message>
    <message>
        <source>Snaps within</source>
        <translation>Fäster inom</translation>
    </message>
    <message>
        <source>From paint that breaks off sharply to paint that flows out at its edges and in long runs: the angle at which it spreads, the front and tail of drips, and the flow index</source>
        <translation>Från färg som bryter tvärt till färg som flyter ut i kanterna och i långa rinningar: vinkeln den breder ut sig vid, rinningens front och svans, och flytindex</translation>
    </message>
    <message>
        <source>How easily it slides over the canvas, in pixels of the painting: more lets edges run on</source>
        <translation>Hur lätt den glider över duken, i pixlar i målningen: mer låter kanterna rinna vidare</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Front of drips</source>
        <translation>Rinningens front</translation>
    </message>
    <message>
        <source>How fast a drip goes at its front, where surface tension holds it back: less makes it thicker and rounder there</source>
        <translation>Hur fort en rinning går vid sin front, där ytspänningen håller emot: mindre gör den tjockare och rundare där</translation>
    </message>
    <message>
        <source>Tail of drips</source>
        <translation>Rinningens svans</translation>
    </message>
    <message>
        <source>How fast a drip follows at its tail, where surface tension draws it along: more makes it thinner there</source>
        <translation>Hur fort en rinning följer efter vid sin svans, där ytspänningen drar den med sig: mer gör den tunnare där</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::AidsPart</name>
    <message>
        <source>Harmony and gamut mask</source>
        <translation>Harmoni och färgmask</translation>
    </message>
    <message>
        <source>Marks for hues that go together, and a shape on the wheel to choose within</source>
        <translation>Märken för nyanser som passar ihop, och en form på hjulet att välja inom</translation>
    </message>
    <message>
        <source>Harmony</source>
        <translation>Harmoni</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ingen</translation>
    </message>
    <message>
        <source>Complementary</source>
        <translation>Komplementär</translation>
    </message>
    <message>
        <source>Split complementary</source>
        <translation>Delad komplementär</translation>
    </message>
    <message>
        <source>Analogous</source>
        <translation>Närliggande</translation>
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
        <translation>Nyanserna som passar till din är märkta på ringen: ett klick tar en</translation>
    </message>
    <message>
        <source>Gamut mask</source>
        <translation>Färgmask</translation>
    </message>
    <message>
        <source>Atmospheric triad</source>
        <translation>Atmosfärisk triad</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cirkel</translation>
    </message>
    <message>
        <source>The colours of one lightness on a disc, and a shape that the wheel keeps to</source>
        <translation>Färgerna av en ljushet på en skiva, och en form som hjulet håller sig till</translation>
    </message>
    <message>
        <source>Turn of the gamut mask</source>
        <translation>Färgmaskens vridning</translation>
    </message>
    <message>
        <source>Turns the gamut mask</source>
        <translation>Vrider färgmasken</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushEditor</name>
    <message>
        <source>Brush editor</source>
        <translation>Penselredigerare</translation>
    </message>
    <message>
        <source>A stroke of the tool in hand, pressed hardest in its middle</source>
        <translation>Ett drag med verktyget i handen, hårdast tryckt på mitten</translation>
    </message>
    <message>
        <source>The same stroke of the tool as it is saved</source>
        <translation>Samma drag med verktyget som det är sparat</translation>
    </message>
    <message>
        <source>As saved</source>
        <translation>Som sparat</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Jämför</translation>
    </message>
    <message>
        <source>Shows below the stroke of the tool as it is saved</source>
        <translation>Visar nedanför draget med verktyget som det är sparat</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Återgå</translation>
    </message>
    <message>
        <source>Takes back all changes of the tool in hand</source>
        <translation>Tar tillbaka alla ändringar av verktyget i handen</translation>
    </message>
    <message>
        <source>In hand</source>
        <translation>I handen</translation>
    </message>
    <message>
        <source>Parts of the tool</source>
        <translation>Verktygets delar</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurvor</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, ändrat</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushFinder</name>
    <message>
        <source>Which tools are listed</source>
        <translation>Vilka verktyg som visas</translation>
    </message>
    <message>
        <source>Find a tool</source>
        <translation>Sök verktyg</translation>
    </message>
    <message>
        <source>A few letters of its name or of its family; Return takes the first</source>
        <translation>Några bokstäver i dess namn eller grupp; Retur tar det första</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alla</translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>Favoriter</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Senaste</translation>
    </message>
    <message>
        <source>My own</source>
        <translation>Mina egna</translation>
    </message>
    <message>
        <source>No tool has such a name.</source>
        <translation>Inget verktyg heter så.</translation>
    </message>
    <message>
        <source>Tools that you mark with a star are listed here.</source>
        <translation>Verktyg som du märker med en stjärna visas här.</translation>
    </message>
    <message>
        <source>Tools that you have taken are listed here, the latest first.</source>
        <translation>Verktyg som du har tagit visas här, det senaste först.</translation>
    </message>
    <message>
        <source>Tools that you save as your own are listed here.</source>
        <translation>Verktyg som du sparar som egna visas här.</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushList</name>
    <message>
        <source>%1, your own</source>
        <translation>%1, ditt eget</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushPanel</name>
    <message>
        <source>Brush</source>
        <translation>Pensel</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Width of the brush&apos;s tip  ([ and ])</source>
        <translation>Bredden på penselns spets  ([ och ])</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>Stabilisera</translation>
    </message>
    <message>
        <source>How the hand is steadied</source>
        <translation>Hur handen stabiliseras</translation>
    </message>
    <message>
        <source>off</source>
        <translation>av</translation>
    </message>
    <message>
        <source>lags behind</source>
        <translation>släpar efter</translation>
    </message>
    <message>
        <source>pulled on a string</source>
        <translation>dras i ett snöre</translation>
    </message>
    <message>
        <source>How much the hand is steadied</source>
        <translation>Hur mycket handen stabiliseras</translation>
    </message>
    <message>
        <source>Length of the string: wide curves without a tremor</source>
        <translation>Snörets längd: vida kurvor utan darr</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>How far the brush lags behind the hand</source>
        <translation>Hur långt penseln släpar efter handen</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Width of the brush&apos;s tip</source>
        <translation>Penselspetsens bredd</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Etiketter</translation>
    </message>
    <message>
        <source>New tag...</source>
        <translation>Ny etikett...</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ColourPanel</name>
    <message>
        <source>Mix a colour</source>
        <translation>Blanda en kulör</translation>
    </message>
    <message>
        <source>Nearest from the tubes</source>
        <translation>Närmast ur tuberna</translation>
    </message>
    <message>
        <source>Use the recipe</source>
        <translation>Använd receptet</translation>
    </message>
    <message>
        <source>Dip the brush in this mixture from the tubes instead</source>
        <translation>Doppa penseln i den här blandningen ur tuberna i stället</translation>
    </message>
    <message>
        <source>Used before</source>
        <translation>Använda tidigare</translation>
    </message>
    <message>
        <source>Your palette</source>
        <translation>Din palett</translation>
    </message>
    <message>
        <source>Paints that you keep stay here.</source>
        <translation>Färger som du behåller stannar här.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behåll</translation>
    </message>
    <message>
        <source>Lay the paint in hand out on your palette</source>
        <translation>Lägg ut färgen i handen på din palett</translation>
    </message>
    <message>
        <source>The colour itself, as a paint of its own: %1</source>
        <translation>Själva kulören, som en egen färg: %1</translation>
    </message>
    <message>
        <source>Your palette is full: the right button takes a paint away.</source>
        <translation>Din palett är full: höger knapp tar bort en färg.</translation>
    </message>
    <message>
        <source>%1
The right button, or Delete, takes it away.</source>
        <translation>%1
Höger knapp, eller Delete, tar bort den.</translation>
    </message>
    <message>
        <source>%1
ΔE %2, %3; %4</source>
        <translation>%1
ΔE %2, %3; %4</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Spara...</translation>
    </message>
    <message>
        <source>The colours of your palette for GIMP, Krita or Inkscape, as a .gpl file</source>
        <translation>Färgerna på din palett för GIMP, Krita eller Inkscape, som en .gpl-fil</translation>
    </message>
    <message>
        <source>There is no room for more mixes; take one away first.</source>
        <translation>Det finns inte plats för fler blandningar; ta bort en först.</translation>
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
        <translation>Ljushet, kroma och nyans som ögat ser dem</translation>
    </message>
    <message>
        <source>HSV</source>
        <translation>HSV</translation>
    </message>
    <message>
        <source>Hue, saturation and value</source>
        <translation>Nyans, mättnad och värde</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>Red, green and blue of the screen</source>
        <translation>Skärmens rött, grönt och blått</translation>
    </message>
    <message>
        <source>The colour as it is written, for example #c03020</source>
        <translation>Kulören i skrift, till exempel #c03020</translation>
    </message>
    <message>
        <source>Colour as written</source>
        <translation>Kulören i skrift</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; write it for example as #c03020.</source>
        <translation>”%1” är ingen kulör; skriv den till exempel som #c03020.</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ColourWheel</name>
    <message>
        <source>Colour wheel</source>
        <translation>Färghjul</translation>
    </message>
    <message>
        <source>The ring is the hue. Inside, lightness goes up and chroma to the right, as far as the
screen has it. Keys: arrows, Page Up and Page Down for the hue, with Ctrl finely.</source>
        <translation>Ringen är nyansen. Inuti ökar ljusheten uppåt och kroman åt höger, så långt
skärmen räcker. Tangenter: piltangenter, Page Up och Page Down för nyansen, fint med Ctrl.</translation>
    </message>
    <message>
        <source>Lightness %1 %, chroma %2, hue %3°</source>
        <translation>Ljushet %1 %, kroma %2, nyans %3°</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::CurveEditor</name>
    <message>
        <source>Curve</source>
        <translation>Kurva</translation>
    </message>
    <message>
        <source>Drag a point, click beside one to add another, right click to take one away.
Keys: Page Up and Page Down choose, arrows move, Insert adds, Delete takes away.</source>
        <translation>Dra en punkt, klicka bredvid för att lägga till en, högerklicka för att ta bort en.
Tangenter: Page Up och Page Down väljer, pilarna flyttar, Insert lägger till, Delete tar bort.</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n punkt</numerusform>
            <numerusform>%n punkter</numerusform>
        </translation>
    </message>
    <message>
        <source>Point %1 of %2: %3 % across, %4 % up</source>
        <translation>Punkt %1 av %2: %3 % åt höger, %4 % upp</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::CurvesPanel</name>
    <message>
        <source>Add</source>
        <translation>Lägg till</translation>
    </message>
    <message>
        <source>Another curve: what of the hand sets what of the tool</source>
        <translation>Ännu en kurva: vad hos handen som styr vad hos verktyget</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Takes this curve away</source>
        <translation>Tar bort den här kurvan</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Återställ</translation>
    </message>
    <message>
        <source>The curve as the tool was kept with</source>
        <translation>Kurvan som verktyget sparades med</translation>
    </message>
    <message>
        <source>How it answers to the hand</source>
        <translation>Hur det svarar på handen</translation>
    </message>
    <message>
        <source>What of the hand sets what of the tool</source>
        <translation>Vad hos handen som styr vad hos verktyget</translation>
    </message>
    <message>
        <source>This tool has no curves.</source>
        <translation>Det här verktyget har inga kurvor.</translation>
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
        <translation>Lutning</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Ljus</translation>
    </message>
    <message>
        <source>Drying</source>
        <translation>Torkning</translation>
    </message>
    <message>
        <source>How fast wet paint dries; D dries it at once</source>
        <translation>Hur snabbt våt färg torkar; D torkar den på en gång</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>plan</translation>
    </message>
    <message>
        <source>How steeply the canvas stands</source>
        <translation>Hur brant duken står</translation>
    </message>
    <message>
        <source>Where down is: 0 right, 90 bottom</source>
        <translation>Vart nedåt är: 0 åt höger, 90 neråt</translation>
    </message>
    <message>
        <source>How high the lamp stands</source>
        <translation>Hur högt lampan står</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 right, 90 top</source>
        <translation>Varifrån ljuset kommer: 0 från höger, 90 uppifrån</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::FeelRow</name>
    <message>
        <source>From %1 to %2</source>
        <translation>Från %1 till %2</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::GuidesPanel</name>
    <message>
        <source>Mirrors and copies</source>
        <translation>Speglar och kopior</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Kopior</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Från vänster</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Uppifrån</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axel</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::HistoryModel</name>
    <message>
        <source>As far back as is kept</source>
        <translation>Så långt tillbaka som finns kvar</translation>
    </message>
    <message>
        <source>Click: do again up to here</source>
        <translation>Klicka: gör om fram till hit</translation>
    </message>
    <message>
        <source>Click: go back to this moment</source>
        <translation>Klicka: gå tillbaka till det här ögonblicket</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::HistoryPanel</name>
    <message>
        <source>What was done</source>
        <translation>Vad som har gjorts</translation>
    </message>
    <message>
        <source>What the steps take; &quot;Memory for undo&quot; in the Edit menu says how much they may</source>
        <translation>Vad stegen tar; ”Ångraminne” i menyn Redigera anger hur mycket de får ta</translation>
    </message>
    <message>
        <source>%1 of %2 MB</source>
        <translation>%1 av %2 MB</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::IlluminantBox</name>
    <message>
        <source>The light on the easel; the paint stays as it is</source>
        <translation>Ljuset på staffliet; färgen förblir som den är</translation>
    </message>
    <message>
        <source>Daylight (D65)</source>
        <translation>Dagsljus (D65)</translation>
    </message>
    <message>
        <source>Print booth (D50)</source>
        <translation>Granskningsljus (D50)</translation>
    </message>
    <message>
        <source>Light bulb (A)</source>
        <translation>Glödlampa (A)</translation>
    </message>
    <message>
        <source>LED lamp</source>
        <translation>LED-lampa</translation>
    </message>
    <message>
        <source>From a file...</source>
        <translation>Från en fil...</translation>
    </message>
    <message>
        <source>Seen in</source>
        <translation>Betraktas i</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LaidGuidePart</name>
    <message>
        <source>Guide</source>
        <translation>Hjälplinje</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Snapping strength</source>
        <translation>Fäststyrka</translation>
    </message>
    <message>
        <source>How far the guide draws the brush from where your hand is: 0 not at all, 100 all the way</source>
        <translation>Hur långt hjälplinjen drar penseln från handens plats: 0 inte alls, 100 hela vägen</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>What guides your strokes</source>
        <translation>Vad som styr dina drag</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Linjal</translation>
    </message>
    <message>
        <source>Parallel ruler</source>
        <translation>Parallell linjal</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellips</translation>
    </message>
    <message>
        <source>Concentric ellipse</source>
        <translation>Koncentrisk ellips</translation>
    </message>
    <message>
        <source>1 point perspective</source>
        <translation>1-punktsperspektiv</translation>
    </message>
    <message>
        <source>2 point perspective</source>
        <translation>2-punktsperspektiv</translation>
    </message>
    <message>
        <source>3 point perspective</source>
        <translation>3-punktsperspektiv</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Rutnät</translation>
    </message>
    <message>
        <source>Lies on the canvas</source>
        <translation>På duken</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LayerModel</name>
    <message>
        <source>a group of %1</source>
        <translation>en grupp med %1 lager</translation>
    </message>
    <message>
        <source>the layer that you paint on</source>
        <translation>lagret som du målar på</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>dolt</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>låst</translation>
    </message>
    <message>
        <source>opacity %1 %</source>
        <translation>opacitet %1 %</translation>
    </message>
    <message>
        <source>what is bare is locked</source>
        <translation>det som är bart är låst</translation>
    </message>
    <message>
        <source>clipped to the layer below</source>
        <translation>begränsat till lagret under</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LayerPanel</name>
    <message>
        <source>Layers</source>
        <translation>Lager</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacitet</translation>
    </message>
    <message>
        <source>Fades what its paint does to light; its relief stays</source>
        <translation>Tonar ned färgens verkan på ljuset; reliefen blir kvar</translation>
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
        <translation>Dra lampan: nära kanten ger den släpljus över reliefen. Dubbelklicka för att ställa tillbaka den.
Tangenter: pilarna flyttar den, Home ställer tillbaka den.</translation>
    </message>
    <message>
        <source>%1° high, from %2°</source>
        <translation>%1° hög, från %2°</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LightPanel</name>
    <message>
        <source>Seen in</source>
        <translation>Betraktas i</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Lampa</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Från</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 right, 90 above, 180 left, 270 below</source>
        <translation>Varifrån ljuset kommer: 0 höger, 90 ovanifrån, 180 vänster, 270 nedifrån</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höjd</translation>
    </message>
    <message>
        <source>Low light rakes over the relief, 90 is overhead</source>
        <translation>Lågt ljus ger släpljus över reliefen, 90 är rakt ovanifrån</translation>
    </message>
    <message>
        <source>Even light</source>
        <translation>Jämnt ljus</translation>
    </message>
    <message>
        <source>The part of the light that comes from all sides; the lamp gives the rest. More of it softens the relief</source>
        <translation>Den del av ljuset som kommer från alla håll; lampan ger resten. Mer av det mjukar upp reliefen</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Varnish</source>
        <translation>Fernissa</translation>
    </message>
    <message>
        <source>A clear coat to look through, here and in exports; it changes no paint, and can be taken off again</source>
        <translation>Ett klart skikt att se igenom, här och vid export; det ändrar ingen färg, och kan tas bort igen</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Mängd</translation>
    </message>
    <message>
        <source>A thin coat evens the gloss only in part</source>
        <translation>Ett tunt skikt jämnar bara delvis ut glansen</translation>
    </message>
    <message>
        <source>Aged</source>
        <translation>Åldrad</translation>
    </message>
    <message>
        <source>Old varnish turns yellow: 100 % is about a century</source>
        <translation>Gammal fernissa gulnar: 100 % är ungefär ett sekel</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LoadBar</name>
    <message>
        <source>The paint in the brush, across its width: how full it is, and of which colour</source>
        <translation>Färgen i penseln, tvärs över dess bredd: hur full den är, och av vilken kulör</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LoadPanel</name>
    <message>
        <source>On the brush</source>
        <translation>På penseln</translation>
    </message>
    <message>
        <source>How the brush is dipped, from the next time on</source>
        <translation>Hur penseln doppas, från och med nästa gång</translation>
    </message>
    <message>
        <source>Full, in one paint</source>
        <translation>Full, i en färg</translation>
    </message>
    <message>
        <source>Only the tip</source>
        <translation>Bara spetsen</translation>
    </message>
    <message>
        <source>One paint on each side</source>
        <translation>En färg på var sida</translation>
    </message>
    <message>
        <source>Half mixed from two</source>
        <translation>Halvblandad av två</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Fyllnad</translation>
    </message>
    <message>
        <source>How full the brush is dipped; little leaves a dry brush</source>
        <translation>Hur full penseln doppas; lite ger en torr pensel</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Andra färgen</translation>
    </message>
    <message>
        <source>The second paint&apos;s share of a half-mixed load</source>
        <translation>Den andra färgens andel när färgerna är halvblandade</translation>
    </message>
    <message>
        <source>In hand: %1</source>
        <translation>I handen: %1</translation>
    </message>
    <message>
        <source>The second paint of the load: %1</source>
        <translation>Den andra färgen på penseln: %1</translation>
    </message>
    <message>
        <source>The second paint, laid out for later: %1</source>
        <translation>Den andra färgen, framlagd till senare: %1</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>tom</translation>
    </message>
    <message>
        <source>all but empty</source>
        <translation>nästan tom</translation>
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
        <translation>Ursprungligt</translation>
    </message>
    <message>
        <source>Kind of paint</source>
        <translation>Färgtyp</translation>
    </message>
    <message>
        <source>The brush is cleaned, and dipped in paint of this kind</source>
        <translation>Penseln rengörs, och doppas i färg av den här typen</translation>
    </message>
    <message>
        <source>Takes back what was changed below</source>
        <translation>Tar tillbaka det som ändrats nedan</translation>
    </message>
    <message>
        <source>What it is like</source>
        <translation>Hur den är</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Siffror</translation>
    </message>
    <message>
        <source>Each number of the paint</source>
        <translation>Varje siffra för färgen</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MessageBar</name>
    <message>
        <source>What needs your attention</source>
        <translation>Det som behöver din uppmärksamhet</translation>
    </message>
    <message>
        <source>Put away</source>
        <translation>Lägg undan</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MessagePanel</name>
    <message>
        <source>Messages</source>
        <translation>Meddelanden</translation>
    </message>
    <message>
        <source>Nothing has been told yet.</source>
        <translation>Inget har meddelats än.</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Kopiera allt</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Rensa</translation>
    </message>
    <message>
        <source>All messages, to be pasted elsewhere</source>
        <translation>Alla meddelanden, att klistra in någon annanstans</translation>
    </message>
    <message>
        <source>Take all messages off the list</source>
        <translation>Ta bort alla meddelanden från listan</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MixesPart</name>
    <message>
        <source>Your mixes</source>
        <translation>Dina blandningar</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Byt namn</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Keep as a mix</source>
        <translation>Behåll som blandning</translation>
    </message>
    <message>
        <source>Keep the paint in hand as a recipe of tubes, under a name of your own</source>
        <translation>Behåll färgen i handen som ett recept av tuber, under ett eget namn</translation>
    </message>
    <message>
        <source>Take the chosen mix away</source>
        <translation>Ta bort den valda blandningen</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportera...</translation>
    </message>
    <message>
        <source>Save your mixes and your palette as a file for others</source>
        <translation>Spara dina blandningar och din palett som en fil för andra</translation>
    </message>
    <message>
        <source>Import...</source>
        <translation>Importera...</translation>
    </message>
    <message>
        <source>Add the mixes and the palette of such a file</source>
        <translation>Lägg till blandningarna och paletten ur en sådan fil</translation>
    </message>
    <message>
        <source>Paints that you keep are listed here, under names of your own.</source>
        <translation>Färger som du behåller visas här, under namn som du själv ger dem.</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MousePart</name>
    <message>
        <source>Pressure</source>
        <translation>Tryck</translation>
    </message>
    <message>
        <source>How hard the brush is pressed</source>
        <translation>Hur hårt penseln trycks</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Lighter the faster it goes</source>
        <translation>Lättare ju fortare det går</translation>
    </message>
    <message>
        <source>A slow line is pressed as set above, a fast one down to a quarter of it</source>
        <translation>En långsam linje får trycket ovan, en snabb ned till en fjärdedel av det</translation>
    </message>
    <message>
        <source>A mouse, or a finger on the screen, does not tell how hard it presses.</source>
        <translation>En mus, eller ett finger på skärmen, anger inte hur hårt den trycker.</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::NavigatorMap</name>
    <message>
        <source>The middle of the window is %1 % from the left and %2 % from the top</source>
        <translation>Fönstrets mitt är %1 % från vänster och %2 % uppifrån</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::NavigatorPanel</name>
    <message>
        <source>The whole canvas</source>
        <translation>Hela duken</translation>
    </message>
    <message>
        <source>Drag the frame, or click, to go there
Wheel: closer, farther</source>
        <translation>Dra ramen, eller klicka, för att gå dit
Hjulet: närmare, längre bort</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Screen pixels for a pixel of the saved picture</source>
        <translation>Skärmpixlar per pixel i den sparade bilden</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Vriden</translation>
    </message>
    <message>
        <source>How far the canvas is turned, clockwise</source>
        <translation>Hur långt duken är vriden, medurs</translation>
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
        <translation>ingen öppnad</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Öppna...</translation>
    </message>
    <message>
        <source>Colours of GIMP, Krita or Inkscape, from a .gpl file</source>
        <translation>Färger från GIMP, Krita eller Inkscape, ur en .gpl-fil</translation>
    </message>
    <message>
        <source>From a picture...</source>
        <translation>Från en bild...</translation>
    </message>
    <message>
        <source>Finds the colours that a picture is made of</source>
        <translation>Hittar färgerna som en bild består av</translation>
    </message>
    <message>
        <source>Colours of the picture</source>
        <translation>Bildens färger</translation>
    </message>
    <message>
        <source>How many colours are looked for</source>
        <translation>Hur många färger som söks</translation>
    </message>
    <message>
        <source>As recipes of the tubes</source>
        <translation>Som recept ur tuberna</translation>
    </message>
    <message>
        <source>A click dips the brush in the nearest mixture of tubes, not in the colour itself</source>
        <translation>Ett klick doppar penseln i den närmaste blandningen ur tuberna, inte i själva färgen</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>Från en fil</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PaceNotice</name>
    <message>
        <source>The paint runs at %1 of its pace.</source>
        <translation>Färgen rör sig med %1 av sin fart.</translation>
    </message>
    <message>
        <source>Time runs at %1 of %2 ×.</source>
        <translation>Tiden går med %1 av %2 ×.</translation>
    </message>
    <message>
        <source>What helps</source>
        <translation>Vad som hjälper</translation>
    </message>
    <message>
        <source>What lets the paint keep up again</source>
        <translation>Vad som låter färgen hinna med igen</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PaintPanel</name>
    <message>
        <source>The medium without pigment, for example thinner</source>
        <translation>Mediet utan pigment, till exempel förtunning</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Färg</translation>
    </message>
    <message>
        <source>%1 (%2), %3
As the tool in hand lays it (%4 mm), thinned over white and over black, and with white</source>
        <translation>%1 (%2), %3
Som verktyget i handen lägger den (%4 mm), utdragen tunt över vitt och över svart, och med vitt</translation>
    </message>
    <message>
        <source>Put into a set</source>
        <translation>Lägg i en uppsättning</translation>
    </message>
    <message>
        <source>Take out of this set</source>
        <translation>Ta ur den här uppsättningen</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PenButtons</name>
    <message>
        <source>Ends and buttons of pens</source>
        <translation>Pennornas ändar och knappar</translation>
    </message>
    <message>
        <source>Eraser end</source>
        <translation>Suddände</translation>
    </message>
    <message>
        <source>Lower button</source>
        <translation>Nedre knappen</translation>
    </message>
    <message>
        <source>Upper button</source>
        <translation>Övre knappen</translation>
    </message>
    <message>
        <source>picks up paint</source>
        <translation>hämtar färg</translation>
    </message>
    <message>
        <source>picks the colour seen</source>
        <translation>hämtar kulören som syns</translation>
    </message>
    <message>
        <source>moves the canvas</source>
        <translation>flyttar duken</translation>
    </message>
    <message>
        <source>opens the palette</source>
        <translation>öppnar paletten</translation>
    </message>
    <message>
        <source>does nothing</source>
        <translation>gör inget</translation>
    </message>
    <message>
        <source>takes %1</source>
        <translation>tar %1</translation>
    </message>
    <message>
        <source>paints like the tip</source>
        <translation>målar som spetsen</translation>
    </message>
    <message>
        <source>Third button</source>
        <translation>Tredje knappen</translation>
    </message>
    <message>
        <source>Wheel forward</source>
        <translation>Hjulet framåt</translation>
    </message>
    <message>
        <source>Wheel back</source>
        <translation>Hjulet bakåt</translation>
    </message>
    <message>
        <source>Fingers paint</source>
        <translation>Fingrar målar</translation>
    </message>
    <message>
        <source>Otherwise one finger moves the canvas, as two always do</source>
        <translation>Annars flyttar ett finger duken, som två alltid gör</translation>
    </message>
    <message>
        <source>Wet mark</source>
        <translation>Vått märke</translation>
    </message>
    <message>
        <source>Shows paint under the pen at once, until the paint itself is on the screen</source>
        <translation>Visar färg under pennan genast, tills färgen själv syns på skärmen</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PenDialog</name>
    <message>
        <source>Pen and tablet</source>
        <translation>Penna och ritplatta</translation>
    </message>
    <message>
        <source>Pens and mouse</source>
        <translation>Pennor och mus</translation>
    </message>
    <message>
        <source>A pen that is not listed comes here when it touches the sheet below.</source>
        <translation>En penna som saknas i listan dyker upp när den rör vid arket nedan.</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Mjukt</translation>
    </message>
    <message>
        <source>A light hand already presses hard</source>
        <translation>En lätt hand trycker redan hårt</translation>
    </message>
    <message>
        <source>As it comes</source>
        <translation>Ursprungligt</translation>
    </message>
    <message>
        <source>The pressure as the pen tells it, without a curve</source>
        <translation>Trycket som pennan anger det, utan kurva</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Fast</translation>
    </message>
    <message>
        <source>Only a heavy hand presses hard</source>
        <translation>Bara en tung hand trycker hårt</translation>
    </message>
    <message>
        <source>From left to right what the pen tells, upwards what the brush is pressed with.</source>
        <translation>Från vänster till höger vad pennan anger, uppåt hur hårt penseln trycks.</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>Torka rent</translation>
    </message>
    <message>
        <source>Try it here</source>
        <translation>Prova här</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Mus</translation>
    </message>
    <message>
        <source>Pressure of %1</source>
        <translation>Tryck för %1</translation>
    </message>
    <message>
        <source>Pressure of the mouse</source>
        <translation>Tryck för musen</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PenPad</name>
    <message>
        <source>Sheet to try the pen on</source>
        <translation>Ark att prova pennan på</translation>
    </message>
    <message>
        <source>Scribble here with a pen or the mouse</source>
        <translation>Klottra här med en penna eller musen</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PictureBoard</name>
    <message>
        <source>no picture</source>
        <translation>ingen bild</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 pixlar</translation>
    </message>
    <message>
        <source>A picture that you choose to trace lies here, to look at and to pick colours from, and below the paint.</source>
        <translation>En bild som du väljer att kalkera ligger här, att se på och plocka färger ur, och under färgen.</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PopupPalette</name>
    <message>
        <source>Pop-up palette</source>
        <translation>Popup-palett</translation>
    </message>
    <message>
        <source>A narrower brush</source>
        <translation>En smalare pensel</translation>
    </message>
    <message>
        <source>A wider brush</source>
        <translation>En bredare pensel</translation>
    </message>
    <message>
        <source>%1: take this one, and put the other here</source>
        <translation>%1: ta den här, och lägg den andra här</translation>
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
        <translation>%1: som verktyget är sparat</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::RecorderPanel</name>
    <message>
        <source>Strokes</source>
        <translation>Penseldrag</translation>
    </message>
    <message>
        <source>Painting time</source>
        <translation>Målningstid</translation>
    </message>
    <message>
        <source>Recorded so far</source>
        <translation>Inspelat hittills</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ReferencePanel</name>
    <message>
        <source>Opacity</source>
        <translation>Opacitet</translation>
    </message>
    <message>
        <source>How strongly the chosen picture shows</source>
        <translation>Hur starkt den valda bilden syns</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>Höj</translation>
    </message>
    <message>
        <source>Above the next picture (PgUp)</source>
        <translation>Över nästa bild (PgUp)</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Sänk</translation>
    </message>
    <message>
        <source>Below the picture under it (PgDown)</source>
        <translation>Under bilden där under (PgDown)</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spegla</translation>
    </message>
    <message>
        <source>Left and right change sides</source>
        <translation>Vänster och höger byter plats</translation>
    </message>
    <message>
        <source>Greys</source>
        <translation>Gråtoner</translation>
    </message>
    <message>
        <source>Shown in greys as light as its colours</source>
        <translation>Visas i gråtoner lika ljusa som dess kulörer</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Take the chosen picture off the board (Del)</source>
        <translation>Ta bort den valda bilden från tavlan (Del)</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ReferenceView</name>
    <message>
        <source>Board of references</source>
        <translation>Referenstavla</translation>
    </message>
    <message>
        <source>Drag: move a picture, scale it by a corner, turn it by the ring
Control and click: paint of that colour
Wheel: closer, farther; with Shift it turns the picture
Double click, 0: all of it</source>
        <translation>Dra: flytta en bild, skala den i ett hörn, vrid den i ringen
Ctrl och klick: färg i den kulören
Hjulet: närmare, längre bort; med Skift vrids bilden
Dubbelklick, 0: hela tavlan</translation>
    </message>
    <message>
        <source>pictures: %1</source>
        <translation>bilder: %1</translation>
    </message>
    <message>
        <source>pictures: %1; chosen: %2</source>
        <translation>bilder: %1; vald: %2</translation>
    </message>
    <message>
        <source>Drag pictures here, to look at them and pick their colours while you paint.</source>
        <translation>Dra hit bilder, att titta på och hämta kulörer från medan du målar.</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::StatusReadings</name>
    <message>
        <source>The pen&apos;s place on the canvas, from its upper left corner</source>
        <translation>Pennans läge på duken, från dess övre vänstra hörn</translation>
    </message>
    <message>
        <source>Tools keep to what is outlined; Ctrl+A ends the selection, Esc goes back to painting</source>
        <translation>Verktygen håller sig inom konturen; Ctrl+A avslutar markeringen, med Esc målar du igen</translation>
    </message>
    <message>
        <source>Memory that the program holds: the painting, its history and its pictures</source>
        <translation>Minne som programmet använder: målningen, dess historik och dess bilder</translation>
    </message>
    <message>
        <source>Size of the canvas and of its saved picture</source>
        <translation>Dukens storlek, och den sparade bildens</translation>
    </message>
    <message>
        <source>What the canvas shows; Alt+1 shows it in its light again</source>
        <translation>Vad duken visar; Alt+1 visar den i sitt ljus igen</translation>
    </message>
    <message>
        <source>How the canvas stands on the screen; 5 puts it upright, M mirrors it</source>
        <translation>Hur duken står på skärmen; 5 rätar upp den, M speglar den</translation>
    </message>
    <message>
        <source>Screen pixels for a pixel of the saved picture</source>
        <translation>Skärmpixlar per pixel i den sparade bilden</translation>
    </message>
    <message>
        <source>%1 × %2 mm   %3 × %4 px</source>
        <translation>%1 × %2 mm   %3 × %4 px</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>speglad</translation>
    </message>
    <message>
        <source>turned %1°</source>
        <translation>vriden %1°</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1; %2 mm</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>pausad</translation>
    </message>
    <message>
        <source>paint at rest</source>
        <translation>färgen i vila</translation>
    </message>
    <message>
        <source>%1 × time</source>
        <translation>%1 × tiden</translation>
    </message>
    <message>
        <source>%1 % selected</source>
        <translation>%1 % markerat</translation>
    </message>
    <message>
        <source>Paint time against the clock: less than you set where there is more wet paint than this computer can move in time</source>
        <translation>Färgens tid mot klockan: mindre än du valt när det finns mer våt färg än datorn hinner flytta</translation>
    </message>
    <message>
        <source>Whether paint still moves, and how much of its time this computer works on it</source>
        <translation>Om färgen ännu rör sig, och hur stor del av tiden datorn arbetar med den</translation>
    </message>
    <message>
        <source>paint moving, %1 % busy</source>
        <translation>färgen rör sig, %1 % upptagen</translation>
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
        <translation>Färg : medium, från pasta till bets. Åt höger tunnas färgen ut: den rinner förr och släpper igenom det som ligger under</translation>
    </message>
    <message>
        <source>Paint : medium</source>
        <translation>Färg : medium</translation>
    </message>
    <message>
        <source>Paint : medium, from paste to stain. Upwards the paint is thinned: it runs sooner, and lets through what lies below</source>
        <translation>Färg : medium, från pasta till bets. Uppåt tunnas färgen ut: den rinner förr och släpper igenom det som ligger under</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TiltDial</name>
    <message>
        <source>Drag to tilt the canvas: the paint runs towards the knob. Double-click lays it flat.
Keys: arrows tilt it, Home lays it flat.</source>
        <translation>Dra för att luta duken: färgen rinner mot knoppen. Dubbelklicka för att lägga den plant.
Tangenter: pilarna lutar den, Home lägger den plant.</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>plant</translation>
    </message>
    <message>
        <source>%1° steep, down is at %2°</source>
        <translation>%1° brant, nedåt är vid %2°</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TracingPanel</name>
    <message>
        <source>Picture to trace</source>
        <translation>Bild att kalkera</translation>
    </message>
    <message>
        <source>Click: paint of that colour
Wheel: closer, farther
Drag: move the picture
0: all of it</source>
        <translation>Klick: färg i den kulören
Hjulet: närmare, längre bort
Dra: flytta bilden
0: hela bilden</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacitet</translation>
    </message>
    <message>
        <source>How strongly it shows below the paint</source>
        <translation>Hur starkt den syns under färgen</translation>
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
        <translation>Från vänster</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Uppifrån</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>Its height follows in proportion</source>
        <translation>Dess höjd följer i proportion</translation>
    </message>
    <message>
        <source>Where its left edge lies on the canvas</source>
        <translation>Var dess vänstra kant ligger på duken</translation>
    </message>
    <message>
        <source>Where its upper edge lies on the canvas</source>
        <translation>Var dess övre kant ligger på duken</translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TubeMenu</name>
    <message>
        <source>Which tubes are shown: all of them, or a set of yours</source>
        <translation>Vilka tuber som visas: alla, eller en av dina uppsättningar</translation>
    </message>
    <message>
        <source>All tubes</source>
        <translation>Alla tuber</translation>
    </message>
    <message>
        <source>Save as a set...</source>
        <translation>Spara som uppsättning...</translation>
    </message>
    <message>
        <source>Rename the set...</source>
        <translation>Byt namn på uppsättningen...</translation>
    </message>
    <message>
        <source>Remove the set</source>
        <translation>Ta bort uppsättningen</translation>
    </message>
    <message>
        <source>Squeeze these onto the mixing well</source>
        <translation>Kläm ut dessa på blandningsytan</translation>
    </message>
    <message>
        <source>Import sets...</source>
        <translation>Importera uppsättningar...</translation>
    </message>
    <message>
        <source>Export my sets...</source>
        <translation>Exportera mina uppsättningar...</translation>
    </message>
    <message>
        <source>Squeeze out the last painting&apos;s palette</source>
        <translation>Kläm ut den förra målningens palett</translation>
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
        <translation>Det finns inte längre någon OpenGL att rita duken med.</translation>
    </message>
</context>
<context>
    <name>pastoso::screens</name>
    <message>
        <source>All commands and their keys</source>
        <translation>Alla kommandon och deras tangenter</translation>
    </message>
    <message>
        <source>In the order of the menus. &quot;Keys&quot; in the &quot;Settings&quot; menu changes them ([how](settings.md#keys)). This page is printed by the program; `packaging/screens.sh --manual` prints it anew.</source>
        <translation>I menyernas ordning. ”Kortkommandon” i menyn ”Inställningar” ändrar dem ([så här](settings.md#keys)). Den här sidan skrivs ut av programmet; `packaging/screens.sh --manual` skriver ut den på nytt.</translation>
    </message>
    <message>
        <source>command</source>
        <translation>kommando</translation>
    </message>
    <message>
        <source>like Krita</source>
        <translation>som i Krita</translation>
    </message>
    <message>
        <source>like Photoshop</source>
        <translation>som i Photoshop</translation>
    </message>
    <message>
        <source>does</source>
        <translation>gör</translation>
    </message>
</context>
<context>
    <name>pastoso::start::ExamplesSection</name>
    <message>
        <source>Examples, painted before your eyes</source>
        <translation>Exempel, målade inför dina ögon</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Exempel</translation>
    </message>
    <message>
        <source>Watch how it is painted, stroke by stroke, and paint on</source>
        <translation>Se hur den målas, drag för drag, och måla vidare</translation>
    </message>
</context>
<context>
    <name>pastoso::start::NewCanvasSection</name>
    <message>
        <source>New canvas</source>
        <translation>Ny duk</translation>
    </message>
    <message>
        <source>Sizes of a new canvas</source>
        <translation>Storlekar för en ny duk</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Liggande</translation>
    </message>
    <message>
        <source>Wider than high</source>
        <translation>Bredare än hög</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Stående</translation>
    </message>
    <message>
        <source>Higher than wide</source>
        <translation>Högre än bred</translation>
    </message>
    <message>
        <source>More...</source>
        <translation>Mer...</translation>
    </message>
    <message>
        <source>Any size</source>
        <translation>Valfri storlek</translation>
    </message>
    <message>
        <source>Choose width, height, resolution and support yourself</source>
        <translation>Välj själv bredd, höjd, upplösning och underlag</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, %4 px/mm</source>
        <translation>%1, %2 × %3 pixlar, %4 px/mm</translation>
    </message>
</context>
<context>
    <name>pastoso::start::PaintingReader</name>
    <message>
        <source>This file is not there any more.</source>
        <translation>Filen finns inte längre kvar.</translation>
    </message>
    <message>
        <source>This file cannot be read.</source>
        <translation>Filen kan inte läsas.</translation>
    </message>
</context>
<context>
    <name>pastoso::start::RecentSection</name>
    <message>
        <source>Today, %1</source>
        <translation>I dag, %1</translation>
    </message>
    <message>
        <source>Yesterday, %1</source>
        <translation>I går, %1</translation>
    </message>
    <message>
        <source>Recent paintings</source>
        <translation>Senaste målningar</translation>
    </message>
    <message>
        <source>Open a file...</source>
        <translation>Öppna en fil...</translation>
    </message>
    <message>
        <source>Paintings that you save will stand here.</source>
        <translation>Målningar som du sparar visas här.</translation>
    </message>
</context>
<context>
    <name>pastoso::start::StartPage</name>
    <message>
        <source>Show this page at start</source>
        <translation>Visa den här sidan vid start</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Startsida</translation>
    </message>
    <message>
        <source>Esc closes it; &quot;Start page&quot; in the &quot;File&quot; menu brings it back.</source>
        <translation>Esc stänger den; ”Startsida” i menyn ”Arkiv” tar fram den igen.</translation>
    </message>
    <message>
        <source>Back to the painting</source>
        <translation>Tillbaka till målningen</translation>
    </message>
    <message>
        <source>Start painting</source>
        <translation>Börja måla</translation>
    </message>
    <message>
        <source>The painting stands on the easel as you left it.</source>
        <translation>Målningen står på staffliet som du lämnade den.</translation>
    </message>
    <message>
        <source>A canvas of %1, %2, is ready. You can also just paint on it.</source>
        <translation>En duk på %1, %2, står klar. Du kan också bara börja måla på den.</translation>
    </message>
</context>
<context>
    <name>pastoso::start::UnfinishedSection</name>
    <message>
        <source>Not closed last time</source>
        <translation>Inte stängda förra gången</translation>
    </message>
    <message>
        <source>Choose or discard...</source>
        <translation>Välj eller kasta...</translation>
    </message>
    <message>
        <source>All paintings that were left unfinished</source>
        <translation>Alla målningar som lämnades oavslutade</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Återskapa</translation>
    </message>
</context>
<context>
    <name>pastoso::tools</name>
    <message>
        <source>PNG, 8 bits</source>
        <translation>PNG, 8 bitar</translation>
    </message>
    <message>
        <source>PNG, 16 bits</source>
        <translation>PNG, 16 bitar</translation>
    </message>
    <message>
        <source>JPEG</source>
        <translation>JPEG</translation>
    </message>
    <message>
        <source>TIFF, 8 bits</source>
        <translation>TIFF, 8 bitar</translation>
    </message>
    <message>
        <source>TIFF, 16 bits</source>
        <translation>TIFF, 16 bitar</translation>
    </message>
    <message>
        <source>TIFF, 32 bits of linear light</source>
        <translation>TIFF, 32 bitar linjärt ljus</translation>
    </message>
    <message>
        <source>WebP</source>
        <translation>WebP</translation>
    </message>
    <message>
        <source>OpenEXR, linear light</source>
        <translation>OpenEXR, linjärt ljus</translation>
    </message>
    <message>
        <source>PNG, 8 bits, heights in 16</source>
        <translation>PNG, 8 bitar, höjder med 16</translation>
    </message>
    <message>
        <source>TIFF, 32 bits, heights in mm</source>
        <translation>TIFF, 32 bitar, höjder i mm</translation>
    </message>
    <message>
        <source>OpenEXR, heights in mm</source>
        <translation>OpenEXR, höjder i mm</translation>
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
        <translation>Numrerade bilder, PNG med 8 bitar</translation>
    </message>
    <message>
        <source>Numbered pictures, PNG of 16 bits</source>
        <translation>Numrerade bilder, PNG med 16 bitar</translation>
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
        <translation>Rött</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grönt</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blått</translation>
    </message>
    <message>
        <source>Hue, degrees</source>
        <translation>Nyans, grader</translation>
    </message>
    <message>
        <source>Saturation, %</source>
        <translation>Mättnad, %</translation>
    </message>
    <message>
        <source>Value, %</source>
        <translation>Valör, %</translation>
    </message>
    <message>
        <source>Lightness as it is seen, %</source>
        <translation>Upplevd ljushet, %</translation>
    </message>
    <message>
        <source>Chroma: how far from grey</source>
        <translation>Kroma: hur långt från grått</translation>
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
        <translation>Våt färg</translation>
    </message>
    <message>
        <source>Height of the paint</source>
        <translation>Färgens höjd</translation>
    </message>
    <message>
        <source>Slopes of the surface</source>
        <translation>Ytans lutningar</translation>
    </message>
    <message>
        <source>Flat colour</source>
        <translation>Kulör utan ljus</translation>
    </message>
</context>
<context>
    <name>std</name>
    <message>
        <source>Stroke in the mixing well</source>
        <translation>Penseldrag på blandningsytan</translation>
    </message>
    <message>
        <source>Canvas mirrored</source>
        <translation>Duken speglad</translation>
    </message>
    <message>
        <source>Canvas turned</source>
        <translation>Duken vriden</translation>
    </message>
    <message>
        <source>Masking tape</source>
        <translation>Maskeringstejp</translation>
    </message>
    <message>
        <source>Masking peeled off</source>
        <translation>Maskering avdragen</translation>
    </message>
</context>
</TS>
