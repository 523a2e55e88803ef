#include "production/slides/pptx_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "text/markup.h"

namespace poinsot {

namespace {

// English Metric Units: 914400 an inch. The slide is 13.333 by 7.5 inches, as PowerPoint's.
constexpr std::int64_t slide_width_emu = 12'192'000, slide_height_emu = 6'858'000;

constexpr std::string_view declaration =
    "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";
constexpr std::string_view namespaces =
    R"(xmlns:a="http://schemas.openxmlformats.org/drawingml/2006/main" )"
    R"(xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships" )"
    R"(xmlns:p="http://schemas.openxmlformats.org/presentationml/2006/main")";
constexpr std::string_view type_start =
    "application/vnd.openxmlformats-officedocument.presentationml.";

// The list of types, before those of single parts.
constexpr std::string_view types_start =
    R"(<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">)"
    R"(<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>)"
    R"(<Default Extension="xml" ContentType="application/xml"/>)"
    R"(<Default Extension="mp4" ContentType="video/mp4"/>)"
    R"(<Default Extension="png" ContentType="image/png"/>)";

// The root of a tree of shapes, before its first shape.
constexpr std::string_view tree_start =
    R"(<p:nvGrpSpPr><p:cNvPr id="1" name=""/><p:cNvGrpSpPr/><p:nvPr/></p:nvGrpSpPr><p:grpSpPr>)"
    R"(<a:xfrm><a:off x="0" y="0"/><a:ext cx="0" cy="0"/><a:chOff x="0" y="0"/><a:chExt cx="0" cy="0"/></a:xfrm></p:grpSpPr>)";

constexpr std::string_view colour_map =
    R"(<p:clrMap bg1="lt1" tx1="dk1" bg2="lt2" tx2="dk2" accent1="accent1" accent2="accent2" )"
    R"(accent3="accent3" accent4="accent4" accent5="accent5" accent6="accent6" hlink="hlink" folHlink="folHlink"/>)";
constexpr std::string_view masters_colours = "<p:clrMapOvr><a:masterClrMapping/></p:clrMapOvr>";

// A theme needs three fills, lines and effects each.
constexpr std::string_view theme_xml =
    R"(<a:theme xmlns:a="http://schemas.openxmlformats.org/drawingml/2006/main" name="poinsot"><a:themeElements>
<a:clrScheme name="poinsot"><a:dk1><a:sysClr val="windowText" lastClr="000000"/></a:dk1><a:lt1><a:sysClr val="window" lastClr="FFFFFF"/></a:lt1>
<a:dk2><a:srgbClr val="44546A"/></a:dk2><a:lt2><a:srgbClr val="E7E6E6"/></a:lt2><a:accent1><a:srgbClr val="4472C4"/></a:accent1>
<a:accent2><a:srgbClr val="ED7D31"/></a:accent2><a:accent3><a:srgbClr val="A5A5A5"/></a:accent3><a:accent4><a:srgbClr val="FFC000"/></a:accent4>
<a:accent5><a:srgbClr val="5B9BD5"/></a:accent5><a:accent6><a:srgbClr val="70AD47"/></a:accent6><a:hlink><a:srgbClr val="0563C1"/></a:hlink>
<a:folHlink><a:srgbClr val="954F72"/></a:folHlink></a:clrScheme>
<a:fontScheme name="poinsot"><a:majorFont><a:latin typeface="Calibri"/><a:ea typeface=""/><a:cs typeface=""/></a:majorFont>
<a:minorFont><a:latin typeface="Calibri"/><a:ea typeface=""/><a:cs typeface=""/></a:minorFont></a:fontScheme>
<a:fmtScheme name="poinsot"><a:fillStyleLst><a:solidFill><a:schemeClr val="phClr"/></a:solidFill><a:solidFill><a:schemeClr val="phClr"/></a:solidFill>
<a:solidFill><a:schemeClr val="phClr"/></a:solidFill></a:fillStyleLst>
<a:lnStyleLst><a:ln w="6350"><a:solidFill><a:schemeClr val="phClr"/></a:solidFill></a:ln><a:ln w="12700"><a:solidFill><a:schemeClr val="phClr"/></a:solidFill></a:ln>
<a:ln w="19050"><a:solidFill><a:schemeClr val="phClr"/></a:solidFill></a:ln></a:lnStyleLst>
<a:effectStyleLst><a:effectStyle><a:effectLst/></a:effectStyle><a:effectStyle><a:effectLst/></a:effectStyle><a:effectStyle><a:effectLst/></a:effectStyle></a:effectStyleLst>
<a:bgFillStyleLst><a:solidFill><a:schemeClr val="phClr"/></a:solidFill><a:solidFill><a:schemeClr val="phClr"/></a:solidFill>
<a:solidFill><a:schemeClr val="phClr"/></a:solidFill></a:bgFillStyleLst></a:fmtScheme></a:themeElements></a:theme>
)";

