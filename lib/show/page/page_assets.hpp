#pragma once
// The parts of a page that do not depend on its data, compiled in from view/ (CMakeLists.txt). Private to page.

#include <string>

namespace quadrille::page {

std::string page_style();   ///< view/view.css
std::string page_body();    ///< view/body.html
std::string page_script();  ///< view/*.js in one function

}  // namespace quadrille::page
