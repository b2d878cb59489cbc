<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Keys</name>
    <message>
        <source>Like Krita</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The keys of Krita, where it has the same command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Like Photoshop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The keys of Photoshop, where it has the same command</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Drops and sprays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Air</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knives and combs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rags and fingers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left, right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above, below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the last stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Below the paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Physics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear medium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the next paint flows; what lies on the canvas keeps its own way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reload each stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn with stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Medium </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dry now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mixing well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wipe the well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same to the eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a little off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond these tubes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Barrel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how far it is pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how far it leans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how it is turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reach into hollows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>film that it leaves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paint taken up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>width of the spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % pressure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wet, asleep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A group: its eye, its lock and its opacity hold for all of its layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You paint on this layer; its wet paint flows and dries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its wet paint is asleep: it neither flows nor dries, and stays as wet as it is until you choose this layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to paint on this layer; a double click names it, dragging moves it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seen; click to hide it. Its relief goes with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden, and not painted on; click to show it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked: nothing is painted on it, cleared or merged. Click to unlock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to lock it against painting, clearing and merging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke in the mixing well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint squeezed out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mixing well wiped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look of a layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer duplicated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer cleared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Merged down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flattened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers grouped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look of a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group dissolved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture as paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture to trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place of the traced picture</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::commands</name>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Guides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New canvas...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put a fresh canvas on the easel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with a painting that was saved, wet as it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the painting with all its wet paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the painting in another file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a picture, layers, maps, a relief to print or a time-lapse of the painting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same export of the painting as it is now, into the same file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;top the export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give up the export that is being written; its file stays as it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export &amp;recording...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save all strokes, to be replayed at any resolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the last stroke back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the last stroke back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Memory for undo...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much memory the steps may take that you can return to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Canvas size...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the canvas larger, or cut it, on any side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crop to the &amp;selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut the canvas to the smallest one that holds what is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Narrower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A narrower brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A wider brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next &amp;brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the next brush of the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Previous brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the brush before in the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clean the brush and fill it with the paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Top up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dip the brush without cleaning it: what it holds stays on it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B&amp;lot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press the brush into a cloth: a quarter of its paint stays on it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wipe the brush: an empty one moves the paint that lies there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;wap the two paints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dip the brush in the second paint; the first takes its place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;ick up the paint there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next click dips the brush in the mixture of pigments that lies there; so does Ctrl and a click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick the c&amp;olour seen there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next click makes paint of the colour that is seen there; so does Alt and a click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reload before &amp;each stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every stroke starts with a clean, full brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Turn with the stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat brushes stand across their path, where the pen does not tell its rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save as my own...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the tool in hand, with its curves, among your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;name...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give your own tool another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Throw your own tool away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause the paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wet paint stands still until you go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dry now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All wet paint dries at once: paint over it without stirring it up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mixing &amp;well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A palette of wet paint: mix there with any tool, and carry it to the canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Squeeze onto the well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Squeeze the paint that you chose onto the mixing well; Control and click says where</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clean the well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wipe the mixing well bare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A bare layer above the one that you paint on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a &amp;picture...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put a picture onto the canvas as a layer of dry paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same paint once more, on a layer above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Na&amp;me...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the layer or the group another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the layer away with all its paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wipe all paint off the layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Transform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move, scale, turn and mirror the layer&apos;s paint, or what is selected of it, by a frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M&amp;erge down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the layer&apos;s paint on the layer below, and make them one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Flatten what is visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make one layer of all that are visible; hidden ones stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the chosen layers into a group, which is hidden, locked and faded as one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dissolve the group; its layers stay where they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide the layer or the group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the layer or the group from being painted on, cleared and merged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the one &amp;above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint on the layer above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the one &amp;below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint on the layer below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move u&amp;p</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the layer or the group one place up, into and out of groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move d&amp;own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the layer or the group one place down, into and out of groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a rectangle that tools keep to; Shift adds, Alt takes away, Ctrl makes a square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw around what tools keep to; Shift adds, Alt takes away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the selection: tools work on all of the canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select what is not selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By &amp;height...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select where the paint stands so high above the bare canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By &amp;wetness...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select where the wet paint of the layer is so thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden, it is out of the way of what you paint; tools keep to it as before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mirror left and right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every stroke is painted on both sides of the upright line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror a&amp;bove and below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every stroke is painted on both sides of the level line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M&amp;ore copies around the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every stroke is painted once more around the middle of the canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fewer copies around the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every stroke is painted once less around the middle of the canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Ruler along the last stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strokes run along the ruler, or parallel to it; Shift and drag draw a straight line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strokes run along the ellipse, or along another of the same shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points by which guides are dragged; Shift keeps to steps and proportions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;No guides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take mirrors, copies, ruler and ellipse away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Trace a picture...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lay a picture below the paint, and beside the canvas; it is in no picture that you save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Show it below the paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide the picture that you trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;it it to the canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the middle of the canvas, as large as it fits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ta&amp;ke it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the picture that you trace away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit the canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Actual pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One screen pixel for every pixel of the saved picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Farther</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the canvas a little to the left on the screen; so does Shift+Space and a drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The canvas stands again as it is saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn &amp;right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the canvas a little to the right on the screen; so does Shift+Space and a drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mirror the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See the painting as in a mirror, and paint on it so; it is saved as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Canvas &amp;only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing but the canvas; Tab or Escape brings the panels back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In its l&amp;ight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paint as it hangs in its light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;wet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tints what is still wet, the more the thicker it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How high the paint stands above the bare canvas, in steps of colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;normals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the surface faces: red to the right, green up, blue towards you</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Flat colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paint&apos;s colours alone, without light and relief</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tool panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the brush holds, and how it answers to the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Colour panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A paint of any colour, and its recipe from the tubes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;hysics panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the paint is like: how it flows, holds and dries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Guides panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirrors, ruler and ellipse in millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Layers panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The layers of the painting: seen, locked, faded, in what order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tr&amp;acing panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture that you trace, to look at and to pick colours from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;History panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was done, to go back to any of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset the panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panels and mixing well as they stood at the first start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours for s&amp;RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the painting for common screens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours for Display &amp;P3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the painting for a screen of wide gamut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Daylight (D65)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The light that screens are made for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Print booth (D50)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The light that prints are judged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light &amp;bulb (A)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Incandescent lamplight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;LED lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A white LED with its blue peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a &amp;file...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A lamp that you have measured, as a CSV file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Move the light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the lamp over the canvas: towards the rim it rakes over the relief</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find a command...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a few letters of what you want to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a set of keys, and give any command keys of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Settings...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The look of the window, what is kept, and how much of the machine is used</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs</name>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 pixels for %3 × %4 mm, which is %5 pixels per inch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Four files of %1 × %2 pixels, %3 to %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A solid of %1 × %2 mm; its front has %3 × %4 points, %5 mm apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of painting become %2 of film: %3 frames of %4 × %5 pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a file; numbered pictures go into a folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 holds the frames of another time-lapse; name another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has been painted yet that a film could show.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CanvasSizeDialog</name>
    <message>
        <source>The upper left corner stays where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The middle of the upper edge stays where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The upper right corner stays where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The middle of the left edge stays where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The middle stays where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The middle of the right edge stays where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lower left corner stays where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The middle of the lower edge stays where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lower right corner stays where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm on the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm on the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm at the top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm at the bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut off: %1. What lies there is wiped off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Canvas size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The canvas has this size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels.