// {0}: namespaces, {1}: start of the tree, {2}: colour map, {3}: relationship of the layout.
constexpr std::string_view slide_master_xml =
    R"(<p:sldMaster {0}><p:cSld><p:bg><p:bgRef idx="1001"><a:schemeClr val="bg1"/></p:bgRef></p:bg><p:spTree>{1}
<p:sp><p:nvSpPr><p:cNvPr id="2" name="Title"/><p:cNvSpPr><a:spLocks noGrp="1"/></p:cNvSpPr><p:nvPr><p:ph type="title"/></p:nvPr></p:nvSpPr>
<p:spPr><a:xfrm><a:off x="838200" y="365125"/><a:ext cx="10515600" cy="1325563"/></a:xfrm><a:prstGeom prst="rect"><a:avLst/></a:prstGeom></p:spPr>
<p:txBody><a:bodyPr anchor="ctr"><a:normAutofit/></a:bodyPr><a:lstStyle/><a:p><a:endParaRPr/></a:p></p:txBody></p:sp>
</p:spTree></p:cSld>{2}<p:sldLayoutIdLst><p:sldLayoutId id="2147483649" r:id="{3}"/></p:sldLayoutIdLst>
<p:txStyles><p:titleStyle><a:lvl1pPr algn="l"><a:defRPr sz="4400"><a:solidFill><a:schemeClr val="tx1"/></a:solidFill><a:latin typeface="+mj-lt"/></a:defRPr></a:lvl1pPr></p:titleStyle>
<p:bodyStyle><a:lvl1pPr><a:defRPr sz="2800"/></a:lvl1pPr></p:bodyStyle><p:otherStyle><a:lvl1pPr><a:defRPr sz="1800"/></a:lvl1pPr></p:otherStyle></p:txStyles></p:sldMaster>
)";

// {0}: namespaces, {1}: start of the tree, {2}: colours of the master.
constexpr std::string_view slide_layout_xml =
    R"(<p:sldLayout {0} type="titleOnly" preserve="1"><p:cSld name="Title Only"><p:spTree>{1}
<p:sp><p:nvSpPr><p:cNvPr id="2" name="Title"/><p:cNvSpPr><a:spLocks noGrp="1"/></p:cNvSpPr><p:nvPr><p:ph type="title"/></p:nvPr></p:nvSpPr>
<p:spPr/><p:txBody><a:bodyPr/><a:lstStyle/><a:p><a:endParaRPr/></a:p></p:txBody></p:sp>
</p:spTree></p:cSld>{2}</p:sldLayout>
)";

// The picture of the slide above the text. {0}: namespaces, {1}: start of the tree, {2}: colour
// map.
constexpr std::string_view notes_master_xml =
    R"(<p:notesMaster {0}><p:cSld><p:bg><p:bgRef idx="1001"><a:schemeClr val="bg1"/></p:bgRef></p:bg><p:spTree>{1}