%3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No command of that name. Fewer letters find more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not now: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::CrashDialog</name>
    <message>
        <source>Pastoso failed the last time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>We are sorry. What you had painted was kept and is offered to you next. This report says where the program was; it tells nothing of your painting. With it the mistake can be found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is kept as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the report</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::ExportDialog</name>
    <message>
        <source>Where the folder is put</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sRGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Display P3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ICC profile...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ICC profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ICC profiles (*.icc *.icm);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the painting looks like.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture, and of every layer its colours, normals, heights in mm, wetness, gloss and cover, as channels of one file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base colour, normal (OpenGL, +Y up), height and roughness, a file for each.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paint as it stands on the canvas: a closed solid in millimetres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the painting came about. It is painted once more, which takes a while.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the file is; its name ends accordingly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is made of the painting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers, for compositing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maps, for 3D programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relief, for 3D printing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time-lapse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where it is put; the ending of the name chooses the format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Browse...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 is a small file, 100 a fine picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the picture is of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mixing well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light and shade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the window shows the painting; otherwise the paint&apos;s own colours, as a scan would have them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> px/cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixels for a cell of the canvas: 1 as the window paints it, 2 twice as wide and high. The paint&apos;s surface is interpolated, not the pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> px wide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The width that the scale comes to, or the scale that gives this width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the numbers in the file mean; the file says so too. sRGB is for common screens, Display P3 for screens of wide gamut, an ICC profile for a printer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness from the flat back to the lowest level of the canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> times as high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 is the relief as it is painted, 2 twice as high; width and height stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance between two points of the surface; 0 is as far as the cells, or farther where the canvas is large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> times as fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seconds of painting in a second of film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames in a second of film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Make</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Heights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sp&amp;eed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;rames</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::KeyCatcher</name>
    <message>
        <source>Press the keys... (Esc: none)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the keys are to start with; keys of your own stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find by words, or by keys such as Ctrl+J</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click, and press other keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the set has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget all my own keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click, and press other keys in place of these</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is needed on the canvas itself: it can be given to no command. Choose another key.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is its key already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is the key of &quot;%2&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take it from there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 stays with &quot;%2&quot;, which you gave it to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All keys will be as the set &quot;%1&quot; has them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget my own</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::NewCanvasDialog</name>
    <message>
        <source>New canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> px/mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cotton duck</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height image...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Support</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height image: white is high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Image: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels; up to %3 MiB of memory when all of it is wet.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::RecoveryDialog</name>
    <message>
        <source>A painting without a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A painting that cannot be read