<p:sp><p:nvSpPr><p:cNvPr id="2" name="Slide"/><p:cNvSpPr><a:spLocks noGrp="1" noRot="1" noChangeAspect="1"/></p:cNvSpPr><p:nvPr><p:ph type="sldImg" idx="2"/></p:nvPr></p:nvSpPr>
<p:spPr><a:xfrm><a:off x="685800" y="1143000"/><a:ext cx="5486400" cy="3086100"/></a:xfrm><a:prstGeom prst="rect"><a:avLst/></a:prstGeom></p:spPr></p:sp>
<p:sp><p:nvSpPr><p:cNvPr id="3" name="Notes"/><p:cNvSpPr><a:spLocks noGrp="1"/></p:cNvSpPr><p:nvPr><p:ph type="body" sz="quarter" idx="3"/></p:nvPr></p:nvSpPr>
<p:spPr><a:xfrm><a:off x="685800" y="4400550"/><a:ext cx="5486400" cy="3600450"/></a:xfrm><a:prstGeom prst="rect"><a:avLst/></a:prstGeom></p:spPr>
<p:txBody><a:bodyPr/><a:lstStyle/><a:p><a:endParaRPr/></a:p></p:txBody></p:sp>
</p:spTree></p:cSld>{2}<p:notesStyle><a:lvl1pPr><a:defRPr sz="1200"/></a:lvl1pPr></p:notesStyle></p:notesMaster>
)";

// A film that fills the slide. {0}: number of the shape, {1}: its name, {2}: title, {3} to {5}:
// relationships of the film, of its bytes and of its picture, {6}: the box.
constexpr std::string_view film_xml =
    R"xml(<p:pic><p:nvPicPr><p:cNvPr id="{0}" name="{1}" descr="{2}"><a:hlinkClick r:id="" action="ppaction://media"/></p:cNvPr><p:cNvPicPr><a:picLocks noChangeAspect="1"/></p:cNvPicPr>
<p:nvPr><a:videoFile r:link="{3}"/><p:extLst><p:ext uri="{{DAA4B4D4-6D71-4841-9C94-3DE7FCFB9230}}"><p14:media xmlns:p14="http://schemas.microsoft.com/office/powerpoint/2010/main" r:embed="{4}"/></p:ext></p:extLst></p:nvPr></p:nvPicPr>
<p:blipFill><a:blip r:embed="{5}"/><a:stretch><a:fillRect/></a:stretch></p:blipFill>
<p:spPr><a:xfrm>{6}</a:xfrm><a:prstGeom prst="rect"><a:avLst/></a:prstGeom></p:spPr></p:pic>
)xml";

// {0}: title, {1}: relationship, {2}: the box.
constexpr std::string_view still_xml =
    R"(<p:pic><p:nvPicPr><p:cNvPr id="4" name="Still" descr="{0}"/><p:cNvPicPr><a:picLocks noChangeAspect="1"/></p:cNvPicPr><p:nvPr/></p:nvPicPr>
<p:blipFill><a:blip r:embed="{1}"/><a:stretch><a:fillRect/></a:stretch></p:blipFill>
<p:spPr><a:xfrm>{2}</a:xfrm><a:prstGeom prst="rect"><a:avLst/></a:prstGeom></p:spPr></p:pic>
)";

// Nodes of time. A step begins when its sequence goes on; the first one also when the slide begins.
// {0} and {3}: numbers of the nodes, {1}: condition of the start, {2}: effects.
constexpr std::string_view step_xml =
    R"(<p:par><p:cTn id="{0}" fill="hold"><p:stCondLst><p:cond delay="indefinite"/>{1}</p:stCondLst><p:childTnLst>
<p:par><p:cTn id="{3}" fill="hold"><p:stCondLst><p:cond delay="0"/></p:stCondLst><p:childTnLst>
{2}</p:childTnLst></p:cTn></p:par></p:childTnLst></p:cTn></p:par>
)";

// Plays a film. {0} and {1}: numbers of the nodes, {2}: kind of start, {3}: duration in ms, {4}:
// the shape.
constexpr std::string_view play_xml =
    R"xml(<p:par><p:cTn id="{0}" presetID="1" presetClass="mediacall" presetSubtype="0" fill="hold" nodeType="{2}"><p:stCondLst><p:cond delay="0"/></p:stCondLst><p:childTnLst>
<p:cmd type="call" cmd="playFrom(0.0)"><p:cBhvr><p:cTn id="{1}" dur="{3}" fill="hold"/><p:tgtEl><p:spTgt spid="{4}"/></p:tgtEl></p:cBhvr></p:cmd>
</p:childTnLst></p:cTn></p:par>
)xml";

// Shows the shape above the film, which is hidden until then, but not on paper. {0} and {1}:
// numbers of the nodes.
constexpr std::string_view appear_xml =
    R"(<p:par><p:cTn id="{0}" presetID="1" presetClass="entr" presetSubtype="0" fill="hold" nodeType="clickEffect"><p:stCondLst><p:cond delay="0"/></p:stCondLst><p:childTnLst>
<p:set><p:cBhvr><p:cTn id="{1}" dur="1" fill="hold"><p:stCondLst><p:cond delay="0"/></p:stCondLst></p:cTn><p:tgtEl><p:spTgt spid="4"/></p:tgtEl><p:attrNameLst><p:attrName>style.visibility</p:attrName></p:attrNameLst></p:cBhvr><p:to><p:strVal val="visible"/></p:to></p:set>
</p:childTnLst></p:cTn></p:par>
)";

// A click on the title, which is above the slide, shows the still. {0}: the step.
constexpr std::string_view still_sequence_xml =
    R"(<p:seq concurrent="1" nextAc="seek"><p:cTn id="8" restart="whenNotActive" fill="hold" evtFilter="cancelBubble" nodeType="interactiveSeq"><p:stCondLst><p:cond evt="onClick" delay="0"><p:tgtEl><p:spTgt spid="2"/></p:tgtEl></p:cond></p:stCondLst><p:endSync evt="end" delay="0"><p:rtn val="all"/></p:endSync><p:childTnLst>
{0}</p:childTnLst></p:cTn><p:nextCondLst><p:cond evt="onClick" delay="0"><p:tgtEl><p:spTgt spid="2"/></p:tgtEl></p:cond></p:nextCondLst></p:seq>
)";

// {0}: number of the node, {1}: attribute of a loop, {2}: the shape.
constexpr std::string_view video_xml =
    R"(<p:video><p:cMediaNode vol="80000"><p:cTn id="{0}"{1} fill="hold" display="0"><p:stCondLst><p:cond delay="indefinite"/></p:stCondLst></p:cTn><p:tgtEl><p:spTgt spid="{2}"/></p:tgtEl></p:cMediaNode></p:video>
)";

// The title is above the slide: screen readers and the outline have it, and it covers no film.
// {0}: namespaces, {1}: start of the tree, {2}: language, {3}: title, {4}: the pictures, {5}:
// colours of the master, {6}: steps, {7}: what follows their sequence.
constexpr std::string_view slide_xml =
    R"xml(<p:sld {0}><p:cSld><p:bg><p:bgPr><a:solidFill><a:srgbClr val="000000"/></a:solidFill><a:effectLst/></p:bgPr></p:bg><p:spTree>{1}
<p:sp><p:nvSpPr><p:cNvPr id="2" name="Title"/><p:cNvSpPr><a:spLocks noGrp="1"/></p:cNvSpPr><p:nvPr><p:ph type="title"/></p:nvPr></p:nvSpPr>
<p:spPr><a:xfrm><a:off x="838200" y="-1000000"/><a:ext cx="10515600" cy="800000"/></a:xfrm></p:spPr>
<p:txBody><a:bodyPr/><a:lstStyle/><a:p><a:r><a:rPr lang="{2}" sz="2400"/><a:t>{3}</a:t></a:r></a:p></p:txBody></p:sp>
{4}</p:spTree></p:cSld>{5}
<p:timing><p:tnLst><p:par><p:cTn id="1" dur="indefinite" restart="never" nodeType="tmRoot"><p:childTnLst>
<p:seq concurrent="1" nextAc="seek"><p:cTn id="2" dur="indefinite" nodeType="mainSeq"><p:childTnLst>
{6}</p:childTnLst></p:cTn>
<p:prevCondLst><p:cond evt="onPrev" delay="0"><p:tgtEl><p:sldTgt/></p:tgtEl></p:cond></p:prevCondLst>
<p:nextCondLst><p:cond evt="onNext" delay="0"><p:tgtEl><p:sldTgt/></p:tgtEl></p:cond></p:nextCondLst></p:seq>
{7}</p:childTnLst></p:cTn></p:par></p:tnLst></p:timing></p:sld>
)xml";