%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1
%2
%3 × %4 mm, %n change(s) not saved</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Unfinished paintings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pastoso ended before these were saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard %1 for good? It is nowhere else.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::SelectRangeDialog</name>
    <message>
        <source>Select it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add it to the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take it out of the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep what is in both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is there to be selected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then %1 % of the canvas is selected.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Performance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both are neutral greys, so that nothing beside the canvas colours what you see on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As on the desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another language speaks from the next start on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> MiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The steps that you can return to. The oldest are given up when it is full; 500 are kept at most.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Never</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save by itself every</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Into the painting&apos;s own file, once it has one. Whatever you choose, every stroke is kept aside within a second and offered to you again should the program or the machine fail.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of the machine (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many things the program works on at once, from the next painting on. The paint flows the same with any number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How carefully moving paint is shown follows from how fast this machine draws; what stands still is always shown in full.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::dialogs::TransformDialog</name>
    <message>
        <source>Transform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clockwise, about the middle of the frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left–right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left and right of the paint change places, before it is turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up–down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above and below change places, before the paint is turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paint keeps its thickness and its amount.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paint keeps its thickness: %1 % of it will be there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What comes beyond the canvas is wiped off.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main</name>
    <message>
        <source>OpenGL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Graphics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (the processor draws, no graphics card)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its maker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shading language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest texture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 pixels a side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 pixels, %3 for one of the layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>System</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Processor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at once, %2, kernels for %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 GiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Windows by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Screen</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::BrushJar</name>
    <message>
        <source>%1 was read again; the next stroke is painted with it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the tool:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as my own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is already a tool of your own named &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept &quot;%1&quot; among your own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Throw your tool &quot;%1&quot; away? Its file is deleted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is thrown away; what you have in hand stays.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::CanvasSizing</name>
    <message>
        <source>A recording is being played; the canvas is yours when it has ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selection reaches over the whole canvas: there is nothing to cut.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The canvas is %1 × %2 mm now; Undo brings back what it was.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::Exporting</name>
    <message>
        <source>Exported %1: %2 triangles, %3 × %4 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported %1 and %2 more; heights from %3 mm (black) to %4 mm (white).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported %1: %2 × %3 pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported %1: %2 frames of %3 × %4 pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped; %1 holds the pictures that are complete.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped; %1 was not written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>painting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is still being written; wait for it, or stop it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is still being written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close when it is done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The window closes as soon as %1 is written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>painting.json</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::GuideCommands</name>
    <message>
        <source>Strokes around the middle: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::LayerCommands</name>
    <message>
        <source>Layer %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::LayerTransform</name>
    <message>
        <source>A recording is being played; the layers are yours when it has ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no paint on this layer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no paint of this layer in the selection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag inside to move, a handle to scale, outside to turn (Shift: in steps). Enter applies, Esc gives up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paint stays as it is.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::LightChoice</name>
    <message>
        <source>Light from a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spectra (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintMemory</name>
    <message>
        <source>Open a palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palettes (*.gpl)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::PaintPicking</name>
    <message>
        <source>Picked up wet paint: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picked up dry paint: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no colour to pick beside the canvas.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picked the colour seen: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::PictureLayers</name>
    <message>
        <source>Layer from a picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::ProjectFiles</name>
    <message>
        <source>Open re&amp;cent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] %2 × %3 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving %1...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paintings and pictures (*.pastoso *.ora %1);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>painting.pastoso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paintings (*.pastoso)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pastoso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The painting on the easel has changes that are not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::RangeSelection</name>
    <message>
        <source>Wet paint of this layer is up to %1 mm thick, %2 mm on average.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint, wet and dry, stands up to %1 mm above the canvas, %2 mm on average.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select by wetness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select by height</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::SelectionCommands</name>
    <message>
        <source>Outside the selection: nothing is painted there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was selected. Esc again goes back to painting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools keep to the outline. Esc, or taking a tool, goes back to painting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag around what tools shall keep to. Shift adds, Alt takes away, both keep what is in both; a click ends the selection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The brush paints again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selects what is inside.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds what is inside to the selection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes what is inside out of the selection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps what is inside and was selected before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A recording is being played; the brush is yours when it has ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is selected: tools work on all of the canvas.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lasso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::main::TracingCommands</name>
    <message>
        <source>Picked the colour of the picture: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace a picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels</name>
    <message>
        <source>never</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>real time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a minute a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 min a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an hour a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a day a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How slowly it flows: water 1, ink 100, cream 3000, oil from the tube 300000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm²/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yield stress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it stands up to before it moves at all: at 0 it runs for ever, at 80 it keeps every bristle mark, at 200 it stands in peaks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Pa</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flow index</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Below 1 it thins where it is sheared: a brush or a fast run finds it thinner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heavy paint runs faster down a tilted canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> kg/m³</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface tension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rounds drips and edges, and draws thin lines into drops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mN/m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spreads at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edge moves out where it is steeper than this: low numbers wet the canvas easily, high ones stand in beads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws back at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edge draws back where it is flatter than this; 0: it stays where it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How easily it slides over the canvas, in cells: more lets edges run on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> cells</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile against</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alpha where surface tension pulls against the flow: less slows the front of a drip, which gets thicker and rounder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alpha where surface tension pulls with the flow: more speeds up the tail of a drip, which gets thinner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dry after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Until a film of the usual thickness can be touched, in still air</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usual thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The film that dries in that time; thicker ones take longer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stays when dry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the wet thickness is left: oil keeps all, watery paint sinks in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drying</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushList</name>
    <message>
        <source>%1, your own</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::BrushPanel</name>
    <message>
        <source>Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the brush&apos;s tip  ([ and ])</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steady</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the hand is steadied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How a trembling hand is steadied, besides the brush&apos;s own smoothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lags behind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pulled on a string</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much the hand is steadied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the string: wide curves without a tremor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the brush lags behind the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ColourPanel</name>
    <message>
        <source>Mix a colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearest from the tubes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the recipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dip the brush in this mixture from the tubes instead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Used before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paints that you keep stay here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lay the paint in hand out on your palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours of GIMP, Krita or Inkscape, from a .gpl file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colour itself, as a paint of its own: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
㥎 %2, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your palette is full: the right button takes a paint away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
The right button, or Delete, takes it away.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ColourPicker</name>
    <message>
        <source>OKLCh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lightness, chroma and hue as the eye sees them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hue, saturation and value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red, green and blue of the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colour as it is written, for example #c03020</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour as written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; write it for example as #c03020.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::ColourWheel</name>
    <message>
        <source>Colour wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ring is the hue. Inside, lightness goes up and chroma to the right, as far as the
screen has it. Keys: arrows, Page Up and Page Down for the hue, with Ctrl finely.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lightness %1 %, chroma %2, hue %3°</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::CurveEditor</name>
    <message>
        <source>Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a point, click beside one to add another, right click to take one away.
Keys: Page Up and Page Down choose, arrows move, Insert adds, Delete takes away.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::CurvesPanel</name>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another curve: what of the hand sets what of the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes this curve away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curve as the tool was kept with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How it answers to the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What of the hand sets what of the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This tool has no curves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::EaselPanel</name>
    <message>
        <source>Tilt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seen in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The light on the easel; the paint stays as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Daylight (D65)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print booth (D50)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light bulb (A)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LED lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a file...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drying</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast wet paint dries; D dries it at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> high</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::GuidesPanel</name>
    <message>
        <source>Mirrors and copies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle, from the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle, from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::HistoryModel</name>
    <message>
        <source>As far back as is kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: do again up to here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: go back to this moment</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::HistoryPanel</name>
    <message>
        <source>What was done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the steps take; &quot;Memory for undo&quot; in the Edit menu says how much they may</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 MiB</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LayerModel</name>
    <message>
        <source>a group of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the layer that you paint on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opacity %1 %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LayerPanel</name>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fades what its paint does to light; its relief stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LightDial</name>
    <message>
        <source>Drag the lamp: near the rim it rakes over the relief. Double-click puts it back.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LoadBar</name>
    <message>
        <source>The paint in the brush, across its width: how full it is, and of which colour</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::LoadPanel</name>
    <message>
        <source>On the brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the brush is dipped, from the next time on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full, in one paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the tip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One paint on each side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half mixed from two</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How full the brush is dipped; little leaves a dry brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second paint&apos;s share of a half-mixed load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In hand: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second paint of the load: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second paint, laid out for later: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all but empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % full</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::MediumPanel</name>
    <message>
        <source>As it comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind of paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The brush is cleaned, and dipped in paint of this kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes back what was changed below</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PaintPanel</name>
    <message>
        <source>The medium without pigment, for example thinner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2): from the tube, and mixed with white</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::PictureBoard</name>
    <message>
        <source>No picture to trace</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::StatusReadings</name>
    <message>
        <source>The pen&apos;s place on the canvas, from its upper left corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles of 64 x 64 cells in which the paint still moves, and how much of its time computing them takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint time against the clock: slower than 1 when there is more wet paint than this computer can move in time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools keep to what is outlined; Ctrl+A ends the selection, Esc goes back to painting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory that the program holds: the painting, its history and its pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the canvas and of its saved picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the canvas shows; Alt+1 shows it in its light again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the canvas stands on the screen; 5 puts it upright, M mirrors it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Screen pixels for a pixel of the saved picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 mm   %3 × %4 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turned %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paint at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 tiles moving, %2 % load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 MiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 GiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % selected</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TiltDial</name>
    <message>
        <source>Drag to tilt the canvas: the arrow shows where the paint runs. Double-click lays it flat.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::TracingPanel</name>
    <message>
        <source>Picture to trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: paint of that colour
Wheel: closer, farther
Drag: move the picture
0: all of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How strongly it shows below the paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its height follows in proportion</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::panels::WorkProgress</name>
    <message>
        <source>%p %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::tools</name>
    <message>
        <source>PNG, 8 bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG, 16 bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JPEG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TIFF, 8 bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TIFF, 16 bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TIFF, 32 bits of linear light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>WebP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenEXR, linear light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG, 8 bits, heights in 16</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TIFF, 32 bits, heights in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenEXR, heights in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PLY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wavefront OBJ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbered pictures, PNG of 8 bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbered pictures, PNG of 16 bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Video, MP4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Video, Matroska</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Video, WebM</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>pastoso::view::LookLegend</name>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wet paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slopes of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat colour</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