// {0}: namespaces, {1}: start of the tree, {2}: paragraphs, {3}: colours of the master.
constexpr std::string_view notes_slide_xml =
    R"(<p:notes {0}><p:cSld><p:spTree>{1}
<p:sp><p:nvSpPr><p:cNvPr id="2" name="Slide"/><p:cNvSpPr><a:spLocks noGrp="1" noRot="1" noChangeAspect="1"/></p:cNvSpPr><p:nvPr><p:ph type="sldImg"/></p:nvPr></p:nvSpPr><p:spPr/></p:sp>
<p:sp><p:nvSpPr><p:cNvPr id="3" name="Notes"/><p:cNvSpPr><a:spLocks noGrp="1"/></p:cNvSpPr><p:nvPr><p:ph type="body" idx="1"/></p:nvPr></p:nvSpPr><p:spPr/>
<p:txBody><a:bodyPr/><a:lstStyle/>{2}</p:txBody></p:sp>
</p:spTree></p:cSld>{3}</p:notes>
)";

// The references of a part, or of the package, to other parts.
class Relationships {
 public:
    // Returns the id by which the part's XML names it. `type`: a whole address, or the end of that
    // of office documents.
    std::string add(std::string_view type, std::string_view target) {
        constexpr std::string_view office =
            "http://schemas.openxmlformats.org/officeDocument/2006/relationships/";
        std::string id = fmt::format("rId{}", ++n_);
        entries_ += fmt::format(R"(<Relationship Id="{}" Type="{}{}" Target="{}"/>)", id,
                                type.starts_with("http") ? "" : office, type, target);
        return id;
    }
    bool empty() const { return n_ == 0; }
    std::string xml() const {
        constexpr std::string_view start =
            R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)";
        return fmt::format("{}{}</Relationships>\n", start, entries_);
    }

 private:
    int n_ = 0;
    std::string entries_;
};

// Centred, as large as fits on the slide.
std::string film_box(int width_px, int height_px) {
    const double scale = std::min(static_cast<double>(slide_width_emu) / width_px,
                                  static_cast<double>(slide_height_emu) / height_px);
    const std::int64_t width = std::llround(scale * width_px),
                       height = std::llround(scale * height_px);
    return fmt::format(R"(<a:off x="{}" y="{}"/><a:ext cx="{}" cy="{}"/>)",
                       (slide_width_emu - width) / 2, (slide_height_emu - height) / 2, width,
                       height);
}

// A paragraph a line.
std::string paragraphs(std::string_view text, const std::string& language) {
    std::string xml;
    for (bool has_more = true; has_more;) {
        const std::size_t end = text.find('\n');
        xml += fmt::format(R"(<a:p><a:r><a:rPr lang="{}"/><a:t>{}</a:t></a:r></a:p>)", language,
                           escaped_markup(text.substr(0, end)));
        has_more = end != std::string_view::npos;
        if (has_more) text.remove_prefix(end + 1);
    }
    return xml;
}

// Collects parts with their types and relationships.
class PartList {
 public:
    void add(const std::string& name, std::string_view type, std::string xml,
             const Relationships& relationships = {}) {
        parts_.push_back({name, std::string(declaration) + std::move(xml)});
        types_ += fmt::format(R"(<Override PartName="/{}" ContentType="{}"/>)", name, type);
        if (!relationships.empty()) add_relationships(name, relationships);
    }
    void add_relationships(const std::string& name, const Relationships& relationships) {
        const std::size_t folder = name.rfind('/') + 1;  // 0 for the whole package
        parts_.push_back(
            {fmt::format("{}_rels/{}.rels", name.substr(0, folder), name.substr(folder)),
             std::string(declaration) + relationships.xml()});
    }

    // The types come first.
    std::vector<PptxPart> take() {
        parts_.insert(parts_.begin(),
                      {"[Content_Types].xml", std::string(declaration) + std::string(types_start) +
                                                  types_ + "</Types>\n"});
        return std::move(parts_);
    }

 private:
    std::vector<PptxPart> parts_;
    std::string types_;
};

std::string type_of(std::string_view part) { return fmt::format("{}{}+xml", type_start, part); }

void add_slide(PartList& parts, const PptxText& text, std::size_t index) {
    const PptxSlide& slide = text.slides[index];
    const std::string language = escaped_markup(text.language);
    const std::string name = fmt::format("slide{}.xml", index + 1);
    const std::string notes = fmt::format("notesSlide{}.xml", index + 1);
    const std::string title = escaped_markup(slide.title);
    const std::string box = film_box(text.width_px, text.height_px);
    Relationships relationships;
    relationships.add("slideLayout", "../slideLayouts/slideLayout1.xml");
    const auto picture_of_film = [&](int shape, std::string_view shape_name,
                                     const std::string& film, const std::string& poster) {
        const std::string file = "../media/" + film;
        const std::string link = relationships.add("video", file);
        const std::string bytes =
            relationships.add("http://schemas.microsoft.com/office/2007/relationships/media", file);
        const std::string image = relationships.add("image", "../media/" + poster);
        return fmt::format(film_xml, shape, shape_name, title, link, bytes, image, box);
    };
    std::string pictures = picture_of_film(3, "Film", slide.film, slide.poster);
    std::string steps =
        fmt::format(step_xml, 3, R"(<p:cond evt="onBegin" delay="0"><p:tn val="2"/></p:cond>)",
                    fmt::format(play_xml, 5, 6, "afterEffect", slide.duration_ms, 3), 4);
    std::string after = fmt::format(video_xml, 7, "", 3);
    if (slide.loop.empty()) {
        const std::string image = relationships.add("image", "../media/" + slide.still);
        pictures += fmt::format(still_xml, title, image, box);
        after += fmt::format(still_sequence_xml,
                             fmt::format(step_xml, 9, "", fmt::format(appear_xml, 11, 12), 10));
    } else {
        pictures += picture_of_film(4, "Loop", slide.loop, slide.still);
        steps += fmt::format(step_xml, 8, "",
                             fmt::format(appear_xml, 10, 11) +
                                 fmt::format(play_xml, 12, 13, "withEffect", slide.loop_ms, 4),
                             9);
        after += fmt::format(video_xml, 14, R"( repeatCount="indefinite")", 4);
    }
    if (!slide.note.empty()) relationships.add("notesSlide", "../notesSlides/" + notes);
    parts.add("ppt/slides/" + name, type_of("slide"),
              fmt::format(slide_xml, namespaces, tree_start, language, title, pictures,
                          masters_colours, steps, after),
              relationships);
    if (slide.note.empty()) return;
    Relationships of_notes;
    of_notes.add("notesMaster", "../notesMasters/notesMaster1.xml");
    of_notes.add("slide", "../slides/" + name);
    parts.add("ppt/notesSlides/" + notes, type_of("notesSlide"),
              fmt::format(notes_slide_xml, namespaces, tree_start, paragraphs(slide.note, language),
                          masters_colours),
              of_notes);
}

// The masters, the layout and their themes.
void add_masters(PartList& parts) {
    constexpr std::string_view theme_type =
        "application/vnd.openxmlformats-officedocument.theme+xml";
    parts.add("ppt/theme/theme1.xml", theme_type, std::string(theme_xml));
    parts.add("ppt/theme/theme2.xml", theme_type, std::string(theme_xml));
    Relationships of_master, of_layout, of_notes_master;
    const std::string layout = of_master.add("slideLayout", "../slideLayouts/slideLayout1.xml");
    of_master.add("theme", "../theme/theme1.xml");
    parts.add("ppt/slideMasters/slideMaster1.xml", type_of("slideMaster"),
              fmt::format(slide_master_xml, namespaces, tree_start, colour_map, layout), of_master);
    of_layout.add("slideMaster", "../slideMasters/slideMaster1.xml");
    parts.add("ppt/slideLayouts/slideLayout1.xml", type_of("slideLayout"),
              fmt::format(slide_layout_xml, namespaces, tree_start, masters_colours), of_layout);
    of_notes_master.add("theme", "../theme/theme2.xml");
    parts.add("ppt/notesMasters/notesMaster1.xml", type_of("notesMaster"),
              fmt::format(notes_master_xml, namespaces, tree_start, colour_map), of_notes_master);
}

}  // namespace

bool describes_slides_of(const SlideOrigin& origin, std::string_view origin_xml) {
    const auto value_of = [&origin_xml](std::string_view tag) -> std::string_view {
        const std::string begin = fmt::format("<dc:{}>", tag), end = fmt::format("</dc:{}>", tag);
        const std::size_t at = origin_xml.find(begin);
        if (at == std::string_view::npos) return {};
        const std::string_view rest = origin_xml.substr(at + begin.size());
        return rest.substr(0, rest.find(end));
    };
    const std::string_view description = value_of("description"),
                           identifier = value_of("identifier");
    const std::size_t colon = description.find(": ");
    if (colon == std::string_view::npos ||
        description.substr(colon + 2) != escaped_markup(origin.scene_name))
        return false;
    const std::string file = escaped_markup(origin.scene_file) + " ";
    const bool is_one_file =
        identifier.size() == file.size() + origin.scene_sha256.size() &&
        identifier.starts_with(file) &&
        (!origin.scene_file.empty() || value_of("title") == escaped_markup(origin.title));
    return is_one_file || identifier.ends_with(" " + origin.scene_sha256);
}

std::vector<PptxPart> pptx_parts(const PptxText& text) {
    PartList parts;
    Relationships of_package;
    of_package.add("officeDocument", "ppt/presentation.xml");
    of_package.add(
        "http://schemas.openxmlformats.org/package/2006/relationships/metadata/core-properties",
        pptx_origin_name);
    parts.add_relationships("", of_package);
    parts.add(
        std::string(pptx_origin_name), "application/vnd.openxmlformats-package.core-properties+xml",
        fmt::format(
            R"(<cp:coreProperties xmlns:cp="http://schemas.openxmlformats.org/package/2006/metadata/core-properties" )"
            R"(xmlns:dc="http://purl.org/dc/elements/1.1/"><dc:title>{}</dc:title><dc:description>{}</dc:description>)"
            R"(<dc:identifier>{} {}</dc:identifier><dc:language>{}</dc:language></cp:coreProperties>)"
            "\n",
            escaped_markup(text.title),
            escaped_markup(fmt::format("poinsot {}: {}", POINSOT_VERSION, text.origin.scene_name)),
            escaped_markup(text.origin.scene_file), text.origin.scene_sha256,
            escaped_markup(text.language)));

    Relationships relationships;
    const std::string slide_master =
        relationships.add("slideMaster", "slideMasters/slideMaster1.xml");
    const std::string notes_master =
        relationships.add("notesMaster", "notesMasters/notesMaster1.xml");
    relationships.add("theme", "theme/theme1.xml");
    std::string slide_ids;
    for (std::size_t i = 0; i < text.slides.size(); ++i) {
        const std::string slide =
            relationships.add("slide", fmt::format("slides/slide{}.xml", i + 1));
        constexpr std::size_t first_id = 256;  // the least that is allowed
        slide_ids += fmt::format(R"(<p:sldId id="{}" r:id="{}"/>)", first_id + i, slide);
    }
    parts.add(
        "ppt/presentation.xml", type_of("presentation.main"),
        fmt::format(
            R"(<p:presentation {}><p:sldMasterIdLst><p:sldMasterId id="2147483648" r:id="{}"/></p:sldMasterIdLst>)"
            R"(<p:notesMasterIdLst><p:notesMasterId r:id="{}"/></p:notesMasterIdLst><p:sldIdLst>{}</p:sldIdLst>)"
            R"(<p:sldSz cx="{}" cy="{}"/><p:notesSz cx="6858000" cy="9144000"/></p:presentation>)"
            "\n",
            namespaces, slide_master, notes_master, slide_ids, slide_width_emu, slide_height_emu),
        relationships);

    add_masters(parts);
    for (std::size_t i = 0; i < text.slides.size(); ++i) add_slide(parts, text, i);
    return parts.take();
}

}  // namespace poinsot
